#pragma once

#include "geom/progress.h"
#include "ops/remesh_scheme.h"

namespace druse {

namespace remesh {
class OldMesh;
struct NewPoints;
} // namespace remesh

/// A face between the middles of the sides of every face (group 1), and a triangle in each of its corners (group 2).
///
/// V + E vertices, 4E edges, F + 2E faces. An edge point is 3/8 (v + w) + 1/8 (o_f + o_g), v and w the ends, o_f and o_g the third
/// corners beside the edge; a vertex of valence m goes the fraction 5/8 − (3/8 + cos(2π/m)/4)² of the way to the mean of its neighbours.
/// Where a face has more corners, o is the mean of the others: this is our own extension. Without `smooth` edges are halved.
/// Source: Loop, *Smooth subdivision surfaces based on triangles* (1987).
struct Loop {
    static constexpr remesh::Scheme scheme = [] {
        using namespace remesh;
        Scheme s;
        s.face = polygon(1, edge_point);
        s.corner[0] = polygon(2, old_vertex, edge_point, edge_point(back));
        return s;
    }();

    bool smooth = true;

    void place(const remesh::OldMesh& old, const remesh::NewPoints& to, Progress& progress) const;
};

} // namespace druse
