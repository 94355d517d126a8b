#include "ui/section.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/fl_draw.H>

#include <algorithm>
#include <utility>

namespace druse::ui {

Section::Section(std::string title, Fl_Widget& content) : Panel(0, 0, 1, 1), title_(std::move(title)), content_(content)
{
    end();
    add(content);
}

void Section::set_open(bool open)
{
    open_ = open;
    if (open) content_.show();
    else content_.hide();
    redraw();
}

void Section::set_note(const std::string& note)
{
    if (note == note_) return;
    note_ = note;
    damage(FL_DAMAGE_ALL);
}

void Section::arrange()
{
    const int header = layout().header_height();
    content_.resize(x(), y() + header, w(), std::max(0, h() - header));
}

void Section::draw()
{
    const Layout& l = layout();
    fl_color(hovered_ ? theme().hover : theme().header);
    fl_rectf(x(), y(), w(), l.header_height());
    fl_color(theme().border);
    fl_xyline(x(), y(), x() + w() - 1);
    draw_chevron(x() + l.gap(), y() + (l.header_height() - l.px(12)) / 2, l.px(12), open_, theme().faint_text);
    fl_font(FL_HELVETICA_BOLD, l.font());
    draw_text(title_, x() + l.gap() + l.px(16), y(), w() - l.px(30), l.header_height(), theme().text);
    fl_font(FL_HELVETICA, l.small_font());
    draw_text(note_, x() + l.px(90), y(), w() - l.px(90) - l.margin(), l.header_height(), theme().faint_text, FL_ALIGN_RIGHT);
    draw_children();
}

int Section::handle(int event)
{
    const bool on_bar = Fl::event_inside(x(), y(), w(), layout().header_height());
    switch (event) {
    case FL_ENTER:
    case FL_MOVE:
    case FL_LEAVE: {
        const bool now = event != FL_LEAVE && on_bar;
        if (now != hovered_) {
            hovered_ = now;
            redraw();
        }
        Panel::handle(event);
        return 1;
    }
    case FL_PUSH:
        if (!on_bar) break;
        set_open(!open_);
        if (on_fold) on_fold();
        return 1;
    default: break;
    }
    return Panel::handle(event);
}

} // namespace druse::ui
