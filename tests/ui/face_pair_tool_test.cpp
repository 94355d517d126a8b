#include "ui/cube_view.h"

namespace druse::ui {
namespace {

/// The cube with a tool for two faces in hand. The top is seen from above, at (200, 200), the bottom from below.
class FacePair : public CubeView {
protected:
    FacePair() { arm("topology.pipe"); }
    void from_top() { view.look({0, 90}); }
    void from_below() { view.look({0, -90}); }
};

TEST_F(FacePair, TwoClicksMakeAPipe)
{
    from_top();
    click(200, 200);
    EXPECT_TRUE(session.display().steps.empty());
    EXPECT_EQ(view.overlay().pressed, std::vector<Face>{Face(1)}) << "the first face stays marked";
    from_below();
    view.hover(at(200, 200, 0));
    EXPECT_EQ(view.overlay().lines.size(), 4u) << "a rung for each corner";
    for (const ThickLine& rung : view.overlay().lines) {
        // The pairing with the least twist goes straight down the edges of the cube.
        EXPECT_EQ(rung.from.z, 1);
        EXPECT_EQ(rung.to, (Point{rung.from.x, rung.from.y, -1}));
    }
    EXPECT_TRUE(session.display().steps.empty());
    click(200, 200);
    EXPECT_EQ(session.display().steps, std::vector<std::string>{"topology.pipe from=1 to=0"});
    EXPECT_EQ(session.display().counts, (Counts{8, 16, 8})); // E + n, F + n - 2
    EXPECT_EQ(session.message().text, "parts 1, genus 0 → 1");
    view.hover(at(200, 200, 0));
    EXPECT_TRUE(view.overlay().pressed.empty()) << "it is over with the first face";
    EXPECT_TRUE(view.overlay().lines.empty());
}

TEST_F(FacePair, WithShiftTheNearestCornersAreJoined)
{
    const auto press = [this](const Point& corner, bool shift) {
        const Point2 place = *view.camera().project(corner);
        Pointer p = at(0.9 * place.x + 20, 0.9 * place.y + 20); // a little way into the face
        p.shift = shift;
        view.press(p);
        view.release(p);
        session.wait();
        p.button = 0;
        view.hover(p);
    };
    const Mesh& mesh = *session.mesh();
    const auto corner_at = [&mesh](Face f, const Point& p) {
        int k = 0;
        for (const Corner c : mesh.corners(f)) {
            if (mesh.position(c) == p) return k;
            ++k;
        }
        return -1;
    };
    const Point above{1, 1, 1}, below{1, -1, -1};
    const std::string expected = "topology.pipe from=1 to=0 corners=" + std::to_string(corner_at(Face(1), above)) + "," + std::to_string(corner_at(Face(0), below));
    from_top();
    press(above, false);
    from_below();
    press(below, true);
    EXPECT_EQ(last_step(), expected);
}

TEST_F(FacePair, ShiftAloneShowsTheNearestCorner)
{
    from_top();
    click(200, 200);
    from_below();
    view.hover(at(250, 250, 0));
    EXPECT_TRUE(view.overlay().vertices.empty());
    view.hold_shift(true);
    EXPECT_EQ(view.overlay().vertices.size(), 1u);
    view.hold_shift(false);
    EXPECT_TRUE(view.overlay().vertices.empty());
}

TEST_F(FacePair, EscapeDropsTheFirstFace)
{
    from_top();
    click(200, 200);
    EXPECT_EQ(view.hint(), "click the second face: Pipe; Shift joins the nearest corners, Escape drops face 1");
    EXPECT_TRUE(view.cancel());
    EXPECT_TRUE(view.overlay().pressed.empty());
    EXPECT_EQ(view.hint(), "click the first face: Pipe");
    EXPECT_FALSE(view.cancel());
    from_below();
    click(200, 200);
    EXPECT_TRUE(session.display().steps.empty());
    EXPECT_EQ(view.overlay().pressed, std::vector<Face>{Face(0)});
}

TEST_F(FacePair, AClickOnTheSameFaceOrBesideTheMeshDropsItToo)
{
    from_top();
    click(200, 200);
    click(200, 200);
    EXPECT_TRUE(view.overlay().pressed.empty());
    click(200, 200);
    click(4, 4);
    EXPECT_TRUE(view.overlay().pressed.empty());
    EXPECT_TRUE(session.display().steps.empty());
}

TEST_F(FacePair, WhatCannotBeJoinedIsSaidBeforeTheClick)
{
    from_top();
    click(200, 200);
    view.look({0, 0});
    view.hover(at(200, 200, 0));
    EXPECT_TRUE(view.hint().starts_with("faces 1 and 2 share vertex ")) << view.hint();
    EXPECT_TRUE(view.overlay().lines.empty());
    click(200, 200);
    EXPECT_TRUE(session.display().steps.empty());
    EXPECT_EQ(session.failed_faces(), (std::vector<Face>{Face(1), Face(2)}));
    EXPECT_EQ(view.overlay().pressed, std::vector<Face>{Face(1)}) << "another second face may be tried";
}

TEST_F(FacePair, AnotherMeshForgetsTheFirstFace)
{
    from_top();
    click(200, 200);
    run("mesh.transform scale=2");
    EXPECT_TRUE(view.overlay().pressed.empty());
    EXPECT_EQ(view.hint(), "click the first face: Pipe");
}

TEST_F(FacePair, AHandleShowsAllItsRings)
{
    arm("topology.handle");
    session.set("segments", "3");
    from_top();
    click(200, 200);
    from_below();
    view.hover(at(200, 200, 0));
    EXPECT_EQ(view.overlay().lines.size(), 3u * 4u);
    click(200, 200);
    EXPECT_EQ(last_step(), "topology.handle from=1 to=0 segments=3");
    EXPECT_EQ(session.display().counts, (Counts{8 + 4 * 2, 12 + 4 * 5, 6 + 4 * 3 - 2})); // V + n(s-1), E + n(2s-1), F + ns - 2
}

} // namespace
} // namespace druse::ui
