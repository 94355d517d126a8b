#pragma once

#include "ui/gesture.h"
#include "ui/tool.h"

#include <optional>

namespace druse::ui {

/// Press shows what a tool would act on, the pointer may hunt for another target, release acts. Released beside the mesh, or
/// cancelled, nothing is done.
class ClickGesture : public Gesture {
public:
    /// `show` is told what is outlined as pressed.
    ClickGesture(Tool& tool, const Pointer& start, Tool::ShowTarget show);
    void move(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override { show_({}); }
    void add_to(Overlay& overlay) const override;

private:
    Tool& tool_;
    Tool::ShowTarget show_;
    std::optional<Target> target_; // under the pointer
    bool twice_;

    void aim(const Pointer& pointer);
};

} // namespace druse::ui
