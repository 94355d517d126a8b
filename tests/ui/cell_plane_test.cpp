#include "ui/cell_plane.h"

#include "ui/cell_drawing.h"
#include "ui/layout.h"
#include "ui/plane_picture.h"

#include "app/registry.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace druse::ui {
namespace {

/// The pane of a cube of edge 2 that looks along x: right is y, up is z; corner 0 is at (1, 1), and side 0 runs from it to (-1, 1).
class CubePane : public testing::Test {
protected:
    CubePane() : session(all_operators()), view(session)
    {
        set_layout(Layout(1));
        session.on_change = [this] { view.session_changed(); };
        view.resize(400, 400);
        run("cell.new cell=cube size=2");
        view.show_pane(0);
    }
    void run(const std::string& command)
    {
        session.run(command);
        session.wait();
    }
    Pointer at(double x, double y) const
    {
        const Point2 p = view.plane().picture({x, y});
        return {.x = p.x, .y = p.y, .button = 1};
    }
    void click(const Pointer& p)
    {
        view.hover(p);
        view.press(p);
        view.release(p);
        session.wait();
    }
    void drag(const Pointer& from, const Pointer& to)
    {
        view.press(from);
        view.drag(to);
        session.wait();
        view.release(to);
        session.wait();
    }
    std::size_t steps() const { return session.display().done; }
    std::string last_step() const { return session.display().steps.at(steps() - 1); }
    std::string message() const { return session.message().text; }
    const std::vector<Point2>& inside() const { return view.cell()->interior(0); }

