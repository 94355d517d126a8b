#include "ui/crust_guide.h"

#include "ui/cube_view.h"

#include <algorithm>
#include <cmath>

namespace druse::ui {
namespace {

class GuidedCrust : public CubeView {
protected:
    GuidedCrust() { arm("rind.crust"); }
    CrustGuide& guide()
    {
        view.crust().wait();
        return view.crust();
    }
    void set(const char* parameter, const char* value)
    {
        session.set(parameter, value);
        session.wait();
    }
    void apply()
    {
        session.apply_chosen();
        session.wait();
    }
    Control thickness()
    {
        auto controls = controls_of(*session.chosen());
        Control& c = *std::ranges::find(controls, std::string("thickness"), &Control::parameter);
        guide().fit(c);
        return c;
    }
};

// 0.95 of the limits in section 7 of 30-rind-and-pipes: a cube of side 2 turns inside out at its half diagonal, 1.7321; uniform, at 1.
TEST_F(GuidedCrust, TheSafeThicknessOfACubeIsMarked)
{
    ASSERT_TRUE(guide().safe());
    EXPECT_NEAR(guide().safe()->inward, 0.95 * std::sqrt(3), 1e-9);
    EXPECT_TRUE(std::isinf(guide().safe()->outward));
    const Control c = thickness();
    EXPECT_EQ(c.kind, Control::Kind::number);
    ASSERT_TRUE(c.slider);
    ASSERT_EQ(c.marks.size(), 1u);
    EXPECT_NEAR(c.marks[0], 1.6454, 1e-4);
    EXPECT_GE(c.high, c.marks[0]);
    EXPECT_LT(c.low, 0) << "outward too";
    EXPECT_NE(c.snap(0), 0) << "no crust has no thickness";
}

TEST_F(GuidedCrust, TheMarkStaysThatOfTheSurfaceWhileItsCrustIsAdjusted)
{
    apply();
    EXPECT_EQ(session.display().counts, (Counts{16, 24, 12}));
    EXPECT_NEAR(guide().safe()->inward, 1.6454, 1e-4);
    set("uniform", "true");
    EXPECT_NEAR(guide().safe()->inward, 0.95, 1e-9);
    EXPECT_EQ(session.display().steps.size(), 1u);
    apply(); // a crust of the crust: there are no marks for what it was made of
    EXPECT_TRUE(thickness().marks.empty());
}

TEST_F(GuidedCrust, OtherOperatorsHaveNoMarks)
{
    guide();
    arm("extrude.cubical");
    EXPECT_FALSE(guide().safe());
}

// A plate of 4 by 4 by 1/2 is safe up to 0.95 · 0.4330.
TEST_F(GuidedCrust, FacesThatMeetAreShownWhereItIsTooThick)
{
    run("mesh.transform scale=2,2,0.25");
    EXPECT_NEAR(guide().safe()->inward, 0.95 * 0.25 * std::sqrt(3), 1e-9);
    set("thickness", "0.4");
    apply();
    EXPECT_TRUE(guide().meeting().empty());
    set("thickness", "1");
    EXPECT_EQ(session.display().steps.size(), 2u);
    const std::vector<Face>& faces = guide().meeting();
    EXPECT_TRUE(std::ranges::count(faces, Face(0)) && std::ranges::count(faces, Face(1))) << "the inner walls come out of bottom and top";
    EXPECT_EQ(view.overlay().painted, faces);
    EXPECT_EQ(view.overlay().paint, view.overlay().error);
    set("thickness", "0.2");
    EXPECT_TRUE(guide().meeting().empty());
    EXPECT_TRUE(view.overlay().painted.empty());
}

} // namespace
} // namespace druse::ui
