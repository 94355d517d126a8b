#include "ui/text_rows.h"

#include "ui/dialogs.h"
#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/Fl_Menu_Button.H>

namespace druse::ui {

// --- a switch -----------------------------------------------------------------------------------------------------------------

ToggleRow::ToggleRow(const Control& control, int x, int y, int w) : ParameterRow(control, x, y, w), button_(0, 0, 1, 1)
{
    end();
    button_.down_box(FL_DOWN_BOX);
    button_.color(theme().sunken);
    button_.selection_color(theme().accent);
    button_.callback([](Fl_Widget*, void* row) {
        auto* self = static_cast<ToggleRow*>(row);
        self->set(self->button_.value() ? "true" : "false");
    }, this);
    arrange();
}

void ToggleRow::arrange() { button_.resize(control_x(), y(), layout().control_height(), layout().control_height()); }

void ToggleRow::show_value(const std::string& text, bool is_default)
{
    is_default_ = is_default;
    button_.value(text == "true");
    redraw();
}

// --- one of some words --------------------------------------------------------------------------------------------------------

ChoiceRow::ChoiceRow(const Control& control, int x, int y, int w) : ParameterRow(control, x, y, w), choice_(0, 0, 1, 1)
{
    end();
    for (const std::string& word : control.words) choice_.add(word.c_str());
    choice_.color(theme().raised);
    choice_.textsize(layout().font());
    choice_.callback([](Fl_Widget*, void* row) {
        auto* self = static_cast<ChoiceRow*>(row);
        if (self->choice_.mvalue()) self->pick(self->control().words.at(std::size_t(self->choice_.value())));
    }, this);
    arrange();
}

void ChoiceRow::arrange() { choice_.resize(control_x(), y(), x() + w() - control_x(), layout().control_height()); }

void ChoiceRow::show_value(const std::string& text, bool is_default)
{
    is_default_ = is_default;
    choice_.value(-1);
    for (std::size_t i = 0; i < control().words.size(); ++i)
        if (control().words[i] == text) choice_.value(int(i));
    redraw();
}

// --- text ---------------------------------------------------------------------------------------------------------------------

TextRow::TextRow(const Control& control, int x, int y, int w) : ParameterRow(control, x, y, w), field_(0, 0, 1, 1), button_(0, 0, 1, 1)
{
    end();
    field_.textsize(layout().font());
    field_.when(FL_WHEN_ENTER_KEY | FL_WHEN_RELEASE | FL_WHEN_NOT_CHANGED);
    field_.callback([](Fl_Widget*, void* row) { static_cast<TextRow*>(row)->typed(); }, this);
    button_.callback([](Fl_Widget*, void* row) { static_cast<TextRow*>(row)->ask(); }, this);
    button_.color(theme().raised);
    button_.labelsize(layout().small_font());
    if (control.kind == Control::Kind::file || control.kind == Control::Kind::solid) button_.label("…");
    else if (control.kind == Control::Kind::selector) button_.label("@#2>");
    else if (control.kind != Control::Kind::colour) button_.hide();
    arrange();
}

void TextRow::arrange()
{
    const int height = layout().control_height(), right = x() + w();
    const int button = button_.visible() ? height + layout().gap() / 2 : 0;
    field_.resize(control_x(), y(), right - control_x() - button, height);
    button_.resize(right - height, y(), height, height);
}

void TextRow::show_value(const std::string& text, bool is_default)
{
    is_default_ = is_default;
    shown_ = text;
    if (text != field_.value()) field_.value(text.c_str());
    if (control().kind == Control::Kind::colour) button_.color(fl_colour(colour_from_hex(text).value_or(Colour{128, 128, 128})));
    redraw();
}

void TextRow::typed()
{
    const bool changed = shown_ != field_.value();
    if (changed) set(field_.value());
    if (Fl::event() == FL_KEYBOARD && (Fl::event_key() == FL_Enter || Fl::event_key() == FL_KP_Enter) && on_enter) on_enter(changed);
}

void TextRow::edit()
{
    field_.take_focus();
    field_.position(0, field_.size());
}

void TextRow::ask()
{
    switch (control().kind) {
    case Control::Kind::file:
        if (const auto file = ask_for_model("Choose a file")) pick(file->string());
        break;
    case Control::Kind::solid:
        if (!on_choose) break;
        if (const auto solid = on_choose(shown_)) pick(*solid);
        break;
    case Control::Kind::colour:
        if (const auto colour = ask_for_colour(colour_from_hex(field_.value()).value_or(Colour{204, 204, 204}))) pick(to_hex(*colour));
        break;
    default: {
        Fl_Menu_Button menu(0, 0, 1, 1);
        menu.textsize(layout().font());
        for (const std::string& word : control().words) menu.add(word.c_str());
        const Fl_Menu_Item* picked = menu.menu()->popup(button_.x(), button_.y() + button_.h());
        if (picked) pick(picked->label());
    }
    }
}

} // namespace druse::ui
