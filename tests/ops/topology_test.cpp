// topology.*: the effects of the minimal operators on V, E, F and χ, on ids and on the selection.
#include "dlfl/mesh_builder.h"
#include "run.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace druse {
namespace {

using namespace test;
using Ids = std::vector<std::uint32_t>;

TEST(InsertEdge, SplitsAFaceIntoTwoOfItsGroup)
{
    Scene scene = scene_of(cube());
    scene.mesh.set_group(Face(5), 4);
    run(scene, "topology.insert_edge", {{"c1", "5:0"}, {"c2", "5:2"}});
    EXPECT_EQ(counts(scene.mesh), (Counts{8, 13, 7}));
    EXPECT_EQ(scene.mesh.valence(Face(5)), 3);
    EXPECT_EQ(scene.mesh.valence(Face(6)), 3);
    EXPECT_EQ(scene.mesh.group(Face(6)), 4);
    EXPECT_SOUND(scene.mesh);
    EXPECT_EQ(genus(scene.mesh), 0);
}

TEST(InsertEdge, BetweenFacesOfAComponentAddsAHandle)
{
    Scene scene = scene_of(cube());
    run(scene, "topology.insert_edge", {{"c1", "0:0"}, {"c2", "5:0"}});
    EXPECT_EQ(counts(scene.mesh), (Counts{8, 13, 5}));
    EXPECT_EQ(genus(scene.mesh), 1);
    EXPECT_EQ(scene.mesh.valence(Face(0)), 10);
    EXPECT_SOUND(scene.mesh);
}

TEST(InsertEdge, BetweenComponentsJoinsThem)
{
    Scene scene = scene_of(two_cubes());
    run(scene, "topology.insert_edge", {{"c1", "2:0"}, {"c2", "10:0"}});
    EXPECT_EQ(counts(scene.mesh), (Counts{16, 25, 11}));
    EXPECT_EQ(components(scene.mesh).parts.size(), 1u);
    EXPECT_EQ(genus(scene.mesh), 0);
    EXPECT_SOUND(scene.mesh);
}

TEST(InsertEdge, RefusesALoopInsideACornerAndCornersThatAreNotThere)
{
    const Scene scene = scene_of(cube());
    EXPECT_EQ(complaint(scene, "topology.insert_edge", {{"c1", "3:1"}, {"c2", "3:1"}}), "c1 and c2 are the same corner 3:1");
    EXPECT_EQ(complaint(scene, "topology.insert_edge", {{"c1", "6:0"}, {"c2", "3:1"}}), "there is no face 6: the faces are 0 to 5");
    EXPECT_EQ(complaint(scene, "topology.insert_edge", {{"c1", "3:4"}, {"c2", "3:1"}}), "face 3 has corners 0 to 3, not 4");
    EXPECT_EQ(complaint(scene, "topology.insert_edge", {{"c1", "3"}, {"c2", "3:1"}}), "expected a corner FACE:K");
}

TEST(DeleteEdge, UndoesASplitAndLeavesTheGroupOfTheLowerFace)
{
    Scene scene = scene_of(cube());
    for (const Face f : scene.mesh.faces()) scene.mesh.set_group(f, int(f.index) + 1);
    const auto [a, b] = scene.mesh.faces(Edge(0));
    const Face stays = std::min(a, b);
    run(scene, "topology.delete_edge", {{"edges", "0"}});
    EXPECT_EQ(counts(scene.mesh), (Counts{8, 11, 5}));
    EXPECT_EQ(scene.mesh.valence(stays), 6);
    EXPECT_EQ(scene.mesh.group(stays), int(stays.index) + 1);
    EXPECT_SOUND(scene.mesh);
}

TEST(DeleteEdge, TakesAHandleAwayOrAComponentApart)
{
    Scene handle = scene_of(cube_with_edge_handle());
    run(handle, "topology.delete_edge", {{"edges", "12"}});
    EXPECT_EQ(counts(handle.mesh), (Counts{8, 12, 6}));
    EXPECT_EQ(genus(handle.mesh), 0);
    Scene tether = scene_of(tethered_cubes());
    run(tether, "topology.delete_edge", {{"edges", "24"}});
    EXPECT_EQ(counts(tether.mesh), (Counts{16, 24, 12}));
    EXPECT_EQ(components(tether.mesh).parts.size(), 2u);
    EXPECT_SOUND(tether.mesh);
}

TEST(DeleteEdge, CleansUpPointSpheresUnlessToldOtherwise)
{
    Scene scene = scene_of(segment());
    run(scene, "topology.delete_edge", {{"edges", "all"}, {"cleanup", "false"}});
    EXPECT_EQ(counts(scene.mesh), (Counts{2, 0, 2}));
    scene = scene_of(segment());
    run(scene, "topology.delete_edge", {{"edges", "all"}});
    EXPECT_EQ(counts(scene.mesh), Counts());
    scene = scene_of(cube_with_antenna());
    run(scene, "topology.delete_edge", {{"edges", "12"}});
    EXPECT_EQ(counts(scene.mesh), (Counts{8, 12, 6}));
    EXPECT_SOUND(scene.mesh);
}

TEST(DeleteEdge, TakesEveryEdgeOfEveryClosedShape)
{
    for (const NamedShape& shape : all_shapes()) {
        Scene scene = scene_of(shape.make());
        if (scene.mesh.boundary_count() > 0) continue;
        std::uint32_t point_spheres = 0;
        for (const Vertex v : scene.mesh.vertices()) point_spheres += scene.mesh.is_point_sphere(v);
        run(scene, "topology.delete_edge", {{"edges", "all"}});
        EXPECT_EQ(counts(scene.mesh), (Counts{point_spheres, 0, point_spheres})) << shape.name; // those there were before stay
        EXPECT_SOUND(scene.mesh);
    }
}

TEST(DeleteEdge, LeavesOpenBoundariesAlone)
{
    const Scene scene = scene_of(open_grid(1, 1));
    EXPECT_EQ(complaint(scene, "topology.delete_edge", {{"edges", "2"}}), "edge 2 lies on an open boundary");
    EXPECT_EQ(complaint(scene, "topology.delete_edge"), "no edges are selected");
}

TEST(DeleteEdge, KeepsSelectedWhatSurvivesAndNothingElse)
{
    // Faces 0 and 4 … of two cubes joined by a tether: one edge merges faces, another lets a face fall apart into a new one that takes
    // the freed id. The new face was never selected.
    Scene scene = scene_of(tethered_cubes());
    Face goes;
    Edge merging;
    for (const Edge e : scene.mesh.edges()) {
        const auto [a, b] = scene.mesh.faces(e);
        if (a == b || merging.valid()) continue;
        merging = e;
        goes = std::max(a, b);
    }
    scene.selection.edit().faces = {goes, Face(goes.index + 1)};
    run(scene, "topology.delete_edge", {{"edges", std::to_string(merging.index) + ",24"}});
    EXPECT_EQ(ids(scene.selection->faces), Ids{goes.index + 1});
    EXPECT_EQ(counts(scene.mesh), (Counts{16, 23, 11}));
}

TEST(DeleteEdge, TakesApartAgainAFaceThatItMade)
{
    // A prism and a cube joined by a tether, 64 faces in all, and the joined face with the tether comes first. When the tether goes, that
    // face falls apart, and its other part is number 64: beyond all faces there were, and deleted with its edges later on.
    Scene joined;
    run(joined, "make.prism", {{"n", "57"}});
    run(joined, "make.cube");
    const Mesh& apart = joined.mesh;
    run(joined, "topology.insert_edge", {{"c1", "3:0"}, {"c2", std::to_string(apart.face_count() - 1) + ":0"}});
    MeshBuilder builder;
    for (const Vertex v : apart.vertices()) builder.add_vertex(apart.position(v));
    const auto add = [&](Corner first) {
        std::vector<std::uint32_t> ring;
        for (Corner c = first; ring.empty() || c != first; c = apart.next(c)) ring.push_back(apart.vertex(c).index);
        builder.add_face(ring);
    };
    const Corner tether = apart.corner(Edge(apart.edge_count() - 1), 0);
    add(tether);
    for (const Face f : apart.faces())
        if (f != apart.face(tether)) add(apart.corner(f));
    Scene scene = scene_of(builder.build());
    ASSERT_EQ(scene.mesh.face_limit(), 64u);

    scene.selection.edit().faces = {Face(0), Face(63)};
    run(scene, "topology.delete_edge", {{"edges", "all"}});
    EXPECT_SOUND(scene.mesh);
    EXPECT_EQ(scene.mesh.edge_count(), 0u);
    for (const Face f : scene.selection->faces) EXPECT_LT(f.index, 64u);
}

TEST(CreateVertex, AddsAPointSphereAndDeleteVertexTakesItAway)
{
    Scene scene = scene_of(cube());
    run(scene, "topology.create_vertex", {{"at", "1,2"}});
    run(scene, "topology.create_vertex", {{"at", "1,2,3"}});
    EXPECT_EQ(counts(scene.mesh), (Counts{10, 12, 8}));
    EXPECT_EQ(scene.mesh.position(Vertex(8)), Point(1, 2, 0));
    EXPECT_EQ(scene.mesh.position(Vertex(9)), Point(1, 2, 3));
    EXPECT_EQ(complaint(scene, "topology.delete_vertex", {{"vertices", "0,8"}}), "vertex 0 is no point sphere: it has 3 edges");
    run(scene, "topology.delete_vertex", {{"vertices", "8"}});
    EXPECT_EQ(counts(scene.mesh), (Counts{9, 12, 7}));
    EXPECT_EQ(scene.mesh.position(Vertex(8)), Point(1, 2, 3));
    run(scene, "topology.delete_vertex", {{"vertices", "valence:0"}});
    EXPECT_EQ(counts(scene.mesh), (Counts{8, 12, 6}));
    EXPECT_TRUE(scene.mesh == cube());
    EXPECT_EQ(complaint(scene_of(segment()), "topology.delete_vertex", {{"vertices", "1"}}), "vertex 1 is no point sphere: it has 1 edge");
}

TEST(Topology, BuildsATetrahedronFromFourPoints)
{
    Scene scene;
    for (const char* at : {"0,0,0", "1,0,0", "0,1,0", "0,0,1"}) run(scene, "topology.create_vertex", {{"at", at}});
    run(scene, "topology.insert_edge", {{"c1", "0:0"}, {"c2", "1:0"}}); // 0–1: the faces 2 and 3 move down
    run(scene, "topology.insert_edge", {{"c1", "0:1"}, {"c2", "1:0"}}); // 1–2
    run(scene, "topology.insert_edge", {{"c1", "0:0"}, {"c2", "0:2"}}); // 2–0 closes a triangle with two sides
    EXPECT_EQ(counts(scene.mesh), (Counts{4, 3, 3}));
    run(scene, "topology.insert_edge", {{"c1", "0:0"}, {"c2", "1:0"}});
    EXPECT_EQ(euler_characteristic(scene.mesh), 4 - 4 + 2);
    EXPECT_SOUND(scene.mesh);
}

} // namespace
} // namespace druse
