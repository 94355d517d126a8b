#include "ui/scroll_bar.h"

#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/fl_draw.H>

#include <algorithm>
#include <cstdint>

namespace druse::ui {

void ScrollBar::set(int total, int step)
{
    total_ = total;
    step_ = step;
    set_top(top_);
}

void ScrollBar::set_top(int top)
{
    const int kept = std::clamp(top, 0, std::max(0, total_ - h()));
    if (kept != top_) {
        top_ = kept;
        do_callback();
    }
    redraw();
}

int ScrollBar::knob_height() const { return std::max(layout().px(24), static_cast<int>(std::int64_t(h()) * h() / std::max(total_, 1))); }

int ScrollBar::knob_y() const
{
    const int room = h() - knob_height(), hidden = total_ - h();
    return y() + (hidden > 0 ? static_cast<int>(std::int64_t(room) * top_ / hidden) : 0);
}

void ScrollBar::draw()
{
    fl_color(color());
    fl_rectf(x(), y(), w(), h());
    const int inset = layout().px(3);
    fl_color(hovered_ ? theme().faint_text : theme().border);
    fl_rectf(x() + inset, knob_y() + 1, w() - 2 * inset, knob_height() - 2);
}

int ScrollBar::handle(int event)
{
    switch (event) {
    case FL_ENTER:
    case FL_LEAVE:
        hovered_ = event == FL_ENTER;
        redraw();
        return 1;
    case FL_PUSH:
        // Beside the knob: it jumps under the pointer.
        grip_ = Fl::event_y() - knob_y();
        if (grip_ < 0 || grip_ > knob_height()) grip_ = knob_height() / 2;
        [[fallthrough]];
    case FL_DRAG: {
        const int room = h() - knob_height();
        if (room > 0) set_top(static_cast<int>(std::int64_t(Fl::event_y() - grip_ - y()) * (total_ - h()) / room));
        return 1;
    }
    case FL_RELEASE: return 1;
    case FL_MOUSEWHEEL: set_top(top_ + 3 * step_ * Fl::event_dy()); return 1;
    default: return Fl_Widget::handle(event);
    }
}

} // namespace druse::ui
