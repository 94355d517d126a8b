#include "ui/list_view.h"

#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/Fl_Tooltip.H>
#include <FL/fl_draw.H>

#include <algorithm>
#include <utility>

namespace druse::ui {

ListView::ListView(int x, int y, int w, int h) : Fl_Group(x, y, w, h)
{
    end();
    bar_.callback([](Fl_Widget* bar, void*) { bar->parent()->redraw(); });
    bar_.color(theme().sunken);
    bar_.hide();
    add(bar_);
    resizable(nullptr);
    box(FL_FLAT_BOX);
    color(theme().sunken);
    set_visible_focus();
}

int ListView::row_height() const { return layout().line_height(); }
int ListView::list_width() const { return w() - (bar_.visible() ? bar_.w() : 0); }

void ListView::resize(int x, int y, int w, int h)
{
    Fl_Widget::resize(x, y, w, h);
    bar_.resize(x + w - layout().scrollbar(), y, layout().scrollbar(), h);
    refresh();
}

void ListView::refresh()
{
    bar_.set(rows() * row_height(), row_height() / 3);
    bar_.is_needed() ? bar_.show() : bar_.hide();
    if (current_ >= rows()) current_ = -1;
    if (hovered_ >= rows()) hovered_ = -1;
    redraw();
}

void ListView::scroll_to(int row)
{
    refresh();
    const int top = row * row_height();
    if (top < bar_.top()) bar_.set_top(top);
    else if (top + row_height() > bar_.top() + h()) bar_.set_top(top + row_height() - h());
}

void ListView::set_current(int row)
{
    current_ = row;
    if (row >= 0) scroll_to(row);
    redraw();
}

int ListView::row_at(int y) const
{
    const int row = (y - this->y() + bar_.top()) / row_height();
    return y >= this->y() && y < this->y() + h() && row < rows() ? row : -1;
}

void ListView::draw()
{
    draw_box();
    fl_push_clip(x(), y(), list_width(), h());
    const int first = bar_.top() / row_height();
    for (int row = first; row < rows(); ++row) {
        const int top = y() + row * row_height() - bar_.top();
        if (top >= y() + h()) break;
        const bool selected = is_selected(row);
        if (selected || row == hovered_) {
            fl_color(selected ? theme().accent : theme().hover);
            fl_rectf(x(), top, list_width(), row_height());
        }
        fl_push_clip(x(), top, list_width(), row_height());
        draw_row(row, x(), top, list_width(), row_height());
        fl_pop_clip();
    }
    fl_pop_clip();
    if (bar_.visible()) draw_child(bar_);
}

void ListView::show_tip()
{
    tip_ = hovered_ >= 0 ? tip(hovered_) : std::string();
    if (tip_.empty()) Fl_Tooltip::exit(this);
    else Fl_Tooltip::enter_area(this, 0, hovered_ * row_height() - bar_.top(), list_width(), row_height(), tip_.c_str());
}

int ListView::handle(int event)
{
    const bool on_bar = bar_.visible() && Fl::event_inside(&bar_);
    switch (event) {
    case FL_ENTER:
    case FL_MOVE: {
        const int row = on_bar ? -1 : row_at(Fl::event_y());
        if (row != hovered_) {
            hovered_ = row;
            show_tip();
            redraw();
        }
        Fl_Group::handle(event);
        return 1;
    }
    case FL_LEAVE:
        hovered_ = -1;
        redraw();
        return Fl_Group::handle(event);
    case FL_PUSH: {
        if (on_bar) return Fl_Group::handle(event);
        take_focus();
        Fl_Tooltip::exit(this);
        dragged_ = row_at(Fl::event_y());
        if (dragged_ >= 0) press_row(dragged_, Fl::event_x() - x(), Fl::event_button(), Fl::event_clicks() > 0);
        return 1;
    }
    case FL_DRAG: return 1;
    case FL_RELEASE: {
        const int from = std::exchange(dragged_, -1), to = Fl::event_inside(this) ? row_at(Fl::event_y()) : -1;
        if (from >= 0 && from != to && Fl::event_button() == 1) drop_row(from, to);
        return 1;
    }
    case FL_MOUSEWHEEL: return bar_.visible() ? bar_.handle(event) : 0;
    case FL_FOCUS:
    case FL_UNFOCUS: redraw(); return 1;
    case FL_KEYBOARD:
        switch (Fl::event_key()) {
        case FL_Up: set_current(std::max(current_ - 1, 0)); return 1;
        case FL_Down: set_current(std::min(current_ + 1, rows() - 1)); return 1;
        case FL_Enter:
        case FL_KP_Enter:
            if (current_ < 0) return 0;
            enter_row(current_);
            return 1;
        default: return 0;
        }
    default: return Fl_Group::handle(event);
    }
}

} // namespace druse::ui
