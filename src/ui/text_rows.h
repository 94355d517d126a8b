#pragma once

#include "ui/parameter_row.h"

#include <FL/Fl_Button.H>
#include <FL/Fl_Check_Button.H>
#include <FL/Fl_Choice.H>
#include <FL/Fl_Input.H>

namespace druse::ui {

/// A switch.
class ToggleRow : public ParameterRow {
public:
    ToggleRow(const Control& control, int x, int y, int w);
    void show_value(const std::string& text, bool is_default) override;

protected:
    void arrange() override;

private:
    Fl_Check_Button button_;
};

/// One of some words.
class ChoiceRow : public ParameterRow {
public:
    ChoiceRow(const Control& control, int x, int y, int w);
    void show_value(const std::string& text, bool is_default) override;

protected:
    void arrange() override;

private:
    Fl_Choice choice_;
};

/// Text as a command writes it, with a button beside it where there is something to choose from: words, a colour, a file.
class TextRow : public ParameterRow {
public:
    TextRow(const Control& control, int x, int y, int w);
    void show_value(const std::string& text, bool is_default) override;

protected:
    void arrange() override;
    void edit() override;

private:
    void typed();
    void ask();
    std::string shown_;
    Fl_Input field_;
    Fl_Button button_;
};

} // namespace druse::ui
