#include "ui/paint_tool.h"

#include "ui/cube_view.h"

#include <algorithm>
#include <cmath>

namespace druse::ui {
namespace {

/// The same with the brush in hand and group 7 on it; top and front are seen.
class Brush : public CubeView {
protected:
    Brush()
    {
        view.look({0, 45});
        arm("group.assign");
        session.set("id", "7");
    }
};

constexpr double x = 200, on_front = 280, on_top = 120, beside = 4;

TEST_F(Brush, AStrokeIsOneCommandOnEveryFaceItWentOver)
{
    view.press(at(x, on_front));
    EXPECT_EQ(view.overlay().painted, std::vector<Face>{Face(2)});
    EXPECT_EQ(view.overlay().paint, GroupTable::default_colour(7));
    view.drag(at(x, on_top));
    EXPECT_EQ(view.overlay().painted, (std::vector<Face>{Face(1), Face(2)}));
    EXPECT_TRUE(session.display().steps.empty()) << "nothing happens before the release";
    view.release(at(x, on_top));
    session.wait();
    EXPECT_EQ(session.display().steps, std::vector<std::string>{"group.assign faces=1-2 id=7"});
    EXPECT_TRUE(view.overlay().painted.empty());
    EXPECT_EQ(session.mesh()->group(Face(1)), 7);
    EXPECT_EQ(*session.display().group_sizes, (std::vector<GroupSize>{{1, 1}, {3, 3}, {7, 2}}));
    session.undo();
    session.wait();
    EXPECT_EQ(*session.display().group_sizes, (std::vector<GroupSize>{{1, 1}, {2, 1}, {3, 4}}));
}

TEST_F(Brush, EscapeTakesAStrokeBack)
{
    view.press(at(x, on_front));
    view.drag(at(x, on_top));
    EXPECT_TRUE(view.cancel());
    EXPECT_TRUE(view.overlay().painted.empty());
    view.release(at(x, on_top));
    EXPECT_TRUE(session.display().steps.empty());
}

TEST_F(Brush, CtrlTakesFacesOutOfTheirGroups)
{
    Pointer p = at(x, on_front);
    p.ctrl = true;
    view.press(p);
    EXPECT_EQ(view.overlay().paint, GroupTable::default_colour(0));
    view.release(at(x, on_front)); // the key may be up again
    session.wait();
    EXPECT_EQ(last_step(), "group.assign faces=2 id=0");
}

TEST_F(Brush, AnotherPaintLeavesTheLastStrokeAlone)
{
    click(x, on_front);
    session.let_go();
    session.set("id", "8");
    session.wait();
    click(x, on_top);
    EXPECT_EQ(session.display().steps, (std::vector<std::string>{"group.assign faces=2 id=7", "group.assign faces=1 id=8"}));
}

TEST_F(Brush, WithoutAGroupItDoesNotPaint)
{
    session.set("id", "");
    click(x, on_front);
    EXPECT_TRUE(session.display().steps.empty());
    EXPECT_EQ(view.hint(), "choose the group to paint with");
}

TEST_F(Brush, AStrokeBeginsOnTheMesh)
{
    const ViewAngles before = view.camera().angles();
    view.press(at(beside, beside));
    view.drag(at(x, on_front));
    view.release(at(x, on_front));
    EXPECT_TRUE(session.display().steps.empty());
    EXPECT_NE(view.camera().angles(), before) << "beside it the camera turns";
}

/// A sheet of 20 by 20 unit squares about the origin, seen from above.
class BrushOnSheet : public Brush {
protected:
    BrushOnSheet()
    {
        session.choose(nullptr);
        session.start_over();
        session.wait();
        run("make.grid nx=20 ny=20 size=1");
        view.look({0, 90});
        view.set_parallel(true);
        view.frame_all();
        arm("group.assign");
    }
};

TEST_F(BrushOnSheet, AFastDragLeavesNoGaps)
{
    const DrawLists& lists = session.display().lists;
    const double y = 200 + 0.5 / view.camera().unit_per_pixel(); // the middle of a row
    view.press(at(202, y));
    view.drag(at(8, y));
    view.drag(at(395, y));
    const std::vector<Face> painted = view.overlay().painted;
    EXPECT_EQ(painted.size(), 20u);
    for (const Face f : painted)
        for (const auto& [a, b] : lists.sides(f)) EXPECT_LE(std::abs(lists.position(a).y + 0.5), 0.5 + 1e-9);
}

TEST_F(BrushOnSheet, AWideBrushTakesExactlyTheSquaresItReaches)
{
    view.set_brush(3.3 / view.camera().unit_per_pixel());
    view.press(at(200, 200));
    std::vector<Face> expected;
    const Mesh& mesh = *session.mesh();
    for (const Face f : mesh.faces()) {
        if (mesh.valence(f) != 4) continue; // the other side
        Point low(1e9), high(-1e9);
        for (const Corner c : mesh.corners(f)) low = glm::min(low, mesh.position(mesh.vertex(c))), high = glm::max(high, mesh.position(mesh.vertex(c)));
        const double dx = std::max({low.x, -high.x, 0.0}), dy = std::max({low.y, -high.y, 0.0});
        if (std::hypot(dx, dy) <= 3.3) expected.push_back(f);
    }
    EXPECT_GT(expected.size(), 30u);
    EXPECT_EQ(view.overlay().painted, expected);
}

TEST_F(BrushOnSheet, TheHistoryGivesTheSameMeshInATerminal)
{
    view.set_brush(20);
    view.press(at(150, 150));
    view.drag(at(250, 210));
    view.release(at(250, 210));
    session.wait();
    Document document(all_operators());
    for (const std::string& step : session.display().steps) document.apply(step);
    EXPECT_TRUE(document.scene().mesh == *session.mesh());
}

TEST_F(CubeView, AGroupIsDroppedOnAFace)
{
    view.carry(view.make_tool<DropGroupTool>(1), at(900, 300));
    EXPECT_TRUE(view.overlay().painted.empty());
    EXPECT_EQ(view.hint(), "release on a face to put it into group 1");
    view.drag(at(200, 200));
    EXPECT_EQ(view.overlay().painted, std::vector<Face>{Face(2)});
    EXPECT_EQ(view.overlay().pressed, std::vector<Face>{Face(2)});
    view.release(at(200, 200));
    session.wait();
    EXPECT_EQ(last_step(), "group.assign faces=2 id=1");
}

TEST_F(CubeView, AGroupThatIsDroppedElsewhereGoesNowhere)
{
    view.carry(view.make_tool<DropGroupTool>(1), at(200, 200));
    view.release(at(500, 200)); // outside the view
    view.carry(view.make_tool<DropGroupTool>(1), at(200, 200));
    EXPECT_TRUE(view.cancel());
    view.release(at(200, 200));
    EXPECT_TRUE(session.display().steps.empty());
    click(200, 200);
    EXPECT_EQ(last_step(), "select.faces faces=2") << "clicks select again";
}

} // namespace
} // namespace druse::ui
