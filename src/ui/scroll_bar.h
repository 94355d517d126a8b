#pragma once

#include <FL/Fl_Widget.H>

namespace druse::ui {

/// A slim bar that shows which part of something taller is seen, and moves it.
class ScrollBar : public Fl_Widget {
public:
    ScrollBar() : Fl_Widget(0, 0, 1, 1) {}

    /// `total` pixels, of which the bar's own height is seen; `step` is what one notch of the wheel moves by a third.
    void set(int total, int step);
    int top() const { return top_; }
    /// Kept inside what there is.
    void set_top(int top);
    bool is_needed() const { return total_ > h() && h() > 0; }

    int handle(int event) override;

protected:
    void draw() override;

private:
    int knob_height() const;
    int knob_y() const;

    int total_ = 0, step_ = 1, top_ = 0, grip_ = 0;
    bool hovered_ = false;
};

} // namespace druse::ui
