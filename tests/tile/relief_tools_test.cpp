// The tools that shape many heights at once, on a square tile with a grid of points.
#include "tile/relief_tools.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace druse {
namespace {

/// IH41 of size 10 with points at whole coordinates, on the outline too.
LayeredTile gridded_tile()
{
    TileDesign design;
    design.type = 41;
    design.size = 10;
    design.parameters = {1, 0};
    design.paths.resize(2);
    for (int i = 1; i < 10; ++i)
        for (auto& path : design.paths) path.emplace_back(i / 10.0, 0.0);
    for (int y = 1; y < 10; ++y)
        for (int x = 1; x < 10; ++x) design.interior.emplace_back(x, y);
    design.thickness = 5;
    return LayeredTile(std::move(design));
}

std::vector<int> all_points(const LayeredTile& tile)
{
    std::vector<int> points(static_cast<std::size_t>(tile.point_count()));
    std::iota(points.begin(), points.end(), 0);
    return points;
}

void set(LayeredTile& tile, const std::vector<double>& heights) { tile.set_heights(all_points(tile), heights); }

TEST(Dome, RisesFromTheOutlineAsItsProfileSays)
{
    LayeredTile tile = gridded_tile();
    set(tile, domed_heights(tile, all_points(tile), 3, {}, ReliefProfile::straight));
    for (const double x : {0.0, 1.0, 2.0, 5.0}) EXPECT_NEAR(tile.layer_height({x, 5}), 3 * x / 5, 1e-12) << x;
    EXPECT_NEAR(tile.layer_height({2, 9}), 0.6, 1e-12);

    LayeredTile round = gridded_tile();
    set(round, domed_heights(round, all_points(round), 2, 4.0, ReliefProfile::round));
    EXPECT_NEAR(round.layer_height({2, 5}), std::sqrt(3.0), 1e-12); // halfway in, a quarter of a circle of radius 2 is √(2² − 1²) high
    EXPECT_NEAR(round.layer_height({5, 5}), 2, 1e-12);
}

TEST(Ridge, GoesOnInTheCopiesBeyondTheOutline)
{
    LayeredTile tile = gridded_tile();
    set(tile, ridged_heights(tile, all_points(tile), std::array{Point2(0, 0), Point2(10, 0)}, 2, 2, ReliefProfile::straight));
    // The ridge lies on the lower edge of this tile and so on the upper edge of the next: both edges are at its height, and all other points by their distance.
    EXPECT_NEAR(tile.layer_height({4, 0}), 2, 1e-12);
    EXPECT_NEAR(tile.layer_height({4, 10}), 2, 1e-12);
    EXPECT_NEAR(tile.layer_height({4, 1}), 1, 1e-12);
    EXPECT_NEAR(tile.layer_height({4, 2}), 0, 1e-12);
    EXPECT_NEAR(tile.layer_height({4, 9}), 0, 1e-12) << "a point inside belongs to this tile alone";
    // A valley takes away, along a chain.
    set(tile, ridged_heights(tile, all_points(tile), std::array{Point2(2, 5), Point2(5, 5), Point2(5, 8)}, -1, 1, ReliefProfile::round));
    for (const Point2 p : {Point2(3, 5), Point2(5, 5), Point2(5, 8)}) EXPECT_NEAR(tile.layer_height(p), -1, 1e-12);
    EXPECT_NEAR(tile.layer_height({3, 6}), 0, 1e-12);
}

TEST(Smoothing, KeepsWhatIsFlatAndTheMeanOfAll)
{
    LayeredTile tile = gridded_tile();
    tile.add_heights(all_points(tile), 1.5);
    set(tile, smoothed_heights(tile, all_points(tile), 0.7, 5));
    for (const int i : all_points(tile)) EXPECT_NEAR(tile.height(i), 1.5, 1e-12);

    // One point raised: what it loses, those around it gain. Points that may not move stay.
    const int middle = tile.find(PointName::interior(40));
    tile.set_heights(std::array{middle}, 2.5);
    const std::vector<double> heights = smoothed_heights(tile, std::array{middle}, 1, 1);
    EXPECT_NEAR(heights[0], 1.5, 1e-12);
    const std::vector<double> all = smoothed_heights(tile, all_points(tile), 0.5, 1);
    EXPECT_NEAR(all[static_cast<std::size_t>(middle)], 2.0, 1e-12);
    EXPECT_EQ(all[0], 1.5);
}

TEST(HeightsByPlace, RunOverTheBoxOfTheOutline)
{
    LayeredTile tile = gridded_tile();
    set(tile, mapped_heights(tile, all_points(tile), [](const Point2& p) { return p.x + 10 * p.y; }));
    EXPECT_NEAR(tile.layer_height({3, 4}), 4.3, 1e-12);
    EXPECT_NEAR(tile.layer_height({0, 4}), 4.5, 1e-12) << "left and right edge are one line of the layer: the mean of 0 and 1";
    EXPECT_NEAR(tile.layer_height({0, 0}), 5.5, 1e-12);
}

} // namespace
} // namespace druse
