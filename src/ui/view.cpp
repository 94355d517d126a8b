#include "ui/view.h"

#include "ui/box_gesture.h"
#include "ui/camera_gestures.h"
#include "ui/click_gesture.h"
#include "ui/element_tools.h"
#include "ui/gizmo.h"
#include "ui/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse::ui {

namespace {

constexpr double turn_seconds = 0.2;
constexpr double zoom_per_notch = 1.15;

std::string text_of(const std::optional<Target>& target)
{
    if (!target) return "nothing";
    if (target->edge) return fmt::format("edge {}", target->edge->index);
    if (target->vertex && !target->face) return fmt::format("vertex {}", target->vertex->index);
    std::string text = fmt::format("face {}", target->face->index);
    if (target->vertex) text += fmt::format(" vertex {}", target->vertex->index);
    if (target->faces.size() > 1) text += fmt::format(" outlined {}", target->faces.size());
    return text;
}

void outline(Overlay& overlay, const Target& target, std::vector<Face>& faces)
{
    faces = target.faces;
    if (target.edge) overlay.edges.push_back(*target.edge);
    if (target.vertex) overlay.vertices.push_back(*target.vertex);
}

} // namespace

View::View(Session& session) : session_(session), select_(std::make_unique<SelectTool>(element_, session_, camera_)) {}

void View::redraw()
{
    if (on_redraw) on_redraw();
}

void View::event(const std::string& line)
{
    if (on_event) on_event(line);
}

void View::resize(int width, int height)
{
    camera_.resize(std::max(width, 1), std::max(height, 1));
    redraw();
}

void View::set_style(const Style& style)
{
    style_ = style;
    redraw();
}

std::string View::hint() const
{
    if (box_next_) return "drag a box around what to select; Shift adds, Ctrl removes";
    if (!armed_ && session_.display().counts.vertices == 0) return "open a file (Ctrl+O) or choose a shape under Make";
    if (clicking_) return "release to act; beside the mesh or Escape cancels";
    return tool().hint();
}

void View::set_element(Element element)
{
    element_ = element;
    select_ = std::make_unique<SelectTool>(element_, session_, camera_);
    hovered_.reset();
    redraw();
}

void View::start_box_select()
{
    box_next_ = true;
    hovered_.reset();
    redraw();
}

// --- what is drawn over the mesh ----------------------------------------------------------------------------------------------

Overlay View::overlay() const
{
    Overlay overlay;
    const Selection& selection = *session_.display().selection;
    overlay.edges = selection.edges;
    overlay.vertices = selection.vertices;
    overlay.failed = session_.failed_faces();
    if (pressed_) outline(overlay, *pressed_, overlay.pressed);
    else if (hovered_) outline(overlay, *hovered_, overlay.hovered);

    if (armed_operator_ && armed_operator_->family() == "face")
        for (const Point& p : session_.display().starts) overlay.lines.push_back({p, p, overlay.highlight, 9 * layout().scale, 1});
    add_box_lines(overlay);
    const auto axes = Gizmo::lines(camera_, pointer_);
    overlay.screen_lines.insert(overlay.screen_lines.end(), axes.begin(), axes.end());
    return overlay;
}

void View::add_box_lines(Overlay& overlay) const
{
    if (!box_) return;
    const Point a(box_->start().x, box_->start().y, 0), c(box_->end().x, box_->end().y, 0);
    const Point b(c.x, a.y, 0), d(a.x, c.y, 0);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, d), std::pair(d, a)})
        overlay.screen_lines.push_back({from, to, overlay.highlight, 1.5 * layout().scale, 1});
}

void View::show_hovered(const std::optional<Target>& target)
{
    if (target == hovered_) return;
    hovered_ = target;
    redraw();
}

void View::show_pressed(const std::optional<Target>& target)
{
    if (target == pressed_) return;
    pressed_ = target;
    if (target || clicking_) event("pressed " + text_of(target));
    redraw();
}

// --- the camera ---------------------------------------------------------------------------------------------------------------

void View::frame_all()
{
    camera_.fit(session_.display().lists.bounds());
    framed_ = session_.display().lists.id();
    redraw();
}

void View::frame_selection()
{
    const Display& display = session_.display();
    Box box;
    for (const Face f : display.selection->faces)
        for (const auto& side : display.lists.sides(f))
            for (const std::uint32_t v : side) box.add(display.lists.position(v));
    for (const Edge e : display.selection->edges)
        for (const std::uint32_t v : display.lists.edges()[e.index]) box.add(display.lists.position(v));
    for (const Vertex v : display.selection->vertices) box.add(display.lists.position(v.index));
    camera_.fit(box.empty() ? display.lists.bounds() : box);
    redraw();
}

void View::look(ViewAngles angles)
{
    if (animated_) {
        // The short way round.
        ViewAngles from = camera_.angles();
        from.azimuth = angles.azimuth + std::remainder(from.azimuth - angles.azimuth, 360.0);
        turn_ = Turn{from, angles};
    } else {
        camera_.set_angles(angles);
    }
    redraw();
}

