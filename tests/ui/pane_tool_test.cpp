#include "ui/pane_tool.h"
#include "ui/view.h"

#include "app/registry.h"

#include <gtest/gtest.h>

#include <string>

namespace druse::ui {
namespace {

/// A view from above of a pane from (0,0) to (10,10) with points 4 at (3,5) and 5 at (7,5).
class PaneInView : public testing::Test {
protected:
    PaneInView() : session(all_operators()), view(session)
    {
        session.on_change = [this] { view.session_changed(); };
        view.set_animated(false);
        view.resize(500, 500);
        for (const char* command : {"pane.new loop=0,0,10,0,10,10,0,10", "pane.add at=3,5", "pane.add at=7,5"}) run(command);
        view.look({0, 90});
        view.set_parallel(true);
        view.frame_all();
    }
    void run(const std::string& command)
    {
        session.run(command);
        session.wait();
    }
    void choose(const char* op)
    {
        session.choose(&all_operators().get(op));
        view.session_changed();
    }
    Pointer at(double u, double v) const
    {
        const auto seen = view.camera().project({u, v, 0});
        Pointer p;
        p.x = seen->x;
        p.y = seen->y;
        p.button = 1;
        return p;
    }
    void click(double u, double v)
    {
        view.press(at(u, v));
        view.release(at(u, v));
        session.wait();
    }
    const Pane& pane() const { return std::get<Pane>(*session.scene()->source); }
    std::string last() const { return session.display().steps.back(); }

    Session session;
    View view;
};

TEST_F(PaneInView, AddsAPointWhereItIsClickedAndOnALineExactly)
{
    choose("pane.add");
    click(5, 8);
    EXPECT_EQ(pane().point_count(), 7u);
    EXPECT_NEAR(pane().position(PointId(6)).x, 5, 0.05);
    click(4, 0.05); // a few pixels beside the boundary
    EXPECT_EQ(last().substr(0, 12), "pane.add at=");
    EXPECT_NE(last().find("edge="), std::string::npos) << last();
    EXPECT_EQ(pane().position(PointId(7)).y, 0);
    EXPECT_EQ(pane().boundary_count(), 5u);
}

TEST_F(PaneInView, TakesAPointAlongWithADragAsOneStep)
{
    choose("pane.move");
    const std::size_t before = session.display().done;
    view.press(at(3, 5));
    for (const double u : {4.0, 4.5, 5.0}) view.drag(at(u, 7)), session.wait();
    view.release(at(5, 7));
    session.wait();
    EXPECT_EQ(session.display().done, before + 1);
    EXPECT_NEAR(pane().position(PointId(4)).x, 5, 0.05);
    EXPECT_NEAR(pane().position(PointId(4)).y, 7, 0.05);
}

TEST_F(PaneInView, JoinsTwoPointsByALineAndTakesItAwayAgain)
{
    choose("pane.constrain");
    click(3, 5);
    click(7, 5);
    EXPECT_EQ(last(), "pane.constrain from=4 to=5");
    EXPECT_EQ(pane().segment_count(), 1u);
    choose("pane.unconstrain");
    click(5, 5);
    EXPECT_EQ(pane().segment_count(), 0u);
}

TEST_F(PaneInView, RemovesAndLocksThePointThatIsClicked)
{
    choose("pane.lock");
    click(7, 5);
    EXPECT_TRUE(pane().is_locked(PointId(5)));
    choose("pane.remove");
    click(7, 5);
    EXPECT_TRUE(pane().exists(PointId(5))) << "locked";
    EXPECT_EQ(session.message().kind, Message::Kind::error);
    click(3, 5);
    EXPECT_FALSE(pane().exists(PointId(4)));
}

TEST_F(PaneInView, PutsOnlyTheLinesAgainThatChanged)
{
    const std::uint64_t before = session.display().lists.id();
    run("pane.move point=4 to=4,6");
    EXPECT_EQ(session.display().lists.id(), before) << "the same lists, brought up to date";
    EXPECT_EQ(session.display().lists.position(4), Point(4, 6, 0));
    run("pane.remove point=5");
    EXPECT_EQ(session.display().lists.id(), before);
    EXPECT_EQ(session.display().lists.vertex_limit(), 5u);
    EXPECT_EQ(session.display().lists.edge_limit(), 8u) << "four sides, and four spokes";
}

} // namespace
} // namespace druse::ui
