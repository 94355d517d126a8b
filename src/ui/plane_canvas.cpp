#include "ui/plane_canvas.h"

#include "ui/draw.h"
#include "ui/layout.h"
#include "ui/theme.h"

#include <FL/Fl.H>
#include <FL/fl_draw.H>

#include <utility>

namespace druse::ui {

PlaneCanvas::PlaneCanvas(PlaneEditor& editor, Drawing drawing, int x, int y, int w, int h) : Fl_Widget(x, y, w, h), editor_(editor), drawing_(std::move(drawing))
{
    editor_.on_redraw = [this] { redraw(); };
    set_visible_focus();
}

void PlaneCanvas::resize(int x, int y, int w, int h)
{
    Fl_Widget::resize(x, y, w, h);
    editor_.resize(w, h);
}

void PlaneCanvas::draw()
{
    if (w() < 1 || h() < 1) return;
    if (image_.width != w() || image_.height != h()) image_ = Image(w(), h());
    drawing_(theme_is_dark(), layout().scale, image_);
    fl_draw_image(&image_.pixels.front().red, x(), y(), w(), h(), int(sizeof(Pixel)), 0);
    fl_font(FL_HELVETICA, layout().font());
    draw_text(editor_.invitation().c_str(), x(), y(), w(), h(), theme().faint_text, FL_ALIGN_CENTER);
}

int PlaneCanvas::handle(int event)
{
    switch (event) {
    case FL_PUSH:
        take_focus();
        editor_.press(pointer_at(x(), y()));
        break;
    case FL_DRAG: editor_.drag(pointer_at(x(), y())); break;
    case FL_RELEASE: editor_.release(pointer_at(x(), y())); break;
    case FL_ENTER:
    case FL_MOVE: editor_.hover(pointer_at(x(), y())); break;
    case FL_LEAVE: editor_.leave(); break;
    case FL_MOUSEWHEEL: editor_.wheel(Fl::event_dy(), pointer_at(x(), y())); break;
    case FL_FOCUS:
    case FL_UNFOCUS: return 1;
    default: return Fl_Widget::handle(event);
    }
    if (on_pointer) on_pointer();
    return 1;
}

} // namespace druse::ui
