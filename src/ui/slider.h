#pragma once

#include <FL/Fl_Valuator.H>

#include <functional>
#include <vector>

namespace druse::ui {

/// A slim horizontal slider. The wheel and the arrow keys go a step, with Shift a tenth of one.
///
/// The value may lie outside the slider's ends; the knob then stays at the end.
class Slider : public Fl_Valuator {
public:
    Slider(int x, int y, int w, int h);

    void set_range(double low, double high, double step);
    /// Values to be marked; those beyond the ends are not shown.
    void set_marks(const std::vector<double>& marks);
    const std::vector<double>& marks() const { return marks_; }
    /// Called with the wanted number before it becomes the value: what one can slide to.
    std::function<double(double)> snap;
    std::function<void(double)> on_slide;
    std::function<void()> on_release;

    int handle(int event) override;

protected:
    void draw() override;

private:
    int knob_x(double value) const;
    double under_pointer() const;
    void slide_to(double wanted);
    void go(double steps);

    double step_ = 0;
    std::vector<double> marks_;
    bool hovered_ = false;
};

} // namespace druse::ui
