#include "ui/rind_tool.h"

#include <fmt/format.h>

namespace druse::ui {

std::optional<Target> RindTool::under(const Pointer& pointer) const
{
    auto target = FaceTool::under(pointer);
    const Mesh* mesh = session_.mesh();
    if (!target || !mesh) return target;
    if (const auto pair = session_.rind()->find(*mesh, *target->face)) target->faces = {mesh->face((*pair)[0]), mesh->face((*pair)[1])};
    return target;
}

void RindTool::act(const Target& target, const Pointer& pointer)
{
    const Mesh* mesh = session_.mesh();
    if (!mesh || session_.rind()->find(*mesh, *target.face)) {
        FaceTool::act(target, pointer);
        return;
    }
    session_.say(Message::Kind::note, fmt::format("face {} is not part of a rind", target.face->index));
    if (session_.on_change) session_.on_change();
}

std::string RindTool::hint() const
{
    const Rind* rind = session_.rind();
    if (rind && rind->empty()) return "there is no rind to open: Crust makes one";
    return "click a face of either surface: " + session_.chosen()->title();
}

} // namespace druse::ui
