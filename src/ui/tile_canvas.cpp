#include "ui/tile_canvas.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/fl_draw.H>

#include <algorithm>

namespace druse::ui {

TileCanvas::TileCanvas(TileView& view, int x, int y, int w, int h) : Fl_Widget(x, y, w, h), view_(view)
{
    view_.on_redraw = [this] { redraw(); };
    set_visible_focus();
}

void TileCanvas::resize(int x, int y, int w, int h)
{
    Fl_Widget::resize(x, y, w, h);
    view_.resize(w, h);
}

void TileCanvas::draw()
{
    if (w() < 1 || h() < 1) return;
    if (image_.width != w() || image_.height != h()) image_ = Image(w(), h());
    drawing_.draw(view_, theme_is_dark(), layout().scale, image_);
    fl_draw_image(&image_.pixels.front().red, x(), y(), w(), h(), int(sizeof(Pixel)), 0);
    if (view_.tile().type) return;
    fl_font(FL_HELVETICA, layout().font());
    draw_text("Choose a type of tile at the top left, or open a tile.", x(), y(), w(), h(), theme().faint_text, FL_ALIGN_CENTER);
}

int TileCanvas::handle(int event)
{
    switch (event) {
    case FL_PUSH:
        take_focus();
        view_.press(pointer_at(x(), y()));
        break;
    case FL_DRAG: view_.drag(pointer_at(x(), y())); break;
    case FL_RELEASE: view_.release(pointer_at(x(), y())); break;
    case FL_ENTER:
    case FL_MOVE: view_.hover(pointer_at(x(), y())); break;
    case FL_LEAVE: view_.leave(); break;
    case FL_MOUSEWHEEL: view_.wheel(Fl::event_dy(), pointer_at(x(), y())); break;
    case FL_FOCUS:
    case FL_UNFOCUS: return 1;
    default: return Fl_Widget::handle(event);
    }
    if (on_pointer) on_pointer();
    return 1;
}

} // namespace druse::ui
