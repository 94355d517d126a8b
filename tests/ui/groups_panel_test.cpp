#include "ui/groups_panel.h"

#include "ui/widgets.h"

#include <algorithm>
#include <string_view>

namespace druse::ui {
namespace {

/// The palette beside a coloured cube: groups 1 (the bottom), 2 (the top) and 3 (four sides), in rows 0, 1 and 2.
class Palette : public Widgets {
protected:
    Palette()
    {
        session->open(DRUSE_MODELS "/colored_cube.obj");
        session->wait();
        list().choose_colour = [this](Colour before) {
            asked_about = before;
            return answer;
        };
    }
    GroupsPanel& palette() { return window->groups(); }
    GroupList& list() { return palette().list(); }
    int row_y(int row) { return list().y() + row * layout().line_height() + layout().line_height() / 2; }
    int swatch_x() { return list().x() + layout().margin() + layout().swatch() / 2; }
    int name_x() { return list().x() + layout().px(80); }
    void press_button(const char* label)
    {
        for (int i = 0; i < palette().children(); ++i)
            if (const char* text = palette().child(i)->label(); text && std::string_view(text) == label) {
                click(palette().child(i)->x() + 5, palette().child(i)->y() + 5);
                return;
            }
        FAIL() << "no button " << label;
    }
    /// From a row of the list to a place in the window.
    void drag_row(int row, int x, int y)
    {
        push(swatch_x(), row_y(row));
        drag(swatch_x() + 2, row_y(row)); // not yet: a hand is never quite still
        drag((swatch_x() + x) / 2, (row_y(row) + y) / 2);
        drag(x, y);
    }
    void type(const char* text)
    {
        static char letter[2];
        for (; *text; ++text) {
            letter[0] = *text;
            Fl::e_keysym = *text;
            Fl::e_state = 0;
            Fl::e_text = letter;
            Fl::e_length = 1;
            Fl::handle(FL_KEYBOARD, &*window);
        }
    }
    void type_key(int key)
    {
        static char nothing[1] = "";
        Fl::e_keysym = key;
        Fl::e_state = 0;
        Fl::e_text = nothing;
        Fl::e_length = 0;
        Fl::handle(FL_KEYBOARD, &*window);
        session->wait();
    }
    std::vector<std::string> steps() const { return session->display().steps; }
    std::string last_step() const { return steps().empty() ? "" : steps().back(); }
    const std::vector<Face>& selected() const { return session->display().selection->faces; }

