#pragma once

#include "dlfl/mesh.h"
#include "geom/progress.h"

namespace druse {

// Shapes centred at the origin, outside out, in group 0. Lengths are in model units; `size` is the length of the edges.
// Numbers are written in closed form, so that a shape costs what its memory costs.

/// A regular n-gon with two sides in z = 0: face 0 looks up, face 1 down, vertex 0 lies on +x. V n, E n, F 2.
Mesh make_polygon(int n, double size);

/// nx·ny squares that look up, row by row from least y then least x, and last one face with 2(nx + ny) corners below them.
Mesh make_grid(int nx, int ny, double size, Progress& progress);

/// A regular n-gon (face 0, below), n squares, and the lid (face n + 1); axis z. V 2n, E 3n, F n + 2.
Mesh make_prism(int n, double size);

/// A regular n-gon (face 0, below), n triangles that stand on it, n that hang from the lid, and the lid; axis z. V 2n, E 4n, F 2n + 2.
Mesh make_antiprism(int n, double size);

/// nu·nv quads on a torus with axis z, nu of them round the axis; vertex 0 on +x, farthest from the axis. Genus 1.
Mesh make_torus(int nu, int nv, double major, double minor, Progress& progress);

/// nu meridians and nv bands from the south pole (vertex 0) up: triangles at the poles, quads between. V nu(nv − 1) + 2, F nu·nv.
Mesh make_sphere(int nu, int nv, double radius, Progress& progress);

/// The icosahedron with each face cut into frequency² triangles, all vertices at `radius`. V 10f² + 2, E 30f², F 20f².
/// Source: Fuller, as class I in Clinton, *Advanced structural geometry studies* (1971).
Mesh make_geodesic(int frequency, double radius);

} // namespace druse
