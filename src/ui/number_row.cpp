#include "ui/number_row.h"

#include "ui/layout.h"
#include "ui/theme.h"

#include "dlfl/errors.h"
#include "ops/text.h"

#include <FL/Fl.H>

#include <fmt/format.h>

namespace druse::ui {

namespace {

double number_of(const std::string& text, double otherwise)
{
    try {
        return parse_number(text);
    } catch (const CommandError&) {
        return otherwise;
    }
}

/// A number as it fits a field; the tooltip and the command have all its digits.
std::string short_text(const std::string& text)
{
    if (text.size() <= 7) return text;
    try {
        return fmt::format("{:.6g}", parse_number(text));
    } catch (const CommandError&) {
        return text;
    }
}

} // namespace

NumberRow::NumberRow(const Control& control, int x, int y, int w)
    : ParameterRow(control, x, y, w), field_(0, 0, 1, 1), slider_(0, 0, 1, 1)
{
    end();
    field_.textsize(layout().font());
    field_.when(FL_WHEN_ENTER_KEY | FL_WHEN_RELEASE | FL_WHEN_NOT_CHANGED);
    field_.callback([](Fl_Widget*, void* row) { static_cast<NumberRow*>(row)->typed(); }, this);
    if (control.slider) {
        slider_.set_range(control.low, control.high, control.step);
        slider_.snap = [this](double wanted) { return this->control().snap(wanted); };
        slider_.on_slide = [this](double value) { set(number_text(value)); };
    } else {
        slider_.hide();
    }
    arrange();
}

void NumberRow::arrange()
{
    const int height = layout().control_height(), right = x() + w();
    const int field = slider_.visible() ? layout().field_width() : right - control_x();
    field_.resize(control_x(), y(), field, height);
    slider_.resize(control_x() + field + layout().gap(), y(), right - control_x() - field - layout().gap(), height);
}

void NumberRow::show_value(const std::string& text, bool is_default)
{
    is_default_ = is_default;
    text_ = text;
    shown_ = short_text(text);
    if (Fl::focus() != &field_ || shown_ != field_.value()) field_.value(shown_.c_str());
    slider_.value(number_of(text, slider_.value()));
    redraw();
}

void NumberRow::follow(const Control& control)
{
    ParameterRow::follow(control);
    slider_.set_marks(control.marks);
}

void NumberRow::typed()
{
    // What was not touched keeps the digits that the field does not show.
    const bool changed = shown_ != field_.value();
    if (changed) set(field_.value());
    if (Fl::event() == FL_KEYBOARD && (Fl::event_key() == FL_Enter || Fl::event_key() == FL_KP_Enter) && on_enter) on_enter(changed);
}

void NumberRow::edit()
{
    field_.take_focus();
    field_.position(0, field_.size());
}

int NumberRow::handle(int event)
{
    // The wheel turns the number wherever in the row the pointer is; but only where it is not needed to scroll the panel.
    if (event == FL_MOUSEWHEEL && slider_.visible() && Fl::event_inside(control_x(), y(), w(), h())) return slider_.handle(event);
    return ParameterRow::handle(event);
}

} // namespace druse::ui
