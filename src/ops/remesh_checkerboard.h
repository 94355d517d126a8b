#pragma once

#include "geom/progress.h"
#include "ops/remesh_scheme.h"

namespace druse {

namespace remesh {
class OldMesh;
struct NewPoints;
} // namespace remesh

/// Every face becomes a smaller one (group 1) in a frame of quads (group 2), one in each corner and one on each side.
///
/// V + 4E vertices, 9E edges, F + 4E faces. Edges are cut at the fraction `t` from both ends; the inner point of a corner v with
/// neighbours p and q is v + t((p − v) + (q − v)), or at a reflex corner v − t(…). So a square with t = 1/3 becomes nine equal ones,
/// and the new vertices of a flat face lie in it.
/// Source: Landreneau 2005, III.5, fig. 18, which gives no thickness; TopMod has 0.33.
struct Checkerboard {
    static constexpr remesh::Scheme scheme = [] {
        using namespace remesh;
        Scheme s;
        s.face = polygon(1, corner_point);
        s.corner[0] = polygon(2, old_vertex, side_point, corner_point, side_point(back, across));
        s.corner[1] = polygon(2, side_point, side_point(across), corner_point(on), corner_point);
        return s;
    }();

    double t = 0.333333333333333;

    void place(const remesh::OldMesh& old, const remesh::NewPoints& to, Progress& progress) const;
};

} // namespace druse
