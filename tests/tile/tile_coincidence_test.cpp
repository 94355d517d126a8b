// Each way in which a cutter and a landscape can lie upon each other, and the four types of the paper with many outlines, reliefs and stacks.
#include "dlfl/measures.h"
#include "support/mesh_checks.h"
#include "tile/carve.h"
#include "tile/layered_facts.h"
#include "tile/tile_check.h"
#include "tile/tile_inset.h"
#include "tile/tile_stack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace druse {
namespace {

/// A square of side 10 with two points inside and a line between them: its landscape has vertices at (0,0), (3,4), (7,4) and edges between all that see each other.
LayeredTile square_tile(const std::vector<Point2>& lower = {}, const std::vector<Point2>& right = {})
{
    LayeredTile tile = LayeredTile::of_type(41, 10);
    if (!lower.empty()) tile.set_path(0, lower);
    if (!right.empty()) tile.set_path(1, right);
    tile.add_point({3, 4});
    tile.add_point({7, 4});
    tile.constrain(std::array{PointName::interior(0), PointName::interior(1)});
    tile.extrude(5);
    for (int i = 0; i < tile.point_count(); ++i) tile.set_heights(std::array{i}, 0.1 * (i % 7));
    return tile;
}

void expect_well_carved(LayeredTile tile, const Point2& offset)
{
    tile.set_stack({TileStack::Mode::shift, offset, 0});
    const TileSolid solid = make_solid(tile);
    EXPECT_NEAR(volume(solid), 5 * tile.area(), 1e-9 * 5 * tile.area());
    const HeightFinder top(tile.surface());
    for (const Point& p : solid.bottom.points) {
        const Point2 below = Point2(p) + offset;
        EXPECT_NEAR(p.z, top.at(inverse(tile.motion(tile.copy_at(below)))(below)), 1e-7);
    }
    double shortest = 1e300;
    for (const auto& t : solid.bottom.triangles)
        for (std::size_t i = 0; i < 3; ++i) shortest = std::min(shortest, glm::length(Point2(solid.bottom.points[t[i]] - solid.bottom.points[t[(i + 1) % 3]])));
    EXPECT_GE(shortest, tile.weld());
    const Mesh mesh = mesh_of(solid);
    EXPECT_SOUND(mesh);
    EXPECT_EQ(mesh.boundary_count(), 0u);
    EXPECT_EQ(int(mesh.vertex_count()) - int(mesh.edge_count()) + int(mesh.face_count()), 2);
}

struct Coincidence {
    const char* name;
    Point2 offset;
};

class EachCoincidence : public testing::TestWithParam<Coincidence> {};

TEST_P(EachCoincidence, IsCarvedExactly)
{
    expect_well_carved(square_tile(), GetParam().offset);
    expect_well_carved(square_tile({{0.2, 0.1}, {0.5, 0.0}, {0.8, -0.1}}, {{0.3, -0.05}, {0.6, 0.05}}), GetParam().offset);
}

INSTANTIATE_TEST_SUITE_P(Carving, EachCoincidence,
                         testing::Values(Coincidence{"NoOffset", {0, 0}}, Coincidence{"ALatticeVector", {10, -20}},
                                         Coincidence{"AVertexOnAVertex", {3, 4}},                // corner 0 over i0
                                         Coincidence{"AVertexOnASide", {3, 2}},                  // i0 below the lower side, at (0,2)
                                         Coincidence{"ACornerOnAnEdge", {5, 4}},                 // over the line from i0 to i1
                                         Coincidence{"SidesInPart", {2.5, 0}}, Coincidence{"SidesWholly", {0, 10}},
                                         Coincidence{"SidesInLineWithVertices", {4, 0}},         // points of the lower side over others of it
                                         Coincidence{"OneUlpOff", {std::nextafter(3.0, 4.0), 4}}, Coincidence{"JustLeft", {5, 4 + 1e-10}},
                                         Coincidence{"JustRight", {5, 4 - 1e-10}}, Coincidence{"JustBeyondTheWeld", {5, 4 + 3e-8}}),
                         [](const auto& made) { return made.param.name; });

TEST(CarvingCoincidence, OfAnEdgeThatTouchesTheOutlineFromInside)
{
    // The lower side has a peak at (5,1); shifted by (0,−3) the line from (3,4) to (7,4) of the landscape runs through that peak.
    expect_well_carved(square_tile({{0.3, 0.0}, {0.5, 0.1}, {0.7, 0.0}}), {0, 3});
}

TEST(CarvingCoincidence, OfACutterThatComesBackToTheSameTriangle)
{
    // Teeth shorter than the triangles that they cut.
    std::vector<Point2> teeth;
    for (int i = 1; i < 20; ++i) teeth.emplace_back(i / 20.0, i % 2 == 0 ? 0.03 : -0.03);
    for (const Point2 offset : {Point2(4.1, 5.3), Point2(0.25, 0.3), Point2(5, 5), Point2(0, 0.3)}) expect_well_carved(square_tile(teeth, teeth), offset);
}

TEST(CarvingCoincidence, StaysExactWhileTheOffsetIsDraggedThroughAThousandPlaces)
{
    LayeredTile tile = square_tile({{0.25, 0.1}, {0.6, -0.12}}, {{0.5, 0.08}});
    std::mt19937 random(11);
    const auto uniform = [&](double from, double to) { return from + (to - from) * (double(random()) / 4294967296.0); };
    Point2 offset(0, 0);
    for (int step = 0; step < 1000; ++step) {
        // Small steps, and now and then on a feature: a point of the tile over a point of the landscape, or just beside one.
        offset += Point2(uniform(-0.3, 0.35), uniform(-0.3, 0.3));
        if (step % 3 == 0) {
            const auto point = [&] { return tile.position(int(random() % unsigned(tile.point_count()))); };
            offset = point() - point();
            if (step % 2 == 0) offset += Point2(uniform(-2e-9, 2e-9), uniform(-2e-9, 2e-9));
        }
        tile.set_stack({TileStack::Mode::shift, offset, 0});
        const TileSolid solid = make_solid(tile);
        ASSERT_NEAR(volume(solid), 5 * tile.area(), 1e-6) << offset.x << "," << offset.y;
        for (const auto& t : solid.bottom.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                ASSERT_GE(glm::length(Point2(solid.bottom.points[t[i]] - solid.bottom.points[t[(i + 1) % 3]])), tile.weld()) << offset.x << "," << offset.y;
    }
}

class TypeOfThePaper : public testing::TestWithParam<int> {};

TEST_P(TypeOfThePaper, FillsPlaneAndSpaceWithFiftyOutlines)
{
    std::mt19937 random(static_cast<unsigned>(1000 + GetParam()));
    const auto uniform = [&](double from, double to) { return from + (to - from) * (double(random()) / 4294967296.0); };
    for (int made = 0; made < 50; ++made) {
        SCOPED_TRACE(made);
        LayeredTile tile = LayeredTile::of_type(GetParam(), 20);
        for (int path = 0; path < int(tile.type().shapes.size()); ++path)
            for (bool fits = false; !fits;) {
                std::vector<Point2> points;
                for (const double u : {0.15, 0.4, 0.65, 0.85})
                    if (u < 0.5 || tile.type().shapes[std::size_t(path)] == PathShape::free) points.emplace_back(u + uniform(-0.06, 0.06), uniform(-0.1, 0.1));
                try {
                    tile.set_path(path, points);
                    fits = true;
                } catch (const PaneRefusal&) { // it would cross another one
                }
            }
        FlatBox box;
        for (const OutlinePoint& p : tile.outline().points) box.add(p.position);
        const std::vector<Point2> polygon = tile.outline().positions();
        for (int tries = 0; tries < 12; ++tries)
            if (const Point2 p(uniform(box.min.x, box.max.x), uniform(box.min.y, box.max.y)); contains(polygon, p)) tile.add_point(p);
        tile.extrude(6);
        for (int i = 0; i < tile.point_count(); ++i) tile.set_heights(std::array{i}, uniform(-2, 2));
        const IsohedralOffsets offsets(tile.aspects(), tile.lattice(), {});
        tile.set_stack({TileStack::Mode::shift, offsets.nearest({uniform(-30, 30), uniform(-30, 30)}), 0});

        const TileSolid solid = make_solid(tile);
        EXPECT_NEAR(volume(solid), 6 * tile.area(), 1e-12 * std::sqrt(double(solid.faces())) * 6 * tile.area());
        const Mesh mesh = mesh_of(solid);
        EXPECT_SOUND(mesh);
        EXPECT_EQ(mesh.boundary_count(), 0u);
        EXPECT_EQ(genus(mesh), 0);
        for (int a = 1; a < tile.type().aspects(); ++a) {
            // Congruent: at the same places the same heights.
            const TileSolid other = make_solid(tile, TileBottom::carved, a);
            const HeightFinder own(solid.bottom);
            for (const Point& p : other.bottom.points) ASSERT_NEAR(p.z, own.at(Point2(p)), 1e-9 * 20 * 10) << "aspect " << a;
        }
        // The bottom is the top of the layer below, at a thousand places; and two thousand places of a cell lie in one copy each.
        const HeightFinder bottom(solid.bottom), top(tile.surface());
        std::vector<Isometry> back;
        for (const TileCopy& copy : tile.copies_in(box.grown(60))) back.push_back(inverse(tile.motion(copy)));
        const auto holders = [&](const Point2& p) {
            std::vector<Point2> found;
            for (const Isometry& m : back)
                if (const Point2 q = m(p); contains(polygon, q)) found.push_back(q);
            return found;
        };
        for (int sample = 0; sample < 2000; ++sample) {
            const Point2 p = uniform(0, 1) * tile.lattice()[0] + uniform(0, 1) * tile.lattice()[1];
            ASSERT_EQ(holders(p).size(), 1u) << p.x << "," << p.y;
        }
        const Isometry below = stack_motion(tile.design().stack);
        for (int sample = 0; sample < 1000;) {
            const Point2 p(uniform(box.min.x, box.max.x), uniform(box.min.y, box.max.y));
            if (!contains(polygon, p)) continue;
            ++sample;
            const Point2 q = below(p);
            ASSERT_NEAR(bottom.at(p), top.at(inverse(tile.motion(tile.copy_at(q)))(q)), 1e-7) << p.x << "," << p.y;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Types, TypeOfThePaper, testing::Values(1, 41, 79, 31), [](const auto& made) { return "IH" + std::to_string(made.param); });

TEST(TileClearance, OfAFreeStackKeepsItsDifferentSolidsApart)
{
    LayeredTile tile = LayeredTile::of_type(79, 20);
    tile.set_path(0, {{0.333, 0.125}, {0.667, -0.125}});
    tile.add_point({10, 4});
    tile.extrude(6);
    tile.set_heights(std::array{tile.find(PointName::interior(0))}, 2);
    tile.set_stack({TileStack::Mode::free, {5, 5}, 0});
    const TileCheck found = check(tile, 0.4);
    EXPECT_EQ(found.faults, std::vector<std::string>{});
    EXPECT_EQ(found.solid->members, 4);
    EXPECT_EQ(found.parts.size(), 4u);
    EXPECT_GE(found.solid->clearance, 0.4 - 1e-6 * 20);
    EXPECT_LT(found.solid->volume_left, 600);
}

TEST(TileClearance, IsKeptBetweenSteepPlacesNarrowerThanTheJoint)
{
    // A gorge half as wide as the joint, with walls of 60 degrees: what lies beside it must move too.
    LayeredTile tile = LayeredTile::of_type(41, 20);
    for (const double x : {9.7, 9.85, 10.0, 10.15, 10.3})
        for (const double y : {6.0, 8.0, 10.0, 12.0, 14.0}) tile.add_point({x, y});
    tile.extrude(6);
    for (int i = 10; i < 15; ++i) tile.set_heights(std::array{tile.find(PointName::interior(i))}, -0.26);
    tile.set_stack({TileStack::Mode::shift, {10, 3}, 0});
    const TileCheck found = check(tile, 0.6);
    EXPECT_EQ(found.faults, std::vector<std::string>{});
    EXPECT_GE(found.solid->clearance, 0.6 - 1e-6 * 20);
}

TEST(TileClearance, LeavesNoEdgeShorterThanItsWeld)
{
    // Edges of the relief run from the corners of the outline inwards, so near to where those of the joint lie as points in files have digits.
    struct Case {
        int type;
        TileStack stack;
    };
    using enum TileStack::Mode;
    std::mt19937 random(5);
    const auto uniform = [&](double from, double to) { return from + (to - from) * (double(random()) / 4294967296.0); };
    for (const Case& c : {Case{1, {shift, {13.1, 7.3}, 0}}, Case{41, {shift, {20, 0}, 0}}, Case{79, {shift, {20, 20}, 0}}, Case{31, {mirror, {0, 0}, 0}}, Case{79, {free, {5, 3}, 0}}})
        for (const double noise : {0.0, 1e-8, 1e-7, 1e-6, 1e-5}) {
            LayeredTile tile = LayeredTile::of_type(c.type, 40);
            for (const Point2& p : inset(tile.outline().positions(), 1, tile.weld()).polygon) tile.add_point(p + Point2(uniform(-noise, noise), uniform(-noise, noise)));
            tile.extrude(6);
            for (int i = 0; i < tile.point_count(); ++i) tile.set_heights(std::array{i}, uniform(-0.3, 0.3));
            tile.set_stack(c.stack);
            for (const double clearance : {0.2, 0.3, 0.4}) {
                const TileSolid solid = make_solid(tile, TileBottom::carved, 0, clearance);
                double shortest = 1e300;
                for (const HeightField* field : {&solid.top, &solid.bottom})
                    for (const auto& t : field->triangles)
                        for (std::size_t i = 0; i < 3; ++i) shortest = std::min(shortest, glm::length(Point2(field->points[t[i]] - field->points[t[(i + 1) % 3]])));
                EXPECT_GE(shortest, joint_weld * 40) << c.type << " " << noise << " " << clearance;
                const Mesh mesh = mesh_of(solid);
                EXPECT_SOUND(mesh);
                EXPECT_EQ(mesh.boundary_count(), 0u);
                EXPECT_EQ(int(mesh.vertex_count()) - int(mesh.edge_count()) + int(mesh.face_count()), 2);
            }
            if (noise == 1e-7) {
                EXPECT_EQ(check(tile, 0.3).faults, std::vector<std::string>{}) << c.type;
            }
        }
}

TEST(TileAssemblyCheck, LetsATileLeaveUpwardsOnly)
{
    LayeredTile tile = straight_tile(references()[3]);
    EXPECT_EQ(check(tile).solid->leaves, (std::vector<std::array<int, 3>>{{0, 0, 1}}));
}

TEST(TileParts, AreLeftAndRightWhereAspectsOrLayersAreMirrored)
{
    const auto parts_of = [](int type, const TileStack& stack) {
        LayeredTile tile = LayeredTile::of_type(type, 10);
        tile.set_stack(stack);
        std::vector<std::array<int, 2>> list;
        for (const TilePart& part : tile_parts(tile)) list.push_back({part.member, part.mirrored});
        return list;
    };
    using List = std::vector<std::array<int, 2>>;
    using enum TileStack::Mode;
    EXPECT_EQ(parts_of(31, {}), (List{{0, 0}}));
    EXPECT_EQ(parts_of(43, {}), (List{{0, 0}, {0, 1}}));                       // pg: every other tile is a reflection
    EXPECT_EQ(parts_of(31, {mirror, {0, 0}, 0}), (List{{0, 0}, {0, 1}}));
    EXPECT_EQ(parts_of(79, {free, {5, 0}, 0}), (List{{0, 0}, {1, 0}}));        // half a side of the square of four: 2-fold centres
}

} // namespace
} // namespace druse
