#pragma once

#include "geom/point.h"
#include "io/byte_source.h"
#include "io/face_colours.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace druse {

/// What a 3MF package says of places and colours, taken from its parts by a parser that unpacks them bit by bit.
struct ThreeMfModel {
    /// An object by the part that it is in, and its id there.
    using Key = std::pair<std::string, std::uint32_t>;
    struct Placed {
        Key object;
        glm::dmat4 place{1.0};
    };
    struct Triangle {
        std::array<std::uint32_t, 3> points;
        std::int32_t paint = 0; // 0: none; else 1 + its place in `materials`
    };
    struct Object {
        std::vector<Point> points;
        std::vector<Triangle> triangles;
        std::vector<Placed> components;
    };

    double unit = 1; // of the part that has the build, in millimetres
    std::map<Key, Object> objects;
    std::vector<Placed> items; // of the build
    std::vector<NamedColour> materials;
};

/// Reads all of it into memory. Cost: linear in what is packed.
/// @throws InputError with part and line where something is not what it should be; where the package unpacks to more than 2^30 bytes
ThreeMfModel read_3mf_model(ByteSource& source);

} // namespace druse
