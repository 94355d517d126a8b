#include "ui/widgets.h"

namespace druse::ui {
namespace {

TEST_F(Widgets, TheThicknessOfACrustSlidesPastAMarkAsOneStep)
{
    run("make.cube size=2");
    choose("rind.crust");
    window->view().crust().wait();
    ASSERT_EQ(slider("thickness").marks().size(), 1u);
    EXPECT_NEAR(slider("thickness").marks()[0], 1.6454, 1e-4); // 0.95 · sqrt 3
    session->apply_chosen();
    session->wait();

    Slider& thickness = slider("thickness");
    const int y = thickness.y() + thickness.h() / 2, middle = thickness.x() + thickness.w() / 2;
    push(middle + 4, y);
    for (int x = middle + 8; x < thickness.x() + thickness.w() - 10; x += 4) drag(x, y);
    drag(thickness.x() + thickness.w(), y);
    release(thickness.x() + thickness.w(), y);
    ASSERT_EQ(session->display().steps.size(), 2u);
    EXPECT_EQ(session->display().steps[1], "rind.crust thickness=" + session->arguments().text("thickness"));
    EXPECT_EQ(&slider("thickness"), &thickness) << "the row stays under the pointer";
    EXPECT_EQ(thickness.value(), thickness.maximum());
    EXPECT_GE(thickness.value(), thickness.marks()[0]);
}

TEST_F(Widgets, ASliderTakesThePlaceWhereItIsReleased)
{
    choose("extrude.cubical");
    Slider& angle = slider("angle");
    const int y = angle.y() + angle.h() / 2;
    push(angle.x() + angle.w() / 2, y);
    release(angle.x() + angle.w(), y); // moved so quickly that no drag came between
    EXPECT_EQ(session->arguments().text("angle"), "179");
}

TEST_F(Widgets, EscapeDropsTheFirstOfTwoFacesBeforeTheTool)
{
    run("make.cube size=2");
    choose("topology.pipe");
    const Pointer middle{.x = window->view().camera().width() / 2.0, .y = window->view().camera().height() / 2.0, .button = 1};
    window->view().press(middle);
    window->view().release(middle);
    ASSERT_EQ(window->view().overlay().pressed.size(), 1u);
    key(FL_Escape, 0, "\x1b");
    EXPECT_TRUE(window->view().overlay().pressed.empty());
    EXPECT_NE(session->chosen(), nullptr);
    key(FL_Escape, 0, "\x1b");
    EXPECT_EQ(session->chosen(), nullptr);
}

} // namespace
} // namespace druse::ui
