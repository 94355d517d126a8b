#include "dlfl/ray_cast.h"

#include <algorithm>
#include <cmath>

namespace druse {

RayCast::RayCast(const Mesh& mesh, Progress& progress, double share)
    : triangles_(mesh, progress, 0.5 * share), tree_(triangles_.boxes(), progress, 0.5 * share, share)
{
    Box all;
    for (const Point& p : mesh.positions()) all.add(p);
    rounding_ = 1e-12 * (all.diagonal() + glm::length(all.center()));
}

std::optional<RayCast::Met> RayCast::meet(std::uint32_t triangle, const Point& origin, const Vector& direction) const
{
    constexpr double slack = 1e-9; // of barycentric coordinates: both triangles beside a side own it
    const auto [a, b, c] = triangles_[triangle];
    const Vector ab = b - a, ac = c - a, normal = glm::cross(ab, ac);
    const double determinant = -glm::dot(direction, normal);
    if (determinant == 0) return std::nullopt;
    const Vector from_a = origin - a, q = glm::cross(from_a, direction);
    const double u = glm::dot(ac, q) / determinant, v = -glm::dot(ab, q) / determinant, w = 1 - u - v;
    const double least = std::min({u, v, w});
    if (!(least >= -slack)) return std::nullopt;
    return Met{glm::dot(from_a, normal) / determinant, -determinant / glm::length(normal), least <= slack};
}

std::optional<RayCast::Hit> RayCast::first(const Point& origin, const Vector& direction, double reach, std::uint32_t from) const
{
    return first_of(origin, direction, reach, [from](std::uint32_t t) { return t != from; });
}

} // namespace druse
