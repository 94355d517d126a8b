#pragma once

#include "geom/point.h"
#include "io/glb_file.h"
#include "io/glb_library.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

namespace druse {

/// Numbers among the bytes of a buffer, one index or three coordinates at a time; all lie inside of it.
class GlbValues {
public:
    GlbValues() = default;
    GlbValues(const char* data, std::size_t stride, std::size_t count, int type, bool normalized)
        : data_(data), stride_(stride), count_(count), type_(type), normalized_(normalized)
    {
    }
    /// As many indices, each its own place.
    static GlbValues counted(std::size_t count) { return {nullptr, 0, count, 0, false}; }

    std::size_t count() const { return count_; }
    std::size_t index(std::size_t i) const;
    Point position(std::size_t i) const;

private:
    template <class T> Point three(const char* at) const
    {
        T value[3];
        std::memcpy(value, at, sizeof value);
        Point p(value[0], value[1], value[2]);
        if constexpr (std::is_integral_v<T>)
            if (normalized_) p = glm::max(p / double(std::numeric_limits<T>::max()), -1.0);
        return p;
    }

    const char* data_ = nullptr;
    std::size_t stride_ = 0, count_ = 0;
    int type_ = 0;
    bool normalized_ = false;
};

/// The values of an accessor that is to hold positions, or indices. Throws InputError that begins with `name` if it does not hold
/// them, or reaches beyond its buffer.
GlbValues glb_positions(const tinygltf::Model& gltf, const GlbFile& file, int accessor, const std::string& name);
GlbValues glb_indices(const tinygltf::Model& gltf, const GlbFile& file, int accessor, const std::string& name);

/// Throws InputError if there is no such thing among `count` of them.
void check_glb_index(int index, std::size_t count, const char* what, const std::string& name);

inline std::size_t GlbValues::index(std::size_t i) const
{
    if (!data_) return i;
    const std::size_t size = type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 1
                             : type_ == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 2
                                                                               : 4;
    std::uint32_t value = 0; // its lowest bytes come first, in the file and here
    std::memcpy(&value, data_ + i * stride_, size);
    return value;
}

inline Point GlbValues::position(std::size_t i) const
{
    const char* const at = data_ + i * stride_;
    switch (type_) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return three<std::int8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return three<std::uint8_t>(at);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return three<std::int16_t>(at);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return three<std::uint16_t>(at);
    default:
        return three<float>(at);
    }
}

} // namespace druse
