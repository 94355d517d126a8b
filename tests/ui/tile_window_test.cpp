#include "dlfl/measures.h"
#include "support/folder.h"
#include "ui/layout.h"
#include "ui/plane_view.h"
#include "ui/relief_picture.h"
#include "ui/tile_offset.h"
#include "ui/tile_source.h"
#include "ui/tile_view.h"
#include "ui/type_chooser.h"
#include "ui/type_picture.h"

#include "app/registry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
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

TEST(TileOffset, KeepsAStackOfMirrorsOne)
{
    LayeredTile tile = LayeredTile::of_type(79, 20);
    tile.set_stack({TileStack::Mode::mirror, Point2(0.0), 0});
    const ShownTile shown = shown_tile(&tile);
    // About the horizontal through the 4-fold corner v1 the tiling is its own image, also a whole leg along it.
    const TileOffset leg = attract(shown, {10.2, 9.9}, 0.5);
    EXPECT_TRUE(leg.is_allowed);
    EXPECT_NEAR(leg.at.x, 10, 1e-9);
    EXPECT_NEAR(leg.at.y, 10, 1e-9);
    EXPECT_FALSE(attract(shown, {3, 1}, 0.5).is_allowed);
}

TEST(TileOffset, BringsPointsOverEdgesInsideTheTileBelow)
{
    LayeredTile tile = LayeredTile::of_type(41, 10);
    tile.add_point({2, 6});
    const ShownTile shown = shown_tile(&tile);
    // The corner (0,0) goes near the line from (0,0) to (2,6), and nothing else comes near anything.
    const Point2 wanted(1.05, 3.0);
    const TileOffset over = attract(shown, wanted, 0.2);
    EXPECT_TRUE(over.is_allowed);
    EXPECT_NEAR(over.at.y, 3 * over.at.x, 1e-12);
    EXPECT_LT(glm::distance(over.at, wanted), 0.2);
}

TEST(SolidFiles, AreOneForEachMirrorImageAndEachMemberOfAFreeStack)
{
    const auto count = [](const LayeredTile& tile) { return solid_files(tile, "tile.solid", "tile.stl").size(); };
    LayeredTile turned = LayeredTile::of_type(79, 20), mirrored = LayeredTile::of_type(2, 20);
    EXPECT_EQ(count(turned), 1u) << "quarter turns bring all four together";
    EXPECT_EQ(count(mirrored), 2u) << "left and right";
    turned.add_point({8, 5});
    turned.set_stack({TileStack::Mode::free, Point2(10, 0), 0});
    EXPECT_EQ(count(turned), 2u) << "half a leg along: the reference has two solids";
    turned.set_stack({TileStack::Mode::free, Point2(5, 5), 0});
    EXPECT_EQ(count(turned), 4u);
}

TEST(SolidFiles, HoldTheMirrorImageOfAStackOfMirrors)
{
    const test::Folder folder;
    Session session(all_operators());
    for (const char* command : {"tile.new type=IH79 size=20", "tile.point_add at=10,4", "tile.stack mode=mirror", "tile.extrude thickness=5", "tile.height points=i0 set=2"}) session.run(command), session.wait();
    const std::vector<SolidFile> files = solid_files(*layered_tile(*session.scene()), "tile.solid clearance=0.2", folder.path() / "a.obj");
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files[1].command, "tile.solid clearance=0.2 layer=1");
    EXPECT_EQ(files[1].file.filename(), "a-2.obj");
    std::vector<Point> places[2];
    for (int k = 0; k < 2; ++k) {
        session.run(files[std::size_t(k)].command);
        session.wait();
        session.export_to(files[std::size_t(k)].file);
        session.wait();
        EXPECT_TRUE(std::filesystem::exists(files[std::size_t(k)].file));
        const Mesh& mesh = session.scene()->mesh;
        EXPECT_GT(volume(mesh), 400) << "outside out, on both sides of the mirror";
        for (const Vertex v : mesh.vertices()) places[k].push_back(mesh.position(v));
    }
    ASSERT_EQ(places[0].size(), places[1].size());
    for (std::size_t i = 0; i < places[0].size(); ++i) {
        const Point& p = places[0][i];
        EXPECT_LT(glm::distance(places[1][i], Point(p.x, -p.y, p.z + 5)), 1e-9) << "mirrored in the x axis, a layer up";
    }
}

