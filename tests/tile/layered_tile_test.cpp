#include "tile/layered_tile.h"

#include "dlfl/measures.h"
#include "support/mesh_checks.h"
#include "tile/layered_facts.h"
#include "tile/tile_inset.h"
#include "tile/tile_solid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace druse {
namespace {

class ReferenceTile : public testing::TestWithParam<Reference> {};

TEST_P(ReferenceTile, HasTheCountsVolumeAndThicknessOfExactArithmetic)
{
    const Reference& r = GetParam();
    const LayeredTile tile = straight_tile(r);
    EXPECT_NEAR(tile.area(), r.area, 1e-9 * r.area);
    EXPECT_EQ(disk_counts(tile.surface()), r.top);
    const TileSolid solid = make_solid(tile);
    EXPECT_EQ(disk_counts(solid.bottom), r.bottom);
    EXPECT_NEAR(solid.thinnest.thickness, r.thinnest, 1e-9);
    EXPECT_NEAR(volume(solid), r.volume, 1e-9 * r.volume);

    const Mesh mesh = mesh_of(solid);
    EXPECT_SOUND(mesh);
    EXPECT_EQ((std::array<int, 3>{int(mesh.vertex_count()), int(mesh.edge_count()), int(mesh.face_count())}), r.solid);
    EXPECT_NEAR(volume(mesh), r.volume, 1e-9 * r.volume);
}

INSTANTIATE_TEST_SUITE_P(Straight, ReferenceTile, testing::ValuesIn(references()), [](const auto& made) { return made.param.name; });

TEST(FreeStack, HasAsManySolidsAsExactArithmeticSays)
{
    struct Case {
        int type;
        Point2 inside, offset;
        double thickness;
        std::vector<double> volumes;
    };
    for (const Case& c : std::vector<Case>{{79, {8, 5}, {10, 0}, 5, {521.417798, 478.582202}},
                                           {79, {8, 5}, {5, 5}, 5, {492.013889, 492.013889, 507.986111, 507.986111}},
                                           {79, {8, 5}, {10, 10}, 5, {500}},
                                           {31, {12, 2}, {20, 0}, 5, {875.894639, 856.156168}},
                                           {31, {12, 2}, {15, 5 * std::sqrt(3.0)}, 5, {865.400163, 853.475016, 879.201032}}}) {
        const LayeredTile tile = straight_tile({"", c.type, 20, c.inside, 2, {TileStack::Mode::free, c.offset, 0}, c.thickness, 0, {}, {}, {}, 0, 0});
        ASSERT_EQ(member_count(tile), int(c.volumes.size()));
        std::vector<double> found;
        for (int m = 0; m < member_count(tile); ++m) found.push_back(volume(make_solid(tile, TileBottom::carved, aspect_of_member(tile, m))));
        std::ranges::sort(found);
        std::vector<double> expected = c.volumes;
        std::ranges::sort(expected);
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-5) << c.type;
    }
}

TEST(LayeredTile, WithCurvedPathsHasTheOutlinesAndOrbitsOfTheirSymbols)
{
    struct Case {
        int type;
        std::vector<std::vector<Point2>> paths;
        int points, orbits;
    };
    for (const Case& c : std::vector<Case>{{1, {{{0.25, 0.2}, {0.6, -0.2}}, {{0.5, 0.25}}, {{1.0 / 3, -1.0 / 6}, {0.75, 0.2}}}, 16, 7},
                                           {41, {{{0.25, 0.2}, {0.75, -0.125}}, {{0.5, 0.2}}}, 10, 4},
                                           {79, {{{1.0 / 3, 0.125}, {2.0 / 3, -0.125}}, {{0.25, 0.1}}}, 10, 6},
                                           {31, {{{0.5, 1.0 / 6}}, {{0.25, 0.125}, {0.625, -0.125}}}, 10, 6}}) {
        LayeredTile tile = LayeredTile::of_type(c.type, 20);
        for (std::size_t p = 0; p < c.paths.size(); ++p) tile.set_path(int(p), c.paths[p]);
        EXPECT_EQ(tile.outline_count(), c.points) << c.type;
        EXPECT_EQ(tile.outline().orbits, c.orbits) << c.type;
        const auto [t1, t2] = tile.lattice();
        EXPECT_NEAR(tile.area() * tile.type().aspects(), std::abs(t1.x * t2.y - t1.y * t2.x), 1e-9) << c.type;
    }
}

TEST(LayeredTile, LowersPointsToZeroAgain)
{
    LayeredTile tile = straight_tile(references()[0]);
    const std::array both{0, tile.find(PointName::interior(0))};
    tile.set_heights(both, 3);
    tile.set_heights(both, 0);
    for (const int point : both) EXPECT_EQ(tile.height(point), 0);
}

TEST(Inset, OfASquareIsASquareUntilNothingIsLeft)
{
    const std::vector<Point2> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    const Inset smaller = inset(square, 2, 1e-8);
    EXPECT_EQ(smaller.polygon.size(), 4u);
    EXPECT_NEAR(twice_area(smaller.polygon), 72, 1e-9);
    EXPECT_EQ(smaller.lost, 0);
    EXPECT_TRUE(inset(square, 6, 1e-8).polygon.empty());
    // Two rooms with a door: the larger one is left, and of the other, which is 6 by 6, what it would have left is lost.
    const std::vector<Point2> rooms{{0, 0}, {10, 0}, {10, 4.5}, {11, 4.5}, {11, 2}, {17, 2}, {17, 8}, {11, 8}, {11, 5.5}, {10, 5.5}, {10, 10}, {0, 10}};
    const Inset room = inset(rooms, 1, 1e-8);
    EXPECT_NEAR(twice_area(room.polygon), 128, 1e-9);
    EXPECT_NEAR(room.lost, 16, 1e-9);
}

} // namespace
} // namespace druse
