#pragma once

#include "ui/crust_guide.h"
#include "ui/gesture.h"
#include "ui/smooth_preview.h"
#include "ui/tool.h"

#include "render/camera.h"
#include "render/renderer.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace druse::ui {

/// The 3D view without its window: camera, style, what is outlined, and what the mouse does.
///
/// With an operator armed that acts on clicks, the left button is its, except beside the mesh, where it turns the camera. Without
/// one it selects.
class View {
public:
    explicit View(Session& session);

    std::function<void()> on_redraw;
    std::function<void(const std::string&)> on_event; // one line for the event log
    std::function<void(const Pointer&)> on_menu;      // a right click
    std::function<void()> on_camera;                  // it was turned, moved or zoomed, but not by set_camera()

    const Camera& camera() const { return camera_; }
    void resize(int width, int height);
    void set_style(const Style& style);
    const Style& style() const { return style_; }
    /// What is drawn: the mesh, or the smooth surface in its place. Clicks act on the mesh in either case. Or what `stand_in` has, if that is set.
    const DrawLists& shown() const
    {
        if (const DrawLists* lists = stand_in ? stand_in() : nullptr) return *lists;
        return smooth_.lists() ? *smooth_.lists() : session_.display().lists;
    }
    /// Something of the document that is no mesh, drawn in place of it; null: the mesh after all.
    std::function<const DrawLists*()> stand_in;
    /// Clicks are this tool's, in place of the selection.
    void use_tool(std::unique_ptr<Tool> tool);
    /// What is drawn over it now.
    Overlay overlay() const;
    SmoothPreview& smooth() { return smooth_; }
    const SmoothPreview& smooth() const { return smooth_; }
    CrustGuide& crust() { return crust_; }
    std::string hint() const;
    bool is_gesturing() const { return gesture_ != nullptr; }
    /// True while the camera is turned, moved or zoomed by a drag.
    bool is_moving_camera() const { return gesture_ != nullptr && !clicking_ && !boxing_; }

    Element element() const { return element_; }
    void set_element(Element element);
    /// The next drag with the left button selects what is in a box.
    void start_box_select();
    bool is_box_next() const { return box_next_ && !boxing_; }
    void forget_box() { box_next_ = boxing_; }
    /// The radius of brushes in pixels; 0 touches only the face under the pointer.
    double brush() const { return settings_.brush; }
    void set_brush(double radius);
    static constexpr double largest_brush = 128;

    // --- the camera -----------------------------------------------------------------------------------------------------

    void frame_all();
    void frame_selection();
    void look(ViewAngles angles, double seconds = 0.2);
    /// From where that direction (of length 1) points, by the smallest turn in space, which may leave z aslant.
    void look_from(const Vector& toward_eye, double seconds);
    /// Drags turn about axes of the picture; else z is upright, and comes upright again.
    void set_free_orbit(bool on);
    bool is_free_orbit() const { return free_orbit_; }
    /// Takes all but the size of the picture from another camera, at once.
    void set_camera(const Camera& camera);
    void frame(std::span<const Point> points);
    void set_parallel(bool on);
    void zoom(double factor); // about the middle
    /// Views snap at once instead of turning there.
    void set_animated(bool on) { animated_ = on; }
    /// Goes on with a turn of the camera; `now` in seconds. @return true while it has not arrived
    bool animate(double now);
    bool is_animating() const { return turn_.has_value(); }

    // --- the mouse ------------------------------------------------------------------------------------------------------

    void press(const Pointer& pointer);
    void drag(const Pointer& pointer);
    void release(const Pointer& pointer);
    void hover(const Pointer& pointer);
    void leave();
    /// The Shift key went down or up, with the pointer where it is.
    void hold_shift(bool down);
    void wheel(double notches, const Pointer& pointer);
    /// Something is carried over the view with the button held since a press elsewhere: `tool` acts where drag() and release() end.
    void carry(std::unique_ptr<Tool> tool, const Pointer& pointer);
    /// For tools that are carried.
    template <class T, class... Args>
    std::unique_ptr<Tool> make_tool(Args&&... args) { return std::make_unique<T>(session_, camera_, std::forward<Args>(args)...); }
    /// Escape: cancels what the pressed button would do, or forgets the first of two clicks. @return false if there was nothing to cancel
    bool cancel();

    /// The session's display or operator changed.
    void session_changed();

private:
    struct Turn {
        Camera from;
        ViewAngles to;
        Vector axis{0.0}; // of the one turn that leads there, and its angle; no axis: azimuth and elevation go by themselves
        double degrees = 0;
        double seconds = 0;
        double start = -1; // seconds; negative: at the next animate()
    };

    Tool& tool() const { return carried_ ? *carried_ : armed_ ? *armed_ : *select_; }
    void start_turn(const Turn& turn);
    std::unique_ptr<Gesture> gesture_for(const Pointer& pointer);
    void show_hovered(const std::optional<Target>& target);
    void show_pressed(const std::optional<Target>& target);
    Tool::ShowTarget press_shower();
    void show_on_smooth(Overlay& overlay) const;
    void redraw();
    void event(const std::string& line);

    Session& session_;
    Camera camera_, told_; // told_: as on_camera knows it
    Style style_;
    SmoothPreview smooth_;
    CrustGuide crust_;
    Element element_ = Element::face;
    ToolSettings settings_;

    std::unique_ptr<Tool> select_, armed_, carried_; // select_: or what use_tool() gave
    bool has_own_tool_ = false;
    const Operator* armed_operator_ = nullptr;
    std::unique_ptr<Gesture> gesture_;
    Pointer pressed_at_;
    bool clicking_ = false;           // the gesture is a tool's
    bool box_next_ = false;
    bool boxing_ = false;             // the gesture is that
    bool moved_ = false;              // the pointer left the place where it was pressed

    std::optional<Target> hovered_, pressed_;
    Overlay settling_; // what a gesture showed, while its command runs
    std::uint64_t pressed_shape_ = 0; // of the session's lists when the gesture began
    std::optional<Pointer> pointer_;
    std::uint64_t framed_ = 0;        // the lists' id when the camera last framed them

    bool animated_ = true, free_orbit_ = false;
    std::optional<Turn> turn_;
};

} // namespace druse::ui
