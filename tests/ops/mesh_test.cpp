// mesh.transform: order of the steps, exact right angles, and mirror images that keep their outside out.
#include "ops/mesh.h"

#include "run.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <cmath>

namespace druse {
namespace {

using namespace test;
using Arguments = std::vector<std::pair<std::string, std::string>>;

Point moved(const Point& p, const Arguments& arguments)
{
    Scene scene;
    scene.mesh.create_vertex(p);
    run(scene, "mesh.transform", arguments);
    return scene.mesh.position(Vertex(0));
}

TEST(Transform, ScalesThenTurnsThenMoves)
{
    EXPECT_EQ(moved({1, 2, 3}, {}), Point(1, 2, 3));
    EXPECT_EQ(moved({1, 2, 3}, {{"scale", "2"}}), Point(2, 4, 6));
    EXPECT_EQ(moved({1, 2, 3}, {{"scale", "2,3,-1"}}), Point(2, 6, -3));
    EXPECT_EQ(moved({1, 2, 3}, {{"move", "10,20,30"}}), Point(11, 22, 33));
    EXPECT_EQ(moved({1, 2, 3}, {{"scale", "2,1,1"}, {"rotate", "0,0,90"}, {"move", "0,0,1"}}), Point(-2, 2, 4));
}

TEST(Transform, TurnsRightAnglesWithoutRounding)
{
    EXPECT_EQ(moved({1, 2, 3}, {{"rotate", "90,0,0"}}), Point(1, -3, 2));
    EXPECT_EQ(moved({1, 2, 3}, {{"rotate", "0,90,0"}}), Point(3, 2, -1));
    EXPECT_EQ(moved({1, 2, 3}, {{"rotate", "0,0,-270"}}), Point(-2, 1, 3));
    EXPECT_EQ(moved({1, 2, 3}, {{"rotate", "90,90,0"}}), Point(2, -3, -1)); // about x first
    const Point p = moved({1, 0, 0}, {{"rotate", "0,0,30"}});
    EXPECT_NEAR(p.x, std::sqrt(3.0) / 2, 1e-16);
    EXPECT_EQ(p.y, 0.5);
    EXPECT_NEAR(moved({1, 0, 0}, {{"rotate", "0,0,30.25"}}).y, std::sin(30.25 * 3.141592653589793 / 180), 1e-15);
}

TEST(Transform, LeavesThePointItTurnsAboutInPlace)
{
    EXPECT_EQ(moved({5, 1, 1}, {{"rotate", "0,0,180"}, {"scale", "2"}, {"about", "4,1,1"}}), Point(2, 1, 1));
    Scene scene = scene_of(cube());
    run(scene, "mesh.transform", {{"move", "10,0,0"}});
    run(scene, "mesh.transform", {{"scale", "3"}, {"about", "center"}});
    EXPECT_EQ(bounds(scene.mesh).center(), Point(10, 0, 0));
    EXPECT_EQ(bounds(scene.mesh).size(), Vector(3.0));
    // A million units away a turn costs no digits of the shape.
    run(scene, "mesh.transform", {{"move", "1048576,0,0"}});
    run(scene, "mesh.transform", {{"rotate", "0,0,90"}, {"about", "center"}});
    EXPECT_EQ(bounds(scene.mesh).size(), Vector(3.0));
}

TEST(Transform, MovesChosenVerticesOnly)
{
    Scene scene = scene_of(cube());
    run(scene, "mesh.transform", {{"vertices", "4-7"}, {"scale", "0.5"}, {"move", "0,0,1"}});
    EXPECT_EQ(scene.mesh.position(Vertex(0)), Point(-0.5, -0.5, -0.5));
    EXPECT_EQ(scene.mesh.position(Vertex(6)), Point(0.25, 0.25, 1.25));
    const Mesh before = scene.mesh;
    run(scene, "mesh.transform", {{"vertices", "none"}, {"scale", "-2"}});
    EXPECT_TRUE(scene.mesh == before);
}

TEST(Transform, TurnsAMirrorImageOutward)
{
    for (const NamedShape& shape : all_shapes()) {
        Scene scene = scene_of(shape.make());
        const double before = volume(scene.mesh);
        const auto rings_before = rings(scene.mesh);
        run(scene, "mesh.transform", {{"scale", "-1,1,1"}});
        EXPECT_SOUND(scene.mesh);
        EXPECT_NEAR(volume(scene.mesh), before, 1e-12) << shape.name;
        const auto now = rings(scene.mesh);
        for (std::size_t f = 0; f < now.size(); ++f) {
            std::vector<std::uint32_t> back = now[f];
            std::reverse(back.begin() + 1, back.end()); // from the same start
            EXPECT_EQ(back, rings_before[f]) << shape.name;
        }
        run(scene, "mesh.transform", {{"scale", "-1,1,1"}});
        EXPECT_EQ(rings(scene.mesh), rings_before) << shape.name;
        EXPECT_SOUND(scene.mesh);
        run(scene, "mesh.transform", {{"scale", "-1,-1,1"}}); // half a turn
        EXPECT_EQ(rings(scene.mesh), rings_before) << shape.name;
    }
}

TEST(Transform, TurnsOnlyComponentsThatAreMirroredAsAWhole)
{
    Scene scene = scene_of(two_cubes());
    run(scene, "mesh.transform", {{"vertices", "0-7,8"}, {"scale", "-1,1,1"}});
    const auto parts = components(scene.mesh);
    EXPECT_EQ(parts.parts.size(), 2u);
    const auto was = rings(two_cubes()), now = rings(scene.mesh);
    for (std::size_t f = 0; f < 6; ++f) EXPECT_NE(now[f], was[f]);
    for (std::size_t f = 6; f < 12; ++f) EXPECT_EQ(now[f], was[f]);
    EXPECT_SOUND(scene.mesh);
}

TEST(Transform, RefusesZeroScaleTwoFactorsAndWhatDoesNotStayFinite)
{
    const auto refuses = [](const char* key, const char* value) { return complaint(scene_of(cube()), "mesh.transform", {{key, value}}); };
    EXPECT_EQ(refuses("scale", "0"), "expected any number but 0");
    EXPECT_EQ(refuses("scale", "1,2"), "scale: expected one or three numbers, found 2");
    EXPECT_EQ(refuses("scale", "1,2,3,4"), "expected 1 to 3 numbers, found 4");
    EXPECT_EQ(refuses("rotate", "90"), "expected 3 numbers, found 1");
    EXPECT_EQ(refuses("about", "middle"), "expected a point x,y,z, or origin or center");
    Mesh far = cube();
    far.set_position(Vertex(3), Point(1e308, 0, 0));
    EXPECT_EQ(complaint(scene_of(far), "mesh.transform", {{"scale", "10"}}), "vertex 3 would lie beyond 1e+38");
}

} // namespace
} // namespace druse
