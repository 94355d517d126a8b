#pragma once

#include "io/io_support.h"

#include <nlohmann/json.hpp>

#include <cstring>

namespace druse::test {

template <class T> void append(std::string& bytes, T value)
{
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A binary glTF file of a description and a buffer.
inline std::string glb_of(std::string description, std::string buffer)
{
    description.resize((description.size() + 3) / 4 * 4, ' ');
    buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
    std::string file = "glTF";
    append<std::uint32_t>(file, 2);
    append(file, static_cast<std::uint32_t>(12 + 8 + description.size() + (buffer.empty() ? 0 : 8 + buffer.size())));
    append(file, static_cast<std::uint32_t>(description.size()));
    file += "JSON" + description;
    if (buffer.empty()) return file;
    append(file, static_cast<std::uint32_t>(buffer.size()));
    return file + std::string("BIN\0", 4) + buffer;
}

struct Glb {
    nlohmann::json description;
    std::string buffer;
};

inline Glb taken_apart(const std::string& file)
{
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, file.data() + at, 4);
        return value;
    };
    const std::uint32_t length = number(12);
    return {nlohmann::json::parse(file.substr(20, length)), file.substr(28 + length, number(20 + length))};
}

inline std::string file_of(const Glb& glb)
{
    return glb_of(glb.description.dump(), glb.buffer);
}

/// A tetrahedron with the right angle at the origin: 4 positions in single precision, and behind them 12 indices of one byte. Up
/// is y, so ours has its corners at 0, x, z and −y.
inline Glb tetrahedron_glb()
{
    Glb glb;
    for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f}) append(glb.buffer, x);
    for (const std::uint8_t v : {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}) append(glb.buffer, v);
    glb.description = nlohmann::json::parse(R"({
        "asset": {"version": "2.0"},
        "buffers": [{"byteLength": 60}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5121, "count": 12, "type": "SCALAR"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "nodes": [{"mesh": 0}],
        "scenes": [{"nodes": [0]}],
        "scene": 0})");
    return glb;
}

} // namespace druse::test
