#include "ui/cell_dialogs.h"
#include "ui/cell_faults.h"
#include "ui/cell_match.h"
#include "ui/cell_tool.h"
#include "ui/layout.h"
#include "ui/opposite_camera.h"

#include "app/registry.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace druse::ui {
namespace {

constexpr CellKind all_kinds[] = {CellKind::cube, CellKind::hexprism, CellKind::fcc, CellKind::bcc, CellKind::elongated};

void expect_near(const Vector& a, const Vector& b, double tolerance = 1e-9) { EXPECT_LT(glm::distance(a, b), tolerance) << a.x << ',' << a.y << ',' << a.z; }

TEST(CellSelection, NamesEachOrbitOnceAndTheLastPickedLast)
{
    CellTile cell = CellTile::of_kind(CellKind::cube, 2);
    cell.add_point(0, {0, 0});
    cell.shape();
    const int inner = cell.find(CellPointName::interior(0, 0));
    CellSelection selection;
    int changes = 0;
    selection.on_change = [&] { ++changes; };
    const std::vector<LatticeStep> corners(cell.members(0).begin(), cell.members(0).end());
    selection.click(cell, {0, corners[1]}, false, false);
    selection.click(cell, {inner, {}}, true, false);
    EXPECT_EQ(selection.text(), "c0,p0:i0");
    selection.click(cell, {0, corners[2]}, true, false); // another corner of that orbit
    EXPECT_EQ(selection.text(), "p0:i0,c0");
    EXPECT_EQ(selection.picks().size(), 3u);
    EXPECT_TRUE(selection.has({0, corners[1]}));
    EXPECT_FALSE(selection.has({0, corners[3]}));
    EXPECT_TRUE(selection.has_orbit(0));
    selection.click(cell, {0, corners[1]}, false, true);
    selection.click(cell, {0, corners[2]}, true, false); // the last one again: it goes
    EXPECT_EQ(selection.text(), "p0:i0");
    EXPECT_EQ(changes, 5);
}

TEST(CellSelection, KeepsNamesThroughEditsAndForgetsWhatIsGone)
{
    CellTile cell = CellTile::of_kind(CellKind::cube, 2);
    cell.add_point(0, {0, 0});
    cell.add_point(1, {0, 0});
    cell.shape();
    CellSelection selection;
    selection.pick(cell, {{cell.find(CellPointName::interior(0, 0)), {}}, {cell.find(CellPointName::interior(1, 0)), {}}});
    cell.roll_back(0);
    cell.remove_points(std::array{CellPointName::interior(0, 0)});
    selection.follow(&cell);
    EXPECT_EQ(selection.text(), "p1:i0");
    EXPECT_EQ(selection.last()->at.orbit, cell.find(CellPointName::interior(1, 0)));
    selection.follow(nullptr);
    EXPECT_TRUE(selection.empty());
}

TEST(CellSelection, StaysOnThePointsWhereNamesShift)
{
    CellTile cell = CellTile::of_kind(CellKind::cube, 2);
    cell.add_point(0, {0.5, 0});
    cell.add_point(0, {-0.5, 0});
    cell.shape();
    cell.split_triangle(1, 0, {0.2, 0.3, 0.5});
    cell.split_triangle(2, 0, {0.2, 0.3, 0.5});
    cell.split_edge(0, CellPointName::parse("i0"), CellPointName::parse("i1"), 0.5);
    const CellTile before = cell;
    CellSelection selection;
    for (const char* name : {"p0:i1", "s1", "s2"}) selection.add(cell, {{cell.find(CellPointName::parse(name)), {}}});
    cell.roll_back(1); // takes s0
    selection.follow(&cell);
    EXPECT_EQ(selection.text(), "p0:i1,s0,s1");
    cell.roll_back(0); // takes the split of its edge
    cell.remove_points(std::array{CellPointName::interior(0, 0)});
    selection.follow(&cell);
    EXPECT_EQ(selection.text(), "p0:i0,s0");
    EXPECT_EQ(selection.picks()[1].at.orbit, cell.find(CellPointName::split(0)));
    selection.follow(&before); // as undo does
    EXPECT_EQ(selection.text(), "p0:i1,s1");
}

TEST(CellMatch, KnowsNothingOfCellsOfAnotherHeightNorOfPointsThatWereNone)
{
    const CellTile low = CellTile::of_kind(CellKind::hexprism, 4), high = CellTile::of_kind(CellKind::hexprism, 4, 8);
    EXPECT_FALSE(CellMatch(low, high).now(CellPointName::corner(0)));
    EXPECT_TRUE(CellMatch(low, low).now(CellPointName::corner(0)));

    CellTile cell = low;
    cell.add_point(0, {0.5, 0});
    cell.add_point(0, {-0.5, 0});
    CellTile less = cell;
    less.remove_points(std::array{CellPointName::interior(0, 0)});
    const CellMatch match(cell, less);
    EXPECT_EQ(match.now(CellPointName::interior(0, 1)), CellPointName::interior(0, 0));
    EXPECT_FALSE(match.now(CellPointName::interior(0, 2)));
}

TEST(RollBack, TellsOfAllThatGoes)
{
    CellTile cell = CellTile::of_kind(CellKind::cube, 2);
    cell.add_point(0, {0, 0});
    cell.shape();
    EXPECT_TRUE(shape_of(cell, 0).empty());
    cell.split_triangle(0, 0, {0.2, 0.3, 0.5});
    cell.flip(0, CellPointName::parse("i0"), CellPointName::parse("v1"));
    EXPECT_EQ(shape_of(cell, 0).splits, 1);
    EXPECT_EQ(shape_of(cell, 0).flips, 1);
    EXPECT_TRUE(shape_of(cell, 1).empty());
    cell.move(std::vector{cell.find(CellPointName::interior(0, 0))}, {0.1, 0, 0});
    EXPECT_EQ(roll_back_question(0, shape_of(cell, 0)), "Pane 0 becomes flat again, to edit its points and lines.\n1 of its points was moved; begun anew, it forgets that."
                                                        "\n1 point that a split made goes.\n1 edge that was flipped turns back.");
    EXPECT_EQ(roll_back_question(3, {.flips = 2}), "Pane 3 becomes flat again, to edit its points and lines.\n2 edges that were flipped turn back.");
}

TEST(OppositeCamera, TurnsToEveryPaneByTheSmallestAngle)
{
    Session session(all_operators());
    for (const CellKind kind : all_kinds) {
        const CellTile cell = CellTile::of_kind(kind);
        for (const bool linked : {true, false})
            for (int side = 0; side < 2 * cell.pane_count(); ++side) {
                View one(session), other(session);
                one.set_animated(false);
                other.set_animated(false);
                OppositeCamera cameras(one, other);
                one.look({50, 20, 10});
                cameras.set_linked(linked);
                const Camera before = one.camera();
                const Vector normal = normal_of(cell, {side / 2, side % 2 == 1});
                cameras.look_at(normal);
                expect_near(one.camera().backward(), normal);
                expect_near(other.camera().backward(), -normal);
                // What both the eye's old and new direction are at right angles to has not moved in the picture.
                const Vector axis = glm::normalize(glm::cross(before.backward(), normal));
                expect_near(one.camera().rotation() * axis, before.rotation() * axis);
                if (linked) expect_near(other.camera().up(), one.camera().up());
            }
    }
}

TEST(OppositeCamera, HasTheSameUpHoweverItIsTurned)
{
    for (const ViewAngles angles : {ViewAngles{10, 20}, ViewAngles{-100, 70, 30}, ViewAngles{0, 90, -120}, ViewAngles{180, -45, 180}}) {
        Camera camera;
        camera.set_angles(angles);
        const Camera other = opposite(camera, {1, 2, 3});
        expect_near(other.backward(), -camera.backward());
        expect_near(other.up(), camera.up());
        expect_near(other.right(), -camera.right());
    }
}

TEST(OppositeCamera, LooksThroughTheCentreWhicheverViewIsMoved)
{
    Session session(all_operators());
    View one(session), other(session);
    one.set_animated(false);
    other.set_animated(false);
    one.resize(400, 300);
    other.resize(200, 300);
    OppositeCamera cameras(one, other);
    cameras.set_centre({1, 2, 3});
    const auto expect_opposite = [&] { expect_near(0.5 * (one.camera().eye() + other.camera().eye()), {1, 2, 3}); };
    one.look({30, 20});
    expect_opposite();
    other.wheel(2, {.x = 20, .y = 200});
    expect_opposite();
    EXPECT_EQ(other.camera().width(), 200);
    EXPECT_EQ(one.camera().width(), 400);
    cameras.look_at({0, 0, -1});
    expect_near(other.camera().backward(), {0, 0, 1});
    cameras.set_linked(false);
    one.look({0, 0});
    expect_near(other.camera().backward(), {0, 0, 1});
    cameras.look_at({0, 1, 0}); // both of the pair are seen again
    expect_near(other.camera().backward(), {0, -1, 0});
}

void expect_same_picture(const CellPicture& a, const CellPicture& b)
{
    ASSERT_EQ(a.lists().triangle_count(), b.lists().triangle_count());
    ASSERT_EQ(a.lists().vertex_limit(), b.lists().vertex_limit());
    for (std::uint32_t v = 0; v < a.lists().vertex_limit(); ++v) ASSERT_LE(glm::distance(a.lists().position(v), b.lists().position(v)), 1e-12) << v;
    ASSERT_TRUE(std::ranges::equal(a.lists().copies(), b.lists().copies()));
}

TEST(CellPicture, KnowsThePanesAndOrbitsOfWhatIsDrawn)
{
    for (const CellKind kind : all_kinds) {
        CellTile cell = CellTile::of_kind(kind);
        cell.add_point(0, {0.01, 0.02});
        cell.add_edge_point(0, 0.3);
        CellPicture picture;
        picture.set_neighbours(0.8, 1);
        picture.follow(&cell, 0);
        const std::size_t around = 2 * std::size_t(cell.pane_count()); // those that share a pane
        EXPECT_EQ(picture.lists().copies().size(), around);
        const std::size_t own = picture.solid().triangles.size();
        EXPECT_EQ(picture.lists().face_limit(), own);
        std::set<std::pair<int, int>> triangles;
        for (std::uint32_t f = 0; f < own; ++f) {
            const CellSolid::Side side = picture.pane_of(Face(f));
            triangles.insert({2 * side.pane + side.far, picture.triangle_of(Face(f))});
            EXPECT_LT(picture.triangle_of(Face(f)), std::ssize(cell.mesh(side.pane).triangles));
        }
        EXPECT_EQ(triangles.size(), own);
        for (std::uint32_t v = 0; v < picture.solid().points.size(); ++v) {
            const OrbitMember member = picture.orbit_of(Vertex(v));
            expect_near(picture.lists().position(v), cell.position(member.orbit) + cell.cell().at(member.shift));
            EXPECT_EQ(picture.vertex_of(member), Vertex(v));
        }
    }
}

TEST(CellPicture, FollowsAMoveAsIfItWereDrawnAnew)
{
    CellTile cell = CellTile::of_kind(CellKind::fcc, 4);
    for (int k = 0; k < 60; ++k) cell.add_point(k % 6, {0.3 * std::cos(k), 0.3 * std::sin(k)});
    cell.shape();
    CellPicture picture;
    picture.set_neighbours(0.7, 1);
    picture.follow(&cell, -1);
    const std::uint64_t id = picture.lists().id();
    const int point = cell.find(CellPointName::interior(2, 0));
    cell.move(std::vector{point}, {0.1, 0.2, 0.3});
    picture.follow(&cell, -1);
    EXPECT_EQ(picture.lists().id(), id); // only what moved was put again
    CellPicture fresh;
    fresh.set_neighbours(0.7, 1);
    fresh.follow(&cell, -1);
    expect_same_picture(picture, fresh);
    const auto moved = picture.vertex_of({point, {}});
    expect_near(picture.lists().position(moved->index), cell.position(point));

    cell.set_matrix({1.2, 0.3, 0, 0, 1, 0, 0, 0.1, 0.9});
    cell.split_triangle(1, 0, {0.2, 0.3, 0.5});
    picture.follow(&cell, 3);
    CellPicture after;
    after.set_neighbours(0.7, 1);
    after.follow(&cell, 3);
    expect_same_picture(picture, after);
    picture.follow(nullptr, -1);
    EXPECT_FALSE(picture.lists().has_faces());
}

TEST(CellPicture, ScalesNeighboursAboutTheirCentresOfMass)
{
    const CellTile cell = CellTile::of_kind(CellKind::cube, 2);
    CellPicture picture;
    const auto far_corner = [&] { return picture.lists().with_copies(picture.lists().bounds()).max; };
    picture.set_neighbours(0.5, 1);
    picture.follow(&cell, -1);
    EXPECT_EQ(far_corner(), Point(2.5, 2.5, 2.5)); // those around are of edge 1
    picture.set_neighbours(1, 2);
    EXPECT_EQ(far_corner(), Point(5, 5, 5));
    picture.set_neighbours(0, 2);
    EXPECT_EQ(far_corner(), Point(1, 1, 1));
}

TEST(CellFaults, TellsOfANeighbourThatIsMet)
{
    CellTile cell = CellTile::of_kind(CellKind::cube, 2);
    cell.add_point(0, {0, 0});
    cell.shape();
    const std::vector<int> point{cell.find(CellPointName::interior(0, 0))};
    CellFaults faults;
    faults.follow(&cell);
    faults.wait();
    ASSERT_TRUE(faults.found());
    EXPECT_NEAR(faults.found()->volume, 8, 1e-12);
    EXPECT_TRUE(faults.found()->trouble.empty()) << faults.found()->trouble;
    cell.move(point, {0, 1.5, 0}); // through the side of its own pane
    cell.move(point, {0.5, 0, 0});
    faults.follow(&cell);
    faults.wait();
    ASSERT_TRUE(faults.found());
    EXPECT_GT(faults.found()->pairs, 0u);
    EXPECT_EQ(faults.found()->trouble.substr(0, 11), "meets pane ");
    EXPECT_EQ(faults.found()->where.substr(0, 5), "pane ");
    faults.follow(nullptr);
    EXPECT_FALSE(faults.found());
}

/// A cube of edge 2 with a point in the middle of pane 1, whose far one looks at a viewer in front: x is to the right there, z is up.
class CellInView : public testing::Test {
protected:
    CellInView() : session(all_operators()), plane(session), view(session), back(session), cameras(view, back)
    {
        set_layout(Layout(1));
        session.on_change = [this] {
            plane.session_changed();
            picture.follow(plane.cell() ? &*plane.cell() : nullptr, plane.pane());
            selection.follow(plane.cell() ? &*plane.cell() : nullptr);
            tool->go_on();
            back_tool->go_on();
            view.session_changed();
            back.session_changed();
        };
        for (View* v : {&view, &back}) {
            v->set_animated(false);
            v->resize(500, 500);
            v->stand_in = [this] { return &picture.lists(); };
            auto made = std::make_unique<CellTool>(session, v->camera(), plane, picture, selection);
            (v == &view ? tool : back_tool) = made.get();
            v->use_tool(std::move(made));
        }
        run("cell.new cell=cube size=2");
        run("cell.point_add pane=1 at=0,0");
        view.set_parallel(true);
        view.frame(picture.solid().points);
        view.look({0, 0});
    }
    void run(const std::string& command)
    {
        session.run(command);
        session.wait();
    }
    Pointer at(const Point& p, const View& v) const
    {
        const auto seen = v.camera().project(p);
        return {.x = seen->x, .y = seen->y, .button = 1};
    }
    Pointer at(const Point& p) const { return at(p, view); }
    void click(const Pointer& p, View& v)
    {
        v.hover(p);
        v.press(p);
        v.release(p);
        session.wait();
    }
    void click(const Pointer& p) { click(p, view); }
    void drag(const Pointer& from, double dx, double dy)
    {
        Pointer p = from;
        view.press(p);
        p.x += dx / 2, p.y += dy / 2;
        view.drag(p);
        session.wait();
        p.x = from.x + dx, p.y = from.y + dy;
        view.drag(p);
        session.wait();
        view.release(p);
        session.wait();
    }
    double unit() const { return view.camera().unit_per_pixel(); }
    const CellTile& cell() const { return *plane.cell(); }
    Point place(const char* name) const { return cell().position(cell().find(CellPointName::parse(name))); }
    std::string last() const { return session.display().steps.at(session.display().done - 1); }

