#pragma once

#include "ui/face_tool.h"

namespace druse::ui {

/// The armed operator on a face of a rind, of whichever surface, and thereby on the one that belongs to it: both are outlined.
/// Of other faces it only says that they are none.
class RindTool : public FaceTool {
public:
    using FaceTool::FaceTool;
    std::optional<Target> under(const Pointer& pointer) const override;
    void act(const Target& target, const Pointer& pointer) override;
    std::string hint() const override;
};

} // namespace druse::ui
