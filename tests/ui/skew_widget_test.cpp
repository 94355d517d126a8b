#include "ui/skew_widget.h"

#include "ui/layout.h"
#include "ui/theme.h"

#include "app/registry.h"

#include <FL/Fl.H>

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <variant>

namespace druse::ui {
namespace {

class SkewFields : public testing::Test {
protected:
    SkewFields() : session(all_operators())
    {
        set_layout(Layout(1));
        use_theme(true);
        session.on_change = [this] { follow(); };
        widget = std::make_unique<SkewWidget>(session, camera);
        session.run("cell.new cell=cube size=2");
        session.wait();
    }
    void follow()
    {
        if (widget && session.scene()) widget->show_matrix(std::get<CellTile>(*session.scene()->source).matrix());
    }
    Fl_Input& field(int entry) { return dynamic_cast<Fl_Input&>(*widget->child(entry)); }
    void type(int entry, const char* text)
    {
        field(entry).value(text);
        field(entry).do_callback();
        session.wait();
    }
    const CellMatrix& matrix() const { return std::get<CellTile>(*session.scene()->source).matrix(); }

    Session session;
    Camera camera;
    std::unique_ptr<SkewWidget> widget;
};

TEST_F(SkewFields, TakeWhatIsTypedToTheLastDigitAndAnySize)
{
    type(1, "0.123456789012345");
    EXPECT_EQ(matrix()[1], 0.123456789012345);
    EXPECT_STREQ(field(1).value(), "0.12346");
    type(0, "150");
    EXPECT_EQ(matrix()[0], 150);
    type(0, "1e5");
    EXPECT_EQ(matrix()[0], 100000);
}

TEST_F(SkewFields, SendNothingThatIsNotChanged)
{
    type(1, "0.123456789012345");
    const std::size_t steps = session.display().done;
    field(1).do_callback(); // left as it is: what is shown of the number is not all of it
    type(0, "1.0");
    session.wait();
    EXPECT_EQ(session.display().done, steps);
    EXPECT_EQ(matrix()[1], 0.123456789012345);
}

TEST_F(SkewFields, EscapeForgetsWhatWasTyped)
{
    const std::size_t steps = session.display().done;
    EXPECT_FALSE(widget->cancel());
    Fl::focus(&field(4));
    field(4).value("3");
    EXPECT_TRUE(widget->cancel());
    EXPECT_STREQ(field(4).value(), "1");
    Fl::focus(nullptr); // which commits what is there
    session.wait();
    EXPECT_EQ(session.display().done, steps);
    type(4, "x");
    EXPECT_EQ(session.message().kind, Message::Kind::error);
    EXPECT_STREQ(field(4).value(), "1");
}

} // namespace
} // namespace druse::ui
