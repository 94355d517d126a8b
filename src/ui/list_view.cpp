#include "ui/list_view.h"

#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/Fl_Tooltip.H>
#include <FL/fl_draw.H>

#include <algorithm>
#include <cmath>
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
    if (dragged_ >= rows() && dragging_) stop_drag();
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

int ListView::row_top(int row) const { return y() + row * row_height() - bar_.top(); }

void ListView::draw()
{
    draw_box();
    fl_push_clip(x(), y(), list_width(), h());
    const int first = bar_.top() / row_height();
    for (int row = first; row < rows(); ++row) {
        const int top = row_top(row);
        if (top >= y() + h()) break;
        const bool selected = is_selected(row);
        if (selected || row == hovered_) {
            fl_color(selected ? theme().accent : theme().hover);
            fl_rectf(x(), top, list_width(), row_height());
        }
        fl_push_clip(x(), top, list_width(), row_height());
        draw_row(row, x(), top, list_width(), row_height());
        fl_pop_clip();
        if (row == target_) {
            fl_color(theme().accent);
            fl_rect(x(), top, list_width(), row_height());
            fl_rect(x() + 1, top + 1, list_width() - 2, row_height() - 2);
        }
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

int ListView::handle_press()
{
    take_focus();
    Fl_Tooltip::exit(this);
    dragged_ = row_at(Fl::event_y());
    dragging_ = false;
    pressed_x_ = Fl::event_x();
    pressed_y_ = Fl::event_y();
    pressed_twice_ = Fl::event_clicks() > 0;
    if (dragged_ >= 0) press_row(dragged_, Fl::event_x() - x(), Fl::event_button(), pressed_twice_);
    return 1;
}

void ListView::handle_drag()
{
    if (dragged_ < 0 || !Fl::event_state(FL_BUTTON1)) return;
    if (std::hypot(Fl::event_x() - pressed_x_, Fl::event_y() - pressed_y_) >= layout().click_slop()) dragging_ = true;
    if (!dragging_) return;
    const int to = Fl::event_inside(this) ? row_at(Fl::event_y()) : -1;
    const int target = drag_row(dragged_, to) ? to : -1;
    if (target == target_) return;
    target_ = target;
    redraw();
}

void ListView::handle_release()
{
    const int from = std::exchange(dragged_, -1), to = Fl::event_inside(this) ? row_at(Fl::event_y()) : -1;
    const bool dragged = std::exchange(dragging_, false);
    target_ = -1;
    redraw();
    if (from < 0 || Fl::event_button() != 1) return;
    if (dragged && from != to) drop_row(from, to);
    else if (!dragged && !pressed_twice_) click_row(from, Fl::event_x() - x());
}

void ListView::stop_drag()
{
    const bool was_dragging = std::exchange(dragging_, false);
    dragged_ = target_ = -1;
    if (was_dragging) cancel_drag();
    redraw();
}

int ListView::handle_key()
{
    switch (Fl::event_key()) {
    case FL_Up:
    case FL_Down:
        if (rows() == 0) return 1;
        set_current(std::clamp(current_ + (Fl::event_key() == FL_Down ? 1 : -1), 0, rows() - 1));
        go_to_row(current_);
        return 1;
    case FL_Enter:
    case FL_KP_Enter:
        if (current_ < 0) return 0;
        enter_row(current_);
        return 1;
    case FL_Escape:
        if (!dragging_) return 0;
        stop_drag();
        return 1;
    default: return 0;
    }
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
    case FL_PUSH: return on_bar ? Fl_Group::handle(event) : handle_press();
    case FL_DRAG: handle_drag(); return 1;
    case FL_RELEASE: handle_release(); return 1;
    case FL_MOUSEWHEEL: return bar_.visible() ? bar_.handle(event) : 0;
    case FL_FOCUS:
    case FL_UNFOCUS: redraw(); return 1;
    case FL_KEYBOARD: return handle_key();
    default: return Fl_Group::handle(event);
    }
}

} // namespace druse::ui
