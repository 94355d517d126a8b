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

Mesh block(const Vector& size)
{
    Mesh mesh = cube();
    for (const Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v) * size);
    return mesh;
}

std::vector<std::string> words(const Json& list) { return list.get<std::vector<std::string>>(); }

TEST(CheckPrint, HasNothingAgainstABlock)
{
    const Json json = asked(block(Vector(10, 20, 30)), "check.print");
    EXPECT_EQ(json["printable"], true);
    EXPECT_TRUE(json["problems"].empty());
    EXPECT_TRUE(json["warnings"].empty());
    EXPECT_EQ(json["units"], "mm");
    EXPECT_NEAR(json["size"][2].get<double>(), 30, 1e-12);
    EXPECT_EQ(json["watertight"], true);
    EXPECT_EQ(json["oriented"], true);
    EXPECT_EQ(json["self_intersections"], 0);
    EXPECT_NEAR(json["thinnest_wall"].get<double>(), 10, 1e-9);
    EXPECT_EQ(json["thin_walls"], Json({{"count", 0}, {"faces", "none"}}));
    EXPECT_FALSE(fails(block(Vector(10, 20, 30)), "check.print", {{"strict", "true"}}));
}

TEST(CheckPrint, FindsThinWallsAndFeatures)
{
    const Mesh plate = block(Vector(10, 20, 0.6)); // below the wall of 0.8, above the nozzle of 0.4
    const Json json = asked(plate, "check.print");
    EXPECT_EQ(words(json["problems"]), std::vector<std::string>{"thin_walls"});
    EXPECT_NEAR(json["thinnest_wall"].get<double>(), 0.6, 1e-12);
    EXPECT_EQ(json["thin_walls"]["count"], 2);
    EXPECT_EQ(json["thin_features"]["count"], 0);
    EXPECT_TRUE(fails(plate, "check.print", {{"strict", "true"}}));
    EXPECT_FALSE(fails(plate, "check.print"));
    EXPECT_FALSE(fails(plate, "check.print", {{"strict", "true"}, {"wall", "0.5"}}));
    EXPECT_EQ(words(asked(plate, "check.print", {{"nozzle", "0.7"}})["problems"]), (std::vector<std::string>{"thin_walls", "thin_features"}));
    EXPECT_EQ(words(asked(plate, "check.print", {{"nozzle", "0.7"}, {"wall", "0.1"}})["problems"]), std::vector<std::string>{"thin_features"});
}

TEST(CheckPrint, FindsSelfIntersections)
{
    Mesh mesh = block(Vector(10));
    Mesh other = block(Vector(10));
    for (const Vertex v : other.vertices()) other.set_position(v, other.position(v) + Vector(5, 3, 2));
    mesh.append(other);
    const Json json = asked(mesh, "check.print");
    EXPECT_EQ(words(json["problems"]), std::vector<std::string>{"self_intersections"});
    EXPECT_EQ(json["self_intersecting"]["count"], 6);
    EXPECT_GE(json["self_intersections"], 6);
    EXPECT_TRUE(fails(mesh, "check.print", {{"strict", "true"}}));
    // What it names can be selected.
    Scene scene = scene_of(mesh);
    run(scene, "select.faces", {{"faces", json["self_intersecting"]["faces"].get<std::string>()}});
    EXPECT_EQ(scene.selection->faces.size(), 6u);
}

TEST(CheckPrint, FindsOpenAndEmptyModels)
{
    EXPECT_EQ(words(asked(Mesh(), "check.print")["problems"]), std::vector<std::string>{"empty"});
    const Json open = asked(open_tube(5), "check.print");
    EXPECT_EQ(open["problems"][0], "open");
    EXPECT_EQ(open["boundary_edges"], 10);
    EXPECT_TRUE(fails(Mesh(), "check.print", {{"strict", "true"}}));
}

TEST(CheckPrint, KnowsACavityFromASolidInsideOut)
{
    const Face any(0);
    Mesh reversed = block(Vector(10));
    reversed.reverse_components({&any, 1});
    EXPECT_EQ(words(asked(reversed, "check.print")["problems"]), std::vector<std::string>{"inside_out"});

    // A cavity of side 5 in a block of side 10, concentric; and beside it.
    const Point centre = bounds(reversed).center();
    Mesh cavity = reversed;
    for (const Vertex v : cavity.vertices()) cavity.set_position(v, centre + 0.5 * (cavity.position(v) - centre));
    Mesh hollow = block(Vector(10));
    hollow.append(cavity);
    EXPECT_EQ(asked(hollow, "check.print")["oriented"], true);
    EXPECT_EQ(asked(hollow, "check.print")["printable"], true);
    for (const Vertex v : cavity.vertices()) cavity.set_position(v, cavity.position(v) + Vector(30, 0, 0));
    Mesh beside = block(Vector(10));
    beside.append(cavity);
    EXPECT_EQ(asked(beside, "check.print")["components_inside_out"], 1);
}

TEST(CheckPrint, WarnsOfOverhangsAndUnits)
{
    Mesh bridge = voxels({{0, 0, 0}, {2, 0, 0}, {0, 0, 1}, {1, 0, 1}, {2, 0, 1}}); // two legs and a beam, of cubes of side 1
    for (const Vertex v : bridge.vertices()) bridge.set_position(v, 10.0 * bridge.position(v));
    const Json json = asked(bridge, "check.print");
    EXPECT_EQ(json["printable"], true);
    EXPECT_EQ(words(json["warnings"]), std::vector<std::string>{"overhang"});
    EXPECT_EQ(json["overhang"]["count"], 1);
    EXPECT_NEAR(json["overhang"]["area"].get<double>(), 100, 1e-9);
    EXPECT_NEAR(json["overhang"]["share"].get<double>(), 1.0 / 22, 1e-12); // 5 cubes have 30 sides, of which 8 are joined
    EXPECT_FALSE(fails(bridge, "check.print", {{"strict", "true"}}));
    EXPECT_TRUE(words(asked(bridge, "check.print", {{"overhang", "90"}})["warnings"]).empty());

    EXPECT_EQ(words(asked(block(Vector(2000, 10, 10)), "check.print")["warnings"]), std::vector<std::string>{"units"});
    EXPECT_EQ(words(asked(block(Vector(0.01)), "check.print")["warnings"]), std::vector<std::string>{"units"});
}

TEST(Check, AsksEveryShape)
{
    for (const NamedShape& shape : all_shapes())
        for (const char* name : {"check.print", "check.manifold", "check.planarity"}) EXPECT_TRUE(asked(shape.make(), name).is_object()) << shape.name;
}

TEST(Check, IsNoStepOfTheHistory)
{
    for (const Operator& op : ops_registry().operators()) EXPECT_EQ(op.kind == Operator::Kind::query, op.family() == "check" || op.name.ends_with(".check")) << op.name;
}

} // namespace
} // namespace druse
