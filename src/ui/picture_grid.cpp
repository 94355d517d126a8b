#include "ui/picture_grid.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/Fl_Window.H>
#include <FL/fl_draw.H>

#include <algorithm>

namespace druse::ui {

PictureGrid::PictureGrid(int x, int y, int columns, int rows, int cell_width, int cell_height)
    : Panel(x, y, columns * cell_width + layout().scrollbar(), rows * cell_height), columns_(columns), cell_width_(cell_width), cell_height_(cell_height)
{
    end();
    bar_.callback([](Fl_Widget* bar, void*) { bar->parent()->redraw(); });
    bar_.color(theme().sunken);
    add(bar_);
    set_visible_focus();
    arrange();
}

void PictureGrid::arrange() { bar_.resize(x() + w() - layout().scrollbar(), y(), layout().scrollbar(), h()); }

void PictureGrid::set_cells(int count, int marked)
{
    count_ = count;
    bar_.set((count_ + columns_ - 1) / columns_ * cell_height_, cell_height_ / 3);
    bar_.is_needed() ? bar_.show() : bar_.hide();
    mark(marked, true);
}

int PictureGrid::cell_at(int px, int py) const
{
    if (px < x() || py < y() || px >= x() + columns_ * cell_width_ || py >= y() + h()) return -1;
    const int cell = (py - y() + bar_.top()) / cell_height_ * columns_ + (px - x()) / cell_width_;
    return cell < count_ ? cell : -1;
}

void PictureGrid::mark(int cell, bool scroll)
{
    marked_ = std::clamp(cell, 0, std::max(count_ - 1, 0));
    if (scroll) show_marked();
    redraw();
    if (count_ > 0 && on_mark) on_mark();
}

void PictureGrid::show_marked()
{
    const int top = marked_ / columns_ * cell_height_;
    if (top < bar_.top()) bar_.set_top(top);
    else if (top + cell_height_ > bar_.top() + h()) bar_.set_top(top + cell_height_ - h());
}

void PictureGrid::take(int cell)
{
    if (count_ == 0) return;
    chosen_ = cell;
    window()->hide();
}

int PictureGrid::handle(int event)
{
    switch (event) {
    case FL_ENTER:
    case FL_FOCUS:
    case FL_UNFOCUS: return 1;
    case FL_MOVE:
        if (const int cell = cell_at(Fl::event_x(), Fl::event_y()); cell >= 0 && cell != marked_) mark(cell, false);
        return Panel::handle(event), 1;
    case FL_PUSH:
        if (Panel::handle(event)) return 1;
        take_focus();
        return 1;
    case FL_RELEASE:
        if (const int cell = cell_at(Fl::event_x(), Fl::event_y()); cell >= 0 && Fl::event_is_click()) take(cell);
        return 1;
    case FL_MOUSEWHEEL: return bar_.handle(event);
    case FL_KEYBOARD: return key(Fl::event_key()) ? 1 : 0;
    default: return Panel::handle(event);
    }
}

bool PictureGrid::key(int key)
{
    switch (key) {
    case FL_Home: mark(0, true); return true;
    case FL_End: mark(count_ - 1, true); return true;
    case FL_Left: mark(marked_ - 1, true); return true;
    case FL_Right: mark(marked_ + 1, true); return true;
    case FL_Up: mark(marked_ >= columns_ ? marked_ - columns_ : marked_, true); return true;
    case FL_Down: mark(marked_ + columns_ < count_ ? marked_ + columns_ : marked_, true); return true;
    case FL_Enter:
    case FL_KP_Enter: take(marked_); return true;
    default: return false;
    }
}

void PictureGrid::draw()
{
    fl_push_clip(x(), y(), w(), h());
    fl_color(theme().sunken);
    fl_rectf(x(), y(), w(), h());
    fl_font(FL_HELVETICA, layout().small_font());
    for (int i = 0; i < count_; ++i) {
        const int left = x() + i % columns_ * cell_width_, top = y() + i / columns_ * cell_height_ - bar_.top();
        if (top + cell_height_ <= y() || top >= y() + h()) continue;
        if (i == marked_) {
            fl_color(theme().accent);
            fl_rectf(left, top, cell_width_, cell_height_);
        }
        draw_cell(i, left, top, i == marked_);
    }
    if (count_ == 0) {
        fl_font(FL_HELVETICA, layout().font());
        draw_text(nothing(), x(), y(), w(), h(), theme().faint_text, FL_ALIGN_CENTER);
    }
    fl_pop_clip();
    if (bar_.visible()) draw_child(bar_);
}

} // namespace druse::ui
