#include "ui/view.h"

#include "ui/box_gesture.h"
#include "ui/camera_gestures.h"
#include "ui/click_gesture.h"
#include "ui/element_tools.h"
#include "ui/gizmo.h"
#include "ui/layout.h"

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace druse::ui {

namespace {

constexpr double zoom_per_notch = 1.15;

std::string text_of(const std::optional<Target>& target)
{
    if (!target) return "nothing";
    if (!target->name.empty()) return target->name;
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

View::View(Session& session) : session_(session), smooth_(session), crust_(session), select_(std::make_unique<SelectTool>(element_, session_, camera_))
{
    smooth_.on_event = crust_.on_event = [this](const std::string& line) { event(line); };
}

void View::redraw()
{
    if (on_camera && camera_ != told_) {
        told_ = camera_;
        on_camera();
    }
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
    if (!armed_ && !has_own_tool_ && session_.display().counts.vertices == 0) return "open a file (Ctrl+O) or choose a shape under Make";
    if (clicking_) return tool().pressed_hint();
    return tool().hint();
}

void View::set_element(Element element)
{
    element_ = element;
    select_ = std::make_unique<SelectTool>(element_, session_, camera_);
    hovered_.reset();
    redraw();
}

void View::use_tool(std::unique_ptr<Tool> tool)
{
    cancel();
    select_ = std::move(tool);
    has_own_tool_ = true;
    hovered_.reset();
    redraw();
}

void View::set_brush(double radius)
{
    settings_.brush = std::clamp(radius, 0.0, largest_brush);
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
    if (const bool is_mesh = !(stand_in && stand_in()); is_mesh) {
        overlay.edges = session_.display().selection->edges;
        overlay.vertices = session_.display().selection->vertices;
        overlay.failed = session_.failed_faces();
    }
    if (pressed_) outline(overlay, *pressed_, overlay.pressed);
    else if (hovered_) outline(overlay, *hovered_, overlay.hovered);
    if (gesture_) gesture_->add_to(overlay);
    else if (!settling_.painted.empty()) overlay.painted = settling_.painted, overlay.paint = settling_.paint;
    else if (!crust_.meeting().empty()) overlay.painted = crust_.meeting(), overlay.paint = overlay.error;

    if (armed_operator_ && armed_operator_->family() == "face")
        for (const Point& p : session_.display().starts) overlay.lines.push_back({p, p, overlay.highlight, 9 * layout().scale, 1});
    tool().add_marks(overlay);
    if (pointer_ && !box_next_ && !is_moving_camera()) tool().add_pointer(*pointer_, overlay);
    const auto axes = Gizmo::lines(camera_, pointer_ ? std::optional(Point2(pointer_->x, pointer_->y)) : std::nullopt);
    overlay.screen_lines.insert(overlay.screen_lines.end(), axes.begin(), axes.end());
    if (smooth_.lists()) show_on_smooth(overlay);
    return overlay;
}

/// Where the smooth surface is drawn, what is said of faces goes for the parts that they became; and of the faces themselves, on which
/// clicks act, the outlines are drawn around it.
void View::show_on_smooth(Overlay& overlay) const
{
    constexpr std::size_t most_lines = 20000;
    const DrawLists& lists = session_.display().lists;
    const auto add = [&](const std::array<std::uint32_t, 2>& ends, Colour colour, double width) {
        overlay.lines.push_back({lists.position(ends[0]), lists.position(ends[1]), colour, width * layout().scale, 1});
    };
    const auto replace = [&](std::vector<Face>& faces, Colour colour, double width) {
        for (const Face f : faces) {
            if (overlay.lines.size() > most_lines) break;
            for (const auto& side : lists.sides(f)) add(side, colour, width);
        }
        faces = smooth_.parts(faces);
    };
    replace(overlay.hovered, overlay.highlight, 1.5);
    replace(overlay.pressed, overlay.highlight, 3);
    replace(overlay.failed, overlay.error, 3);
    overlay.painted = smooth_.parts(overlay.painted);
    for (const Edge e : overlay.edges)
        if (e.index < lists.edge_limit() && lists.edges()[e.index][0] != DrawLists::none) add(lists.edges()[e.index], overlay.highlight, 3);
    for (const Vertex v : overlay.vertices)
        if (v.index < lists.vertex_limit()) add({v.index, v.index}, overlay.highlight, 7);
    overlay.edges.clear();
    overlay.vertices.clear();
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
    camera_.fit(shown().with_copies(shown().bounds()));
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

void View::frame(std::span<const Point> points)
{
    camera_.fit(points);
    redraw();
}

void View::set_camera(const Camera& camera)
{
    turn_.reset();
    const int width = camera_.width(), height = camera_.height();
    camera_ = camera;
    camera_.resize(width, height);
    told_ = camera_;
    redraw();
}

void View::look(ViewAngles angles, double seconds)
{
    Turn turn{camera_, angles, Vector(0.0), 0, seconds};
    if (free_orbit_ || camera_.angles().roll != 0 || angles.roll != 0) {
        Camera goal = camera_;
        goal.set_angles(angles);
        const glm::dquat by = glm::quat_cast(glm::transpose(goal.rotation()) * camera_.rotation());
        turn.axis = glm::axis(by);
        turn.degrees = std::remainder(glm::degrees(glm::angle(by)), 360.0);
    }
    start_turn(turn);
}

void View::look_from(const Vector& toward_eye, double seconds)
{
    Turn turn{camera_, {}, camera_.up(), 180, seconds}; // to the opposite side any axis would do
    const Vector from = camera_.backward(), across = glm::cross(from, toward_eye);
    constexpr double least_across = 1e-12; // of an axis that means anything
    if (const double sine = glm::length(across), cosine = glm::dot(from, toward_eye); sine > least_across || cosine > 0) {
        if (sine > least_across) turn.axis = across / sine;
        turn.degrees = glm::degrees(std::atan2(sine, cosine));
    }
    Camera goal = camera_;
    goal.turn(turn.axis, turn.degrees);
    turn.to = goal.angles();
    start_turn(turn);
}

void View::start_turn(const Turn& turn)
{
    if (animated_) turn_ = turn;
    else camera_.set_angles(turn.to);
    redraw();
}

bool View::animate(double now)
{
    if (!turn_) return false;
    if (turn_->start < 0) turn_->start = now;
    const double t = std::clamp((now - turn_->start) / turn_->seconds, 0.0, 1.0), s = t * t * (3 - 2 * t);
    const ViewAngles from = turn_->from.angles(), to = turn_->to;
    if (t >= 1) {
        camera_.set_angles(to);
    } else if (turn_->axis != Vector(0.0)) {
        camera_.set_angles(from);
        camera_.turn(turn_->axis, s * turn_->degrees);
    } else { // the short way round
        camera_.set_angles({from.azimuth + s * std::remainder(to.azimuth - from.azimuth, 360.0), std::lerp(from.elevation, to.elevation, s)});
    }
    if (t >= 1) turn_.reset();
    redraw();
    return turn_.has_value();
}

void View::set_free_orbit(bool on)
{
    free_orbit_ = on;
    if (const ViewAngles at = camera_.angles(); !on && at.roll != 0) { // at once: a press would end an animation before it is upright
        turn_.reset();
        camera_.set_angles({at.azimuth, at.elevation});
    }
    redraw();
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
        return std::make_unique<OrbitGesture>(camera_, p, free_orbit_);
    }
    if (p.button == 3) return std::make_unique<PanGesture>(camera_, p);
    if (p.button != 1 || p.alt) return std::make_unique<OrbitGesture>(camera_, p, free_orbit_);
    if (box_next_) {
        boxing_ = true;
        return std::make_unique<BoxGesture>(element_, session_, camera_, tool(), p);
    }
    if (!tool().under(p)) return std::make_unique<OrbitGesture>(camera_, p, free_orbit_);
    clicking_ = true;
    return tool().press(p, press_shower());
}

Tool::ShowTarget View::press_shower()
{
    return [this](const std::optional<Target>& target) { show_pressed(target); };
}

void View::carry(std::unique_ptr<Tool> tool, const Pointer& p)
{
    cancel();
    hovered_.reset();
    carried_ = std::move(tool);
    pressed_at_ = p;
    clicking_ = true;
    pressed_shape_ = session_.display().lists.shape_version();
    gesture_ = carried_->press(p, press_shower());
    redraw();
}

void View::press(const Pointer& p)
{
    pointer_ = p;
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
    pressed_shape_ = session_.display().lists.shape_version();
    gesture_ = gesture_for(p);
    redraw();
}

void View::drag(const Pointer& p)
{
    pointer_ = p;
    if (!gesture_) return;
    if (std::hypot(p.x - pressed_at_.x, p.y - pressed_at_.y) >= layout().click_slop()) moved_ = true;
    // A tool follows from the first pixel; the camera, or a box, when it is clear that this is no click.
    if (clicking_ || moved_) gesture_->move(p);
    redraw();
}

void View::release(const Pointer& p)
{
    if (!gesture_) return;
    const std::unique_ptr<Tool> carried = std::move(carried_); // the gesture works with it
    const std::unique_ptr<Gesture> gesture = std::move(gesture_);
    const bool click = !moved_, was_clicking = clicking_;
    clicking_ = false;
    if (boxing_) boxing_ = box_next_ = false;
    Overlay shown;
    gesture->add_to(shown);
    if (was_clicking || moved_) gesture->release(p);
    else if (click && pressed_at_.button == 3 && on_menu) on_menu(p);
    else if (click && pressed_at_.button == 1 && !pressed_at_.alt) tool().act_on_nothing();
    if (session_.is_working()) settling_ = std::move(shown); // or the picture would fall back for a moment
    hover(p);
    redraw();
}

void View::hover(const Pointer& pointer)
{
    Pointer p = pointer;
    p.twice = false; // whatever the last press was
    pointer_ = p;
    const bool on_gizmo = Gizmo::view_at(camera_, p.x, p.y).has_value();
    if (on_gizmo || p.x > camera_.width() - 2 * (layout().gizmo_margin() + layout().gizmo_radius())) redraw();
    if (armed_ && settings_.brush > 0) redraw(); // its disc
    show_hovered(box_next_ || on_gizmo ? std::nullopt : tool().under(p));
}

void View::hold_shift(bool down)
{
    if (!pointer_ || gesture_ || pointer_->shift == down) return;
    Pointer p = *pointer_;
    p.shift = down;
    hover(p);
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
    if (!gesture_) {
        if (!tool().take_back()) return false;
        event("click taken back");
        redraw();
        return true;
    }
    const std::unique_ptr<Tool> carried = std::move(carried_);
    const std::unique_ptr<Gesture> gesture = std::move(gesture_);
    if (clicking_) event("click cancelled");
    clicking_ = false;
    box_next_ = box_next_ && !boxing_;
    boxing_ = false;
    gesture->cancel();
    pressed_.reset();
    redraw();
    return true;
}

void View::session_changed()
{
    if (!session_.is_working()) settling_ = {};
    if (clicking_ && !tool().holds_through_edits() && pressed_shape_ != session_.display().lists.shape_version()) cancel(); // its faces may be others now
    if (session_.chosen() != armed_operator_) {
        cancel();
        armed_operator_ = session_.chosen();
        armed_ = tool_for(armed_operator_, session_, camera_, settings_);
    }
    smooth_.follow();
    crust_.follow();
    // What was hovered may be gone; what is framed stays framed until a file, or the first shape, comes.
    hovered_.reset();
    redraw();
}

} // namespace druse::ui
