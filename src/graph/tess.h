#pragma once

#include "geom/progress.h"
#include "graph/graph.h"

#include <cstdint>
#include <vector>

namespace druse {

enum class DiskModel { poincare, klein, halfplane };

/// A patch of a vertex-uniform tessellation of the hyperbolic plane, as `graph.tess` makes it.
struct TessShape {
    std::vector<int> config{7, 7, 7}; // polygons in cyclic order round every vertex
    Disk::Center center = Disk::Center::face;
    int center_number = -1;           // of a face its sides, of an edge its slot; −1: the first one
    int layers = 3;                   // each completes every vertex of the patch
    DiskModel model = DiskModel::poincare;
    double turn = 0;                  // degrees
    double shift_x = 0, shift_y = 0;  // the point of the disk to which the centre is taken
    int arc = 1;                      // straight pieces of each geodesic edge
    bool mirror = false;
};

/// The patch: a graph, and the polygons that are complete, as lists of its vertices, counter-clockwise.
struct Tess {
    Graph graph;
    std::vector<std::uint32_t> polygon_corners, polygon_ends; // one past the last corner of each polygon
};

inline constexpr std::uint32_t most_tess_vertices = 2'000'000;
inline constexpr double shortest_tess_edge = 1e-6; // in the chosen model

/// Grows the patch without comparing coordinates: a face is found to be there by what joins its corners. V − E + F = 1 after every layer.
///
/// Placed: a face with its centre at 0 and a vertex on the +x axis, a vertex at 0 with its first edge along +x, or an edge along the x axis
/// with its middle at 0; then mirrored in the x axis, turned and shifted. Points between the ends of an edge come after all
/// vertices and are equally spaced in hyperbolic length. The graph remembers what is at the centre.
/// @throws CommandError for what is not hyperbolic or has no vertex-uniform tessellation, a centre that is not there, a vertex at infinity
/// of the half-plane; and, with the most layers that fit, where edges, or their pieces, would be shorter than 1e-6 or vertices more than 2 000 000
/// Cost: linear in vertices and polygons: 0.5 µs a vertex. Sources: Hart 2009, 4; Anderson 1999; Grünbaum & Shephard 1987.
Tess tessellate(const TessShape& shape, bool with_polygons, Progress& progress);

} // namespace druse
