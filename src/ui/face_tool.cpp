#include "ui/face_tool.h"

namespace druse::ui {

bool FaceTool::grouped() const
{
    const Operator* op = session_.chosen();
    return op && op->find("grouped") && session_.arguments().is_on("grouped");
}

std::optional<Target> FaceTool::under(const Pointer& pointer) const
{
    auto target = face_under(pointer);
    if (target && grouped()) target->faces = group_of(*target->face);
    return target;
}

void FaceTool::act(const Target& target, const Pointer&)
{
    session_.apply_chosen({{"faces", std::to_string(target.face->index)}});
}

std::string FaceTool::hint() const
{
    return "click a face: " + session_.chosen()->title() + (grouped() ? " on its group" : "");
}

} // namespace druse::ui
