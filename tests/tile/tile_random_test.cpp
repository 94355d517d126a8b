// Tiles of all types with random outlines, points, heights and stacks.
#include "geom/predicates.h"
#include "tile/carve.h"
#include "tile/layered_facts.h"
#include "tile/tile_check.h"
#include "tile/tile_stack.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <vector>

namespace druse {
namespace {

using Random = std::mt19937;

double uniform(Random& random, double from, double to) { return from + (to - from) * (double(random()) / 4294967296.0); }

std::vector<Point2> some_path(const IsohedralType& type, int path, Random& random)
{
    std::vector<Point2> points;
    const bool half = is_half_stored(type, path);
    for (const double u : {0.2, 0.4, 0.7}) {
        if (half && u > 0.5) break;
        points.emplace_back(u + uniform(random, -0.08, 0.08), type.shapes[path] == PathShape::straight ? 0.0 : uniform(random, -0.12, 0.12));
    }
    return points;
}

/// A tile with random paths, some points and a line inside, and a relief; what is refused on the way is left out.
LayeredTile random_tile(int number, Random& random)
{
    LayeredTile tile = LayeredTile::of_type(number, 20);
    const IsohedralType& type = tile.type();
    const auto attempt = [](auto&& f) {
        try {
            f();
        } catch (const CommandError&) {
        }
    };
    attempt([&] {
        std::vector<double> values = tile.design().parameters;
        for (double& v : values) v += uniform(random, -0.1, 0.1);
        tile.set_parameters(values);
    });
    for (int p = 0; p < int(type.shapes.size()); ++p) attempt([&] { tile.set_path(p, some_path(type, p, random)); });
    FlatBox box;
    for (const OutlinePoint& p : tile.outline().points) box.add(p.position);
    for (int i = 0; i < 8; ++i) attempt([&] { tile.add_point({uniform(random, box.min.x, box.max.x), uniform(random, box.min.y, box.max.y)}); });
    attempt([&] { tile.constrain(std::array{PointName::interior(0), PointName::interior(1)}); });
    tile.extrude(6);
    for (int i = 0; i < tile.point_count(); ++i) tile.set_heights(std::array{i}, uniform(random, -2, 2));
    return tile;
}

/// One of the stacks that keep a tile isohedral, any of its classes.
TileStack random_stack(const LayeredTile& tile, Random& random)
{
    const Point2 anywhere = uniform(random, -2, 2) * tile.lattice()[0] + uniform(random, -2, 2) * tile.lattice()[1];
    TileStack stack{random() % 3 == 0 ? TileStack::Mode::mirror : TileStack::Mode::shift, anywhere, 15.0 * double(random() % 12)};
    std::optional<IsohedralOffsets> offsets(std::in_place, tile.aspects(), tile.lattice(), stack_motion(stack));
    if (!offsets->any()) {
        stack.mode = TileStack::Mode::shift;
        offsets.emplace(tile.aspects(), tile.lattice(), stack_motion(stack));
    }
    stack.offset = offsets->nearest(anywhere);
    return stack;
}

class EveryType : public testing::TestWithParam<int> {};

TEST_P(EveryType, FillsSpaceWithAnyReliefAndStack)
{
    Random random{static_cast<unsigned>(GetParam())};
    for (int round = 0; round < 3; ++round) {
        SCOPED_TRACE(round);
        LayeredTile tile = random_tile(GetParam(), random);
        tile.set_stack(random_stack(tile, random));
        const TileCheck found = check(tile);
        EXPECT_EQ(found.faults, std::vector<std::string>{});
        const TileSolid solid = make_solid(tile);
        EXPECT_NEAR(volume(solid), 6 * tile.area(), 1e-12 * std::sqrt(double(solid.faces())) * 6 * tile.area() + 1e-9);
        EXPECT_LT(found.solid->bottom_mismatch, 1e-7);
        EXPECT_LT(found.solid->aspect_mismatch, 1e-7);
        const Mesh mesh = mesh_of(solid);
        EXPECT_EQ(int(mesh.vertex_count()) - int(mesh.edge_count()) + int(mesh.face_count()), 2);
        // Each place of a cell is in one copy only.
        const std::vector<Point2> polygon = tile.outline().positions();
        for (int i = 0; i < 40; ++i) {
            const Point2 p = uniform(random, 0, 1) * tile.lattice()[0] + uniform(random, 0, 1) * tile.lattice()[1];
            int holders = 0;
            for (const TileCopy& copy : tile.copies_in({p, p})) holders += contains(polygon, inverse(tile.motion(copy))(p));
            EXPECT_EQ(holders, 1);
        }
    }
}

/// All of a solid, to the last digit.
std::vector<std::uint64_t> digits(const TileSolid& solid)
{
    std::vector<std::uint64_t> all;
    const auto put = [&](double x) { all.push_back(std::bit_cast<std::uint64_t>(x)); };
    for (const HeightField* field : {&solid.top, &solid.bottom}) {
        for (const Point& p : field->points)
            for (int i = 0; i < 3; ++i) put(p[i]);
        for (const auto& t : field->triangles) all.insert(all.end(), t.begin(), t.end());
    }
    for (const auto* rim : {&solid.top_rim, &solid.bottom_rim})
        for (const auto& chain : *rim) all.insert(all.end(), chain.begin(), chain.end());
    for (const double x : {solid.thinnest.thickness, solid.thinnest.at.x, solid.thinnest.at.y, double(solid.steep), solid.lost}) put(x);
    return all;
}

TEST_P(EveryType, HasASolidThatFollowsHeightsAsIfItWereCarvedAnew)
{
    Random random{static_cast<unsigned>(1000 + GetParam())};
    LayeredTile tile = random_tile(GetParam(), random);
    const TileStack free{TileStack::Mode::free, {uniform(random, -20, 20), uniform(random, -20, 20)}, 0};
    for (const TileStack& stack : {TileStack{}, random_stack(tile, random), free}) {
        tile.set_stack(stack);
        const int aspect = int(random() % unsigned(tile.type().aspects()));
        for (const double clearance : {0.0, 0.3}) {
            const TileBottom bottom = std::array{TileBottom::carved, TileBottom::carved, TileBottom::column, TileBottom::flat}[random() % 4];
            LayeredTile raised = tile;
            const SolidPlan plan(raised, bottom, aspect, clearance);
            for (const double most : {2.0, 0.0, 40.0}) {
                for (int i = 0; i < raised.point_count(); ++i)
                    if (most == 0 || random() % 3 == 0) raised.set_heights(std::array{i}, uniform(random, -most, most));
                raised.extrude(6 + most);
                ASSERT_TRUE(plan.fits(raised));
                EXPECT_TRUE(digits(plan.solid(raised)) == digits(make_solid(LayeredTile(raised.design()), bottom, aspect, clearance)))
                    << int(stack.mode) << " " << clearance << " " << int(bottom) << " " << most;
            }
        }
    }
}

TEST(SolidPlan, FitsWhileOnlyHeightsAndThicknessChange)
{
    Random random(3);
    const LayeredTile tile = random_tile(79, random);
    const SolidPlan plan(tile);
    const auto fits = [&](auto&& edit) {
        LayeredTile other = tile;
        edit(other);
        return plan.fits(other);
    };
    EXPECT_TRUE(fits([](LayeredTile& t) { t.set_heights(std::array{0, t.point_count() - 1}, 5); }));
    EXPECT_TRUE(fits([](LayeredTile& t) { t.extrude(11); }));
    EXPECT_TRUE(fits([](LayeredTile& t) { t.set_frame(t.size(), 30, {7, 8}); }));
    EXPECT_FALSE(fits([](LayeredTile& t) { t.set_frame(2 * t.size(), 0, {0, 0}); }));
    EXPECT_FALSE(fits([](LayeredTile& t) { t.set_stack({TileStack::Mode::free, {1, 2}, 0}); }));
    EXPECT_FALSE(fits([](LayeredTile& t) { t.remove_point(PointName::interior(2)); }));
    EXPECT_FALSE(fits([](LayeredTile& t) { t.move_point(PointName::interior(2), t.position(t.find(PointName::interior(2))) + Point2(1e-3, 0)); }));
    EXPECT_FALSE(fits([](LayeredTile& t) { t.set_path(0, {}); }));
    EXPECT_FALSE(fits([](LayeredTile& t) { t.switch_type(41); }));
    EXPECT_FALSE(plan.fits(LayeredTile::of_type(79, 20))); // flat still
}

std::vector<int> numbers()
{
    std::vector<int> list;
    for (const IsohedralType& type : isohedral_types()) list.push_back(type.number);
    return list;
}

INSTANTIATE_TEST_SUITE_P(Types, EveryType, testing::ValuesIn(numbers()), [](const auto& made) { return "IH" + std::to_string(made.param); });

/// How many offsets, modulo the lattice and what is free, keep the group of a type; and in how many directions it is free.
TEST(IsohedralOffsets, AreThoseOfTheNormaliser)
{
    std::map<std::pair<int, int>, int> types; // by freedom and classes
    for (const IsohedralType& type : isohedral_types()) {
        const LayeredTile tile = LayeredTile::of_type(type.number);
        const IsohedralOffsets offsets(tile.aspects(), tile.lattice(), {});
        ASSERT_TRUE(offsets.any());
        ++types[{offsets.freedom(), offsets.classes()}];
    }
    const std::map<std::pair<int, int>, int> expected{{{2, 1}, 17}, {{1, 2}, 8}, {{1, 1}, 3}, {{0, 4}, 26}, {{0, 2}, 12}, {{0, 3}, 6}, {{0, 1}, 9}};
    EXPECT_EQ(types, expected);
}

TEST(Carving, SurvivesEveryCoincidence)
{
    Random random(7);
    for (const int number : {1, 41, 7, 23}) { // p1, p1, p3, p2
        LayeredTile tile = random_tile(number, random);
        // Any offset is a free stack: features of the tile over features of the landscape.
        std::vector<Point2> offsets{{0, 0}, tile.lattice()[0], -tile.lattice()[1], 2.0 * tile.lattice()[0] + tile.lattice()[1]};
        const auto point = [&] { return tile.position(int(random() % unsigned(tile.point_count()))); };
        for (int i = 0; i < 60; ++i) {
            const Point2 vertex = point(), other = point();
            offsets.push_back(vertex - other);                              // a vertex on a vertex
            const int k = int(random() % unsigned(tile.outline_count()));
            const Point2 a = tile.outline().points[std::size_t(k)].position, b = tile.outline().points[std::size_t(tile.outline().next(k))].position;
            offsets.push_back(vertex - (a + 0.3 * (b - a)));                // a vertex of the landscape on a side of the cutter
            const auto& t = tile.surface().triangles[random() % tile.surface().triangles.size()];
            const Point2 c = tile.position(int(t[0])), d = tile.position(int(t[1]));
            offsets.push_back(c + 0.6 * (d - c) - a);                       // a corner of the cutter on an edge of the landscape
            offsets.push_back(0.25 * (d - c));                              // edges that overlap in part, or are in line
            for (const double off : {1e-10, -1e-10, 3e-9, -3e-9}) offsets.push_back(c + 0.6 * (d - c) - a + Point2(off * 20, -off * 13));
            offsets.push_back(Point2(uniform(random, -40, 40), uniform(random, -40, 40)));
        }
        double shortest = 1e300;
        for (const Point2& d : offsets) {
            tile.set_stack({TileStack::Mode::free, d, 0});
            double sum = 0;
            for (int m = 0; m < member_count(tile); ++m) {
                const TileSolid solid = make_solid(tile, TileBottom::carved, aspect_of_member(tile, m));
                sum += volume(solid);
                for (const auto& triangle : solid.bottom.triangles) {
                    const std::array<Point2, 3> p{Point2(solid.bottom.points[triangle[0]]), Point2(solid.bottom.points[triangle[1]]), Point2(solid.bottom.points[triangle[2]])};
                    EXPECT_GT(orient(p[0], p[1], p[2]), 0);
                    for (std::size_t i = 0; i < 3; ++i) shortest = std::min(shortest, glm::length(p[i] - p[(i + 1) % 3]));
                }
                const Mesh mesh = mesh_of(solid);
                EXPECT_EQ(int(mesh.vertex_count()) - int(mesh.edge_count()) + int(mesh.face_count()), 2);
            }
            EXPECT_NEAR(sum / member_count(tile), 6 * tile.area(), 1e-6 * tile.area()) << number << " " << d.x << "," << d.y;
        }
        EXPECT_GE(shortest, tile.weld()) << number;
    }
}

} // namespace
} // namespace druse
