#include "ui/slider.h"

#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/fl_draw.H>

#include <algorithm>
#include <cmath>

namespace druse::ui {

Slider::Slider(int x, int y, int w, int h) : Fl_Valuator(x, y, w, h, nullptr)
{
    box(FL_NO_BOX);
    set_visible_focus();
}

void Slider::set_range(double low, double high, double step)
{
    bounds(low, high);
    step_ = step;
}

void Slider::set_marks(const std::vector<double>& marks)
{
    if (marks == marks_) return;
    marks_ = marks;
    redraw();
}

int Slider::knob_x(double value) const
{
    const double t = maximum() > minimum() ? std::clamp((value - minimum()) / (maximum() - minimum()), 0.0, 1.0) : 0.0;
    return x() + static_cast<int>(std::lround(t * (w() - layout().knob())));
}

void Slider::draw()
{
    const int knob = layout().knob(), track = layout().track();
    const int middle = y() + h() / 2, at = knob_x(value());
    fl_push_clip(x(), y(), w(), h());
    fl_color(parent() ? parent()->color() : theme().window);
    fl_rectf(x(), y(), w(), h());

    fl_color(active_r() ? theme().border : theme().raised);
    fl_rectf(x() + knob / 2, middle - track / 2, w() - knob, track);
    if (active_r()) {
        // The part that is filled starts at zero where zero lies between the ends.
        const double zero = std::clamp((0 - minimum()) / (maximum() - minimum()), 0.0, 1.0);
        const int from = x() + knob / 2 + static_cast<int>(std::lround(zero * (w() - knob))), to = at + knob / 2;
        fl_color(theme().accent);
        fl_rectf(std::min(from, to), middle - track / 2, std::abs(to - from), track);
    }
    fl_color(theme().amber);
    for (const double mark : marks_)
        if (mark >= minimum() && mark <= maximum()) fl_rectf(knob_x(mark) + knob / 2 - track / 4, y() + h() / 2 - knob / 2, std::max(2, track / 2), knob);
    const bool focused = Fl::focus() == this;
    fl_color(!active_r() ? theme().border : hovered_ || focused ? theme().on_accent : theme().text);
    fl_pie(at, middle - knob / 2, knob, knob, 0, 360);
    if (focused) {
        fl_color(theme().accent);
        fl_arc(at - 1, middle - knob / 2 - 1, knob + 2, knob + 2, 0, 360);
    }
    fl_pop_clip();
}

void Slider::slide_to(double wanted)
{
    const double next = snap ? snap(wanted) : wanted;
    if (next == value()) return;
    value(next);
    redraw();
    if (on_slide) on_slide(next);
}

void Slider::go(double steps)
{
    const double fine = Fl::event_state(FL_SHIFT) ? 0.1 : 1.0;
    const double next = std::clamp(value() + steps * fine * step_, minimum(), maximum());
    // A tenth of a step is none that snap() knows, so it is taken as it is, free of the dust of its sum.
    if (fine < 1 && step_ < 1) {
        const double places = std::pow(10.0, std::ceil(-std::log10(step_ * fine) - 1e-9));
        const double rounded = std::round(next * places) / places;
        value(rounded);
        redraw();
        if (on_slide) on_slide(rounded);
    } else {
        slide_to(next);
    }
}

double Slider::under_pointer() const
{
    const double t = double(Fl::event_x() - x() - layout().knob() / 2) / std::max(1, w() - layout().knob());
    return minimum() + std::clamp(t, 0.0, 1.0) * (maximum() - minimum());
}

int Slider::handle(int event)
{
    switch (event) {
    case FL_ENTER:
    case FL_LEAVE:
        hovered_ = event == FL_ENTER;
        redraw();
        return 1;
    case FL_PUSH:
        if (Fl::event_button() != 1) return 0;
        take_focus();
        [[fallthrough]];
    case FL_DRAG:
        slide_to(under_pointer());
        return 1;
    case FL_RELEASE:
        slide_to(under_pointer()); // the last move may have come together with the release, and then there was no drag
        if (on_release) on_release();
        return 1;
    case FL_MOUSEWHEEL:
        if (Fl::event_dy() == 0) return 0;
        go(-5.0 * Fl::event_dy());
        return 1;
    case FL_KEYBOARD:
        switch (Fl::event_key()) {
        case FL_Left: go(-1); return 1;
        case FL_Right: go(1); return 1;
        case FL_Page_Down: go(-10); return 1;
        case FL_Page_Up: go(10); return 1;
        default: return 0;
        }
    case FL_FOCUS:
    case FL_UNFOCUS: redraw(); return 1;
    default: return Fl_Valuator::handle(event);
    }
}

} // namespace druse::ui