bool View::animate(double now)
{
    if (!turn_) return false;
    if (turn_->start < 0) turn_->start = now;
    const double t = std::clamp((now - turn_->start) / turn_seconds, 0.0, 1.0), s = t * t * (3 - 2 * t);
    camera_.set_angles(t < 1 ? ViewAngles{std::lerp(turn_->from.azimuth, turn_->to.azimuth, s), std::lerp(turn_->from.elevation, turn_->to.elevation, s)}
                             : turn_->to);
    if (t >= 1) turn_.reset();
    redraw();
    return turn_.has_value();
}

void View::set_parallel(bool on)
{
    camera_.set_parallel(on);
    redraw();
}

void View::zoom(double factor)
{
    camera_.zoom(factor, camera_.width() / 2.0, camera_.height() / 2.0);
    redraw();
}

// --- the mouse ----------------------------------------------------------------------------------------------------------------

std::unique_ptr<Gesture> View::gesture_for(const Pointer& p)
{
    if (p.button == 2) {
        if (p.shift) return std::make_unique<PanGesture>(camera_, p);
        if (p.ctrl) return std::make_unique<ZoomGesture>(camera_, p);
        return std::make_unique<OrbitGesture>(camera_, p);
    }
    if (p.button == 3) return std::make_unique<PanGesture>(camera_, p);
    if (p.button != 1 || p.alt) return std::make_unique<OrbitGesture>(camera_, p);
    if (box_next_) {
        auto box = std::make_unique<BoxGesture>(element_, session_, camera_, p);
        box_ = box.get();
        return box;
    }
    if (!tool().under(p)) return std::make_unique<OrbitGesture>(camera_, p);
    clicking_ = true;
    return std::make_unique<ClickGesture>(tool(), p, [this](const std::optional<Target>& target) { show_pressed(target); });
}

void View::press(const Pointer& p)
{
    pointer_ = Point2(p.x, p.y);
    turn_.reset();
    if (gesture_) {
        cancel(); // a second button
        return;
    }
    hovered_.reset();
    pressed_at_ = p;
    moved_ = false;
    if (const auto view = p.button == 1 ? Gizmo::view_at(camera_, p.x, p.y) : std::nullopt) {
        look(*view);
        return;
    }
    gesture_ = gesture_for(p);
    redraw();
}

void View::drag(const Pointer& p)
{
    pointer_ = Point2(p.x, p.y);
    if (!gesture_) return;
    if (std::hypot(p.x - pressed_at_.x, p.y - pressed_at_.y) >= layout().click_slop()) moved_ = true;
    // A tool follows from the first pixel; the camera, or a box, when it is clear that this is no click.
    if (clicking_ || moved_) gesture_->move(p);
    redraw();
}

void View::release(const Pointer& p)
{
    if (!gesture_) return;
    const std::unique_ptr<Gesture> gesture = std::move(gesture_);
    const bool click = !moved_, was_clicking = clicking_, was_box = box_ != nullptr;
    clicking_ = false;
    box_ = nullptr;
    if (was_box) box_next_ = false;
    if (was_clicking || moved_) gesture->release(p);
    else if (click && pressed_at_.button == 3 && on_menu) on_menu(p);
    else if (click && pressed_at_.button == 1 && !pressed_at_.alt) tool().act_on_nothing();
    hover(p);
    redraw();
}

void View::hover(const Pointer& p)
{
    pointer_ = Point2(p.x, p.y);
    const bool on_gizmo = Gizmo::view_at(camera_, p.x, p.y).has_value();
    if (on_gizmo || p.x > camera_.width() - 2 * (layout().gizmo_margin() + layout().gizmo_radius())) redraw();
    show_hovered(box_next_ || on_gizmo ? std::nullopt : tool().under(p));
}

void View::leave()
{
    pointer_.reset();
    show_hovered({});
}

void View::wheel(double notches, const Pointer& p)
{
    camera_.zoom(std::pow(zoom_per_notch, -notches), p.x, p.y);
    redraw();
}

bool View::cancel()
{
    if (box_next_ && !gesture_) {
        box_next_ = false;
        redraw();
        return true;
    }
    if (!gesture_) return false;
    const std::unique_ptr<Gesture> gesture = std::move(gesture_);
    if (clicking_) event("click cancelled");
    clicking_ = false;
    box_next_ = box_next_ && !box_;
    box_ = nullptr;
    gesture->cancel();
    pressed_.reset();
    redraw();
    return true;
}

void View::session_changed()
{
    if (session_.chosen() != armed_operator_) {
        cancel();
        armed_operator_ = session_.chosen();
        armed_ = tool_for(armed_operator_, session_, camera_);
    }
    // What was hovered may be gone; what is framed stays framed until a file, or the first shape, comes.
    hovered_.reset();
    redraw();
}

} // namespace druse::ui
