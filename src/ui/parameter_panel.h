#pragma once

#include "ui/panel.h"
#include "ui/parameter_row.h"
#include "ui/pictures.h"
#include "ui/scroll_area.h"
#include "ui/session.h"

#include <FL/Fl_Button.H>
#include <FL/Fl_Check_Button.H>

#include <memory>
#include <vector>

namespace druse::ui {

/// The parameters of the chosen operator, one row each, and what to do with them. Made from the registry.
class ParameterPanel : public Panel {
public:
    ParameterPanel(Session& session, Pictures& pictures, int x, int y, int w, int h);

    std::function<void()> on_help;
    /// Fits a control to the model that there is.
    std::function<void(Control&)> fit;

    /// Shows what the session has now.
    void refresh();
    /// The row of a parameter (of a list: of one of its numbers); null if there is none.
    ParameterRow* row(std::string_view parameter, int place = -1);

    int handle(int event) override;

protected:
    void arrange() override;
    void draw() override;

private:
    void make_rows(bool keep);
    void show_values();
    void set(const Control& control, const std::string& text, bool picked);
    int header_height() const;

    void choose_preset();
    void choose_solid_for_shown();

    Session& session_;
    Pictures& pictures_;
    const Operator* shown_ = nullptr;
    std::vector<Control> controls_; // of the rows
    ScrollArea scroll_;
    std::vector<std::unique_ptr<ParameterRow>> rows_; // after what they are in, so that they go first

    /// What the operator makes; where that is a parameter, a click chooses another solid.
    class Picture : public Fl_Button {
    public:
        explicit Picture(const char* label) : Fl_Button(0, 0, 1, 1, label) {}
        std::function<Fl_RGB_Image*()> find;

    private:
        void draw() override;
    };
    Picture picture_;
    Fl_Check_Button live_;
    Fl_Button presets_, apply_, reset_, help_;
};

} // namespace druse::ui
