// check.*: what they find, and that they only look.
#include "run.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <nlohmann/json.hpp>

namespace druse {
namespace {

using namespace test;
using Json = nlohmann::json;

Json asked(const Mesh& mesh, const char* name, const std::vector<std::pair<std::string, std::string>>& arguments = {})
{
    Scene scene = scene_of(mesh);
    const Said said = run(scene, name, arguments);
    EXPECT_TRUE(scene.mesh == mesh);
    return Json::parse(said.output);
}

bool fails(const Mesh& mesh, const char* name, const std::vector<std::pair<std::string, std::string>>& arguments = {})
{
    Scene scene = scene_of(mesh);
    return run(scene, name, arguments).failed;
}

TEST(CheckManifold, KnowsAClosedSurfaceAndItsGenus)
{
    const Json cube_facts = asked(cube(), "check.manifold");
    EXPECT_EQ(cube_facts.at("manifold"), true);
    EXPECT_EQ(cube_facts.at("oriented"), true);
    EXPECT_EQ(cube_facts.at("watertight"), true);
    EXPECT_EQ(cube_facts.at("genus"), 0);
    EXPECT_EQ(cube_facts.at("euler"), 2);
    EXPECT_EQ(asked(block_with_holes(5), "check.manifold").at("genus"), 5);
    EXPECT_EQ(asked(two_cubes(), "check.manifold").at("components"), 2);
    EXPECT_FALSE(fails(cube(), "check.manifold", {{"strict", "true"}}));
}

TEST(CheckManifold, KnowsAnOpenSurface)
{
    const Json facts = asked(open_tube(5), "check.manifold");
    EXPECT_EQ(facts.at("manifold"), true);
    EXPECT_EQ(facts.at("watertight"), false);
    EXPECT_EQ(facts.at("boundary_edges"), 10);
    EXPECT_EQ(facts.at("boundary_loops"), 2);
    EXPECT_FALSE(fails(open_tube(5), "check.manifold"));
    EXPECT_TRUE(fails(open_tube(5), "check.manifold", {{"strict", "true"}}));
}

TEST(CheckManifold, NamesWhatOnlyAFaceListHolds)
{
    EXPECT_EQ(asked(point_sphere(), "check.manifold").at("point_spheres"), 1);
    EXPECT_EQ(asked(three_lunes(), "check.manifold").at("parallel_edges"), 2);
    EXPECT_EQ(asked(dihedron(5), "check.manifold").at("zero_thickness_walls"), 1);
    for (const NamedShape& shape : all_shapes()) EXPECT_EQ(asked(shape.make(), "check.manifold").at("manifold"), true) << shape.name;
}

TEST(CheckPlanarity, MeasuresTheFarthestCorner)
{
    const Json flat = asked(l_prism(), "check.planarity");
    EXPECT_EQ(flat.at("planar"), true);
    EXPECT_EQ(flat.at("warped_faces"), 0);
    // A unit square with one corner lifted by h: its corners lie h/4 off the plane to first order.
    Mesh mesh = dihedron(4);
    mesh.set_position(Vertex(0), mesh.position(Vertex(0)) + Vector(0, 0, 1e-4));
    const Json warped = asked(mesh, "check.planarity");
    EXPECT_EQ(warped.at("planar"), false);
    EXPECT_EQ(warped.at("warped_faces"), 2);
    EXPECT_NEAR(warped.at("max_nonplanarity").get<double>(), 0.25e-4, 1e-10);
    EXPECT_EQ(warped.at("worst_face").get<int>() / 2, 0);
    EXPECT_EQ(asked(mesh, "check.planarity", {{"tolerance", "1e-4"}}).at("planar"), true);
    EXPECT_TRUE(fails(mesh, "check.planarity", {{"strict", "true"}}));
    EXPECT_FALSE(fails(mesh, "check.planarity", {{"strict", "true"}, {"tolerance", "1e-4"}}));
    EXPECT_FALSE(fails(mesh, "check.planarity"));
}

TEST(Check, AsksEveryShape)
{
    for (const NamedShape& shape : all_shapes())
        for (const char* name : {"check.manifold", "check.planarity"}) EXPECT_TRUE(asked(shape.make(), name).is_object()) << shape.name;
}

TEST(Check, IsNoStepOfTheHistory)
{
    for (const Operator& op : ops_registry().operators()) EXPECT_EQ(op.kind == Operator::Kind::query, op.family() == "check") << op.name;
}

} // namespace
} // namespace druse
