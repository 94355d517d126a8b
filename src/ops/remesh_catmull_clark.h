#pragma once

#include "ops/remesh_scheme.h"

#include "geom/progress.h"

namespace druse {

namespace remesh {
class OldMesh;
struct NewPoints;
} // namespace remesh

/// Four-sided faces only: a quad in each corner, between the vertex, two edge points and a point in the face.
///
/// V + E + F vertices, 4E edges, 2E faces. Face points are the means of the corners; an edge point is the mean of the two ends and the
/// two face points beside it; a vertex of valence m goes to (Q + 2R + (m − 3)v)/m, Q and R the means of the face points and edge
/// midpoints around it. Without `smooth` edge points are midpoints and old vertices stay.
/// Source: Catmull & Clark, *Recursively generated B-spline surfaces on arbitrary topological meshes* (1978).
struct CatmullClark {
    static constexpr remesh::Scheme scheme = [] {
        using namespace remesh;
        Scheme s;
        s.corner[0] = polygon(1, old_vertex, edge_point, face_point, edge_point(back));
        return s;
    }();

    bool smooth = true;

    void place(const remesh::OldMesh& old, const remesh::NewPoints& to, Progress& progress) const;
};

} // namespace druse
