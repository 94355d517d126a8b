#include "dlfl/wall_thickness.h"

#include <algorithm>
#include <numbers>

namespace druse {

WallThickness wall_thickness(const Mesh& mesh, const RayCast& rays, double reach, Progress& progress, double from)
{
    constexpr double opposite = 0.5 * std::numbers::sqrt2; // cos 45°
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const TriangleList& triangles = rays.triangles();
    WallThickness result;
    result.under.assign(mesh.face_limit(), infinity);
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        if (i % 1024 == 0) progress.step(from + (1 - from) * i / triangles.size());
        const auto [a, b, c] = triangles[i];
        const Vector inward = -unit(glm::cross(b - a, c - a));
        if (inward == Vector(0.0)) continue; // an area below the least number
        const Face f = triangles.face(i);
        const auto ask = [&](double u, double v, double w) {
            const double farthest = std::max(reach, std::min(result.thinnest, std::numeric_limits<double>::max()));
            const auto hit = rays.first(u * a + v * b + w * c, inward, farthest, i);
            if (!hit || hit->facing < opposite) return;
            if (hit->distance < reach) result.under[f.index] = std::min(result.under[f.index], hit->distance);
            if (hit->distance < result.thinnest) {
                result.thinnest = hit->distance;
                result.where = f;
            }
        };
        ask(1 / 3.0, 1 / 3.0, 1 / 3.0);
        if (std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)}) <= reach) continue;
        ask(2 / 3.0, 1 / 6.0, 1 / 6.0);
        ask(1 / 6.0, 2 / 3.0, 1 / 6.0);
        ask(1 / 6.0, 1 / 6.0, 2 / 3.0);
    }
    return result;
}

} // namespace druse
