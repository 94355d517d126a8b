#include "ui/groups_panel.h"

#include "ui/layout.h"
#include "ui/theme.h"

#include "ops/text.h"

#include <FL/fl_draw.H>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse::ui {

GroupsPanel::GroupsPanel(Session& session, View& view, int x, int y, int w, int h)
    : Panel(x, y, w, h), session_(session), view_(view), list_(session, 0, 0, 1, 1), size_(0, 0, 1, 1)
{
    end();
    add(list_);
    plus_ = &add_button("+", "A new group of the selected faces", &GroupsPanel::make_group);
    select_ = &add_button("Select", "Select the faces of the chosen group", &GroupsPanel::select);
    clear_ = &add_button("Clear", "Take the selected faces out of their groups", &GroupsPanel::clear);
    colour_ = &add_button("Colour…", "Another colour for the chosen group", &GroupsPanel::ask_colour);
    paint_ = &add_button("Paint", "A brush that puts faces into the chosen group (P)", &GroupsPanel::toggle_brush);
    defaults_ = &add_button("Default colours", "Give every group the colour that new groups have", &GroupsPanel::default_colours);
    size_.set_range(0, View::largest_brush, 1);
    size_.snap = [](double wanted) { return std::round(wanted); };
    size_.on_slide = [this](double radius) { resize_brush(radius - view_.brush()); };
    size_.tooltip("Size of the brush (, and .); at the left end it takes single faces");
    add(size_);

    list_.only_chooses = [this] { return has_brush(); };
    list_.on_choose = [this](int group) {
        if (has_brush()) paint_with(std::to_string(group));
    };
}

Fl_Button& GroupsPanel::add_button(const char* label, const char* tip, void (GroupsPanel::*press)())
{
    struct Press {
        GroupsPanel* panel;
        void (GroupsPanel::*run)();
    };
    class Button : public Fl_Button {
    public:
        Button(const char* text, Press p) : Fl_Button(0, 0, 1, 1, text), press(p) {}
        Press press;
    };
    Fl_Group::current(nullptr);
    buttons_.push_back(std::make_unique<Button>(label, Press{this, press}));
    Fl_Button& button = *buttons_.back();
    button.tooltip(tip);
    button.labelsize(layout().small_font());
    button.color(theme().raised);
    button.clear_visible_focus();
    button.callback([](Fl_Widget* widget, void*) {
        const Press& p = static_cast<Button*>(widget)->press;
        p.panel->list_.take_focus(); // a field that had it would take the keys of the brush for text
        (p.panel->*p.run)();
    });
    add(button);
    return button;
}

// --- where everything is ------------------------------------------------------------------------------------------------------

int GroupsPanel::buttons_height() const { return 2 * layout().control_height() + 3 * layout().gap(); }

void GroupsPanel::arrange()
{
    const Layout& l = layout();
    const int left = x() + l.margin(), inner = w() - 2 * l.margin(), height = l.control_height();
    const bool room = h() >= buttons_height() + l.line_height();
    for (const auto& button : buttons_) room ? button->show() : button->hide();
    room ? size_.show() : size_.hide();
    list_.resize(x(), y(), w(), room ? h() - buttons_height() : h());
    if (!room) return;

    int top = y() + list_.h() + l.gap();
    fl_font(FL_HELVETICA, l.small_font());
    const auto needed = [](const Fl_Button* button) { return static_cast<int>(fl_width(button->label())); };
    // The first row is filled, each as wide as its label and its share of what is left.
    Fl_Button* const row[] = {plus_, select_, clear_, colour_};
    int text = 0;
    for (const Fl_Button* button : row) text += needed(button);
    const int share = std::max(0, inner - text - 3 * l.gap()) / 4;
    int at = left;
    for (Fl_Button* button : row) {
        const int width = button == colour_ ? left + inner - at : needed(button) + share;
        button->resize(at, top, width, height);
        at += width + l.gap();
    }
    top += height + l.gap();
    const int pad = l.margin() + l.gap();
    paint_->resize(left, top, needed(paint_) + pad, height);
    const int last = needed(defaults_) + pad;
    defaults_->resize(left + inner - last, top, last, height);
    const int from = paint_->x() + paint_->w() + l.gap();
    size_.resize(from, top, std::max(1, defaults_->x() - l.gap() - from), height);
}

void GroupsPanel::draw()
{
    fl_color(theme().window);
    fl_rectf(x(), y() + list_.h(), w(), h() - list_.h());
    draw_children();
}

void GroupsPanel::update()
{
    list_.update();
    const std::vector<GroupSize>& sizes = *session_.display().group_sizes;
    if (awaits_group_ && !session_.is_working()) {
        awaits_group_ = false;
        if (!sizes.empty() && sizes.back().id > largest_) list_.choose(sizes.back().id);
    }
    if (has_brush())
        if (const std::string id = session_.arguments().text("id"); !id.empty() && id != "new") list_.choose(static_cast<int>(parse_integer(id)));
    paint_->color(has_brush() ? theme().accent : theme().raised);
    paint_->labelcolor(has_brush() ? theme().on_accent : theme().text);
    size_.value(view_.brush());
    redraw();
}

// --- doing --------------------------------------------------------------------------------------------------------------------

void GroupsPanel::make_group()
{
    const std::vector<GroupSize>& sizes = *session_.display().group_sizes;
    largest_ = sizes.empty() ? 0 : sizes.back().id;
    awaits_group_ = true;
    session_.run("group.assign faces=selected id=new");
}

void GroupsPanel::select()
{
    if (const auto group = list_.group()) session_.run(fmt::format("select.faces faces=group:{}", *group));
    else session_.say(Message::Kind::note, "choose a group in the list first");
    if (on_change) on_change();
}

void GroupsPanel::clear() { session_.run("group.clear faces=selected"); }

void GroupsPanel::default_colours() { session_.run("group.color id=all color=auto"); }

const Operator& GroupsPanel::brush_operator() const { return session_.registry().get("group.assign"); }

void GroupsPanel::toggle_brush()
{
    if (has_brush()) {
        session_.choose(nullptr);
        return;
    }
    // The chosen group; else the first there is; else one that does not exist yet.
    const std::vector<GroupSize>& sizes = *session_.display().group_sizes;
    const auto first = std::ranges::find_if(sizes, [](const GroupSize& g) { return g.id > 0; });
    const std::string id = list_.group() ? std::to_string(*list_.group()) : first != sizes.end() ? std::to_string(first->id) : "new";
    session_.choose(&brush_operator());
    paint_with(id);
}

void GroupsPanel::paint_with(const std::string& id)
{
    session_.let_go(); // the last stroke keeps its group
    session_.set("id", id);
}

void GroupsPanel::resize_brush(double by)
{
    view_.set_brush(view_.brush() + by);
    size_.value(view_.brush());
    if (on_change) on_change();
}

} // namespace druse::ui
