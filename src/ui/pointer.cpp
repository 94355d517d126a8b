#include "ui/pointer.h"

#include <FL/Fl.H>

namespace druse::ui {

Pointer pointer_at(int left, int top)
{
    Pointer p;
    p.x = Fl::event_x() - left + 0.5;
    p.y = Fl::event_y() - top + 0.5;
    p.button = Fl::event_button();
    p.shift = Fl::event_state(FL_SHIFT) != 0;
    p.ctrl = Fl::event_state(FL_CTRL) != 0;
    p.alt = Fl::event_state(FL_ALT) != 0;
    p.twice = Fl::event_clicks() > 0;
    return p;
}

} // namespace druse::ui
