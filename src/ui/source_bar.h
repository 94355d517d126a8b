#pragma once

#include "ui/panel.h"

#include "render/image.h"

#include <FL/Fl_Button.H>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace druse::ui {

/// A strip of buttons; those that are switches show whether they are on. The first one says what type of tile or cell there is, with a picture.
class SourceBar : public Panel {
public:
    /// `tip` and `invitation` are of the first button: the latter is on it while there is no type. `width`: of it, in pixels at scale 1.
    SourceBar(const char* tip, const char* invitation, int width);

    std::function<void()> on_type; // the type was clicked
    /// A button: from the left end on, or, `at_end`, up to the right one. A gap goes before it where `apart`.
    void add_button(const char* label, const char* tip, std::function<void()> press, std::function<bool()> is_on = {}, bool apart = false, bool at_end = false);
    /// `make_picture` makes a picture of that height, where the type is another than before.
    void set_type(const std::string& name, const std::function<Image(int height)>& make_picture);
    /// Brings the switches up to date.
    void refresh();

protected:
    void arrange() override;
    void draw() override;

private:
    /// The type there is; a click chooses another.
    class TypeButton : public Fl_Button {
    public:
        explicit TypeButton(const char* invitation) : Fl_Button(0, 0, 1, 1, "…"), invitation_(invitation) {} // it asks, as its label tells
        void set_type(const std::string& name, const std::function<Image(int height)>& make_picture);

    private:
        void draw() override;
        const char* invitation_;
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
    int type_width_;
};

} // namespace druse::ui
