#pragma once

#include "ui/tool.h"

namespace druse::ui {

/// The armed operator on the face that is clicked; with `grouped` on, the whole group of the face is outlined, since the operator
/// takes it too.
class FaceTool : public Tool {
public:
    using Tool::Tool;
    std::optional<Target> under(const Pointer& pointer) const override;
    void act(const Target& target, const Pointer& pointer) override;
    std::string hint() const override;

private:
    bool grouped() const;
};

} // namespace druse::ui
