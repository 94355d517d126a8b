#include "ui/history_panel.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/Fl_Menu_Item.H>
#include <FL/fl_draw.H>

#include <algorithm>

namespace druse::ui {

namespace {

void copy(const std::string& text) { Fl::copy(text.c_str(), int(text.size()), 1); }

} // namespace

void HistoryPanel::update()
{
    refresh();
    if (session_.display().done != done_) {
        done_ = session_.display().done;
        scroll_to(int(done_));
    }
}

std::string HistoryPanel::text(int row) const
{
    const Display& display = session_.display();
    if (row == 0) return display.beginning.empty() ? "empty document" : display.beginning;
    return display.steps[std::size_t(row) - 1];
}

/// The beginning is said in a few words; its command is long, and the same in every session.
std::string HistoryPanel::label(int row) const
{
    if (row > 0 || session_.display().beginning.empty()) return text(row);
    return "Open " + session_.file().filename().string();
}

void HistoryPanel::draw_row(int row, int x, int y, int w, int h)
{
    const Layout& l = layout();
    const bool here = is_selected(row), undone = row > int(session_.display().done), lost = row < int(session_.display().first);
    const int dot = l.px(5);
    if (session_.saved_step() == std::size_t(row)) {
        fl_color(here ? theme().on_accent : theme().good);
        fl_pie(x + l.px(5), y + (h - dot) / 2, dot, dot, 0, 360);
    }
    fl_font(FL_HELVETICA, l.small_font());
    draw_text(label(row), x + l.px(15), y, w - l.px(15) - l.gap(), h,
              here ? theme().on_accent : undone || lost ? theme().faint_text : theme().text);
}

void HistoryPanel::press_row(int row, int, int button, bool)
{
    if (button == 3) open_menu(row);
    else if (button == 1 && !is_selected(row)) session_.go_to(std::size_t(row));
}

/// Dragged over several lines: they go to the clipboard as a script.
void HistoryPanel::drop_row(int from, int to)
{
    if (to < 0) return;
    std::string script;
    const auto [first, last] = std::minmax(from, to);
    for (int row = std::max(first, 1); row <= last; ++row) script += text(row) + "\n";
    copy(script);
    session_.say(Message::Kind::note, "copied as a script");
}

void HistoryPanel::open_menu(int row)
{
    const Fl_Menu_Item items[] = {
        {"Copy this command", 0, nullptr, nullptr, 0, 0, 0, 0, 0},
        {"Copy up to here as script", 0, nullptr, nullptr, 0, 0, 0, 0, 0},
        {nullptr, 0, nullptr, nullptr, 0, 0, 0, 0, 0},
    };
    const Fl_Menu_Item* picked = items->popup(Fl::event_x(), Fl::event_y());
    if (picked == &items[0]) copy(text(row) + "\n");
    if (picked == &items[1]) {
        std::string script;
        for (int i = session_.display().beginning.empty() ? 1 : 0; i <= row; ++i) script += text(i) + "\n";
        copy(script);
    }
}

} // namespace druse::ui
