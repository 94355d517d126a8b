#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace druse {

using Point = glm::dvec3;    // a place, in model units
using Vector = glm::dvec3;   // a difference of places, or a direction
using Point2 = glm::dvec2;

/// The largest coordinate of a mesh, in size: single precision holds it, and products of six of them stay finite.
inline constexpr double largest_coordinate = 1e38;

/// False also for what is no number.
inline bool is_in_reach(const Point& p)
{
    return std::abs(p.x) <= largest_coordinate && std::abs(p.y) <= largest_coordinate && std::abs(p.z) <= largest_coordinate;
}

/// A vector of length 1 in the direction of `v`, or `fallback` where `v` is shorter than `least`.
inline Vector unit(const Vector& v, double least = 0.0, const Vector& fallback = Vector(0.0))
{
    const double length = glm::length(v);
    return length > least ? v * (1.0 / length) : fallback;
}

/// The direction of a vector of any size: also where its square is too large or too small for a double. Zero where `v` is.
inline Vector direction(const Vector& v)
{
    const double largest = std::fmax(std::abs(v.x), std::fmax(std::abs(v.y), std::abs(v.z)));
    return largest > 0 ? unit(v / largest) : Vector(0.0);
}

/// The axis-aligned box of a set of points; empty until a point is added.
struct Box {
    Point min{1e300}, max{-1e300};

    void add(const Point& p)
    {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    bool empty() const { return min.x > max.x; }
    Vector size() const { return empty() ? Vector(0.0) : max - min; }
    Point center() const { return empty() ? Point(0.0) : 0.5 * (min + max); }
    double diagonal() const { return glm::length(size()); }
};

} // namespace druse
