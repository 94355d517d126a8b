#include "geom/segments.h"

#include <algorithm>

namespace druse {

namespace {

/// The place of the point of a segment that is nearest to p.
double nearest_place(const Point& p, const Point& a, const Vector& along)
{
    const double square = glm::dot(along, along);
    return square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
}

} // namespace

double distance_to_segment(const Point& p, const Point& a, const Point& b)
{
    return glm::distance(p, a + nearest_place(p, a, b - a) * (b - a));
}

NearestPoints nearest_points(const Point& a, const Point& b, const Point& c, const Point& d)
{
    const Vector u = b - a, w = d - c;
    const Vector across = glm::cross(u, w); // 0 for parallels, of which any place of the first will do
    const double slant = glm::dot(across, across);
    NearestPoints best;
    best.s = slant > 0 ? std::clamp(glm::dot(glm::cross(c - a, w), across) / slant, 0.0, 1.0) : 0.0;
    best.t = nearest_place(a + best.s * u, c, w);
    best.s = nearest_place(c + best.t * w, a, u);
    best.distance = glm::distance(a + best.s * u, c + best.t * w);
    // Where rounding has spoilt the slant of near parallels, an end of one is nearest.
    for (const double end : {0.0, 1.0}) {
        const double t = nearest_place(a + end * u, c, w), s = nearest_place(c + end * w, a, u);
        if (const double distance = glm::distance(a + end * u, c + t * w); distance < best.distance) best = {end, t, distance};
        if (const double distance = glm::distance(a + s * u, c + end * w); distance < best.distance) best = {s, end, distance};
    }
    return best;
}

} // namespace druse
