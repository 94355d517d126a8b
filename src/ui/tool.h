#pragma once

#include "ui/pointer.h"
#include "ui/session.h"

#include "render/camera.h"
#include "render/draw_lists.h"
#include "render/picking.h"

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
    friend bool operator==(const Target&, const Target&) = default;
};

/// Acts on what is clicked: an armed operator, or the selection. Press shows the target, release acts on it.
class Tool {
public:
    Tool(Session& session, const Camera& camera) : session_(session), camera_(camera) {}
    virtual ~Tool() = default;
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    /// What a click here would act on; nothing if there is nothing.
    virtual std::optional<Target> under(const Pointer& pointer) const = 0;
    virtual void act(const Target& target, const Pointer& pointer) = 0;
    /// A click beside everything.
    virtual void act_on_nothing() {}
    /// What the mouse does now, for the status bar.
    virtual std::string hint() const = 0;
    /// Does it only select? Then a drag that starts beside the mesh turns the camera, and so does one that starts on it with Alt.
    virtual bool only_selects() const { return false; }

protected:
    const DrawLists& lists() const { return session_.display().lists; }
    std::optional<FaceHit> hit(const Pointer& p) const { return pick_face(lists(), camera_.ray(p.x, p.y)); }
    std::optional<Target> face_under(const Pointer& pointer) const;
    /// The face and everything that shares its group; only itself if it has none.
    std::vector<Face> group_of(Face f) const;

    Session& session_;
    const Camera& camera_;
};

/// Which kind of element clicks select.
enum class Element { face, edge, vertex };

/// The tool of an operator that acts on what is clicked, or null for one that acts on the whole model or the selection.
std::unique_ptr<Tool> tool_for(const Operator* op, Session& session, const Camera& camera);
/// True if tool_for() would make one.
bool acts_on_click(const Operator& op);

} // namespace druse::ui
