#include "ui/scroll_area.h"

#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/fl_draw.H>

#include <algorithm>

namespace druse::ui {

ScrollArea::ScrollArea() : Panel(0, 0, 1, 1)
{
    end();
    color(theme().window);
    bar_.color(theme().window);
    bar_.callback([](Fl_Widget*, void* area) { static_cast<ScrollArea*>(area)->arrange(); }, this);
    bar_.hide();
    add(bar_); // the last child, over the others
}

void ScrollArea::add_row(Fl_Widget& row)
{
    insert(row, &bar_);
    arrange();
}

void ScrollArea::remove_row(Fl_Widget& row)
{
    remove(row);
    arrange();
}

void ScrollArea::arrange()
{
    const int rows = children() - 1, height = layout().row_height();
    bar_.resize(x() + w() - layout().scrollbar(), y(), layout().scrollbar(), h());
    bar_.set(rows * height, height / 3);
    bar_.is_needed() ? bar_.show() : bar_.hide();
    const int width = w() - (bar_.visible() ? bar_.w() : 0);
    int top = y() - bar_.top();
    for (int i = 0; i < children(); ++i) {
        if (child(i) == &bar_) continue;
        child(i)->resize(x(), top, width, height);
        top += height;
    }
    redraw();
}

void ScrollArea::draw()
{
    fl_push_clip(x(), y(), w(), h());
    fl_color(color());
    fl_rectf(x(), y(), w(), h());
    for (int i = 0; i < children(); ++i)
        if (child(i) != &bar_) draw_child(*child(i));
    if (bar_.visible()) draw_child(bar_);
    fl_pop_clip();
}

int ScrollArea::handle(int event)
{
    // Rows that are scrolled out of sight get no clicks.
    const bool mouse = event == FL_PUSH || event == FL_MOUSEWHEEL || event == FL_ENTER || event == FL_MOVE;
    if (mouse && !Fl::event_inside(this)) return 0;
    if (Panel::handle(event)) return 1;
    return event == FL_MOUSEWHEEL && bar_.visible() ? bar_.handle(event) : 0;
}

} // namespace druse::ui
