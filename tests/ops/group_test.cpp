// group.*: ids, colours and names of face groups.
#include "ops/group.h"

#include "run.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <random>

namespace druse {
namespace {

using namespace test;
using Arguments = std::vector<std::pair<std::string, std::string>>;
using Groups = std::vector<int>;

Scene scene_with(Mesh mesh, const Groups& groups)
{
    for (const Face f : mesh.faces()) mesh.set_group(f, groups[f.index]);
    return scene_of(std::move(mesh));
}
Groups after(Scene scene, const char* name, const Arguments& arguments = {})
{
    run(scene, name, arguments);
    return groups(scene.mesh);
}

TEST(GroupAssign, PutsFacesIntoAGroup)
{
    const Scene scene = scene_with(cube(), {0, 0, 4, 4, 7, 0});
    EXPECT_EQ(after(scene, "group.assign", {{"faces", "0,2"}, {"id", "5"}}), (Groups{5, 0, 5, 4, 7, 0}));
    EXPECT_EQ(after(scene, "group.assign", {{"faces", "0,4"}, {"id", "new"}}), (Groups{8, 0, 4, 4, 8, 0}));
    EXPECT_EQ(after(scene, "group.assign", {{"faces", "all"}, {"id", "0"}}), Groups(6, 0));
    EXPECT_EQ(complaint(scene, "group.assign", {{"id", "5"}}), "no faces are selected");
    EXPECT_EQ(complaint(scene, "group.assign", {{"faces", "0"}, {"id", "-1"}}), "expected 0 to 2147483647 (an integer), or new");
}

TEST(GroupAssign, RefusesIdsThatNoIntegerHolds)
{
    const Scene scene = scene_with(cube(), {2147483647, 0, 0, 0, 0, 0});
    EXPECT_EQ(complaint(scene, "group.assign", {{"faces", "1"}, {"id", "new"}}), "group ids would pass 2147483647; group.renumber makes them small");
    EXPECT_EQ(complaint(scene, "group.by", {{"rule", "normal"}, {"start", "2147483643"}}), "start=2147483643: 6 group ids from here on pass 2147483647");
    EXPECT_EQ(after(scene, "group.by", {{"rule", "normal"}, {"start", "2147483642"}}).back(), 2147483647);
}

TEST(GroupClear, UngroupsAllUnlessToldOtherwise)
{
    const Scene scene = scene_with(cube(), {1, 1, 2, 2, 3, 3});
    EXPECT_EQ(after(scene, "group.clear"), Groups(6, 0));
    EXPECT_EQ(after(scene, "group.clear", {{"faces", "group:2"}}), (Groups{1, 1, 0, 0, 3, 3}));
}

TEST(GroupMerge, KeepsTheSmallestIdUnlessToldOtherwise)
{
    const Scene scene = scene_with(cube(), {9, 1, 3, 5, 7, 0});
    EXPECT_EQ(after(scene, "group.merge", {{"ids", "7,3,9"}}), (Groups{3, 1, 3, 5, 3, 0}));
    EXPECT_EQ(after(scene, "group.merge", {{"ids", "7,3,9"}, {"into", "9"}}), (Groups{9, 1, 9, 5, 9, 0}));
    EXPECT_EQ(after(scene, "group.merge", {{"ids", "7,3"}, {"into", "20"}}), (Groups{9, 1, 20, 5, 20, 0}));
    EXPECT_EQ(after(scene, "group.merge", {{"ids", "all"}}), (Groups{1, 1, 1, 1, 1, 0}));
    EXPECT_EQ(complaint(scene, "group.merge", {{"ids", "3,4"}}), "no face has group 4");
}

TEST(GroupSplit, ByComponentsGivesAPieceForEachPatch)
{
    // The cube's faces look along −z, −y, +x, +y, −x, +z: 0 and 5 do not touch, 1 and 3 neither.
    const Scene scene = scene_with(cube(), {2, 6, 4, 6, 4, 2});
    EXPECT_EQ(after(scene, "group.split", {{"by", "components"}}), (Groups{2, 6, 4, 9, 8, 7}));
    EXPECT_EQ(after(scene, "group.split", {{"ids", "6"}, {"by", "components"}}), (Groups{2, 6, 4, 7, 4, 2}));
    EXPECT_EQ(after(scene_with(cube(), {2, 2, 2, 2, 2, 2}), "group.split", {{"by", "components"}}), Groups(6, 2));
    EXPECT_EQ(after(scene_with(two_cubes(), Groups(12, 1)), "group.split", {{"by", "components"}}), (Groups{1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2}));
}

TEST(GroupSplit, BySidesAndByNormal)
{
    const Scene prism = scene_with(test::prism(6), Groups(8, 3));
    EXPECT_EQ(after(prism, "group.split", {{"by", "sides"}}), (Groups{3, 4, 4, 4, 4, 4, 4, 3}));
    EXPECT_EQ(after(prism, "group.split", {{"by", "normal"}}), (Groups{3, 4, 5, 6, 7, 8, 9, 10}));
    // 60 degrees: each side joins the first within reach: 1, 2 and 6 together, 3 and 4 with the next one, 5.
    EXPECT_EQ(after(prism, "group.split", {{"by", "normal"}, {"angle", "60"}}), (Groups{3, 4, 4, 5, 5, 6, 4, 7}));
    EXPECT_EQ(complaint(prism, "group.split", {{"by", "normal"}, {"ids", "4"}}), "no face has group 4");
    EXPECT_EQ(complaint(prism, "group.split", {{"by", "normal"}, {"angle", "181"}}), "expected 0 to 180 degrees");
}

TEST(GroupSplit, ThatFindsOnePieceNeedsNoNewId)
{
    EXPECT_EQ(after(scene_with(cube(), Groups(6, 2147483647)), "group.split", {{"by", "sides"}}), Groups(6, 2147483647));
}

TEST(GroupBy, SidesAscend)
{
    const Scene scene = scene_with(test::prism(6), Groups(8, 9));
    EXPECT_EQ(after(scene, "group.by", {{"rule", "sides"}}), (Groups{2, 1, 1, 1, 1, 1, 1, 2}));
    EXPECT_EQ(after(scene, "group.by", {{"rule", "sides"}, {"start", "5"}}), (Groups{6, 5, 5, 5, 5, 5, 5, 6}));
    EXPECT_EQ(after(scene, "group.by", {{"rule", "sides"}, {"absolute", "true"}}), (Groups{6, 4, 4, 4, 4, 4, 4, 6}));
    EXPECT_EQ(complaint(scene, "group.by", {{"rule", "area"}, {"absolute", "true"}}), "absolute=true: goes with rule=sides only");
    EXPECT_EQ(complaint(scene, "group.by", {{"rule", "sides"}, {"tolerance", "3"}}), "tolerance=3: goes with rule=color only");
    // Also with the value that they have unless given.
    EXPECT_EQ(complaint(scene, "group.by", {{"rule", "components"}, {"absolute", "false"}}), "absolute=false: goes with rule=sides only");
    EXPECT_EQ(complaint(scene, "group.by", {{"rule", "area"}, {"tolerance", "0"}}), "tolerance=0: goes with rule=color only");
    EXPECT_EQ(after(scene, "group.by", {{"rule", "sides"}, {"absolute", "false"}}), after(scene, "group.by", {{"rule", "sides"}}));
    EXPECT_EQ(complaint(scene, "group.by", {{"rule", "sides"}, {"start", "0"}}), "expected 1 to 2147483647 (an integer)");
    EXPECT_EQ(complaint(scene, "group.by", {{"rule", "colour"}}), "expected sides, components, normal, area or color");
}

TEST(GroupBy, AreasAscendAndAreEqualWithinAMillionth)
{
    Mesh mesh = l_prism(); // sides 2, 1, 1, 1, 1, 2 long; the L's have area 3
    EXPECT_EQ(after(scene_of(mesh), "group.by", {{"rule", "area"}}), (Groups{3, 2, 1, 1, 1, 1, 2, 3}));
    mesh.set_position(Vertex(2), mesh.position(Vertex(2)) + Vector(0, 3e-7, 0));
    EXPECT_EQ(after(scene_of(mesh), "group.by", {{"rule", "area"}}), (Groups{3, 2, 1, 1, 1, 1, 2, 3}));
    mesh.set_position(Vertex(2), mesh.position(Vertex(2)) + Vector(0, 1e-5, 0));
    EXPECT_GT(after(scene_of(mesh), "group.by", {{"rule", "area"}})[2], 1);
}

TEST(GroupBy, ComponentsAndNormalsStartWithTheLowestFace)
{
    EXPECT_EQ(after(scene_of(two_cubes()), "group.by", {{"rule", "components"}}), (Groups{1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2}));
    EXPECT_EQ(after(scene_of(two_cubes()), "group.by", {{"rule", "normal"}}), (Groups{1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(after(scene_of(two_cubes()), "group.by", {{"rule", "normal"}, {"angle", "90"}}), (Groups{1, 1, 1, 1, 1, 2, 1, 1, 1, 1, 1, 2}));
    EXPECT_EQ(after(scene_of(two_cubes()), "group.by", {{"rule", "normal"}, {"angle", "180"}}), Groups(12, 1));
}

TEST(GroupBy, NormalIsTheRuleThatComparesEachFaceWithTheFirstOfEveryGroup)
{
    // The plain way, face against group, on bumpy tori.
    std::mt19937 random(1);
    for (const double angle : {0.0, 0.5, 5.0, 31.0, 90.0, 135.0}) {
        Mesh mesh = torus(24, 16);
        for (const Vertex v : mesh.vertices())
            mesh.set_position(v, mesh.position(v) + 0.02 * Vector(random() % 100, random() % 100, random() % 100) / 100.0);
        std::vector<Vector> first;
        Groups expected;
        for (const Face f : mesh.faces()) {
            const Vector n = unit_normal(mesh, f);
            std::size_t at = 0;
            while (at < first.size() && 2 * std::atan2(glm::distance(n, first[at]), glm::length(n + first[at])) * 180 / 3.141592653589793 > angle + 1e-9) ++at;
            if (at == first.size()) first.push_back(n);
            expected.push_back(int(at) + 1);
        }
        EXPECT_EQ(after(scene_of(mesh), "group.by", {{"rule", "normal"}, {"angle", std::to_string(angle)}}), expected) << angle;
    }
}

TEST(GroupBy, ColourJoinsWhatLooksAlikeAndKeepsItsLook)
{
    Scene scene = scene_with(cube(), {7, 3, 5, 7, 9, 0});
    GroupTable& table = scene.groups.edit();
    table.set_colour(7, {10, 10, 10});
    table.set_colour(3, {200, 0, 0});
    table.set_colour(5, {12, 10, 9});
    table.set_colour(9, {10, 10, 10});
    Scene exact = scene;
    run(exact, "group.by", {{"rule", "color"}});
    EXPECT_EQ(groups(exact.mesh), (Groups{1, 2, 3, 1, 1, 4}));
    EXPECT_EQ(exact.groups->colour(1), (Colour{10, 10, 10}));
    EXPECT_EQ(exact.groups->colour(2), (Colour{200, 0, 0}));
    EXPECT_EQ(exact.groups->colour(3), (Colour{12, 10, 9}));
    EXPECT_EQ(exact.groups->colour(4), (Colour{204, 204, 204}));
    EXPECT_EQ(after(scene, "group.by", {{"rule", "color"}, {"tolerance", "1"}}), (Groups{1, 2, 3, 1, 1, 4}));
    EXPECT_EQ(after(scene, "group.by", {{"rule", "color"}, {"tolerance", "2"}}), (Groups{1, 2, 1, 1, 1, 3}));
    EXPECT_EQ(after(scene, "group.by", {{"rule", "color"}, {"tolerance", "255"}}), Groups(6, 1));
    EXPECT_EQ(complaint(scene, "group.by", {{"rule", "color"}, {"tolerance", "256"}}), "expected 0 to 255 (an integer)");
}

TEST(GroupBy, ColourIsTheRuleThatComparesEachColourWithEveryGroup)
{
    std::mt19937 random(2);
    for (const int tolerance : {0, 1, 7, 40}) {
        Scene scene;
        run(scene, "make.grid", {{"nx", "20"}, {"ny", "20"}});
        GroupTable& table = scene.groups.edit();
        std::vector<Colour> first;
        Groups expected;
        for (const Face f : scene.mesh.faces()) {
            const Colour c{std::uint8_t(random() % 100), std::uint8_t(150 + random() % 106), std::uint8_t(random() % 30)};
            scene.mesh.set_group(f, int(f.index) + 1);
            table.set_colour(int(f.index) + 1, c);
            std::size_t at = 0;
            while (at < first.size() && std::max({std::abs(c.red - first[at].red), std::abs(c.green - first[at].green), std::abs(c.blue - first[at].blue)}) > tolerance)
                ++at;
            if (at == first.size()) first.push_back(c);
            expected.push_back(int(at) + 1);
        }
        EXPECT_EQ(after(scene, "group.by", {{"rule", "color"}, {"tolerance", std::to_string(tolerance)}}), expected);
    }
}

TEST(GroupRenumber, CountsFromOneByLowestFaceAndTakesColoursAndNamesAlong)
{
    Scene scene = scene_with(cube(), {40, 0, 2, 40, 9, 2});
    GroupTable& table = scene.groups.edit();
    table.set_colour(2, {1, 2, 3});
    table.set_name(40, "roof");
    table.set_colour(77, {7, 7, 7}); // no face has it: it is remembered all the same
    run(scene, "group.renumber");
    EXPECT_EQ(groups(scene.mesh), (Groups{1, 0, 2, 1, 3, 2}));
    EXPECT_EQ(scene.groups->colour(1), GroupTable::default_colour(40));
    EXPECT_EQ(scene.groups->name(1), "roof");
    EXPECT_EQ(scene.groups->colour(2), (Colour{1, 2, 3}));
    EXPECT_EQ(scene.groups->name(2), "");
    EXPECT_EQ(scene.groups->colour(3), GroupTable::default_colour(9));
    EXPECT_EQ(scene.groups->name(40), "");
    EXPECT_EQ(scene.groups->colour(77), (Colour{7, 7, 7}));
    const Scene before = scene;
    run(scene, "group.renumber");
    EXPECT_TRUE(scene.mesh == before.mesh && *scene.groups == *before.groups);
}

TEST(GroupColour, IsGivenAndTakenBack)
{
    Scene scene = scene_with(cube(), {1, 2, 1, 2, 0, 0});
    run(scene, "group.color", {{"id", "2"}, {"color", "#3366ff"}});
    EXPECT_EQ(scene.groups->colour(2), (Colour{0x33, 0x66, 0xff}));
    EXPECT_EQ(scene.groups->colour(1), GroupTable::default_colour(1));
    run(scene, "group.color", {{"id", "all"}, {"color", "#000001"}});
    EXPECT_EQ(scene.groups->colour(1), (Colour{0, 0, 1}));
    EXPECT_EQ(scene.groups->colour(0), (Colour{204, 204, 204}));
    run(scene, "group.color", {{"id", "2"}, {"color", "auto"}});
    EXPECT_EQ(scene.groups->colour(2), GroupTable::default_colour(2));
    EXPECT_EQ(complaint(scene, "group.color", {{"id", "9"}, {"color", "auto"}}), "no face has group 9");
    EXPECT_EQ(complaint(scene, "group.color", {{"id", "1"}, {"color", "blue"}}), "expected a colour #rrggbb, or auto");
}

TEST(GroupName, IsOneWord)
{
    Scene scene = scene_with(cube(), {1, 2, 1, 2, 0, 0});
    run(scene, "group.name", {{"id", "2"}, {"name", "Dächer"}});
    EXPECT_EQ(scene.groups->name(2), "Dächer");
    EXPECT_EQ(complaint(scene, "group.name", {{"id", "9"}, {"name", "a"}}), "no face has group 9");
    EXPECT_EQ(complaint(scene, "group.name", {{"id", "1"}, {"name", "a b"}}), "name=\"a b\": expected one word");
    EXPECT_EQ(complaint(scene, "group.name", {{"id", "1"}, {"name", ""}}), "name=\"\": expected one word");
}

TEST(Groups, WorkOnEveryShapeAndMoveNothing)
{
    for (const NamedShape& shape : all_shapes())
        for (const char* rule : {"sides", "components", "normal", "area", "color"}) {
            Scene scene = scene_of(shape.make());
            const Mesh before = scene.mesh;
            run(scene, "group.by", {{"rule", rule}});
            for (const Face f : scene.mesh.faces()) EXPECT_GE(scene.mesh.group(f), 1) << shape.name;
            for (const char* by : {"components", "sides", "normal"}) run(scene, "group.split", {{"by", by}});
            run(scene, "group.renumber");
            if (const auto ids = existing_groups(scene.mesh); !ids.empty()) {
                EXPECT_EQ(ids.front(), 1) << shape.name;
                EXPECT_EQ(ids.back(), int(ids.size())) << shape.name;
            }
            run(scene, "group.clear");
            Mesh plain = before;
            for (const Face f : plain.faces()) plain.set_group(f, 0);
            EXPECT_TRUE(scene.mesh == plain) << shape.name << " " << rule;
        }
}

} // namespace
} // namespace druse
