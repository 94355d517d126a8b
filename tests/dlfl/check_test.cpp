// Each rule of the doubly linked face list is broken by hand on each shape, and check() names it.
#include "dlfl/check.h"

#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>
#include <vector>

namespace druse {

/// Writes into the columns behind the mesh's back.
struct MeshTestAccess {
    explicit MeshTestAccess(Mesh& m)
        : corner_vertex(m.corner_vertex_), corner_next(m.corner_next_), corner_previous(m.corner_previous_), corner_face(m.corner_face_),
          corner_edge(m.corner_edge_), edge_corners(m.edge_corners_), face_corner(m.face_corner_), face_group(m.face_group_),
          boundary_corner(m.boundary_corner_), vertex_position(m.vertex_position_), vertex_corner(m.vertex_corner_),
          free_vertices(m.free_vertices_), free_faces(m.free_faces_)
    {
    }
    Column<Vertex>& corner_vertex;
    Column<Corner>&corner_next, &corner_previous;
    Column<Face>& corner_face;
    Column<Edge>& corner_edge;
    Column<std::array<Corner, 2>>& edge_corners;
    Column<Corner>& face_corner;
    Column<std::int32_t>& face_group;
    Column<Corner>& boundary_corner;
    Column<Point>& vertex_position;
    Column<Corner>& vertex_corner;
    std::vector<std::uint32_t>&free_vertices, &free_faces;
};

namespace {

using namespace test;

/// What check() says of the mesh after it was broken; check_change() must say something too where it can see it.
template <class Break>
std::string broken(Mesh mesh, Break&& break_it, bool seen_locally = true)
{
    EXPECT_SOUND(mesh);
    mesh.begin_change();
    MeshTestAccess access(mesh);
    break_it(access);
    const std::string whole = check(mesh);
    access.free_vertices.clear(); // a change ends without holes
    access.free_faces.clear();
    const std::string local = check_change(mesh, mesh.end_change());
    EXPECT_EQ(!local.empty(), seen_locally) << "check_change: " << local;
    return whole;
}

TEST(Check, SaysNothingOfASoundMesh)
{
    for (const NamedShape& shape : all_shapes()) {
        Mesh mesh = shape.make();
        EXPECT_EQ(check(mesh), "") << shape.name;
        mesh.begin_change();
        for (const Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v));
        for (const Face f : mesh.faces()) mesh.set_start(mesh.corner(f));
        EXPECT_EQ(check_change(mesh, mesh.end_change()), "") << shape.name;
    }
}

TEST(Check, LooksAtWhatChangedAndNoFurther)
{
    // A page of faces was written to, and in it one face changed; another one was broken before, where nobody looks.
    Mesh mesh = torus(20, 20);
    MeshTestAccess(mesh).face_group.set(7, -1);
    mesh.begin_change();
    for (const Face f : mesh.faces()) mesh.set_group(f, mesh.group(f));
    mesh.set_group(Face(9), 2);
    const MeshChange change = mesh.end_change();
    EXPECT_EQ(check(mesh), "face 7: its group -1 is negative");
    EXPECT_EQ(check_change(mesh, change), "");
}

TEST(Check, SeesAFaceThatStillBeginsWhereItsCornerWentAway)
{
    // All corners of a face go over to another one, which they do not belong to.
    EXPECT_EQ(broken(two_cubes(), [](auto& m) { for (std::uint32_t c = 0; c < 4; ++c) m.corner_face.set(c, Face(6)); }), "face 0: its start corner is not one of its own");
}

TEST(Check, NamesANeighbourThatIsNotAlive)
{
    EXPECT_EQ(broken(cube(), [](auto& m) { m.corner_next.set(5, Corner(99)); }), "corner 5: its neighbour in the face is not alive");
    EXPECT_EQ(broken(cube(), [](auto& m) { m.corner_previous.set(0, Corner()); }), "corner 0: its neighbour in the face is not alive");
}

TEST(Check, NamesNextAndPreviousThatDisagree)
{
    EXPECT_EQ(broken(cube(), [](auto& m) { m.corner_next.set(5, Corner(7)); }), "corner 5: next and previous are not each other's inverse");
    EXPECT_EQ(broken(cube(), [](auto& m) { m.corner_previous.set(0, Corner(2)); }), "corner 0: next and previous are not each other's inverse");
}

TEST(Check, NamesAVertexThatIsNotThere)
{
    EXPECT_EQ(broken(cube(), [](auto& m) { m.corner_vertex.set(0, Vertex(8)); }), "corner 0: its vertex is not alive");
}

TEST(Check, NamesAFaceThatIsNotThere)
{
    for (const Face f : {Face(6), Face(), Face::boundary(0)})
        EXPECT_EQ(broken(cube(), [f](auto& m) { m.corner_face.set(1, f); }), "corner 0: the next corner lies in another face");
    EXPECT_EQ(broken(cube(), [](auto& m) { for (std::uint32_t c = 0; c < 4; ++c) m.corner_face.set(c, Face(6)); }), "corner 0: its face is not alive");
    EXPECT_EQ(broken(open_grid(1, 1), [](auto& m) { for (std::uint32_t c = 4; c < 8; ++c) m.corner_face.set(c, Face::boundary(1)); }),
              "corner 4: its face is not alive");
}

TEST(Check, NamesACycleThroughTwoFaces)
{
    EXPECT_EQ(broken(cube(), [](auto& m) { m.corner_face.set(2, Face(1)); }), "corner 1: the next corner lies in another face");
}

TEST(Check, NamesAMissingEdge)
{
    EXPECT_EQ(broken(cube(), [](auto& m) { m.corner_edge.set(3, Edge()); }), "corner 3: it has no edge but is not a point sphere");
    EXPECT_EQ(broken(cube(), [](auto& m) { m.corner_edge.set(3, Edge(12)); }), "corner 3: its edge is not alive");
}

TEST(Check, NamesAnEdgeThatDoesNotKnowItsCorners)
{
    EXPECT_EQ(broken(cube(), [](auto& m) { m.edge_corners.set(0, {Corner(0), Corner(0)}); }), "corner 0: its edge does not name it as one of two corners");
    EXPECT_EQ(broken(cube(), [](auto& m) { m.edge_corners.set(0, {m.edge_corners[0][1], Corner(1)}); }),
              "corner 0: its edge does not name it as one of two corners");
    EXPECT_EQ(broken(cube(), [](auto& m) { m.edge_corners.set(0, {Corner(0), Corner(1)}); }), "corner 0: the corner across its edge does not have that edge");
}

TEST(Check, NamesSidesThatRunTheSameWay)
{
    // Two edges change one of their corners each: all references agree, but the sides along them do not.
    EXPECT_EQ(broken(cube(),
                     [](auto& m) {
                         const Corner a = m.edge_corners[0][1], b = m.edge_corners[1][1];
                         m.edge_corners.set(0, {m.edge_corners[0][0], b});
                         m.edge_corners.set(1, {m.edge_corners[1][0], a});
                         m.corner_edge.set(b.index, Edge(0));
                         m.corner_edge.set(a.index, Edge(1));
                     }),
              "corner 0: the side across its edge does not run against it");
}

TEST(Check, NamesAStartCornerOfAnotherFace)
{
    EXPECT_EQ(broken(cube(), [](auto& m) { m.face_corner.set(2, Corner(0)); }), "face 2: its start corner is not one of its own");
    EXPECT_EQ(broken(open_grid(1, 1), [](auto& m) { m.boundary_corner.set(0, Corner(0)); }), "boundary face 0: its start corner is not one of its own");
}

TEST(Check, NamesANegativeGroup)
{
    EXPECT_EQ(broken(cube(), [](auto& m) { m.face_group.set(4, -1); }), "face 4: its group -1 is negative");
}

TEST(Check, NamesAPositionThatIsNotFinite)
{
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        for (int k = 0; k < 3; ++k)
            EXPECT_EQ(broken(cube(),
                             [&](auto& m) {
                                 Point p(0);
                                 p[k] = bad;
                                 m.vertex_position.set(6, p);
                             }),
                      "vertex 6: its position lies beyond 1e+38");
}

TEST(Check, NamesAVertexCornerOfAnotherVertex)
{
    EXPECT_EQ(broken(cube(), [](auto& m) { m.vertex_corner.set(0, m.vertex_corner[1]); }), "vertex 0: its corner is not one of its own");
}

TEST(Check, CountsCornersThatNoFaceCanReach)
{
    // Two cycles under one face: seen by counting, not from any corner.
    EXPECT_EQ(broken(two_cubes(),
                     [](auto& m) {
                         for (std::uint32_t c = 0; c < 4; ++c) m.corner_face.set(c, Face(6));
                         m.face_corner.set(0, Corner());
                         m.free_faces.push_back(0);
                     },
                     false),
              "48 corners, but the faces pass through 44");
}

TEST(Check, CountsCornersThatNoVertexCanReach)
{
    // Two fans under one vertex: cubes that share a vertex.
    EXPECT_EQ(broken(two_cubes(),
                     [](auto& m) {
                         for (std::uint32_t c = 0; c < m.corner_vertex.size(); ++c)
                             if (m.corner_vertex[c] == Vertex(8)) m.corner_vertex.set(c, Vertex(0));
                         m.vertex_corner.set(8, Corner());
                         m.free_vertices.push_back(8);
                     },
                     false),
              "48 corners, but the rotations of the vertices pass through 45");
}

TEST(Check, CountsElementsThatAreGoneButNotToBeReused)
{
    EXPECT_EQ(broken(point_sphere(),
                     [](auto& m) {
                         m.corner_vertex.set(0, Vertex());
                         m.face_corner.set(0, Corner());
                         m.vertex_corner.set(0, Corner());
                     },
                     false),
              "vertices: 1 not alive, but 0 holes");
}

TEST(Check, SeesAnyWordThatWasOverwritten)
{
    // Any one reference of any shape replaced by another: the mesh is not sound, or means the same as before (another start).
    std::mt19937 random(1);
    int noticed = 0, harmless = 0;
    for (const NamedShape& shape : all_shapes())
        for (int round = 0; round < 300; ++round) {
            Mesh mesh = shape.make();
            if (mesh.vertex_count() < 2) continue;
            const Mesh before = mesh;
            MeshTestAccess m(mesh);
            const auto overwrite = [&](auto& column) {
                if (column.size() == 0) return;
                const auto i = static_cast<std::uint32_t>(random() % column.size()), j = static_cast<std::uint32_t>(random() % column.size());
                column.set(i, column[j]);
            };
            const unsigned which = random() % 8;
            switch (which) {
            case 0: overwrite(m.corner_vertex); break;
            case 1: overwrite(m.corner_next); break;
            case 2: overwrite(m.corner_previous); break;
            case 3: overwrite(m.corner_face); break;
            case 4: overwrite(m.corner_edge); break;
            case 5: overwrite(m.edge_corners); break;
            case 6: overwrite(m.face_corner); break;
            case 7: overwrite(m.vertex_corner); break;
            }
            if (mesh == before) {
                ++harmless;
                continue;
            }
            EXPECT_NE(check(mesh), "") << shape.name << ", column " << which;
            ++noticed;
        }
    EXPECT_GT(noticed, 5 * harmless);
}

} // namespace
} // namespace druse
