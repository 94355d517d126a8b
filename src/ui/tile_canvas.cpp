#include "ui/tile_canvas.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"
#include "ui/tile_drawing.h"

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
    draw_tile_plane(view_, theme_is_dark(), layout().scale, image_);
    fl_draw_image(&image_.pixels.front().red, x(), y(), w(), h(), int(sizeof(Pixel)), 0);
    if (view_.tile().type) return;
    fl_font(FL_HELVETICA, layout().font());
    draw_text("Choose a type of tile at the top left, or open a tile.", x(), y(), w(), h(), theme().faint_text, FL_ALIGN_CENTER);
}

Pointer TileCanvas::pointer() const
{
    Pointer p;
    p.x = Fl::event_x() - x() + 0.5;
    p.y = Fl::event_y() - y() + 0.5;
    p.button = Fl::event_button();
    p.shift = Fl::event_state(FL_SHIFT) != 0;
    p.ctrl = Fl::event_state(FL_CTRL) != 0;
    p.alt = Fl::event_state(FL_ALT) != 0;
    p.twice = Fl::event_clicks() > 0;
    return p;
}

int TileCanvas::handle(int event)
{
    switch (event) {
    case FL_PUSH:
        take_focus();
        view_.press(pointer());
        break;
    case FL_DRAG: view_.drag(pointer()); break;
    case FL_RELEASE: view_.release(pointer()); break;
    case FL_ENTER:
    case FL_MOVE: view_.hover(pointer()); break;
    case FL_LEAVE: view_.leave(); break;
    case FL_MOUSEWHEEL: view_.wheel(Fl::event_dy(), pointer()); break;
    case FL_FOCUS:
    case FL_UNFOCUS: return 1;
    default: return Fl_Widget::handle(event);
    }
    if (on_pointer) on_pointer();
    return 1;
}

} // namespace druse::ui
