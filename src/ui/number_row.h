#pragma once

#include "ui/parameter_row.h"
#include "ui/slider.h"

#include <FL/Fl_Input.H>

namespace druse::ui {

/// A number: a field to type it into and, where the parameter has a range to slide over, a slider.
class NumberRow : public ParameterRow {
public:
    NumberRow(const Control& control, int x, int y, int w);
    void show_value(const std::string& text, bool is_default) override;
    void follow(const Control& control) override;
    int handle(int event) override;

protected:
    void arrange() override;
    void edit() override;

private:
    void typed();

    std::string text_; // of the value shown, in full
    std::string shown_;
    Fl_Input field_;
    Slider slider_;
};

} // namespace druse::ui
