#pragma once

#include "dlfl/mesh.h"

#include <array>
#include <ostream>
#include <string>
#include <vector>

/// The family of shapes that tests range over. All are sound, have no holes, and look outward (positive volume where they are closed
/// and not flat); edges have length 1 unless a shape says otherwise. Faces, vertices and edges are numbered as a reader would.
namespace druse::test {

// --- plain solids -------------------------------------------------------------------------------------------------------------

/// A regular n-gon of edge length 1 with two sides, in z = 0; face 0 looks up: V n, E n, F 2.
Mesh dihedron(int n);

Mesh tetrahedron();  // V  4, E  6, F  4
Mesh cube();         // V  8, E 12, F  6
Mesh octahedron();   // V  6, E 12, F  8
Mesh dodecahedron(); // V 20, E 30, F 12
Mesh icosahedron();  // V 12, E 30, F 20

/// A regular n-gon (face 0, below), the sides, and the lid (face n + 1): V 2n, E 3n, F n + 2.
Mesh prism(int n);
/// A regular n-gon (face 0, below) and n triangles that meet in vertex n, at height 1: V n + 1, E 2n, F n + 1.
Mesh pyramid(int n);
/// Quads on a torus of radii 1 and 0.4, nu round the axis and nv round the tube: V nu·nv, E 2 nu·nv, F nu·nv, genus 1.
Mesh torus(int nu, int nv);
/// nx·ny unit squares that look up, row by row, and one face with 2(nx + ny) corners below them: flat, but closed.
Mesh grid(int nx, int ny);
/// A prism over an L of three unit squares: two concave hexagons and six squares, one of them 2 long.
Mesh l_prism();
/// A cube of which one corner is pulled out, so that three faces are warped.
Mesh warped_cube();
/// The same with a corner pushed nearly to the middle: three faces are concave and warped.
Mesh dented_cube();

/// The surface of a set of unit cells of the cubic grid; lone diagonal contacts between cells are not allowed.
Mesh voxels(const std::vector<std::array<int, 3>>& cells);
/// A slab of (2g + 1) × 3 cells with g holes through it: genus g.
Mesh block_with_holes(int genus);

// --- what only a doubly linked face list holds ------------------------------------------------------------------------------------

/// Two cubes side by side, not touching.
Mesh two_cubes();
/// A cube with an edge standing on a corner of face 0: that face visits the corner twice and has both sides of the edge.
Mesh cube_with_antenna();
/// Two cubes joined by one edge: the face it ends in has ten corners.
Mesh tethered_cubes();
/// A cube with a second edge along its first one: a face with two sides lies between them.
Mesh cube_with_parallel_edges();
/// A cube whose faces 0 and 1 are joined by an edge inside it: genus 1, one face with ten corners.
Mesh cube_with_edge_handle();
/// A cube with an edge from a corner of face 0 to the same corner: a face with one side.
Mesh cube_with_loop();
/// Two vertices joined by an edge: one face with two corners.
Mesh segment();
/// Two vertices and three edges: three faces with two sides.
Mesh three_lunes();
/// One vertex without an edge.
Mesh point_sphere();

/// nx·ny unit squares and nothing below: an open patch, closed by one boundary face.
Mesh open_grid(int nx, int ny);
/// The sides of a prism: open at both ends.
Mesh open_tube(int n);

/// A pentagonal prism, a torus, an open patch, a cube with an antenna and a point sphere, with groups 0, 1, 2 … on their faces.
Mesh mixed();

// --- the list -----------------------------------------------------------------------------------------------------------------

struct NamedShape {
    std::string name;
    Mesh (*make)();
    friend std::ostream& operator<<(std::ostream& out, const NamedShape& s) { return out << s.name; }
};
/// Every kind of shape above at least once, for parameterised tests.
const std::vector<NamedShape>& all_shapes();

/// For INSTANTIATE_TEST_SUITE_P(…, testing::ValuesIn(all_shapes()), shape_name).
template <class Info>
std::string shape_name(const Info& info)
{
    return info.param.name;
}

} // namespace druse::test
