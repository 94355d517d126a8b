#pragma once

#include "dlfl/mesh_builder.h"
#include "geom/angle.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace druse {

/// A torus of about so many quads, or triangles, a little uneven.
inline Mesh torus(std::int64_t faces, bool triangles = false)
{
    const auto n = static_cast<std::uint32_t>(std::lround(std::sqrt(double(faces) / (triangles ? 2 : 1))));
    MeshBuilder builder;
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            const double a = 2 * pi * i / n, b = 2 * pi * j / n, r = 0.4 + 0.03 * std::sin(9 * a) * std::sin(7 * b);
            builder.add_vertex({(1 + r * std::cos(b)) * std::cos(a), (1 + r * std::cos(b)) * std::sin(a), r * std::sin(b)});
        }
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            const std::uint32_t x = (i + 1) % n, y = (j + 1) % n;
            const std::uint32_t a = i * n + j, b = x * n + j, c = x * n + y, d = i * n + y;
            if (triangles) {
                builder.add_face(std::array{a, b, c});
                builder.add_face(std::array{a, c, d});
            } else {
                builder.add_face(std::array{a, b, c, d});
            }
        }
    return builder.build();
}

} // namespace druse
