#pragma once

#include "ui/gesture.h"
#include "ui/session.h"

#include "render/camera.h"
#include "render/draw_lists.h"
#include "render/picking.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace druse::ui {

/// What lies under the pointer, as a tool sees it: what is outlined, and what the command will name.
struct Target {
    std::vector<Face> faces; // to outline
    std::optional<Edge> edge;
    std::optional<Vertex> vertex;
    std::optional<Face> face; // the one under the pointer itself
    std::string name;         // of what is none of these, as the event log calls it
    friend bool operator==(const Target&, const Target&) = default;
};

/// What a person has set of tools, beside the parameters of operators.
struct ToolSettings {
    double brush = 0; // radius in pixels; 0: only what is under the pointer itself
};

/// Acts on what is clicked: an armed operator, or the selection. Press shows the target, release acts on it.
class Tool {
public:
    using ShowTarget = std::function<void(const std::optional<Target>&)>;

    Tool(Session& session, const Camera& camera) : session_(session), camera_(camera) {}
    virtual ~Tool() = default;
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    /// What a click here would act on; nothing if there is nothing.
    virtual std::optional<Target> under(const Pointer& pointer) const = 0;
    virtual void act(const Target& target, const Pointer& pointer) = 0;
    /// What a press of the left button begins. As a rule a click: `show` is told what is outlined as pressed until it ends.
    virtual std::unique_ptr<Gesture> press(const Pointer& start, const ShowTarget& show);
    /// Draws over the mesh, besides outlines, what acting on the target would do.
    virtual void preview(const Target&, Overlay&) const {}
    /// Draws over the mesh what belongs to the pointer itself.
    virtual void add_pointer(const Pointer&, Overlay&) const {}
    /// Draws over the mesh what clicks before this one have marked.
    virtual void add_marks(Overlay&) const {}
    /// A box was dragged, between two corners in pixels. @return false if it is not for this tool
    virtual bool take_box(const Point2& /*low*/, const Point2& /*high*/, const Pointer& /*end*/) { return false; }
    /// A click beside everything.
    virtual void act_on_nothing() {}
    /// Escape between two clicks: forgets the first one. @return false if there is none
    virtual bool take_back() { return false; }
    /// What the mouse does now, for the status bar.
    virtual std::string hint() const = 0;
    /// The same while the button is held.
    virtual std::string pressed_hint() const { return "release to act; beside the mesh or Escape cancels"; }
    /// Does what it has hold of stay what it is when the shape changes? Else a press ends then.
    virtual bool holds_through_edits() const { return false; }
    /// Does it only select? Then a drag that starts beside the mesh turns the camera, and so does one that starts on it with Alt.
    virtual bool only_selects() const { return false; }

protected:
    const DrawLists& lists() const { return session_.display().lists; }
    /// What is seen under the pointer; nothing outside the view.
    std::optional<FaceHit> hit(const Pointer& p) const;
    std::optional<Target> face_under(const Pointer& pointer) const;
    /// The face and everything that shares its group; only itself if it has none.
    std::vector<Face> group_of(Face f) const;

    Session& session_;
    const Camera& camera_;
};

/// Which kind of element clicks select.
enum class Element { face, edge, vertex };

/// The tool of an operator that acts on what is clicked, or null for one that acts on the whole model or the selection.
/// `settings` are read while it is in use.
std::unique_ptr<Tool> tool_for(const Operator* op, Session& session, const Camera& camera, const ToolSettings& settings);
/// True if tool_for() would make one.
bool acts_on_click(const Operator& op);

} // namespace druse::ui
