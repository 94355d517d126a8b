#pragma once

#include "dlfl/triangle_list.h"
#include "geom/box_tree.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace druse {

/// Half lines through a mesh. Borrows the mesh, which must not change.
/// Cost: to make, O(n log n) for n triangles; of a ray, about log n and the triangles near it.
/// Source: Möller & Trumbore 1997.
class RayCast {
public:
    /// Reports its part of the work as 0 to `share`. @throws Cancelled
    RayCast(const Mesh& mesh, Progress& progress, double share);

    const TriangleList& triangles() const { return triangles_; }

    struct Hit {
        std::uint32_t triangle = 0;
        double distance = 0;
        double facing = 0; // cosine of the angle between ray and normal: above 0 where the ray leaves the solid
    };

    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    /// The first triangle on the ray, at a distance from 0 to `reach`; `from`, the triangle that it starts on, is left out. A triangle
    /// that lies on the start, but for rounding, is met at distance 0. `direction` has length 1.
    std::optional<Hit> first(const Point& origin, const Vector& direction, double reach, std::uint32_t from = none) const;
    /// The same, of those triangles that `counts`.
    template <class Counts>
    std::optional<Hit> first_of(const Point& origin, const Vector& direction, double reach, Counts&& counts) const;

    /// How often a closed surface of those triangles that `counts` goes round a point, counter-clockwise seen from outside: 1 inside a
    /// solid, 0 outside. Precondition: the point is not on one of them.
    template <class Counts>
    int winding(const Point& p, Counts&& counts) const;

private:
    struct Met {
        double distance, facing;
        bool at_side; // so near to a side that a neighbour may be met as well
    };
    std::optional<Met> meet(std::uint32_t triangle, const Point& origin, const Vector& direction) const;

    TriangleList triangles_;
    BoxTree tree_;
    double rounding_ = 0; // a length that is nothing in a model of this size
};

template <class Counts>
std::optional<RayCast::Hit> RayCast::first_of(const Point& origin, const Vector& direction, double reach, Counts&& counts) const
{
    std::optional<Hit> nearest;
    // The tree asks a little farther than the nearest so far, so that of equals always the same one is found.
    tree_.for_each_on_ray(origin, direction, reach, [&](std::uint32_t t, double& limit) {
        const auto met = meet(t, origin, direction);
        if (!met || met->distance < -rounding_ || met->distance > reach || !counts(t)) return;
        const double distance = std::max(0.0, met->distance);
        if (nearest && (distance > nearest->distance || (distance == nearest->distance && t > nearest->triangle))) return;
        nearest = Hit{t, distance, met->facing};
        limit = std::min(limit, distance + rounding_);
    });
    return nearest;
}

template <class Counts>
int RayCast::winding(const Point& p, Counts&& counts) const
{
    // What the ray leaves, less what it enters. Rays that meet a side are asked again in other directions, none of them special.
    Vector direction = glm::normalize(Vector(0.57, 0.31, 0.76));
    int sum = 0;
    for (int attempt = 0; attempt < 8; ++attempt) {
        sum = 0;
        bool clear = true;
        tree_.for_each_on_ray(p, direction, std::numeric_limits<double>::max(), [&](std::uint32_t t, double&) {
            if (!counts(t)) return;
            const auto met = meet(t, p, direction);
            if (!met || met->distance < 0) return;
            sum += met->facing > 0 ? 1 : -1;
            clear &= !met->at_side;
        });
        if (clear) break;
        direction = glm::normalize(Vector(direction.y + 0.21, -direction.z, direction.x - 0.13));
    }
    return sum;
}

} // namespace druse
