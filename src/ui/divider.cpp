#include "ui/divider.h"

#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/Fl_Window.H>
#include <FL/fl_draw.H>

namespace druse::ui {

void Divider::draw()
{
    fl_color(hovered_ ? theme().accent : theme().border);
    fl_rectf(x(), y(), w(), h());
}

int Divider::handle(int event)
{
    switch (event) {
    case FL_ENTER:
    case FL_LEAVE:
        hovered_ = event == FL_ENTER;
        if (window()) window()->cursor(hovered_ ? (across_ ? FL_CURSOR_NS : FL_CURSOR_WE) : FL_CURSOR_DEFAULT);
        redraw();
        return 1;
    case FL_PUSH:
        if (Fl::event_clicks() > 0 && on_fold) on_fold();
        return 1;
    case FL_DRAG:
        if (on_drag) on_drag(across_ ? Fl::event_y() : Fl::event_x());
        return 1;
    case FL_RELEASE: return 1;
    default: return Fl_Widget::handle(event);
    }
}

} // namespace druse::ui
