// select.*: the three parts of the selection and how they grow, shrink and are found.
#include "ops/select.h"

#include "run.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace druse {
namespace {

using namespace test;
using Ids = std::vector<std::uint32_t>;

Scene grid_scene(const char* nx = "5", const char* ny = "5")
{
    Scene scene;
    run(scene, "make.grid", {{"nx", nx}, {"ny", ny}}); // face 25 lies below
    return scene;
}

void select_faces(Scene& scene, const char* faces, const char* mode = "set") { run(scene, "select.faces", {{"faces", faces}, {"mode", mode}}); }
Ids faces(const Scene& scene) { return ids(scene.selection->faces); }

TEST(SelectFaces, SetsAddsAndRemoves)
{
    Scene scene = grid_scene();
    select_faces(scene, "3,1,2");
    EXPECT_EQ(faces(scene), (Ids{1, 2, 3}));
    select_faces(scene, "2,8", "add");
    EXPECT_EQ(faces(scene), (Ids{1, 2, 3, 8}));
    select_faces(scene, "0-2", "remove");
    EXPECT_EQ(faces(scene), (Ids{3, 8}));
    select_faces(scene, "selected+9");
    EXPECT_EQ(faces(scene), (Ids{3, 8, 9}));
    select_faces(scene, "none");
    EXPECT_EQ(faces(scene), Ids());
    EXPECT_EQ(complaint(scene, "select.faces", {{"faces", "selected"}}), "no faces are selected");
    EXPECT_EQ(complaint(scene, "select.faces", {{"faces", "26"}}), "there is no face 26: the faces are 0 to 25");
    EXPECT_EQ(complaint(scene, "select.faces", {{"faces", "0"}, {"mode", "toggle"}}), "expected set, add or remove");
}

TEST(SelectFaces, LeavesTheOtherPartsAlone)
{
    Scene scene = grid_scene();
    run(scene, "select.edges", {{"edges", "0~1"}});
    run(scene, "select.vertices", {{"vertices", "valence:2"}});
    select_faces(scene, "4");
    EXPECT_EQ(ids(scene.selection->edges), Ids{0});
    EXPECT_EQ(ids(scene.selection->vertices), (Ids{0, 5, 30, 35}));
    EXPECT_EQ(faces(scene), Ids{4});
}

// --- grow and shrink --------------------------------------------------------------------------------------------------------------

TEST(SelectGrow, OfFacesStepsAcrossSharedVertices)
{
    Scene scene = grid_scene();
    select_faces(scene, "12"); // the middle
    run(scene, "select.grow");
    EXPECT_EQ(faces(scene), (Ids{6, 7, 8, 11, 12, 13, 16, 17, 18}));
    run(scene, "select.shrink");
    EXPECT_EQ(faces(scene), Ids{12});
    run(scene, "select.grow", {{"steps", "2"}});
    EXPECT_EQ(faces(scene).size(), 25u); // all but the face below
    run(scene, "select.grow");
    EXPECT_EQ(faces(scene).size(), 26u);
    run(scene, "select.shrink", {{"steps", "1000"}}); // nothing outside: nothing to lose
    EXPECT_EQ(faces(scene).size(), 26u);
}

TEST(SelectGrow, OfVerticesStepsAlongEdges)
{
    Scene scene = grid_scene();
    run(scene, "select.vertices", {{"vertices", "14"}}); // (2, 2)
    run(scene, "select.grow", {{"of", "vertices"}});
    EXPECT_EQ(ids(scene.selection->vertices), (Ids{8, 13, 14, 15, 20}));
    run(scene, "select.grow", {{"of", "vertices"}});
    EXPECT_EQ(ids(scene.selection->vertices).size(), 13u);
    run(scene, "select.shrink", {{"of", "vertices"}, {"steps", "2"}});
    EXPECT_EQ(ids(scene.selection->vertices), Ids{14});
}

TEST(SelectGrow, OfEdgesStepsAcrossTheirEnds)
{
    Scene scene = grid_scene();
    run(scene, "select.edges", {{"edges", "14~15"}});
    run(scene, "select.grow", {{"of", "edges"}});
    EXPECT_EQ(ids(scene.selection->edges).size(), 7u);
    run(scene, "select.shrink", {{"of", "edges"}});
    EXPECT_EQ(scene.selection->edges.size(), 1u);
}

TEST(SelectGrow, DoesNotCountTheFaceThatClosesAnOpening)
{
    Scene scene = scene_of(open_grid(3, 2));
    select_faces(scene, "all");
    run(scene, "select.shrink");
    EXPECT_EQ(faces(scene).size(), 6u);
    select_faces(scene, "0");
    run(scene, "select.grow", {{"steps", "1000"}});
    EXPECT_EQ(faces(scene).size(), 6u);
}

TEST(SelectGrow, NeedsASelection)
{
    EXPECT_EQ(complaint(scene_of(cube()), "select.grow"), "no faces are selected");
    EXPECT_EQ(complaint(scene_of(cube()), "select.shrink", {{"of", "edges"}}), "no edges are selected");
    EXPECT_EQ(complaint(scene_of(cube()), "select.grow", {{"steps", "1001"}}), "expected 1 to 1000 (an integer)");
}

TEST(SelectGrow, WorksOnEveryShape)
{
    for (const NamedShape& shape : all_shapes()) {
        Scene scene = scene_of(shape.make());
        for (const char* of : {"faces", "edges", "vertices"}) {
            run(scene, "select.invert", {{"of", of}});
            if (scene.mesh.edge_count() == 0) continue;
            run(scene, "select.grow", {{"of", of}, {"steps", "3"}});
            run(scene, "select.shrink", {{"of", of}, {"steps", "3"}});
        }
        EXPECT_EQ(scene.selection->faces.size(), scene.mesh.face_count()) << shape.name;
        EXPECT_EQ(scene.selection->edges.size(), scene.mesh.edge_count()) << shape.name;
        EXPECT_EQ(scene.selection->vertices.size(), scene.mesh.vertex_count()) << shape.name;
    }
}

TEST(SelectInvert, TakesWhatWasNotSelected)
{
    Scene scene = scene_of(cube());
    select_faces(scene, "1,4");
    run(scene, "select.invert");
    EXPECT_EQ(faces(scene), (Ids{0, 2, 3, 5}));
    run(scene, "select.invert", {{"of", "vertices"}});
    EXPECT_EQ(scene.selection->vertices.size(), 8u);
    EXPECT_EQ(faces(scene), (Ids{0, 2, 3, 5}));
}

// --- loops and rings ------------------------------------------------------------------------------------------------------------

TEST(SelectLoop, OnATorusGoesStraightRoundEitherWay)
{
    Scene scene = scene_of(torus(7, 5));
    // Vertex i·5 + j: 0~1 runs round the tube, 0~5 round the axis.
    run(scene, "select.loop", {{"edge", "0~1"}});
    EXPECT_EQ(scene.selection->edges.size(), 5u);
    run(scene, "select.loop", {{"edge", "0~5"}});
    EXPECT_EQ(scene.selection->edges.size(), 7u);
    run(scene, "select.loop", {{"edge", "0~1"}, {"kind", "ring"}});
    EXPECT_EQ(scene.selection->edges.size(), 7u);
    run(scene, "select.loop", {{"edge", "0~1"}, {"kind", "faces"}});
    EXPECT_EQ(scene.selection->faces.size(), 7u);
    run(scene, "select.loop", {{"edge", "0~5"}, {"kind", "faces"}, {"mode", "add"}});
    EXPECT_EQ(scene.selection->faces.size(), 11u); // 7 + 5, and one lies in both
}

TEST(SelectLoop, EndsWhereAVertexHasNotFourEdges)
{
    Scene scene = grid_scene();
    // From (2, 2) to (3, 2) straight on as far as the rim, whose vertices have three edges.
    run(scene, "select.loop", {{"edge", "14~15"}});
    Ids expected;
    for (const std::uint32_t from : {12u, 13u, 14u, 15u, 16u}) {
        Scene one = scene;
        run(one, "select.edges", {{"edges", std::to_string(from) + "~" + std::to_string(from + 1)}});
        expected.push_back(one.selection->edges[0].index);
    }
    std::ranges::sort(expected);
    EXPECT_EQ(ids(scene.selection->edges), expected);
    // On the cube nothing goes straight on.
    Scene box = scene_of(cube());
    run(box, "select.loop", {{"edge", "3"}});
    EXPECT_EQ(ids(box.selection->edges), Ids{3});
    run(box, "select.loop", {{"edge", "3"}, {"kind", "ring"}});
    EXPECT_EQ(box.selection->edges.size(), 4u);
    run(box, "select.loop", {{"edge", "3"}, {"kind", "faces"}});
    EXPECT_EQ(box.selection->faces.size(), 4u);
}

TEST(SelectLoop, EndsAtAnOpenBoundaryAndAtFacesThatAreNoQuads)
{
    Scene scene = scene_of(open_grid(3, 2));
    // The ring of the left side of the first row: its four upright edges.
    run(scene, "select.loop", {{"edge", "0~4"}, {"kind", "ring"}});
    EXPECT_EQ(scene.selection->edges.size(), 4u);
    run(scene, "select.loop", {{"edge", "0~4"}, {"kind", "faces"}});
    EXPECT_EQ(ids(scene.selection->faces), (Ids{0, 1, 2}));
    run(scene, "select.loop", {{"edge", "5~6"}}); // between the rows, from rim to rim
    EXPECT_EQ(scene.selection->edges.size(), 3u);
    run(scene, "select.loop", {{"edge", "0~1"}});
    EXPECT_EQ(scene.selection->edges.size(), 1u);
    Scene prism = scene_of(test::prism(6));
    run(prism, "select.loop", {{"edge", "0~1"}, {"kind", "ring"}}); // bottom edge, side, top edge
    EXPECT_EQ(prism.selection->edges.size(), 2u);
    EXPECT_EQ(complaint(prism, "select.loop", {{"edge", "0~8"}}), "no edge joins vertices 0 and 8");
}

TEST(SelectLoop, EndsOnEveryEdgeOfEveryShape)
{
    for (const NamedShape& shape : all_shapes()) {
        const Mesh mesh = shape.make();
        for (const Edge e : mesh.edges()) {
            const auto loop = edge_loop(mesh, e);
            const Ring ring = edge_ring(mesh, e);
            EXPECT_TRUE(std::ranges::binary_search(loop, e)) << shape.name;
            EXPECT_TRUE(std::ranges::binary_search(ring.edges, e)) << shape.name;
            // Whatever edge of a loop is picked, the loop is the same.
            EXPECT_EQ(edge_loop(mesh, loop.back()), loop) << shape.name;
            EXPECT_EQ(edge_ring(mesh, ring.edges.back()).edges, ring.edges) << shape.name;
            for (const Face f : ring.faces) EXPECT_EQ(mesh.valence(f), 4) << shape.name;
        }
    }
}

// --- similar --------------------------------------------------------------------------------------------------------------------

TEST(SelectSimilar, ComparesFaces)
{
    Scene scene = scene_of(test::prism(6)); // hexagons 0 and 7
    select_faces(scene, "3");
    run(scene, "select.similar");
    EXPECT_EQ(faces(scene), (Ids{1, 2, 3, 4, 5, 6}));
    select_faces(scene, "0");
    run(scene, "select.similar", {{"by", "area"}});
    EXPECT_EQ(faces(scene), (Ids{0, 7}));
    run(scene, "select.similar", {{"by", "area"}, {"tolerance", "0.7"}}); // 1 differs from 2.598 by 0.615 of it
    EXPECT_EQ(faces(scene).size(), 8u);
    select_faces(scene, "1");
    run(scene, "select.similar", {{"by", "normal"}});
    EXPECT_EQ(faces(scene), Ids{1});
    run(scene, "select.similar", {{"by", "normal"}, {"tolerance", "60"}});
    EXPECT_EQ(faces(scene), (Ids{1, 2, 6}));
    run(scene, "select.similar", {{"by", "normal"}, {"tolerance", "180"}});
    EXPECT_EQ(faces(scene).size(), 8u);
    for (const Face f : scene.mesh.faces()) scene.mesh.set_group(f, int(f.index) / 3);
    select_faces(scene, "4");
    run(scene, "select.similar", {{"by", "group"}});
    EXPECT_EQ(faces(scene), (Ids{3, 4, 5}));
}

TEST(SelectSimilar, ComparesEdgesAndVertices)
{
    Scene scene = scene_of(pyramid(7));
    run(scene, "select.vertices", {{"vertices", "2"}});
    run(scene, "select.similar", {{"by", "valence"}});
    EXPECT_EQ(scene.selection->vertices.size(), 7u);
    run(scene, "select.edges", {{"edges", "0~1"}});
    run(scene, "select.similar", {{"by", "length"}, {"tolerance", "1e-9"}});
    EXPECT_EQ(scene.selection->edges.size(), 7u);
    EXPECT_EQ(complaint(scene, "select.similar", {{"by", "sides"}}), "no faces are selected");
    EXPECT_EQ(complaint(scene, "select.similar", {{"tolerance", "-1"}}), "expected 0 or more");
}

// --- groups -----------------------------------------------------------------------------------------------------------------------

TEST(SelectGroup, TakesAllFacesOfGroups)
{
    Scene scene = scene_of(cube());
    for (const Face f : scene.mesh.faces()) scene.mesh.set_group(f, int(f.index) / 2);
    run(scene, "select.group", {{"ids", "2"}});
    EXPECT_EQ(faces(scene), (Ids{4, 5}));
    run(scene, "select.group", {{"ids", "0"}, {"mode", "add"}});
    EXPECT_EQ(faces(scene), (Ids{0, 1, 4, 5}));
    run(scene, "select.group", {{"ids", "all"}});
    EXPECT_EQ(faces(scene), (Ids{2, 3, 4, 5}));
    EXPECT_EQ(complaint(scene, "select.group", {{"ids", "1,9"}}), "no face has group 9");
}

} // namespace
} // namespace druse
