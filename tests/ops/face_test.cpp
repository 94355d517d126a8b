// face.start: which corner a face begins with.
#include "ops/face.h"

#include "run.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace druse {
namespace {

using namespace test;
using Ids = std::vector<std::uint32_t>;

TEST(FaceStart, AtAVertexTurnsTheFacesThatHaveIt)
{
    Scene scene = scene_of(cube());
    const Ids before = ring(scene.mesh, Face(2));
    run(scene, "face.start", {{"faces", "all"}, {"vertex", "6"}});
    int turned = 0;
    for (const Face f : scene.mesh.faces()) {
        const Ids now = ring(scene.mesh, f);
        if (std::ranges::find(now, 6u) == now.end()) continue;
        EXPECT_EQ(now[0], 6u);
        ++turned;
    }
    EXPECT_EQ(turned, 3);
    Ids same = ring(scene.mesh, Face(2));
    std::rotate(same.begin(), std::ranges::find(same, before[0]), same.end());
    EXPECT_EQ(same, before);
    EXPECT_SOUND(scene.mesh);
    EXPECT_EQ(complaint(scene, "face.start", {{"faces", "0"}, {"vertex", "6"}}), "vertex=6: none of the faces has this vertex");
    EXPECT_EQ(complaint(scene, "face.start", {{"faces", "0"}, {"vertex", "8"}}), "there is no vertex 8: the vertices are 0 to 7");
    EXPECT_EQ(complaint(scene, "face.start", {{"vertex", "6"}}), "no faces are selected");
}

TEST(FaceStart, AtAVertexThatAFaceVisitsTwiceTakesTheFirstFromTheOldStart)
{
    Mesh mesh = cube_with_antenna(); // face 0 passes its first vertex before and after the antenna
    const Vertex base = mesh.vertex(mesh.previous(mesh.corner(Vertex(8))));
    std::vector<Corner> at_base;
    for (const Corner c : mesh.corners(Face(0)))
        if (mesh.vertex(c) == base) at_base.push_back(c);
    ASSERT_EQ(at_base.size(), 2u);
    mesh.set_start(mesh.next(at_base[0]));
    ASSERT_TRUE(start_at(mesh, Face(0), base));
    EXPECT_EQ(mesh.corner(Face(0)), at_base[1]);
}

TEST(FaceStart, ShiftsCounterClockwise)
{
    Scene scene;
    run(scene, "make.polygon", {{"n", "5"}});
    run(scene, "face.start", {{"shift", "2"}});
    EXPECT_EQ(ring(scene.mesh, Face(0)), (Ids{2, 3, 4, 0, 1}));
    EXPECT_EQ(ring(scene.mesh, Face(1)), (Ids{3, 2, 1, 0, 4})); // it looks down
    run(scene, "face.start", {{"shift", "-3"}});
    EXPECT_EQ(ring(scene.mesh, Face(0))[0], 4u);
    run(scene, "face.start", {{"faces", "0"}, {"shift", "1000000"}});
    EXPECT_EQ(ring(scene.mesh, Face(0))[0], 4u);
}

TEST(FaceStart, TurnsTowardADirection)
{
    Scene scene;
    run(scene, "make.polygon", {{"n", "6"}});
    run(scene, "face.start", {{"faces", "0"}, {"toward", "-1,0"}});
    EXPECT_EQ(ring(scene.mesh, Face(0))[0], 3u);
    // Vertices 1 and 2 are equally far up: the first one from the old start wins.
    run(scene, "face.start", {{"faces", "0"}, {"toward", "0,1"}});
    EXPECT_EQ(ring(scene.mesh, Face(0))[0], 1u); // from 3: 3, 4, 5, 0, 1
    run(scene, "face.start", {{"faces", "0"}, {"shift", "1"}});
    run(scene, "face.start", {{"faces", "0"}, {"toward", "0,1e100"}});
    EXPECT_EQ(ring(scene.mesh, Face(0))[0], 2u);
    // All tie: nothing moves.
    run(scene, "face.start", {{"faces", "0"}, {"toward", "0,0,-1"}});
    EXPECT_EQ(ring(scene.mesh, Face(0))[0], 2u);
    EXPECT_EQ(complaint(scene, "face.start", {{"faces", "0"}, {"toward", "0,0,0"}}), "toward=0,0,0: expected a direction, not 0");
}

TEST(FaceStart, TakesNoNoiseForADifference)
{
    Mesh mesh = cube();
    mesh.set_position(Vertex(2), mesh.position(Vertex(2)) + Vector(0, 1e-16, 0));
    for (const Face f : mesh.faces()) {
        const Corner before = mesh.corner(f);
        bool highest = true;
        for (const Corner c : mesh.corners(f)) highest = highest && mesh.position(before).y > mesh.position(c).y - 1e-9;
        start_toward(mesh, f, {0, 1, 0});
        if (highest) {
            EXPECT_EQ(mesh.corner(f), before);
        }
    }
}

TEST(FaceStart, WantsExactlyOneOfItsThreeWays)
{
    EXPECT_EQ(ops_registry().get("face.start").exclusive, (std::vector<std::vector<std::string>>{{"vertex", "shift", "toward"}}));
}

} // namespace
} // namespace druse