    Session session;
    CellPlane plane;
    CellPicture picture;
    CellSelection selection;
    View view, back;
    CellTool *tool = nullptr, *back_tool = nullptr;
    OppositeCamera cameras;
};

TEST_F(CellInView, PicksThePaneUnderARightClickInBothViews)
{
    std::vector<std::pair<int, bool>> picked;
    tool->on_pane = back_tool->on_pane = [&](int pane, bool far) { picked.emplace_back(pane, far); };
    view.on_menu = [this](const Pointer& p) { tool->pick_pane(p); };
    back.on_menu = [this](const Pointer& p) { back_tool->pick_pane(p); };
    Pointer p = at({0.5, -1, 0.5});
    p.button = 3;
    click(p);
    p = at({0.5, 1, 0.5}, back);
    p.button = 3;
    click(p, back);
    click({.x = 2, .y = 2, .button = 3});
    EXPECT_EQ(picked, (std::vector<std::pair<int, bool>>{{1, true}, {1, false}, {-1, false}}));
}

TEST_F(CellInView, PicksPointsOnlyOnceTheyMayMove)
{
    click(at({1, -1, 1}));
    EXPECT_TRUE(selection.empty());
    run("cell.shape");
    click(at({1, -1, 1}));
    EXPECT_EQ(selection.text(), "c0");
    Pointer p = at({0, -1, 0});
    p.shift = true;
    click(p);
    EXPECT_EQ(selection.text(), "c0,p1:i0");
    EXPECT_EQ(selection.last()->at.shift, (LatticeStep{0, -1, 0})); // the far one is seen from here
    click(at({0, 1, 0}, back), back);
    EXPECT_EQ(selection.text(), "p1:i0");
    EXPECT_EQ(selection.last()->at.shift, LatticeStep{});
    click(at({0.5, -1, 0.3}));
    EXPECT_TRUE(selection.empty());
    run("document.undo");
    EXPECT_TRUE(selection.empty());
}

TEST_F(CellInView, ABoxPicksWhatIsSeenInIt)
{
    run("cell.shape");
    view.start_box_select();
    drag(at({-1.2, -1, 1.2}), 2.4 / unit(), 1.1 / unit()); // the upper corners in front
    EXPECT_EQ(selection.picks().size(), 2u);
    view.start_box_select();
    drag(at({-1.2, -1, 1.2}), 2.4 / unit(), 2.4 / unit());
    EXPECT_EQ(selection.picks().size(), 5u); // of nine points in front and behind
    EXPECT_EQ(selection.text(), "c0,p1:i0");
}

TEST_F(CellInView, TheArrowMovesTheOrbitAlongItAsOneStep)
{
    run("cell.shape");
    tool->set_along(CellTool::Along::x);
    click(at({0, -1, 0}));
    const std::size_t before = session.display().done;
    const auto arrow = tool->arrow();
    ASSERT_TRUE(arrow);
    EXPECT_GT(arrow->second.x, arrow->first.x + 50);
    drag({.x = 0.5 * (arrow->first.x + arrow->second.x), .y = arrow->first.y + 2, .button = 1}, 40, -90); // only what goes along it counts
    EXPECT_EQ(session.display().done, before + 1);
    EXPECT_EQ(last().substr(0, 37), "cell.move points=p1:i0 along=x amount") << last();
    expect_near(place("p1:i0"), Point(40 * unit(), 1, 0), unit());
    run("document.undo");
    expect_near(place("p1:i0"), Point(0, 1, 0));
}

TEST_F(CellInView, TheRadialArrowPointsFromTheCentreWhicheverPlaceOfAnOrbitIsPicked)
{
    run("cell.shape");
    click(at({1, -1, 1})); // it is not the first of the eight
    const auto arrow = tool->arrow();
    ASSERT_TRUE(arrow);
    const Point2 along = arrow->second - arrow->first;
    EXPECT_NEAR(along.x, -along.y, 1e-9);
    EXPECT_GT(along.x, 0);
    drag({.x = arrow->first.x + 0.5 * along.x, .y = arrow->first.y + 0.5 * along.y, .button = 1}, 30, -30);
    expect_near(place("c0"), Point(1, 1, 1) + 30 * unit() * Vector(1, -1, 1), 2 * unit()) ;
}

TEST_F(CellInView, TheNormalArrowGoesOutwardOnTheFarPaneToo)
{
    run("cell.shape");
    tool->set_along(CellTool::Along::normal);
    view.look({30, 0}); // or it is seen end on
    click(at({0, -1, 0}));
    const auto arrow = tool->arrow();
    ASSERT_TRUE(arrow);
    const Point2 along = arrow->second - arrow->first;
    drag({.x = arrow->second.x, .y = arrow->second.y, .button = 1}, along.x, along.y);
    EXPECT_LT(place("p1:i0").y, 1 - 10 * unit()) << last(); // a bulge in front, so a dent behind
    EXPECT_NEAR(place("p1:i0").x, 0, 1e-12);
}

TEST_F(CellInView, APointIsDraggedInThePlaneOfItsPane)
{
    run("cell.shape");
    view.look({20, 10});
    const Pointer from = at({0, -1, 0});
    drag(from, 40, -30);
    EXPECT_EQ(last().substr(0, 36), "cell.move points=p1:i0 pane=1 plane=") << last();
    const Point moved = place("p1:i0");
    EXPECT_NEAR(moved.y, 1, 1e-12);
    // Turned parallel to the screen, so as far as the pointer went; and about that way.
    EXPECT_NEAR(glm::distance(moved, Point(0, 1, 0)), 50 * unit(), unit());
    EXPECT_GT(moved.x, 30 * unit());
    EXPECT_GT(moved.z, 20 * unit());
    EXPECT_EQ(selection.text(), "p1:i0");
}

TEST_F(CellInView, APlaneIsReadThroughTheSkew)
{
    run("cell.shape");
    run("cell.skew matrix=2,0,0,0,1,0,0,0,0.5");
    view.frame(picture.solid().points);
    const Point before = place("p1:i0");
    drag(at({0, -1, 0}), 30, -30);
    const Point moved = place("p1:i0"); // before the skew
    EXPECT_NEAR(moved.x - before.x, 15 * unit(), unit());
    EXPECT_NEAR(moved.z - before.z, 60 * unit(), 2 * unit());
}

TEST_F(CellInView, EscapeTakesADragBack)
{
    run("cell.shape");
    const std::size_t before = session.display().done;
    Pointer p = at({0, -1, 0});
    view.press(p);
    p.x += 30;
    view.drag(p);
    session.wait();
    EXPECT_TRUE(tool->is_moving());
    EXPECT_EQ(session.display().done, before + 1);
    view.cancel();
    session.wait();
    EXPECT_FALSE(tool->is_moving());
    EXPECT_EQ(session.display().done, before);
    expect_near(place("p1:i0"), Point(0, 1, 0));
}

TEST_F(CellInView, ADoubleClickSplitsATriangleOrAnEdgeWhereItIsClicked)
{
    run("cell.shape");
    Pointer p = at({0.2, -1, 0.6});
    p.twice = true;
    click(p);
    EXPECT_EQ(last().substr(0, 18), "cell.split face=p1") << last();
    expect_near(place("s0"), Point(0.2, 1, 0.6), 0.01);
    p = at({0.5, -1, 1}); // the side between two panes
    p.twice = true;
    click(p);
    EXPECT_EQ(last().substr(0, 22), "cell.split_edge pane=1") << last();
    const int split = cell().find(CellPointName::split(1));
    EXPECT_EQ(cell().members(split).size(), 4u);
    expect_near(place("s1"), Point(0.5, place("s1").y, place("s1").z), 0.01);
}

TEST_F(CellInView, AModeTurnsTheEdgeThatIsClicked)
{
    run("cell.shape");
    tool->set_mode(CellTool::Mode::flip);
    click(at({0.5, -1, 0.1})); // no edge is near
    EXPECT_EQ(last(), "cell.shape");
    click(at({0.5, -1, 0.5})); // of the middle to the corner
    EXPECT_EQ(last().substr(0, 16), "cell.flip pane=1") << last();
    EXPECT_TRUE(session.message().kind != Message::Kind::error) << session.message().text;
}

TEST_F(CellInView, DotsAreSmallerThanWhatIsBetweenThemAndGoWhereTheyWouldBeDust)
{
    for (int i = 0; i < 12; ++i)
        for (int k = 0; k < 12; ++k) run(fmt::format("cell.point_add pane=1 at={},{}", -0.7 + 0.125 * i + 0.03 * (k % 2), -0.7 + 0.125 * k));
    run("cell.shape");
    const auto widest = [this] {
        double width = 0;
        for (const ThickLine& line : view.overlay().lines)
            if (line.from == line.to && std::abs(line.from.x) < 0.9 && std::abs(line.from.z) < 0.9) width = std::max(width, line.width);
        return width;
    };
    const double between = 0.125 / unit();
    EXPECT_GT(between, 10);
    EXPECT_LT(widest(), 0.5 * between);
    EXPECT_GT(widest(), 2);
    view.zoom(0.1);
    EXPECT_EQ(widest(), 0) << "nothing but the corners is marked";
    selection.pick(cell(), {{cell().find(CellPointName::parse("p1:i5")), {0, -1, 0}}});
    EXPECT_GE(widest(), 5) << "what is picked always is";
}

TEST_F(CellInView, APointThatIsGoneWhenItIsDraggedOrReleasedIsLeftAlone)
{
    run("cell.shape");
    for (const double dx : {0.0, 30.0}) {
        run("cell.split face=p1:0 at=0.3,0.3,0.4");
        Pointer p = at(place("s0") - Vector(0, 2, 0)); // of its far one
        view.press(p);
        run("document.undo");
        p.x += dx;
        view.drag(p);
        session.wait();
        view.release(p);
        session.wait();
        EXPECT_EQ(last(), "cell.shape");
        EXPECT_TRUE(selection.empty());
    }
}

TEST_F(CellInView, APointThatIsCalledOtherwiseWhenItIsDraggedIsTheOneThatMoves)
{
    run("cell.point_add pane=1 at=0.5,0.5");
    run("cell.shape");
    run("cell.rollback pane=0");
    run("cell.point_add pane=0 at=0,0"); // the numbers of all orbits behind it are others without it
    Pointer p = at(place("p1:i1") - Vector(0, 2, 0));
    view.press(p);
    run("document.undo");
    p.x += 20;
    view.drag(p);
    session.wait();
    view.release(p);
    session.wait();
    EXPECT_TRUE(last().starts_with("cell.move points=p1:i1 ")) << last();
}

TEST_F(CellInView, MarksTheWholeOrbitOfWhatIsPicked)
{
    run("cell.shape");
    click(at({1, -1, 1}));
    const auto dots_at = [this](const Point& p) {
        std::set<std::uint32_t> colours;
        for (const ThickLine& line : view.overlay().lines)
            if (line.from == line.to && glm::distance(line.from, p) < 1e-9) colours.insert(line.colour.red << 16 | line.colour.green << 8 | line.colour.blue);
        return colours;
    };
    const auto here = dots_at({1, -1, 1}), partner = dots_at({-1, 1, -1}), other = dots_at({0, -1, 0});
    EXPECT_EQ(here.size(), 2u);
    EXPECT_EQ(partner.size(), 2u); // though it is behind
    EXPECT_NE(here, partner);
    EXPECT_NE(other, partner);
    EXPECT_FALSE(view.overlay().screen_lines.empty());
}

} // namespace
} // namespace druse::ui
