#include "ui/tool.h"

#include "ui/click_gesture.h"
#include "ui/corner_tools.h"
#include "ui/element_tools.h"
#include "ui/face_pair_tool.h"
#include "ui/face_tool.h"
#include "ui/paint_tool.h"
#include "ui/pane_tool.h"
#include "ui/rind_tool.h"

namespace druse::ui {

namespace {

enum class Click { none, face, rind, paint, start_corner, corner_pair, face_pair, edge, vertex };

bool takes(const Operator& op, const char* parameter, Parameter::Type type)
{
    const Parameter* p = op.find(parameter);
    return p && p->type == type;
}

/// From its family and parameters, so that a new operator has its tool by being registered.
Click click_of(const Operator& op)
{
    using Type = Parameter::Type;
    if (op.kind != Operator::Kind::edit) return Click::none;
    const std::string family = op.family();
    if (takes(op, "c1", Type::corner) && takes(op, "c2", Type::corner)) return Click::corner_pair;
    if (family == "face" && takes(op, "vertex", Type::id)) return Click::start_corner;
    if (family == "topology" && takes(op, "from", Type::id) && takes(op, "to", Type::id)) return Click::face_pair;
    if (family == "extrude" && takes(op, "faces", Type::faces)) return Click::face;
    if (family == "rind" && takes(op, "faces", Type::faces)) return Click::rind;
    if (family == "group" && takes(op, "faces", Type::faces) && op.find("id")) return Click::paint;
    if (family == "topology" && takes(op, "edges", Type::edges)) return Click::edge;
    if (family == "topology" && takes(op, "vertices", Type::vertices)) return Click::vertex;
    return Click::none;
}

} // namespace

std::unique_ptr<Gesture> Tool::press(const Pointer& start, const ShowTarget& show) { return std::make_unique<ClickGesture>(*this, start, show); }

std::optional<FaceHit> Tool::hit(const Pointer& p) const
{
    if (p.x < 0 || p.y < 0 || p.x > camera_.width() || p.y > camera_.height()) return {};
    return pick_face(lists(), camera_.ray(p.x, p.y));
}

std::optional<Target> Tool::face_under(const Pointer& pointer) const
{
    const auto found = hit(pointer);
    if (!found) return {};
    Target target;
    target.faces = {found->face};
    target.face = found->face;
    return target;
}

std::vector<Face> Tool::group_of(Face f) const
{
    const int group = lists().group(f);
    if (group == 0) return {f};
    std::vector<Face> result;
    for (std::uint32_t i = 0; i < lists().face_limit(); ++i)
        if (lists().triangles(Face(i)).count > 0 && lists().group(Face(i)) == group) result.push_back(Face(i));
    return result;
}

std::unique_ptr<Tool> tool_for(const Operator* op, Session& session, const Camera& camera, const ToolSettings& settings)
{
    if (const auto act = op ? PaneTool::act_of(op->name) : std::nullopt) return std::make_unique<PaneTool>(*act, session, camera);
    switch (op ? click_of(*op) : Click::none) {
    case Click::face: return std::make_unique<FaceTool>(session, camera);
    case Click::rind: return std::make_unique<RindTool>(session, camera);
    case Click::paint: return std::make_unique<PaintTool>(session, camera, settings);
    case Click::start_corner: return std::make_unique<StartCornerTool>(session, camera);
    case Click::corner_pair: return std::make_unique<CornerPairTool>(session, camera);
    case Click::face_pair: return std::make_unique<FacePairTool>(session, camera);
    case Click::edge: return std::make_unique<EdgeTool>(session, camera);
    case Click::vertex: return std::make_unique<VertexTool>(session, camera);
    case Click::none: break;
    }
    return nullptr;
}

bool acts_on_click(const Operator& op) { return click_of(op) != Click::none || PaneTool::act_of(op.name).has_value(); }

} // namespace druse::ui
