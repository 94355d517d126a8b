#include "ui/group_list.h"

#include "ui/dialogs.h"
#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/popup.h"
#include "ui/theme.h"

#include "app/command.h"

#include <FL/Fl.H>
#include <FL/fl_draw.H>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace druse::ui {

int GroupList::NameField::handle(int event)
{
    if (event == FL_KEYBOARD || event == FL_SHORTCUT) switch (Fl::event_key()) {
        case FL_Enter:
        case FL_KP_Enter: on_end(true); return 1;
        case FL_Escape: on_end(false); return 1;
        default: break;
        }
    if (event == FL_UNFOCUS) on_end(true);
    return Fl_Input::handle(event);
}

GroupList::GroupList(Session& session, int x, int y, int w, int h) : ListView(x, y, w, h), choose_colour(ask_for_colour), session_(session)
{
    field_.textsize(layout().font());
    field_.hide();
    field_.on_end = [this](bool take) { end_rename(take); };
    add(field_);
}

void GroupList::update()
{
    const std::optional<int> chosen = group();
    sizes_ = session_.display().group_sizes;
    keep_current(chosen ? row_of(*chosen) : -1);
    if (renamed_ >= 0 && row_of(renamed_) < 0) end_rename(false);
    refresh();
    place_field();
}

// --- which group --------------------------------------------------------------------------------------------------------------

int GroupList::row_of(int group) const
{
    const auto at = std::ranges::lower_bound(*sizes_, group, {}, &GroupSize::id);
    return at != sizes_->end() && at->id == group ? int(at - sizes_->begin()) : -1;
}

std::optional<int> GroupList::group() const
{
    return current() >= 0 && current() < rows() ? std::optional(size_of(current()).id) : std::nullopt;
}

void GroupList::choose(int group)
{
    if (const int row = row_of(group); row >= 0 && row != current()) set_current(row);
}

// --- what it looks like -------------------------------------------------------------------------------------------------------

int GroupList::name_left() const { return layout().margin() + layout().swatch() + layout().gap() + layout().px(36); }

bool GroupList::is_on_swatch(int x) const { return x < layout().margin() + layout().swatch() + layout().gap() / 2; }

void GroupList::draw_row(int row, int x, int y, int w, int h)
{
    const Layout& l = layout();
    const GroupSize& r = size_of(row);
    const GroupTable& groups = *session_.display().groups;
    const bool here = is_selected(row);
    const Fl_Color text = here ? theme().on_accent : theme().text, faint = here ? theme().on_accent : theme().faint_text;
    const int left = x + l.margin(), count = l.px(60), name = x + name_left();
    draw_swatch(left, y + (h - l.swatch()) / 2, l.swatch(), groups.colour(r.id));
    fl_font(FL_HELVETICA, l.font());
    draw_text(std::to_string(r.id), left + l.swatch() + l.gap(), y, l.px(34), h, text);
    draw_text(r.id == 0 ? "no group" : groups.name(r.id), name, y, x + w - l.margin() - count - name, h, r.id == 0 ? faint : text);
    draw_text(std::to_string(r.faces), x + w - l.margin() - count, y, count, h, faint, FL_ALIGN_RIGHT);
}

void GroupList::draw()
{
    place_field();
    ListView::draw();
    if (field_.visible()) draw_child(field_);
}

std::string GroupList::tip(int row) const
{
    const GroupSize& r = size_of(row);
    return fmt::format("Group {}: {} face{}, {}\nClick: select them (Shift adds, Ctrl removes). Double click: another colour, or name.\n"
                       "Drag onto another group: merge; onto a face: put it in.",
                       r.id, r.faces, r.faces == 1 ? "" : "s", to_hex(session_.display().groups->colour(r.id)));
}

void GroupList::resize(int x, int y, int w, int h)
{
    ListView::resize(x, y, w, h);
    place_field();
}

// --- what the mouse does ------------------------------------------------------------------------------------------------------

int GroupList::handle(int event)
{
    const bool in_field = field_.visible() && (event == FL_PUSH || event == FL_DRAG || event == FL_RELEASE) && Fl::event_inside(&field_);
    return in_field ? Fl_Group::handle(event) : ListView::handle(event);
}

