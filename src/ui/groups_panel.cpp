#include "ui/groups_panel.h"

#include "ui/dialogs.h"
#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include "app/command.h"

#include <FL/Fl.H>
#include <FL/Fl_Menu_Item.H>
#include <FL/fl_draw.H>

#include <fmt/format.h>

namespace druse::ui {

void GroupsPanel::update()
{
    if (const auto& facts = session_.display().facts) {
        rows_.clear();
        for (const auto& [id, faces] : facts->groups) rows_.push_back({id, faces});
    }
    refresh();
}

void GroupsPanel::draw_row(int row, int x, int y, int w, int h)
{
    const Layout& l = layout();
    const Row& r = rows_[std::size_t(row)];
    const GroupTable& groups = *session_.display().groups;
    const int left = x + l.margin(), count = l.px(52);
    draw_swatch(left, y + (h - l.swatch()) / 2, l.swatch(), groups.colour(r.id));
    fl_font(FL_HELVETICA, l.font());
    draw_text(std::to_string(r.id), left + l.swatch() + l.gap(), y, l.px(34), h, theme().text);
    const int name = left + l.swatch() + l.gap() + l.px(36);
    const std::string text = r.id == 0 ? "no group" : groups.name(r.id);
    draw_text(text, name, y, x + w - l.margin() - count - name, h, r.id == 0 ? theme().faint_text : theme().text);
    draw_text(std::to_string(r.faces), x + w - l.margin() - count, y, count, h, theme().faint_text, FL_ALIGN_RIGHT);
}

void GroupsPanel::press_row(int row, int x, int button, bool twice)
{
    const Row r = rows_[std::size_t(row)];
    const bool on_swatch = x < layout().margin() + layout().swatch() + layout().gap() / 2;
    if (button == 3) {
        open_menu(r);
    } else if (button == 1 && on_swatch) {
        if (twice) ask_colour(r.id);
    } else if (button == 1 && !twice) {
        const char* mode = Fl::event_state(FL_CTRL) ? " mode=remove" : Fl::event_state(FL_SHIFT) ? " mode=add" : "";
        session_.run(fmt::format("select.faces faces=group:{}{}", r.id, mode));
    }
}

void GroupsPanel::drop_row(int from, int to)
{
    if (to < 0) return;
    const int a = rows_[std::size_t(from)].id, b = rows_[std::size_t(to)].id;
    if (a != 0 && b != 0) session_.run(fmt::format("group.merge ids={},{} into={}", a, b, b));
}

void GroupsPanel::ask_colour(int id)
{
    if (const auto colour = ask_for_colour(session_.display().groups->colour(id)))
        session_.run(fmt::format("group.color id={} {}", id, argument_text("color", to_hex(*colour))));
}

void GroupsPanel::open_menu(const Row& r)
{
    const Fl_Menu_Item items[] = {
        {"Colour…", 0, nullptr, nullptr, 0, 0, 0, 0, 0},
        {"Default colour", 0, nullptr, nullptr, 0, 0, 0, 0, 0},
        {"Name…", 0, nullptr, nullptr, FL_MENU_DIVIDER | (r.id == 0 ? FL_MENU_INACTIVE : 0), 0, 0, 0, 0},
        {"Put the selected faces here", 0, nullptr, nullptr, 0, 0, 0, 0, 0},
        {nullptr, 0, nullptr, nullptr, 0, 0, 0, 0, 0},
    };
    const Fl_Menu_Item* picked = items->popup(Fl::event_x(), Fl::event_y());
    if (picked == &items[0]) ask_colour(r.id);
    if (picked == &items[1]) session_.run(fmt::format("group.color id={} color=auto", r.id));
    if (picked == &items[2]) {
        if (const auto name = ask_for_text(fmt::format("Name of group {}", r.id), session_.display().groups->name(r.id)))
            session_.run(fmt::format("group.name id={} {}", r.id, argument_text("name", *name)));
    }
    if (picked == &items[3]) session_.run(fmt::format("group.assign faces=selected id={}", r.id));
}

std::string GroupsPanel::tip(int row) const
{
    const Row& r = rows_[std::size_t(row)];
    return fmt::format("Group {}: {} faces, {}\nclick selects them; double click on the colour changes it", r.id, r.faces,
                       to_hex(session_.display().groups->colour(r.id)));
}

} // namespace druse::ui
