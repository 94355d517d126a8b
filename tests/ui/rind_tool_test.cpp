#include "ui/cube_view.h"

namespace druse::ui {
namespace {

/// The cube as a crust: faces 0 to 5 outside, 6 to 11 inside.
class RindView : public CubeView {
protected:
    RindView() { run("rind.crust thickness=0.2"); }
    std::size_t live_pairs() const { return session.rind()->pairs(*session.mesh()).size(); }
};

TEST_F(RindView, OneClickIsOneHoleAndOneStep)
{
    arm("rind.punch");
    click(200, 200);
    EXPECT_EQ(session.display().steps.size(), 2u);
    EXPECT_EQ(last_step(), "rind.punch faces=2");
    EXPECT_EQ(session.display().counts, (Counts{16, 28, 14})); // 30-rind-and-pipes, the table of section 6
    EXPECT_EQ(live_pairs(), 5u);
    EXPECT_EQ(session.message().text, "parts 2 → 1, genus 0");
    view.look({90, 0}); // from the right
    click(200, 200);
    EXPECT_EQ(session.display().steps.size(), 3u);
    EXPECT_EQ(session.display().counts, (Counts{16, 32, 16}));
    EXPECT_EQ(session.message().text, "parts 1, genus 0 → 1");
    session.undo();
    session.wait();
    EXPECT_EQ(live_pairs(), 5u);
    click(200, 200);
    EXPECT_EQ(session.display().counts, (Counts{16, 32, 16}));
}

TEST_F(RindView, BothFacesOfAPairAreOutlined)
{
    arm("rind.punch");
    view.hover(at(200, 200, 0));
    EXPECT_EQ(view.overlay().hovered, (std::vector<Face>{Face(2), Face(8)}));
}

TEST_F(RindView, TheInnerSurfaceOpensTheSameHole)
{
    arm("rind.punch");
    click(200, 200);
    // Through the hole, the far wall of the inner surface is seen: that of the face behind, 4.
    const auto behind = session.rind()->find(*session.mesh(), Face(4));
    ASSERT_TRUE(behind);
    click(200, 200);
    EXPECT_EQ(last_step(), "rind.punch faces=10");
    EXPECT_EQ(session.display().counts, (Counts{16, 32, 16})); // opposite holes
    EXPECT_FALSE(session.rind()->find(*session.mesh(), Face(4)));
}

TEST_F(RindView, AFaceThatIsInNoRindOnlyGivesALine)
{
    arm("rind.punch");
    view.look({0, 45});
    const Point2 wall = *view.camera().project({0, -0.94, -0.94}); // in the hole to come: its lower wall
    const Point2 front = *view.camera().project({0, -1, 0.5});
    click(front.x, front.y);
    ASSERT_EQ(session.display().steps.size(), 2u);
    click(wall.x, wall.y);
    EXPECT_EQ(session.display().steps.size(), 2u);
    EXPECT_EQ(session.message().kind, Message::Kind::note);
    EXPECT_TRUE(session.message().text.starts_with("face ") && session.message().text.ends_with(" is not part of a rind")) << session.message().text;
    EXPECT_TRUE(session.failed_faces().empty());
}

TEST_F(RindView, PeelTakesTheWallBetweenNeighboursAway)
{
    arm("rind.peel");
    click(200, 200);
    view.look({90, 0});
    click(200, 200);
    EXPECT_EQ(session.display().steps.size(), 3u);
    EXPECT_EQ(session.display().counts, (Counts{16, 28, 14})); // peel 2 adjacent
}

TEST_F(CubeView, WithoutARindTheToolSaysWhatMakesOne)
{
    arm("rind.peel");
    EXPECT_EQ(view.hint(), "there is no rind to open: Crust makes one");
    click(200, 200);
    EXPECT_TRUE(session.display().steps.empty());
    EXPECT_EQ(session.message().text, "face 2 is not part of a rind");
    run("rind.crust thickness=0.2");
    EXPECT_EQ(view.hint(), "click a face of either surface: Peel");
}

} // namespace
} // namespace druse::ui