bool GroupList::asks() const { return Fl::event_clicks() > 0 && row_at(Fl::event_y()) >= 0 && is_on_swatch(Fl::event_x() - x()); }

void GroupList::press_row(int row, int x, int button, bool twice)
{
    const int group = size_of(row).id;
    keep_current(row);
    redraw();
    if (button == 3) open_menu(group);
    else if (button == 1 && twice && is_on_swatch(x)) ask_colour_of(group);
    else if (button == 1 && twice) rename();
}

void GroupList::click_row(int row, int)
{
    const int group = size_of(row).id;
    if (on_choose) on_choose(group);
    if (only_chooses && only_chooses()) return;
    const char* mode = Fl::event_state(FL_CTRL) ? " mode=remove" : Fl::event_state(FL_SHIFT) ? " mode=add" : "";
    session_.run(fmt::format("select.faces faces=group:{}{}", group, mode));
}

void GroupList::go_to_row(int row)
{
    if (on_choose) on_choose(size_of(row).id);
}

bool GroupList::drag_row(int from, int to)
{
    carried_ = size_of(from).id;
    const bool merges = to >= 0 && to != from;
    hint_ = merges ? fmt::format("release to merge group {} into group {}", carried_, size_of(to).id) : std::string();
    if (on_carry) on_carry(Carry::move, carried_);
    return merges;
}

void GroupList::drop_row(int from, int to)
{
    const int group = size_of(from).id;
    carried_ = -1;
    hint_.clear();
    if (to < 0) {
        if (on_carry) on_carry(Carry::drop, group);
        return;
    }
    cancel_drag();
    const int into = size_of(to).id;
    session_.run(fmt::format("group.merge ids={},{} into={}", group, into, into));
    keep_current(row_of(into));
}

void GroupList::cancel_drag()
{
    hint_.clear();
    if (on_carry) on_carry(Carry::cancel, std::exchange(carried_, -1));
}

void GroupList::open_menu(int group)
{
    const auto command = [this](std::string text) { return [this, text] { session_.run_chosen(text); }; };
    std::vector<PopupEntry> entries;
    entries.push_back({"Colour…", [this, group] { ask_colour_of(group); }});
    entries.push_back({"Default colour", command(fmt::format("group.color id={} color=auto", group))});
    if (group != 0) entries.push_back({"Name", [this] { rename(); }});
    entries.back().divider = true;
    entries.push_back({"Select its faces", command(fmt::format("select.faces faces=group:{}", group))});
    entries.push_back({"Put the selected faces here", command(fmt::format("group.assign faces=selected id={}", group))});
    if (group != 0) entries.push_back({"Take all its faces out", command(fmt::format("group.clear faces=group:{}", group))});
    show_popup(entries, Fl::event_x(), Fl::event_y());
}

// --- colour and name ----------------------------------------------------------------------------------------------------------

void GroupList::ask_colour()
{
    if (const auto chosen = group()) ask_colour_of(*chosen);
}

void GroupList::ask_colour_of(int group)
{
    if (const auto colour = choose_colour(session_.display().groups->colour(group)))
        session_.run_chosen(fmt::format("group.color id={} {}", group, argument_text("color", to_hex(*colour))));
}

void GroupList::rename()
{
    const auto chosen = group();
    if (!chosen || *chosen == 0) return;
    scroll_to(current());
    renamed_ = *chosen;
    field_.value(session_.display().groups->name(renamed_).c_str());
    field_.position(field_.size(), 0);
    field_.show();
    place_field();
    field_.take_focus();
    redraw();
}

/// Over the name, wherever its row has gone; away with it where that is out of sight.
void GroupList::place_field()
{
    if (renamed_ < 0) return;
    const int row = row_of(renamed_), left = x() + name_left() - layout().px(4);
    field_.resize(left, row_top(row) + 1, std::max(1, x() + list_width() - layout().margin() - left), row_height() - 2);
}

void GroupList::end_rename(bool take)
{
    if (renamed_ < 0) return;
    const int group = std::exchange(renamed_, -1); // hiding the field takes the focus from it, and comes back here
    const std::string name = field_.value();
    field_.hide();
    take_focus();
    redraw();
    if (take && !name.empty() && name != session_.display().groups->name(group))
        session_.run(fmt::format("group.name id={} {}", group, argument_text("name", name)));
}

} // namespace druse::ui