    std::optional<Colour> asked_about, answer;
};

TEST_F(Palette, AClickSelectsAGroupAndShiftAndCtrlAddAndRemove)
{
    click(name_x(), row_y(2));
    EXPECT_EQ(selected(), (std::vector<Face>{Face(2), Face(3), Face(4), Face(5)}));
    EXPECT_EQ(list().group(), 3);
    click(swatch_x(), row_y(0), FL_SHIFT);
    EXPECT_EQ(selected().size(), 5u);
    click(name_x(), row_y(2), FL_CTRL);
    EXPECT_EQ(selected(), std::vector<Face>{Face(0)});
    EXPECT_EQ(last_step(), "select.faces faces=group:3 mode=remove");
}

TEST_F(Palette, ADoubleClickOnASwatchAsksForAColour)
{
    const Colour before_it = session->display().groups->colour(2);
    answer = Colour{1, 2, 3};
    click_twice(swatch_x(), row_y(1));
    EXPECT_EQ(asked_about, before_it);
    EXPECT_EQ(last_step(), "group.color id=2 color=#010203");
    EXPECT_EQ(session->display().groups->colour(2), *answer);
    answer.reset(); // the person changes their mind
    const std::size_t before = steps().size();
    press_button("Colour…");
    EXPECT_EQ(asked_about, (Colour{1, 2, 3}));
    EXPECT_EQ(steps().size(), before);
    answer = Colour{9, 9, 9};
    press_button("Colour…");
    EXPECT_EQ(last_step(), "group.color id=2 color=#090909");
    press_button("Default colours");
    EXPECT_EQ(last_step(), "group.color id=all color=auto");
    EXPECT_EQ(session->display().groups->colour(2), GroupTable::default_colour(2));
}

TEST_F(Palette, ADoubleClickOnANameRenamesTheGroup)
{
    click_twice(name_x(), row_y(2));
    type("roof");
    type_key(FL_Enter);
    EXPECT_EQ(last_step(), "group.name id=3 name=roof");
    EXPECT_EQ(session->display().groups->name(3), "roof");
    const std::size_t before = steps().size();
    list().rename();
    type("wall");
    type_key(FL_Escape);
    list().rename();
    type_key(FL_Enter); // the same name
    EXPECT_EQ(steps().size(), before);
    EXPECT_EQ(session->display().groups->name(3), "roof");
    list().rename();
    type("two words");
    type_key(FL_Enter);
    EXPECT_EQ(session->message().kind, Message::Kind::error);
    EXPECT_EQ(session->message().text, "group.name: name=\"two words\": expected one word");
}

TEST_F(Palette, ARowDraggedOntoAnotherMergesThem)
{
    drag_row(0, name_x(), row_y(2));
    EXPECT_TRUE(steps().empty());
    release(name_x(), row_y(2));
    EXPECT_EQ(steps(), std::vector<std::string>{"group.merge ids=1,3 into=3"});
    EXPECT_EQ(list().group(), 3);
    EXPECT_EQ(*session->display().group_sizes, (std::vector<GroupSize>{{2, 1}, {3, 5}}));
}

TEST_F(Palette, ADragThatEndsWhereItBeganOrIsCancelledDoesNothing)
{
    drag_row(0, name_x(), row_y(2));
    drag(name_x(), row_y(0));
    release(name_x(), row_y(0));
    drag_row(0, name_x(), row_y(2));
    type_key(FL_Escape);
    release(name_x(), row_y(2));
    drag_row(0, 600, 5); // the menu bar
    release(600, 5);
    EXPECT_TRUE(steps().empty());
}

TEST_F(Palette, ARowDraggedOntoAFaceTakesItIn)
{
    View& view = window->view();
    view.resize(window->viewport().w(), window->viewport().h());
    view.look({0, 0});
    view.frame_all();
    const int x = window->viewport().x() + window->viewport().w() / 2, y = window->viewport().y() + window->viewport().h() / 2;
    drag_row(0, x, y);
    EXPECT_EQ(view.overlay().painted, std::vector<Face>{Face(2)}) << "the face shows the colour it would get";
    EXPECT_EQ(view.overlay().paint, session->display().groups->colour(1));
    release(x, y);
    EXPECT_EQ(steps(), std::vector<std::string>{"group.assign faces=2 id=1"});
    drag_row(0, x, y);
    type_key(FL_Escape);
    EXPECT_TRUE(view.overlay().painted.empty());
    release(x, y);
    EXPECT_EQ(steps().size(), 1u);
}

TEST_F(Palette, ButtonsMakeSelectAndClearGroups)
{
    run("select.faces faces=2,3");
    press_button("+");
    EXPECT_EQ(last_step(), "group.assign faces=selected id=new");
    EXPECT_EQ(list().group(), 4) << "the new group is the chosen one";
    run("select.faces faces=none");
    press_button("Select");
    EXPECT_EQ(selected(), (std::vector<Face>{Face(2), Face(3)}));
    press_button("Clear");
    EXPECT_EQ(last_step(), "group.clear faces=selected");
    EXPECT_EQ(*session->display().group_sizes, (std::vector<GroupSize>{{0, 2}, {1, 1}, {2, 1}, {3, 2}}));
}

TEST_F(Palette, TheBrushPaintsWithTheChosenGroup)
{
    click(name_x(), row_y(1));
    const std::size_t before = steps().size();
    press_button("Paint");
    EXPECT_TRUE(palette().has_brush());
    EXPECT_EQ(session->arguments().text("id"), "2");
    session->apply_chosen({{"faces", "5"}}); // as a stroke does
    session->wait();
    click(name_x(), row_y(2)); // other paint; nothing is selected, and the stroke stays as it is
    EXPECT_EQ(session->arguments().text("id"), "3");
    EXPECT_EQ(steps().size(), before + 1);
    EXPECT_EQ(last_step(), "group.assign faces=5 id=2");
    key('p', 0, "p");
    EXPECT_FALSE(palette().has_brush());
    key('.', 0, ".");
    EXPECT_EQ(window->view().brush(), 8);
    key(',', 0, ",");
    key(',', 0, ",");
    EXPECT_EQ(window->view().brush(), 0);
}

TEST_F(Palette, ThousandsOfGroupsAreWithinReach)
{
    run("make.torus nu=110 nv=70");
    run("group.by rule=normal angle=0.001");
    const std::vector<GroupSize> sizes = *session->display().group_sizes;
    ASSERT_GT(sizes.size(), 3000u);
    list().choose(sizes.back().id);
    click(name_x(), list().y() + list().h() - 3);
    EXPECT_EQ(last_step(), "select.faces faces=group:" + std::to_string(sizes.back().id));
    EXPECT_EQ(selected().size(), sizes.back().faces);
}

TEST_F(Palette, TheSmoothPreviewIsAKeyAMenuEntryAndAButton)
{
    SmoothPreview& smooth = window->view().smooth();
    key('s', 0, "s");
    smooth.wait();
    EXPECT_TRUE(window->view().shown().is_divided());
    EXPECT_TRUE(window->menu().pick("View/Smooth preview"));
    EXPECT_FALSE(window->view().shown().is_divided());
    EXPECT_TRUE(steps().empty());
}

} // namespace
} // namespace druse::ui
