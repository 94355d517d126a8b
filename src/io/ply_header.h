#pragma once

#include "io/byte_source.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace druse {

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

inline std::size_t size_of(PlyType type)
{
    constexpr std::uint8_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

struct PlyProperty {
    std::string name;
    PlyType type{};
    std::optional<PlyType> length{}; // of a list: the type of its length, a whole number
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0; // at most most_elements
    std::vector<PlyProperty> properties{};
};

enum class PlyEncoding { ascii, little_endian, big_endian };

/// What the header of a PLY file announces.
struct PlyHeader {
    PlyEncoding encoding{};
    std::vector<PlyElement> elements;
    std::vector<std::pair<int, std::string>> group_names; // of `comment group <id> <name>`
    std::size_t size = 0;                                 // in bytes
    long lines = 0;
};

/// Reads ahead to the end of the header; the source then still begins with it.
/// @throws InputError with the line
PlyHeader read_ply_header(ByteSource& source);

} // namespace druse
