#pragma once

#include "dlfl/mesh.h"
#include "geom/angle.h"
#include "ops/point_finder.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace druse {

/// A solid that stands on one of its faces, and the turns about that face's axis that carry it into itself.
///
/// The base lies in z = 0 around the origin, with a mean edge of 1 and its start corner over the x axis; the solid is above. No two edges of it
/// join the same vertices.
class StandingSolid {
public:
    /// Distances up to `same_place` mean edges of the base count as none. In a mirror the solid is seen turned round.
    /// @throws CommandError `face ID of the solid has no area`
    StandingSolid(const Mesh& solid, Face base, double same_place, bool mirror);

    int sides() const { return static_cast<int>(foot_.size()); } // of the base
    /// Whether the turn by 360°/k carries the solid into itself.
    bool turns(int k) { return !turned_vertices(k).empty(); }

protected:
    static constexpr double full = 2.0 * pi;
    static Point turned(const Point& p, double angle);
    /// Where the turn by 360°/k carries each vertex; empty if it does not carry the solid, vertices and faces, into itself.
    std::vector<std::uint32_t> turned_vertices(int k);
    /// Makes the symmetry of coordinates from a file exact: every vertex becomes the mean of its images under the turn by 360°/k, turned back.
    void average_turns(const std::vector<std::uint32_t>& image, int k);

    const Mesh& solid_;
    const Face base_;
    const double same_place_;
    std::vector<std::uint32_t> foot_; // the base's vertices, counter-clockwise from above
    std::vector<Face> wall_;          // over the edges from each of them
    std::vector<Point> place_;        // of each vertex

private:
    struct Side {
        std::uint32_t from, to;
        Corner corner;
        std::pair<std::uint32_t, std::uint32_t> ends() const { return {from, to}; }
    };
    /// The corner whose side runs from one vertex to another; at most one, as no two edges join the same vertices.
    Corner side(std::uint32_t from, std::uint32_t to);

    std::optional<PointFinder> finder_;
    std::vector<Side> sides_; // by their ends; empty until one is looked for
};

/// The largest number of turns about each face's axis that carry a solid into itself.
///
/// Looking at all vertices is left to the few faces that pass two tests: such a turn keeps the mean of the vertices, so that lies on the
/// axis, and it carries some vertices taken at random to vertices.
class TurnFinder {
public:
    /// Distances up to `same_place` mean edges of a face count as none.
    TurnFinder(const Mesh& solid, double same_place, bool mirror);
    /// 1 if it is below `least`.
    int largest(Face f, int least = 2) const;

private:
    struct Axis {
        Point on;
        Vector along;
        double reach; // how far a vertex may be from where the turn carries another
    };
    Axis axis_of(Face f) const;
    bool may_turn(const Axis& axis, int k) const;

    static constexpr double slack = 1.001; // no face is missed by rounding; the StandingSolid looks again
    const Mesh& solid_;
    const double same_place_;
    const bool mirror_;
    std::vector<Point> points_;
    Point mean_{0.0};
    std::optional<PointFinder> finder_;
};

} // namespace druse
