#include "ui/cube_view.h"

#include "ui/layout.h"

namespace druse::ui {
namespace {

constexpr double beside = 4; // pixels from the left end: no mesh there

TEST_F(CubeView, PressOutlinesTheFaceAndReleaseActs)
{
    arm("extrude.cubical");
    session.set("grouped", "false");
    view.press(at(200, 200));
    EXPECT_EQ(view.overlay().pressed, std::vector<Face>{Face(2)});
    EXPECT_TRUE(session.display().steps.empty());
    view.release(at(200, 200));
    EXPECT_EQ(last_step(), "extrude.cubical faces=2 grouped=false");
    EXPECT_TRUE(view.overlay().pressed.empty());
}

TEST_F(CubeView, WithGroupedTheWholeGroupIsOutlined)
{
    arm("extrude.cubical");
    view.press(at(200, 200));
    EXPECT_EQ(view.overlay().pressed, (std::vector<Face>{Face(2), Face(3), Face(4), Face(5)}));
    EXPECT_EQ(events.back(), "pressed face 2 outlined 4");
}

TEST_F(CubeView, TheOutlineFollowsThePointerAndTheLastFaceCounts)
{
    view.look({0, 45}); // top and front
    arm("extrude.cubical");
    view.press(at(200, 280));
    EXPECT_EQ(view.overlay().pressed.front(), Face(2));
    view.drag(at(200, 120));
    EXPECT_EQ(view.overlay().pressed, std::vector<Face>{Face(1)});
    view.release(at(200, 120));
    EXPECT_EQ(last_step(), "extrude.cubical faces=1");
}

TEST_F(CubeView, ReleasedBesideTheMeshNothingHappens)
{
    arm("extrude.cubical");
    const Camera before = view.camera();
    view.press(at(200, 200));
    view.drag(at(beside, 200));
    EXPECT_TRUE(view.overlay().pressed.empty());
    view.release(at(beside, 200));
    EXPECT_TRUE(session.display().steps.empty());
    EXPECT_EQ(view.camera(), before);
}

TEST_F(CubeView, EscapeAndASecondButtonCancelAPress)
{
    arm("extrude.cubical");
    view.press(at(200, 200));
    EXPECT_TRUE(view.cancel());
    EXPECT_TRUE(view.overlay().pressed.empty());
    view.release(at(200, 200));
    EXPECT_TRUE(session.display().steps.empty());
    EXPECT_FALSE(view.cancel());

    view.press(at(200, 200));
    view.press(at(200, 200, 3));
    view.release(at(200, 200, 3));
    view.release(at(200, 200));
    EXPECT_TRUE(session.display().steps.empty());
}

TEST_F(CubeView, HoveringOutlinesThinly)
{
    view.hover(at(200, 200, 0));
    EXPECT_EQ(view.overlay().hovered, std::vector<Face>{Face(2)});
    view.hover(at(beside, 200, 0));
    EXPECT_TRUE(view.overlay().hovered.empty());
    view.hover(at(200, 200, 0));
    view.leave();
    EXPECT_TRUE(view.overlay().hovered.empty());
}

TEST_F(CubeView, WithoutAToolClicksSelect)
{
    click(200, 200);
    EXPECT_EQ(session.display().selection->faces, std::vector<Face>{Face(2)});
    Pointer add = at(200, 200);
    view.look({0, 90}); // from above: face 1
    add.shift = true;
    view.press(add);
    view.release(add);
    EXPECT_EQ(session.display().selection->faces, (std::vector<Face>{Face(1), Face(2)}));
    Pointer remove = at(200, 200);
    remove.ctrl = true;
    view.press(remove);
    view.release(remove);
    EXPECT_EQ(session.display().selection->faces, std::vector<Face>{Face(2)});
    click(beside, 200);
    EXPECT_TRUE(session.display().selection->faces.empty());
}

TEST_F(CubeView, ADoubleClickSelectsTheGroup)
{
    Pointer twice = at(200, 200);
    twice.twice = true;
    view.press(twice);
    view.release(twice);
    EXPECT_EQ(session.display().selection->faces, (std::vector<Face>{Face(2), Face(3), Face(4), Face(5)}));
    EXPECT_EQ(last_step(), "select.faces faces=group:3");
}

TEST_F(CubeView, EdgesAndVerticesAreSelectedNearThePointer)
{
    // The front face seen straight: its corners are vertices 0, 1, 5 and 4.
    const Point2 corner = *view.camera().project({1, -1, 1});
    view.set_element(Element::vertex);
    click(corner.x - 3, corner.y + 3);
    EXPECT_EQ(session.display().selection->vertices, std::vector<Vertex>{Vertex(5)});
    view.set_element(Element::edge);
    const Point2 side = *view.camera().project({1, -1, 0});
    click(side.x - 3, side.y);
    ASSERT_EQ(session.display().selection->edges.size(), 1u);
    const auto ends = session.mesh()->ends(session.display().selection->edges.front());
    EXPECT_EQ(ends[0].index + ends[1].index, 6u); // vertices 1 and 5
}

TEST_F(CubeView, ABoxSelectsWhatLiesInsideIt)
{
    view.start_box_select();
    view.press(at(beside, beside));
    view.drag(at(396, 396));
    EXPECT_GE(view.overlay().screen_lines.size(), 4u);
    view.release(at(396, 396));
    EXPECT_EQ(session.display().selection->faces.size(), 6u);
    // Once only: the next drag is no box.
    view.press(at(beside, beside));
    view.drag(at(60, 60));
    view.release(at(60, 60));
    EXPECT_EQ(session.display().selection->faces.size(), 6u);
}

TEST_F(CubeView, TheCameraTurnsWithTheMiddleButtonAndOnTheBackground)
{
    arm("extrude.cubical");
    for (const Pointer& start : {at(200, 200, 2), at(beside, 200, 1)}) {
        const ViewAngles before = view.camera().angles();
        view.press(start);
        view.drag(at(start.x + 40, start.y + 10, start.button));
        view.release(at(start.x + 40, start.y + 10, start.button));
        EXPECT_NE(view.camera().angles(), before);
    }
    EXPECT_TRUE(session.display().steps.empty());
}

TEST_F(CubeView, TheWheelZoomsToThePointer)
{
    const double before = view.camera().distance();
    view.wheel(-1, at(200, 200, 0));
    EXPECT_LT(view.camera().distance(), before);
    view.wheel(1, at(200, 200, 0));
    EXPECT_NEAR(view.camera().distance(), before, 1e-9);
}

TEST_F(CubeView, AClickOnAnAxisLooksAlongIt)
{
    view.look({45, 35});
    // z points upward in the picture, straight above the middle of the cross.
    const double inset = layout().gizmo_margin() + layout().gizmo_radius();
    const double lift = layout().gizmo_radius() * std::cos(35 * 3.14159265358979 / 180);
    click(400 - inset, inset - lift);
    EXPECT_EQ(view.camera().angles(), (ViewAngles{0, 90}));
}

TEST_F(CubeView, AnAnimatedViewArrivesExactly)
{
    view.set_animated(true);
    view.look({-90, 10});
    EXPECT_TRUE(view.animate(5.0));
    EXPECT_TRUE(view.animate(5.1));
    EXPECT_FALSE(view.animate(5.3));
    EXPECT_EQ(view.camera().angles(), (ViewAngles{-90, 10}));
}

TEST_F(CubeView, AFreeOrbitGoesOverThePolesAndLevelsWhenItEnds)
{
    const auto drag_down = [this](double pixels) {
        view.press(at(200, 200, 2));
        view.drag(at(200, 200 + pixels, 2));
        view.release(at(200, 200 + pixels, 2));
    };
    view.look({0, 0});
    drag_down(1000); // 350 degrees
    EXPECT_EQ(view.camera().angles(), (ViewAngles{0, 90}));
    view.look({0, 0});
    view.set_free_orbit(true);
    drag_down(400); // 140 degrees: upside down behind it
    EXPECT_LE(glm::distance(view.camera().up(), Vector(0, std::sin(140 * 3.14159265358979 / 180), std::cos(140 * 3.14159265358979 / 180))), 1e-9);
    view.set_free_orbit(false);
    EXPECT_EQ(view.camera().angles().roll, 0);
    EXPECT_GT(view.camera().up().z, 0);
}

TEST_F(CubeView, ATurnOutOfTheLevelIsTheSmallest)
{
    view.look({20, 30, 40});
    const Vector from = view.camera().backward(), to = glm::normalize(Vector(1, -2, -3));
    const Vector axis = glm::normalize(glm::cross(from, to));
    view.set_animated(true);
    view.look_from(to, 1);
    EXPECT_TRUE(view.animate(5.0));
    EXPECT_TRUE(view.animate(5.5)); // half way
    EXPECT_LE(glm::distance(view.camera().backward(), glm::normalize(from + to)), 1e-9);
    EXPECT_FALSE(view.animate(6.0));
    EXPECT_LE(glm::distance(view.camera().backward(), to), 1e-9);
    view.look({20, 30, 40}, 1); // and back about the same axis
    EXPECT_TRUE(view.animate(7.0));
    EXPECT_TRUE(view.animate(7.3));
    EXPECT_NEAR(glm::dot(view.camera().backward(), axis), 0, 1e-9);
    EXPECT_FALSE(view.animate(8.0));
    EXPECT_EQ(view.camera().angles(), (ViewAngles{20, 30, 40}));
}

TEST_F(CubeView, TheStartCornerToolNamesTheNearestCorner)
{
    arm("face.start");
    const Point2 corner = *view.camera().project({1, -1, 1});
    click(corner.x - 20, corner.y + 20);
    EXPECT_EQ(last_step(), "face.start faces=2 vertex=5");
}

TEST_F(CubeView, TwoClicksOnCornersInsertAnEdge)
{
    arm("topology.insert_edge");
    const Point2 a = *view.camera().project({-1, -1, -1}), b = *view.camera().project({1, -1, 1});
    click(a.x + 20, a.y - 20);
    EXPECT_TRUE(session.display().steps.empty());
    click(b.x - 20, b.y + 20);
    // Face 2 of the file is 1 2 6 5, counted from 1: its corners 0 and 2.
    EXPECT_EQ(last_step(), "topology.insert_edge c1=2:0 c2=2:2");
    EXPECT_EQ(session.display().counts, (Counts{8, 13, 7}));
}

TEST_F(CubeView, AClickOnAnEdgeDeletesIt)
{
    arm("topology.delete_edge");
    const Point2 side = *view.camera().project({1, -1, 0});
    click(side.x - 3, side.y);
    EXPECT_EQ(session.display().counts, (Counts{8, 11, 5}));
}

TEST_F(CubeView, ARightClickAsksForTheMenuAndARightDragPans)
{
    int menus = 0;
    view.on_menu = [&](const Pointer&) { ++menus; };
    view.press(at(200, 200, 3));
    view.release(at(200, 200, 3));
    EXPECT_EQ(menus, 1);
    const Point before = view.camera().target();
    view.press(at(200, 200, 3));
    view.drag(at(230, 200, 3));
    view.release(at(230, 200, 3));
    EXPECT_EQ(menus, 1);
    EXPECT_NE(view.camera().target(), before);
}

} // namespace
} // namespace druse::ui
