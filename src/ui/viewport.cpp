#include "ui/viewport.h"

#include "ui/gl_context.h"
#include "ui/pictures.h"

#include "dlfl/errors.h"

#include <FL/Fl.H>

#include <chrono>

namespace druse::ui {

Viewport::Viewport(Session& session, View& view, int x, int y, int w, int h) : Fl_Gl_Window(x, y, w, h), session_(session), view_(view)
{
    mode(FL_RGB | FL_DOUBLE | FL_DEPTH);
    end();
    view_.on_redraw = [this] { redraw(); };
}

Viewport::~Viewport() { hide(); }

void Viewport::show()
{
    Fl_Gl_Window::show();
    if (!shown() || context()) return;
    if (!make_core_context(*this)) report_missing("The graphics driver has no OpenGL 3.3; the 3D view stays empty.");
}

void Viewport::hide()
{
    // FLTK destroys the context with the window, and everything in it.
    if (renderer_) {
        make_current();
        solids_.reset();
        renderer_.reset();
    }
    Fl_Gl_Window::hide();
}

void Viewport::report_missing(const std::string& reason)
{
    if (!reason_.empty()) return;
    reason_ = reason;
    session_.say(Message::Kind::error, reason);
    if (session_.on_change) session_.on_change();
}

bool Viewport::make_renderer()
{
    if (renderer_ && context_valid()) return true;
    if (!reason_.empty()) return false;
    for (Renderer* lost : {renderer_.get(), solids_.get()})
        if (lost) lost->forget_context();
    solids_.reset();
    renderer_.reset();
    try {
        renderer_ = std::make_unique<Renderer>(window_gl_loader());
    } catch (const SystemError& e) {
        report_missing(e.what());
        return false;
    }
    samples_ = renderer_->is_software() ? 0 : 4;
    return true;
}

void Viewport::draw()
{
    if (!make_renderer()) return;
    if (!valid()) view_.resize(pixel_w(), pixel_h());
    Style style = view_.style();
    const DrawLists& lists = view_.shown();
    // A large mesh turns without its edges where the processor draws it.
    constexpr std::uint32_t many_triangles = 500000;
    if (renderer_->is_software() && view_.is_moving_camera() && lists.triangle_count() * (1 + lists.copies().size()) > many_triangles) style.edges = false;
    renderer_->draw(lists, view_.camera(), style, view_.overlay(), samples_);
    renderer_->present();
    if (on_frame) on_frame(++frame_);
}

void Viewport::flush()
{
    const auto start = std::chrono::steady_clock::now();
    Fl_Gl_Window::flush();
    frame_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string Viewport::driver() const { return renderer_ ? renderer_->driver() : std::string(); }

Image Viewport::picture(int factor, bool transparent)
{
    make_current();
    if (!make_renderer()) throw SystemError(reason_);
    Camera camera = view_.camera();
    camera.resize(camera.width() * factor, camera.height() * factor);
    Style style = view_.style();
    style.transparent_background = transparent;
    style.line_scale *= factor;
    renderer_->draw(view_.shown(), camera, style, {}, 4);
    Image image = renderer_->read_image();
    redraw();
    return image;
}

std::optional<Image> Viewport::picture_of(const Mesh& solid, int size)
{
    if (!reason_.empty()) throw SystemError(reason_);
    if (!renderer_ || !shown() || !context_valid()) return {};
    make_current();
    if (!solids_) solids_ = std::make_unique<Renderer>(window_gl_loader());

    // Drawn larger and made smaller, which is smoother than what most drivers do, and the same with all of them.
    constexpr int factor = 4;
    const DrawLists lists(solid, [](int) { return Colour{0xc9, 0xce, 0xd6}; });
    Camera camera;
    camera.resize(size * factor, size * factor);
    camera.set_angles({25, 20});
    camera.fit(lists.positions());
    Style style;
    style.transparent_background = true;
    style.line_scale = 0.7 * factor;
    solids_->draw(lists, camera, style, {}, 0);
    return shrunk(solids_->read_image(), factor);
}

int Viewport::handle(int event)
{
    switch (event) {
    case FL_PUSH:
        take_focus();
        view_.press(pointer_at(0, 0));
        return 1;
    case FL_DRAG: view_.drag(pointer_at(0, 0)); return 1;
    case FL_RELEASE: view_.release(pointer_at(0, 0)); return 1;
    case FL_ENTER:
    case FL_MOVE: view_.hover(pointer_at(0, 0)); return 1;
    case FL_LEAVE: view_.leave(); return 1;
    case FL_MOUSEWHEEL: view_.wheel(Fl::event_dy(), pointer_at(0, 0)); return 1;
    case FL_FOCUS:
    case FL_UNFOCUS: return 1;
    case FL_KEYDOWN:
    case FL_KEYUP:
        if (Fl::event_key() == FL_Shift_L || Fl::event_key() == FL_Shift_R) view_.hold_shift(event == FL_KEYDOWN);
        return Fl_Gl_Window::handle(event);
    case FL_DND_ENTER:
    case FL_DND_DRAG:
    case FL_DND_LEAVE: return 1;
    case FL_DND_RELEASE: dropped_ = true; return 1;
    case FL_PASTE:
        if (dropped_ && on_drop) on_drop(Fl::event_text() ? Fl::event_text() : "");
        dropped_ = false;
        return 1;
    default: return Fl_Gl_Window::handle(event);
    }
}

} // namespace druse::ui