TEST(ReliefPicture, ShowsTheTilesAroundItAsLargeAsTheSliderSays)
{
    LayeredTile tile = LayeredTile::of_type(41, 10);
    tile.extrude(4);
    const auto box_of = [&](double neighbours) {
        ReliefPicture picture;
        picture.neighbours = neighbours;
        picture.follow(&tile);
        Box box;
        for (std::uint32_t v = 0; v < picture.lists.vertex_limit(); ++v) box.add(picture.lists.position(v));
        return box;
    };
    // Squares of side 10 on all sides, and one above and below: 30 wide where they touch. At half the size each is 5 wide about its own middle.
    EXPECT_EQ(box_of(0).size(), Vector(10, 10, 4));
    EXPECT_EQ(box_of(1).size(), Vector(30, 30, 12));
    EXPECT_EQ(box_of(0.5).size(), Vector(25, 25, 10));
}

class TilePlane : public testing::Test {
protected:
    TilePlane() : session(all_operators()), view(session)
    {
        set_layout(Layout(1));
        session.on_change = [this] { view.session_changed(); };
        view.resize(400, 400);
        for (const char* command : {"tile.new type=IH41 size=20", "tile.point_add at=5,12", "tile.point_add at=15,12", "tile.extrude thickness=5"}) run(command);
        view.frame();
    }
    void run(const std::string& command)
    {
        session.run(command);
        session.wait();
    }
    Pointer at(double x, double y) const
    {
        const Point2 p = view.plane().picture({x, y});
        Pointer pointer;
        pointer.x = p.x;
        pointer.y = p.y;
        pointer.button = 1;
        return pointer;
    }
    void drag(const Pointer& from, const Pointer& to)
    {
        view.press(from);
        view.drag(to);
        view.release(to);
        session.wait();
    }
    std::size_t steps() const { return session.display().done; }

    Session session;
    TileView view;
};

TEST_F(TilePlane, ABoxSelectsPointsWhereHeightsAreEdited)
{
    view.set_tool(TileView::Tool::heights);
    const std::size_t before = steps();
    drag(at(3, 10), at(17, 14));
    EXPECT_EQ(view.selected(), (std::set<std::string>{"i0", "i1"}));
    drag(at(5, 12), at(8, 14)); // not a move: places in the plane stay
    EXPECT_EQ(steps(), before);
    Pointer end = at(17, 14);
    end.ctrl = true;
    view.select({"i0", "i1"});
    drag(at(13, 10), end);
    EXPECT_EQ(view.selected(), std::set<std::string>{"i0"});
}

TEST_F(TilePlane, WhatIsRefusedChangesNothingAndShowsInRed)
{
    run("tile.edge_add at=10,0");
    run("tile.edge_move point=e0:1 to=10,6");
    const std::size_t before = steps();
    view.start_constraint();
    drag(at(0, 0), at(20, 0)); // across the dent
    EXPECT_EQ(steps(), before);
    ASSERT_TRUE(view.refused_line());
    EXPECT_EQ(session.message().kind, Message::Kind::error);
    view.press(at(30, 30));
    EXPECT_FALSE(view.refused_line());
}

TEST_F(TilePlane, RemovesEachPointOnceHoweverManyOfItsImagesAreSelected)
{
    run("tile.edge path=0 points=0.3,0.1,0.6,0.1");
    run("tile.edge path=1 points=0.5,0.1");
    std::set<std::string> all;
    for (const TilePoint& p : view.tile().points) all.insert(p.name);
    const std::size_t before = steps();
    view.select(all);
    view.remove();
    session.wait();
    EXPECT_EQ(steps(), before + 5) << "three points of paths, two inside";
    EXPECT_EQ(view.tile().points.size(), 4u) << "corners stay";
    EXPECT_EQ(session.message().kind, Message::Kind::note);
}

TEST_F(TilePlane, DrawsItsCopiesAnewOnlyWhenTheyChange)
{
    const std::uint64_t before = view.backdrop();
    run("tile.point_move point=i0 to=6,13");
    run("tile.height points=i0 set=2");
    EXPECT_EQ(view.backdrop(), before) << "inside the tile alone";
    run("tile.edge_add at=10,0");
    EXPECT_NE(view.backdrop(), before);
    const std::uint64_t now = view.backdrop();
    run("tile.colors colors=#102030,#405060,#708090");
    EXPECT_NE(view.backdrop(), now);
}

TEST_F(TilePlane, ThePictureIsDraggedWithAltAsOneStep)
{
    run("tile.trace image=missing.png place=20,0,0,0,20,0");
    EXPECT_FALSE(view.picture()) << "the file is not there, which is no fault of the tile";
    const std::size_t before = steps();
    Pointer from = at(10, 10);
    from.alt = true;
    drag(from, at(13, 8));
    EXPECT_EQ(steps(), before + 1);
    ASSERT_TRUE(view.tile().look.trace);
    EXPECT_NEAR(view.tile().look.trace->place[2], 3, 0.05);
    EXPECT_NEAR(view.tile().look.trace->place[5], -2, 0.05);
}

} // namespace
} // namespace druse::ui
