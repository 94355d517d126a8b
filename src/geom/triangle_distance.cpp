#include "geom/triangle_distance.h"

#include "geom/segments.h"

#include <algorithm>
#include <cmath>

namespace druse {

namespace {

constexpr double nearer_elsewhere = 1e300; // to a side, which others look at

double distance_within(const Point& p, const Triangle& t)
{
    const Vector normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double square = glm::dot(normal, normal);
    if (square == 0) return nearer_elsewhere;
    for (std::size_t i = 0; i < 3; ++i)
        if (glm::dot(glm::cross(t[(i + 1) % 3] - t[i], p - t[i]), normal) < 0) return nearer_elsewhere;
    return std::abs(glm::dot(p - t[0], normal)) / std::sqrt(square);
}

} // namespace

double triangle_distance(const Triangle& a, const Triangle& b)
{
    double least = nearer_elsewhere;
    for (std::size_t i = 0; i < 3; ++i) {
        least = std::min({least, distance_within(a[i], b), distance_within(b[i], a)});
        for (std::size_t j = 0; j < 3; ++j) least = std::min(least, nearest_points(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]).distance);
    }
    return least;
}

} // namespace druse
