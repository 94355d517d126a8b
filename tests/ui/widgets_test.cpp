// Widgets that are never shown. Making one needs a display all the same, so this program runs on a virtual one.

#include "ui/widgets.h"

#include "ops/text.h"

#include <algorithm>
#include <set>

namespace druse::ui {
namespace {

TEST_F(Widgets, ThePanelHasARowForEveryControlOfEveryOperatorThatCounts)
{
    for (const Operator& op : all_operators().operators()) {
        session->choose(&op);
        for (const Control& c : controls_of(op))
            EXPECT_EQ(window->parameters().row(c.parameter, c.place) != nullptr, session->arguments().counts(c.parameter)) << op.name << " " << c.label;
    }
    // Of those that bend a tessellation, the ones that say what it is bent into.
    choose("graph.map");
    EXPECT_EQ(window->parameters().row("pitch"), nullptr);
    session->set("to", "helix");
    EXPECT_NE(window->parameters().row("pitch"), nullptr);
    EXPECT_EQ(window->parameters().row("rim"), nullptr);
    session->choose(nullptr);
    EXPECT_EQ(window->parameters().row("angle"), nullptr);
}

TEST_F(Widgets, DraggingASliderAdjustsTheLastStepOnce)
{
    run("make.cube");
    choose("extrude.cubical");
    session->apply_chosen({{"faces", "0"}});
    session->wait();
    Slider& angle = slider("angle");
    const int y = angle.y() + angle.h() / 2;
    push(angle.x() + angle.w() / 2, y);
    for (int x = angle.w() / 2; x < angle.w() - 10; x += 5) drag(angle.x() + x, y);
    drag(angle.x() + angle.w(), y);
    release(angle.x() + angle.w(), y);
    session->wait();
    EXPECT_EQ(session->arguments().text("angle"), "179");
    EXPECT_EQ(session->display().steps, (std::vector<std::string>{"make.cube", "extrude.cubical faces=0 angle=179"}));
}

TEST_F(Widgets, ASliderOfOneTierLeavesTheOthersAlone)
{
    choose("extrude.dodecahedral");
    Slider& second = slider("heights", 1);
    push(second.x() + second.w() - 1, second.y() + 5);
    release(second.x() + second.w() - 1, second.y() + 5);
    const std::string text = session->arguments().text("heights");
    const auto heights = split(text, ',');
    ASSERT_EQ(heights.size(), 3u);
    EXPECT_EQ(heights[0], "1");
    EXPECT_GT(parse_number(heights[1]), 5);
    EXPECT_EQ(heights[2], "1");
}

TEST_F(Widgets, ADoubleClickOnALabelRestoresTheDefault)
{
    choose("extrude.cubical");
    session->set("angle", "45");
    ParameterRow& row = *window->parameters().row("angle");
    at(row.x() + 5, row.y() + 5, FL_BUTTON1);
    Fl::e_clicks = 1;
    Fl::handle(FL_PUSH, &*window);
    release(row.x() + 5, row.y() + 5);
    EXPECT_TRUE(session->arguments().is_default("angle"));
}

TEST_F(Widgets, EveryOperatorAndActionIsInTheMenuBar)
{
    const auto& paths = window->menu().paths();
    const auto has = [&](const std::string& path) { return std::find(paths.begin(), paths.end(), path) != paths.end(); };
    for (const Operator& op : all_operators().operators())
        if (op.kind != Operator::Kind::travel && op.name != "document.open") {
            EXPECT_TRUE(has(menu_path(op))) << op.name;
        }
    for (const Action& action : window->actions()) EXPECT_TRUE(has(action.path)) << action.path;
    EXPECT_TRUE(window->menu().pick("Extrude/Dodecahedral"));
    EXPECT_EQ(session->chosen(), &all_operators().get("extrude.dodecahedral"));
    EXPECT_FALSE(window->menu().pick("Extrude/Nothing"));
}

TEST_F(Widgets, NoTwoActionsShareAKey)
{
    std::set<int> keys;
    for (const Action& action : window->actions())
        if (action.shortcut != 0) {
            EXPECT_TRUE(keys.insert(action.shortcut).second) << action.path;
        }
}

TEST_F(Widgets, KeysUndoAndRedo)
{
    run("make.cube");
    key('z', FL_CTRL, "");
    EXPECT_EQ(session->display().counts.faces, 0u);
    key('z', FL_CTRL | FL_SHIFT, "");
    EXPECT_EQ(session->display().counts.faces, 6u);
    key('z', FL_CTRL, "");
    key('y', FL_CTRL, "");
    EXPECT_EQ(session->display().counts.faces, 6u);
    key('a', 0, "a");
    EXPECT_EQ(session->display().selection->faces.size(), 6u);
}

TEST_F(Widgets, EscapePutsTheToolDownThenClearsTheSelectionAndNeverCloses)
{
    run("make.cube");
    choose("extrude.cubical");
    key(FL_Escape, 0, "\x1b");
    EXPECT_EQ(session->chosen(), nullptr);
    EXPECT_FALSE(session->display().selection->faces.empty());
    key(FL_Escape, 0, "\x1b");
    EXPECT_TRUE(session->display().selection->faces.empty());
    key(FL_Escape, 0, "\x1b");
}

/// No child sticks out of its parent, and no two visible ones overlap.
void expect_tidy(const Fl_Group& group)
{
    for (int i = 0; i < group.children(); ++i) {
        const Fl_Widget& a = *group.child(i);
        if (!a.visible()) continue;
        const bool window = const_cast<Fl_Group&>(group).as_window() != nullptr;
        const int left = window ? 0 : group.x(), top = window ? 0 : group.y();
        EXPECT_GE(a.x(), left);
        EXPECT_GE(a.y(), top);
        EXPECT_LE(a.x() + a.w(), left + group.w());
        EXPECT_LE(a.y() + a.h(), top + group.h());
        for (int k = i + 1; k < group.children(); ++k) {
            const Fl_Widget& b = *group.child(k);
            if (!b.visible()) continue;
            const bool apart = a.x() + a.w() <= b.x() || b.x() + b.w() <= a.x() || a.y() + a.h() <= b.y() || b.y() + b.h() <= a.y();
            EXPECT_TRUE(apart) << "children " << i << " and " << k << " of a group of " << group.children();
        }
    }
}

TEST_F(Widgets, EverythingHasItsPlaceAtEverySize)
{
    choose("extrude.dodecahedral");
    for (const auto& [w, h] : {std::pair(960, 640), std::pair(1280, 800), std::pair(1920, 1080), std::pair(960, 1200)}) {
        window->resize(0, 0, w, h);
        expect_tidy(*window);
        EXPECT_GE(window->viewport().w(), layout().least_view_width());
        EXPECT_GE(window->viewport().h(), h / 2);
    }
    window->fold_sides();
    expect_tidy(*window);
    EXPECT_GE(window->viewport().w(), 950);
    window->fold_sides();
    expect_tidy(*window);
}

} // namespace
} // namespace druse::ui
