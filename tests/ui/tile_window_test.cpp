#include "ui/plane_view.h"
#include "ui/tile_offset.h"
#include "ui/tile_source.h"
#include "ui/type_chooser.h"
#include "ui/type_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace druse::ui {
namespace {

double twice_area_of(const std::vector<Point2>& polygon)
{
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

TEST(PlaneView, GoesFromThePlaneToThePictureAndBack)
{
    PlaneView view{400, 300, {7, -2}, 12.5};
    EXPECT_EQ(view.picture({7, -2}), Point2(200, 150));
    EXPECT_EQ(view.picture({8, -1}), Point2(212.5, 137.5)); // y upward
    const Point2 back = view.plane(view.picture({3.25, 4.5}));
    EXPECT_NEAR(back.x, 3.25, 1e-12);
    EXPECT_NEAR(back.y, 4.5, 1e-12);
}

TEST(PlaneView, KeepsThePlaceUnderThePointerWhenItZooms)
{
    PlaneView view{400, 300, {7, -2}, 12.5};
    const Point2 before = view.plane({310, 40});
    view.zoom(1.7, {310, 40});
    EXPECT_NEAR(view.plane({310, 40}).x, before.x, 1e-12);
    EXPECT_NEAR(view.plane({310, 40}).y, before.y, 1e-12);
    EXPECT_NEAR(view.pixels, 12.5 * 1.7, 1e-12);
}

TEST(PlaneView, ShowsAllOfABoxWithAMargin)
{
    PlaneView view{400, 300, {0, 0}, 1};
    view.fit({0, 0}, {10, 10}, 0.25);
    EXPECT_EQ(view.centre, Point2(5, 5));
    EXPECT_NEAR(view.pixels, 20, 1e-12); // 15 units in 300 pixels
}

TEST(TypeChooser, FindsTypesByWhatRotates)
{
    EXPECT_EQ(types_that_pass({}).size(), 81u);
    EXPECT_EQ(types_that_pass({.rotations = 1}).size(), 28u); // p1 17, pg and pm 8, cm 3
    std::size_t all = 0;
    for (const int rotations : {1, 2, 3, 4, 6}) all += types_that_pass({.rotations = rotations}).size();
    EXPECT_EQ(all, 81u);
    const auto passes = [](int number, int rotations) {
        return std::ranges::count(types_that_pass({.rotations = rotations}), number) == 1;
    };
    EXPECT_TRUE(passes(1, 1));
    EXPECT_TRUE(passes(79, 4));
    EXPECT_TRUE(passes(31, 6));
    EXPECT_EQ(types_that_pass({.no_mirrored = true}).size(), 51u); // 30 have mirrored aspects
}

/// With |aspects| · area = det and every piece of the outline on one of a neighbour's, copies cover the plane once.
TEST(TypePicture, ShowsTilesThatFitForEveryType)
{
    for (const IsohedralType& type : isohedral_types()) {
        const Point2 a = type.placed.lattice[0].at(type.start), b = type.placed.lattice[1].at(type.start);
        const std::vector<Point2> outline = sample_outline(type);
        EXPECT_NEAR(0.5 * twice_area_of(outline) * type.aspects(), a.x * b.y - a.y * b.x, 1e-9) << type.name();
    }
}

TEST(TypePicture, IsOfAsManyColoursAsTheTypeHas)
{
    for (const int number : {1, 79}) { // hexagons meet in threes, the triangles of IH79 in even numbers
        const IsohedralType& type = isohedral_type(number);
        const Image image = type_picture(type, 120);
        std::array<int, 3> pixels{};
        for (const Pixel& p : image.pixels)
            for (int c = 0; c < 3; ++c) pixels[std::size_t(c)] += Colour{p.red, p.green, p.blue} == tile_colour(c);
        for (int c = 0; c < type.colours.count; ++c) EXPECT_GT(pixels[std::size_t(c)], 120 * 120 / 8) << type.name() << " colour " << c;
        EXPECT_EQ(pixels[2] > 0, type.colours.count == 3) << type.name();
    }
}

TEST(ShownTile, HasItsPointsByTheNamesThatCommandsUse)
{
    LayeredTile tile = LayeredTile::of_type(79, 20);
    tile.set_path(1, {{0.25, 0.1}});
    tile.add_point({10, 4});
    const ShownTile shown = shown_tile(&tile);
    ASSERT_EQ(shown.type->number, 79);
    EXPECT_EQ(shown.outline, 6); // three corners, and of the path b a point, its middle, and the image of the point
    for (const char* name : {"v0", "v1", "v2", "e1:1", "m1", "e1:1m", "i0"}) EXPECT_GE(shown.find(name), 0) << name;
    EXPECT_EQ(shown.points[std::size_t(shown.find("m1"))].kind, TilePoint::Kind::middle);
    EXPECT_EQ(shown.points[std::size_t(shown.find("i0"))].at, Point2(10, 4));
    EXPECT_TRUE(shown.holds({10, 4}));
    EXPECT_FALSE(shown.holds({-1, 4}));
    EXPECT_FALSE(shown_tile(nullptr).type);
}

TEST(ShownTile, BeginsItsCopiesWithItself)
{
    const LayeredTile tile = LayeredTile::of_type(31, 10);
    const ShownTile shown = shown_tile(&tile);
    ASSERT_GE(shown.copies.size(), 25u);
    EXPECT_EQ(shown.copies[0].map(Point2(3, 4)), Point2(3, 4));
    // Copies are other tiles: the place of a point that no symmetry keeps is never the same twice.
    std::set<std::pair<long, long>> places;
    for (const DrawnCopy& copy : shown.copies) {
        const Point2 p = copy.map({6, 1});
        places.emplace(std::lround(1e6 * p.x), std::lround(1e6 * p.y));
    }
    EXPECT_EQ(places.size(), shown.copies.size());
}

TEST(ShownTile, MarksTheCentresOfRotationOnItsOutline)
{
    const LayeredTile tile = LayeredTile::of_type(79, 20);
    const ShownTile shown = shown_tile(&tile);
    const auto order_at = [&](const Point2& p) {
        for (const RotationCentre& c : shown.centres)
            if (glm::distance(c.at, p) < 1e-9) return c.order;
        return 0;
    };
    EXPECT_EQ(order_at({10, 10}), 4); // the corners of the triangle
    EXPECT_EQ(order_at({0, 0}), 4);
    EXPECT_EQ(order_at({20, 0}), 4);
    EXPECT_EQ(order_at({10, 0}), 2); // the middle of the hypotenuse
    EXPECT_EQ(order_at({10, 5}), 0);
}

TEST(TileOffset, IsDrawnToTheOffsetsThatKeepTilesAlike)
{
    const LayeredTile tile = LayeredTile::of_type(79, 20); // 0 and one leg, modulo the lattice
    const ShownTile shown = shown_tile(&tile);
    const TileOffset leg = attract(shown, {10.3, 9.8}, 0.5);
    EXPECT_TRUE(leg.is_allowed);
    EXPECT_NEAR(leg.at.x, 10, 1e-9);
    EXPECT_NEAR(leg.at.y, 10, 1e-9);
    const TileOffset half_leg = attract(shown, {5, 5}, 0.5);
    EXPECT_FALSE(half_leg.is_allowed);
    EXPECT_EQ(half_leg.at, Point2(5, 5));
}

TEST(TileOffset, BringsPointsOverPointsWhereEveryOffsetIsAllowed)
{
    LayeredTile tile = LayeredTile::of_type(41, 10);
    tile.add_point({3, 4});
    const ShownTile shown = shown_tile(&tile);
    const TileOffset over = attract(shown, {3.1, 4.1}, 0.4); // a corner over the point inside
    EXPECT_NEAR(over.at.x, 3, 1e-12);
    EXPECT_NEAR(over.at.y, 4, 1e-12);
    const TileOffset edge = attract(shown, {5.3, 0.2}, 0.4); // no point is near: the corner over an edge
    EXPECT_NEAR(edge.at.x, 5.3, 1e-12);
    EXPECT_NEAR(edge.at.y, 0, 1e-12);
}

} // namespace
} // namespace druse::ui
