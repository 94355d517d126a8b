#pragma once

#include "ui/tile_drawing.h"
#include "ui/tile_view.h"

#include <FL/Fl_Widget.H>

namespace druse::ui {

/// The plane of a tile as a widget: it turns FLTK's events into those of TileView.
class TileCanvas : public Fl_Widget {
public:
    TileCanvas(TileView& view, int x, int y, int w, int h);
    void resize(int x, int y, int w, int h) override;
    int handle(int event) override;

    /// After every event of the mouse: the hint may be another.
    std::function<void()> on_pointer;

protected:
    void draw() override;

private:
    TileView& view_;
    TileDrawing drawing_;
    Image image_;
};

} // namespace druse::ui
