#pragma once

#include "ui/plane_editor.h"

#include "render/image.h"

#include <FL/Fl_Widget.H>

#include <functional>

namespace druse::ui {

/// A plane as a widget: it turns FLTK's events into those of a PlaneEditor.
class PlaneCanvas : public Fl_Widget {
public:
    /// Draws into an image of the size of the view; `scale` is that of the layout.
    using Drawing = std::function<void(bool dark, double scale, Image& image)>;

    PlaneCanvas(PlaneEditor& editor, Drawing drawing, int x, int y, int w, int h);
    void resize(int x, int y, int w, int h) override;
    int handle(int event) override;

    /// After every event of the mouse: the hint may be another.
    std::function<void()> on_pointer;

protected:
    void draw() override;

private:
    PlaneEditor& editor_;
    Drawing drawing_;
    Image image_;
};

} // namespace druse::ui
