#pragma once

#include "graph/clean_graph.h"
#include "graph/incidence.h"
#include "graph/nearest_directions.h"
#include "graph/strut_shape.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace druse {

/// Where the polygons of struts stand.
struct StrutPlacement {
    static constexpr double least_size = 1e-50; // of an edge or a polygon; squares of smaller areas would not be numbers
    struct End {
        double radius = 0, height = 0; // of the polygon, and its distance from the vertex
    };
    std::vector<End> ends;       // by end of an edge: Incidence
    std::vector<double> wanted;  // by vertex, the radius that was asked for
    std::vector<double> reach;   // by vertex, the radius of the sphere around it that holds the corners of its polygons
    std::uint32_t thinned = 0;   // polygons smaller than asked for, not counting factors
    double least = 1;            // the smallest part of what was asked for,
    std::uint32_t least_at = 0;  // and the vertex where it is
};

/// Places polygons so that struts and the balls that join them keep apart: seen from a vertex its polygons are disjoint discs with a margin, the
/// spheres of neighbours do not meet, and a strut stays within the cone that its polygon is seen in. What does not depend on the radius is
/// computed once. Borrows the graph.
/// Source: Hart 2009, section 2; the bounds on the angle and the taper are ours.
class StrutPlacer {
public:
    /// @throws CommandError for two edges that leave a vertex in nearly the same direction, and for an edge that is too short
    StrutPlacer(const CleanGraph& clean, const Incidence& incidence, const StrutShape& shape);

    /// With the radius times `factor`, and at each vertex times its own where there are any. Cost: O(edges).
    StrutPlacement place(double factor = 1, std::span<const double> of_vertices = {}) const;
    /// The largest factor, at most 1, with which no polygon is smaller than asked for.
    double fitting_factor() const;

    const Vector& direction(std::uint32_t edge) const { return direction_[edge]; } // of length 1, from its first end
    /// To the nearest other edge at the same vertex, radians; infinite at a vertex with one edge.
    double nearest_angle(std::uint32_t end) const { return nearest_[end]; }
    /// For errors, as CleanGraph::vertex_name().
    std::string vertex_name(std::uint32_t v) const { return clean_.vertex_name(v); }

private:
    Vector leaving(std::uint32_t end) const { return end % 2 == 0 ? direction_[end / 2] : -direction_[end / 2]; }
    void find_nearest(std::uint32_t v);
    void place_leaf(StrutPlacement& p, std::uint32_t v, double bound) const;
    void shape_leaf(StrutPlacement& p, std::uint32_t v) const;

    const CleanGraph& clean_;
    const Graph& graph_;
    const Incidence& incidence_;
    const StrutShape& shape_;
    std::vector<Vector> direction_;
    std::vector<double> length_, nearest_, half_angle_; // half the angle under which the largest polygon is seen from its vertex
    NearestDirections finder_; // scratch
    std::vector<Vector> star_;
};

} // namespace druse
