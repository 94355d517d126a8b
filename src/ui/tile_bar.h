#pragma once

#include "ui/panel.h"

#include "render/image.h"

#include <FL/Fl_Button.H>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace druse::ui {

/// A strip of buttons; those that are switches show whether they are on. The first one has a picture of the type of tile.
class TileBar : public Panel {
public:
    TileBar();

    std::function<void()> on_type; // the type was clicked
    /// A button: from the left end on, or, `at_end`, up to the right one. A gap goes before it where `apart`.
    void add_button(const char* label, const char* tip, std::function<void()> press, std::function<bool()> is_on = {}, bool apart = false, bool at_end = false);
    void set_type(const std::string& name);
    /// Brings the switches up to date.
    void refresh();

protected:
    void arrange() override;
    void draw() override;

private:
    /// The type of tile there is; a click chooses another.
    class TypeButton : public Fl_Button {
    public:
        TypeButton() : Fl_Button(0, 0, 1, 1) {}
        void set_type(const std::string& name);

    private:
        void draw() override;
        std::string name_;
        Image picture_;
    };

    struct Item {
        std::unique_ptr<Fl_Button> button;
        std::function<void()> press;
        std::function<bool()> is_on;
        bool apart, at_end;
    };
    std::vector<Item> items_;
    TypeButton type_;
};

} // namespace druse::ui
