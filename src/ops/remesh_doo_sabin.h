#pragma once

#include "geom/progress.h"
#include "ops/remesh_scheme.h"

namespace druse {

namespace remesh {
class OldMesh;
struct NewPoints;
} // namespace remesh

/// Every face shrinks; a quad opens on every edge and an m-gon on every vertex.
///
/// 2E vertices, 4E edges, V + E + F faces; every new vertex has four edges. The point of corner i of an n-sided face is
/// Σ_j W(n, i, j) v_j, W = 1/4 + 5/(4n) for j = i, else (3 + 2 cos(2π(i − j)/n))/(4n).
/// Source: Doo & Sabin, *Behaviour of recursive division surfaces near extraordinary points* (1978).
struct DooSabin {
    static constexpr remesh::Scheme scheme = [] {
        using namespace remesh;
        Scheme s;
        s.face = polygon(1, corner_point);
        s.edge = polygon(2, corner_point, corner_point(across, on));
        s.vertex = polygon(3, corner_point);
        return s;
    }();

    void place(const remesh::OldMesh& old, const remesh::NewPoints& to, Progress& progress) const;
};

} // namespace druse
