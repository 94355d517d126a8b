#pragma once

#include "ui/control.h"
#include "ui/panel.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace druse::ui {

/// One row of the parameter panel: a label and the control of one parameter, or of one number of a list.
class ParameterRow : public Panel {
public:
    ParameterRow(const Control& control, int x, int y, int w);

    /// The person has set it to this text; an empty one asks for the default.
    std::function<void(const std::string&)> on_set;
    /// The same, but in a menu or dialog.
    std::function<void(const std::string&)> on_pick;
    /// "Copy as command" was chosen.
    std::function<void()> on_copy;
    /// Enter was pressed in a field; `changed` tells whether that set another value.
    std::function<void(bool changed)> on_enter;

    /// The button beside a solid was pressed: chooses another one, or none.
    std::function<std::optional<std::string>(const std::string& current)> on_choose;

    const Control& control() const { return control_; }
    /// Shows a value; `is_default` makes the label faint.
    virtual void show_value(const std::string& text, bool is_default) = 0;
    /// Takes over the help and the marks of a control that the row serves too.
    virtual void follow(const Control& control);

    int handle(int event) override;

protected:
    void draw() override;
    void set(const std::string& text);
    void pick(const std::string& text);
    /// Puts the keyboard into the row's field, for "Type a value".
    virtual void edit() {}
    int control_x() const;

    bool is_default_ = true;

private:
    void open_menu();
    Control control_;
};

/// The kind of row that a control asks for.
std::unique_ptr<ParameterRow> make_row(const Control& control, int x, int y, int w);

} // namespace druse::ui