    Session session;
    CellPlane view;
};

TEST_F(CubePane, AClickAddsAPointAndADragMovesItInOneStep)
{
    click(at(0.5, 0.25));
    ASSERT_EQ(inside().size(), 1u);
    EXPECT_NEAR(inside()[0].x, 0.5, 0.01);
    EXPECT_NEAR(inside()[0].y, 0.25, 0.01);
    EXPECT_EQ(steps(), 2u);
    const Point2 before = inside()[0];
    view.press(at(0.5, 0.25));
    for (const double x : {0.3, 0.1, -0.5}) view.drag(at(x, -0.25)), session.wait();
    EXPECT_TRUE(view.is_dragging());
    view.release(at(-0.5, -0.25));
    session.wait();
    EXPECT_EQ(steps(), 3u);
    EXPECT_TRUE(last_step().starts_with("cell.point_move point=p0:i0 to="));
    EXPECT_NEAR(inside()[0].x - before.x, -1, 0.01);
    EXPECT_NEAR(inside()[0].y - before.y, -0.5, 0.01);
}

TEST_F(CubePane, EscapeTakesADragBack)
{
    click(at(0.5, 0.25));
    const Point2 before = inside()[0];
    view.press(at(0.5, 0.25));
    view.drag(at(0, 0));
    session.wait();
    EXPECT_NE(inside()[0], before);
    EXPECT_TRUE(view.cancel());
    session.wait();
    EXPECT_EQ(inside()[0], before);
}

TEST_F(CubePane, APointOfASideComesToAllSidesOfItsOrbit)
{
    click(at(0.5, 0.995));
    EXPECT_EQ(last_step(), "cell.edge_add edge=0 t=0.25");
    const auto& points = view.shown_pane().points;
    std::vector<Point2> places;
    for (const PanePoint& p : points)
        if (p.name == "x0:1") places.push_back(p.at);
    EXPECT_EQ(places, (std::vector<Point2>{{0.5, 1}, {0.5, -1}}));
    click(at(-0.5, -1)); // the side across runs the other way
    EXPECT_EQ(last_step(), "cell.edge_add edge=0 t=0.75");
}

TEST_F(CubePane, PointsOfSidesAndCornersDoNotMoveSoADragFromThemDrawsALine)
{
    run("cell.edge_add edge=0 t=0.5");
    const std::size_t before = steps();
    for (const auto& [x, y, name] : {std::tuple(0.0, 1.0, "x0:1"), std::tuple(1.0, 1.0, "c0")}) {
        drag(at(x, y), at(0.5, 0.5)); // where no point is
        EXPECT_EQ(steps(), before);
        EXPECT_EQ(message(), std::string("a line ends at a point; ") + name + " stays where it is");
    }
    drag(at(1, 1), at(0, -1));
    EXPECT_EQ(last_step(), "cell.constrain pane=0 from=v0 to=e2:1");
    run("cell.point_add pane=0 at=-0.5,0.25");
    drag(at(0, 1), at(-0.5, 0.25));
    EXPECT_EQ(last_step(), "cell.constrain pane=0 from=e0:1 to=i0");
    drag(at(-0.5, 0.25), at(-0.5, -0.25)); // one inside moves
    EXPECT_TRUE(last_step().starts_with("cell.point_move point=p0:i0")) << last_step();
}

TEST_F(CubePane, ALineIsDrawnFromPointToPointAndDeletedUnderThePointer)
{
    click(at(0.5, 0.25));
    click(at(-0.5, 0.25));
    view.start_constraint();
    drag(at(0.5, 0.25), at(1, 1));
    EXPECT_EQ(last_step(), "cell.constrain pane=0 from=i0 to=v0");
    ASSERT_EQ(view.shown_pane().lines.size(), 1u);
    drag(at(-0.5, 0.25), at(0.2, -0.3)); // once only: this one moves the point
    EXPECT_TRUE(last_step().starts_with("cell.point_move"));

    view.hover(at(0.75, 0.625));
    ASSERT_TRUE(view.hovered());
    EXPECT_EQ(view.hovered()->line, 0);
    view.remove();
    session.wait();
    EXPECT_EQ(last_step(), "cell.unconstrain pane=0 from=i0 to=v0");
    EXPECT_TRUE(view.shown_pane().lines.empty());
}

TEST_F(CubePane, ALineThatWasAskedForBeginsAtAPointOrNotAtAll)
{
    click(at(0.5, 0.25));
    const std::size_t before = steps();
    view.start_constraint();
    click(at(-0.3, -0.3)); // adds none
    EXPECT_EQ(steps(), before);
    EXPECT_EQ(message(), "a line begins at a point");
    Pointer beside = at(0.5, 0.25);
    beside.x += 11; // farther than a click reaches
    drag(beside, at(1, 1));
    EXPECT_EQ(last_step(), "cell.constrain pane=0 from=i0 to=v0");
}

TEST_F(CubePane, ALineThatCrossesOthersIsDeletedWhole)
{
    run("cell.constrain pane=0 from=v0 to=v2");
    run("cell.constrain pane=0 from=v1 to=v3");
    ASSERT_EQ(view.shown_pane().lines.size(), 4u) << "they meet in the middle";
    view.hover(at(0.5, 0.5));
    view.remove();
    session.wait();
    EXPECT_TRUE(last_step().starts_with("cell.unconstrain pane=0 path=")) << last_step();
    EXPECT_EQ(view.shown_pane().chains.size(), 1u);
}

TEST_F(CubePane, AClickOnALineAddsAPointToIt)
{
    run("cell.constrain pane=0 from=v0 to=v2");
    click(at(0.4, 0.41));
    ASSERT_EQ(inside().size(), 1u);
    EXPECT_NEAR(inside()[0].x, inside()[0].y, 1e-12);
    EXPECT_EQ(view.shown_pane().lines.size(), 2u);
}

TEST_F(CubePane, WhatIsRefusedChangesNothingAndShowsInRed)
{
    click(at(0.5, 0.25));
    view.press(at(0.5, 0.25));
    view.drag(at(1.3, 0.25)); // outside
    session.wait();
    ASSERT_TRUE(view.refused());
    EXPECT_NEAR(view.refused()->at.x, 1.3, 0.02);
    view.release(at(1.3, 0.25));
    session.wait();
    EXPECT_FALSE(view.refused());
    EXPECT_EQ(steps(), 2u);

}

TEST_F(CubePane, WhatIsPressedStaysItselfWhereOthersGo)
{
    for (const char* place : {"0.5,0.5", "-0.5,0.5", "0,-0.5"}) run(std::string("cell.point_add pane=0 at=") + place);
    view.press(at(0, -0.5)); // i2
    run("cell.point_remove point=p0:i0");
    view.release(at(0, -0.5));
    EXPECT_EQ(view.selected(), std::set<std::string>{"p0:i1"});
    view.start_constraint();
    view.press(at(0, -0.5)); // i1
    run("cell.point_remove point=p0:i0");
    EXPECT_TRUE(view.rubber());
    view.release(at(1, 1));
    session.wait();
    EXPECT_EQ(last_step(), "cell.constrain pane=0 from=i0 to=v0");
    run("cell.point_add pane=0 at=0.5,-0.5");
    view.press(at(0.5, -0.5)); // i1
    run("cell.point_remove point=p0:i0");
    view.drag(at(0.4, -0.3));
    view.release(at(0.4, -0.3));
    session.wait();
    EXPECT_TRUE(last_step().starts_with("cell.point_move point=p0:i0")) << last_step();

    // It goes itself, or comes below the pointer.
    view.select({});
    view.press(at(-0.5, -0.5));
    run("cell.point_add pane=0 at=-0.5,-0.5");
    view.release(at(-0.5, -0.5));
    EXPECT_EQ(view.selected(), std::set<std::string>{"p0:i1"});
    run("cell.point_remove point=p0:i1");
    EXPECT_TRUE(view.selected().empty());
    for (const bool drags : {false, true}) {
        run("cell.point_add pane=0 at=0,0.5");
        view.press(at(0, 0.5));
        run("cell.point_remove point=p0:i1");
        const std::size_t before = steps();
        if (drags) view.drag(at(0.2, 0.2));
        view.release(at(0.2, 0.2));
        session.wait();
        EXPECT_EQ(steps(), before);
        EXPECT_TRUE(view.selected().empty());
    }
}

TEST_F(CubePane, DeleteLeavesPointsOfSidesWhereThePanesAroundHaveTheirShape)
{
    for (const char* command : {"cell.point_add pane=0 at=0.5,0.5", "cell.edge_add edge=0 t=0.5", "cell.shape", "cell.rollback pane=0"}) run(command);
    view.select_all();
    EXPECT_TRUE(view.selected().contains("x0:1"));
    view.remove();
    session.wait();
    EXPECT_EQ(last_step(), "cell.point_remove point=p0:i0");
    EXPECT_TRUE(inside().empty());
    EXPECT_TRUE(view.selected().empty());
    view.select({"x0:1"});
    view.remove();
    EXPECT_EQ(message(), "points of edges come and go only while all panes are flat");
    EXPECT_EQ(view.selected(), std::set<std::string>{"x0:1"});
}

TEST_F(CubePane, DeleteTakesAllThatIsSelectedInOneStep)
{
    for (const char* command : {"cell.point_add pane=0 at=0.5,0.5", "cell.point_add pane=0 at=-0.5,0.5", "cell.point_add pane=0 at=0,-0.5", "cell.edge_add edge=0 t=0.5"})
        run(command);
    click(at(0.5, 0.5));
    EXPECT_EQ(view.selected(), std::set<std::string>{"p0:i0"});
    view.start_box();
    drag(at(-1.1, 0.2), at(1.1, 1.1)); // with two corners
    EXPECT_EQ(view.selected(), (std::set<std::string>{"p0:i0", "p0:i1", "x0:1", "c0"}));
    const std::size_t before = steps();
    view.remove();
    session.wait();
    EXPECT_EQ(steps(), before + 1) << "of one gesture";
    EXPECT_EQ(inside(), std::vector<Point2>({{0, -0.5}}));
    EXPECT_TRUE(view.cell()->edge_points(0).empty());
    EXPECT_TRUE(view.selected().empty());
    view.select({"c0"});
    view.remove();
    EXPECT_EQ(message(), "corners stay");
}

TEST_F(CubePane, WhatHasItsShapeIsOnlyLookedAtUntilItIsRolledBack)
{
    click(at(0.5, 0.25));
    run("cell.shape");
    const std::size_t before = steps();
    for (const auto& [x, y] : {std::pair(0.1, 0.1), std::pair(0.5, 0.25), std::pair(0.0, 1.0)}) {
        click(at(x, y));
        EXPECT_EQ(message(), "roll the pane back to edit it");
        session.say(Message::Kind::note, "");
    }
    drag(at(0.5, 0.25), at(0.6, 0.25));
    view.start_constraint();
    drag(at(0.5, 0.25), at(1, 1));
    view.remove();
    EXPECT_EQ(steps(), before);
    view.frame();
    run("cell.rollback pane=0");
    click(at(0.1, 0.1));
    EXPECT_EQ(inside().size(), 2u);
    click(at(0.0, 1.0)); // panes around it have their shape
    EXPECT_EQ(session.message().kind, Message::Kind::error);
    EXPECT_TRUE(view.cell()->edge_points(0).empty());
}

TEST_F(CubePane, ThePartnersOfWhatIsUnderThePointerAreKnown)
{
    view.hover(at(0.3, 1.0));
    EXPECT_EQ(view.hovered_edge(), 0);
    EXPECT_EQ(view.hovered_orbit(), -1);
    view.hover(at(-1, 0.3));
    EXPECT_EQ(view.hovered_edge(), 1);
    view.hover(at(-1, 1));
    EXPECT_EQ(view.hovered_edge(), -1);
    EXPECT_EQ(view.hovered_orbit(), 0) << "all corners of a cube are one orbit";
    view.hover(at(0, 0));
    EXPECT_EQ(view.hovered_orbit(), -1);
    view.leave();
    EXPECT_EQ(view.hovered_edge(), -1);
}

TEST_F(CubePane, NewPlacesAreThoseOfTheGridWhereThatIsAskedFor)
{
    view.set_shown({.snap = true});
    const double grid = view.grid();
    click(at(3.2 * grid, -2.3 * grid));
    ASSERT_EQ(inside().size(), 1u);
    EXPECT_NEAR(inside()[0].x, 3 * grid, 1e-12);
    EXPECT_NEAR(inside()[0].y, -2 * grid, 1e-12);
    click(at(1, -2.3 * grid));
    EXPECT_NEAR(view.cell()->edge_points(1).at(0), 0.5 * (1 + 2 * grid), 1e-12);
}

TEST_F(CubePane, APointOfASlantingSideStaysBesideThePointerOnTheGridToo)
{
    run("cell.new cell=fcc size=4");
    view.show_pane(0);
    view.set_shown({.snap = true});
    const ShownPane pane = view.shown_pane();
    const double grid = view.grid();
    for (std::size_t k = 0; k < pane.outline.size(); ++k) {
        const Point2 from = pane.outline[k], to = pane.outline[(k + 1) % pane.outline.size()];
        for (const double t : {0.13, 0.5, 0.91}) {
            const Point2 pointer = from + t * (to - from);
            click(at(pointer.x, pointer.y));
            ASSERT_TRUE(last_step().starts_with("cell.edge_add")) << last_step();
            double nearest = 1e9;
            for (const PanePoint& p : view.shown_pane().points)
                if (p.kind == PanePoint::Kind::edge) nearest = std::min(nearest, glm::distance(p.at, pointer));
            EXPECT_LE(nearest, 0.51 * grid) << "side " << k << " at " << t;
            run("document.undo");
        }
    }
}

TEST_F(CubePane, APointOfASideComesBetweenThoseBesideThePointer)
{
    view.set_shown({.snap = true});
    const double grid = view.grid(); // its lines are at -1 and 0 of that, along the side
    run(fmt::format("cell.edge_add edge=0 t={}", 0.5 * (1 + 0.05 * grid)));
    run(fmt::format("cell.edge_add edge=0 t={}", 0.5 * (1 + 0.95 * grid)));
    click(at(-0.3 * grid, 1)); // between both, where the grid has nothing
    const std::vector<double>& t = view.cell()->edge_points(0);
    ASSERT_EQ(t.size(), 3u);
    EXPECT_NEAR(t[1], 0.5 * (1 + 0.3 * grid), 1.0 / 200);
}

TEST_F(CubePane, WhatIsSelectedStaysItselfWhereOthersGoAndComeBack)
{
    for (const char* place : {"0.5,0.5", "-0.5,0.5", "0,-0.5"}) run(std::string("cell.point_add pane=0 at=") + place);
    run("cell.edge_add edge=0 t=0.5");
    using Names = std::set<std::string>;
    view.select({"p0:i1", "p0:i2", "x0:1"});
    run("cell.point_remove point=p0:i0");
    EXPECT_EQ(view.selected(), (Names{"p0:i0", "p0:i1", "x0:1"}));
    run("cell.edge_add edge=0 t=0.25"); // comes before the other
    EXPECT_EQ(view.selected(), (Names{"p0:i0", "p0:i1", "x0:2"}));
    run("cell.point_move point=p0:i1 to=0.1,-0.6"); // is the same elsewhere
    EXPECT_EQ(view.selected(), (Names{"p0:i0", "p0:i1", "x0:2"}));
    session.go_to(5); // at once
    session.wait();
    EXPECT_TRUE(view.selected().contains("p0:i1"));
    EXPECT_TRUE(view.selected().contains("x0:1"));
    run("cell.point_remove point=p0:i1"); // is one of them
    EXPECT_FALSE(view.selected().contains("p0:i1"));
    run("cell.new cell=cube size=4");
    EXPECT_TRUE(view.selected().empty());
}

TEST_F(CubePane, AllOfAPaneIsSelected)
{
    run("cell.point_add pane=0 at=0.5,0.5");
    run("cell.edge_add edge=0 t=0.5");
    view.select_all();
    EXPECT_EQ(view.selected(), (std::set<std::string>{"c0", "p0:i0", "x0:1"}));
    EXPECT_TRUE(view.cancel());
    EXPECT_TRUE(view.selected().empty());
    EXPECT_FALSE(view.cancel());
}

TEST_F(CubePane, ShowsNoPaneOfAnotherKindOfCell)
{
    run("cell.new cell=cube size=4");
    EXPECT_EQ(view.pane(), 0);
    EXPECT_GT(at(0, 2).y, 0) << "all of it is seen";
    run("cell.new cell=bcc size=4");
    EXPECT_EQ(view.pane(), -1);
    view.show_pane(6);
    EXPECT_EQ(view.pane(), 6);
    view.show_pane(7);
    EXPECT_EQ(view.pane(), 6);
    run("cell.new cell=cube size=4");
    EXPECT_EQ(view.pane(), -1);
    EXPECT_FALSE(view.invitation().empty());
    click(at(0, 0));
    view.remove();
    EXPECT_EQ(last_step(), "cell.new cell=cube size=4");
}

TEST_F(CubePane, TheSessionCountsThePointsAndEdgesOfACell)
{
    EXPECT_EQ(session.display().counts, (Counts{8, 18, 0})) << "each square has a diagonal";
    run("cell.point_add pane=0 at=0.5,0.25"); // on both panes of the pair: one more point and three edges each
    EXPECT_EQ(session.display().counts, (Counts{10, 24, 0}));
}

TEST_F(CubePane, IsDrawnInColourWhileItIsFlatAndGreyAfterwards)
{
    view.set_shown({.triangles = false, .grid = false});
    Image image(400, 400);
    const auto colour = [&](double x, double y) {
        draw_pane(view, true, 1, image);
        const Point2 p = view.plane().picture({x, y});
        const Pixel& pixel = image.pixels[std::size_t(p.y) * 400 + std::size_t(p.x)];
        return Colour{pixel.red, pixel.green, pixel.blue};
    };
    EXPECT_EQ(colour(0.3, 0.2), plane_colours(true).tile);
    EXPECT_EQ(colour(1.2, 0.2), plane_colours(true).background);
    EXPECT_EQ(colour(0.3, 1), orbit_colour(0, true));
    EXPECT_EQ(colour(1, 0.3), orbit_colour(1, true));
    EXPECT_EQ(colour(0.3, -1), orbit_colour(0, true)) << "a side and the one across are one orbit";
    run("cell.point_add pane=0 at=0.5,0.25");
    const double beside = 6.3 / view.plane().pixels;
    EXPECT_EQ(colour(0.5 + beside, 0.25), plane_colours(true).tile);
    view.mark({"p0:i0"}); // picked in space
    EXPECT_EQ(colour(0.5 + beside, 0.25), plane_colours(true).selected);
    run("cell.shape");
    EXPECT_EQ(colour(0.3, 0.2), plane_colours(true).neighbours[0]);
}

TEST_F(CubePane, HandlesOfPointsThatAreNearOthersAreSmall)
{
    view.set_shown({.triangles = false, .grid = false});
    Image image(400, 400);
    const auto ground = [&] { // pixels of it
        draw_pane(view, true, 1, image);
        const Colour tile = plane_colours(true).tile;
        return std::ranges::count_if(image.pixels, [&](const Pixel& p) { return Colour{p.red, p.green, p.blue} == tile; });
    };
    const auto empty = ground();
    run("cell.point_add pane=0 at=0,0");
    const auto one = empty - ground();
    EXPECT_GT(one, 60) << "a disc of radius 5";
    for (int i = 0; i < 20; ++i)
        for (int k = 0; k < 20; ++k) session.run(fmt::format("cell.point_add pane=0 at={},{}", -0.85 + 0.085 * i + 0.01 * (k % 2), -0.85 + 0.085 * k)), session.wait();
    EXPECT_LT(empty - ground(), 0.3 * double(empty)) << "400 points leave most of the pane to be seen";
}

TEST(OrbitColours, TellTheOrbitsOfEveryCellApart)
{
    for (const bool dark : {true, false}) {
        std::set<Colour> colours;
        for (int i = 0; i < 12; ++i) colours.insert(orbit_colour(i, dark)); // of the truncated octahedron
        for (int i = 0; i < 6; ++i) colours.insert(corner_colour(i, dark));
        EXPECT_EQ(colours.size(), 18u);
    }
}

} // namespace
} // namespace druse::ui
