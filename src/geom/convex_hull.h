#pragma once

#include "geom/point.h"
#include "geom/progress.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace druse {

/// The convex hull of points in space, as triangles. Exact: the signs of predicates.h decide, no tolerance.
///
/// A point is added if it lies strictly outside a facet; a facet whose plane it lies in counts as not seen from it, so no facet is without
/// area, and points in the plane of a face end up as corners, inside it, or not at all, as the order has it. Memory is kept from hull to hull.
/// Cost: O(n log n) expected for points in random order; in the worst of orders O(n²).
/// Source: Clarkson & Shor 1989, with one conflict kept for each point; Barber, Dobkin & Huhdanpaa 1996, for why one is enough.
class ConvexHull {
public:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// A triangle, counter-clockwise seen from outside. Side k runs from corner k to the next one.
    struct Facet {
        std::array<std::uint32_t, 3> corner{none, none, none}; // points, by their place in the list; none: there is no facet
        std::array<std::uint32_t, 3> neighbour;                // the facet across each side
        Vector normal;                                         // outward, as long as twice the area; off by rounding
        std::uint32_t waiting = none;                          // first of the points that see it and are not added yet
        std::uint32_t seen_by = none;                          // the point that last looked at it,
        bool visible = false;                                  // and what it saw
    };

    /// Makes the hull of points, which are added in the order given after the first four that span a solid. False if all of them lie in a plane.
    /// Precondition: finite, fewer than 2^31. @throws Cancelled, if there is someone to ask
    bool build(std::span<const Point> points, const Progress* progress = nullptr);

    /// Adds one more point, of the next number. False if it does not lie outside; then nothing changes. Cost: O(facets).
    bool add(const Point& p);

    const Point& point(std::uint32_t i) const { return points_[i]; }
    /// Facets, and between them places where there is none; neighbours are places in this list.
    std::span<const Facet> facets() const { return facets_; }

private:
    bool find_solid(std::array<std::uint32_t, 4>& corners) const;
    void begin_with(const std::array<std::uint32_t, 4>& corners);
    bool sees(const Facet& f, const Point& p) const;
    std::uint32_t make(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void bound_errors();
    void insert(std::uint32_t p, std::uint32_t seen);

    std::vector<Point> points_;
    std::vector<std::uint32_t> sees_, after_; // of a point that waits, a facet it sees and the next that waits there
    std::vector<std::uint32_t> at_;           // by point, the new facet whose outer side starts there
    std::vector<Facet> facets_;
    std::vector<std::uint32_t> free_, visible_, made_;
    double certain_ = 0; // determinants beyond have the right sign
};

} // namespace druse
