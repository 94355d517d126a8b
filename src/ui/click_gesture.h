#pragma once

#include "ui/gesture.h"
#include "ui/tool.h"

#include <functional>

namespace druse::ui {

/// Press shows what a tool would act on, the pointer may hunt for another target, release acts. Released beside the mesh, or
/// cancelled, nothing is done.
class ClickGesture : public Gesture {
public:
    /// `show` is told what is outlined as pressed.
    ClickGesture(Tool& tool, const Pointer& start, std::function<void(const std::optional<Target>&)> show);
    void move(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override { show_({}); }

private:
    Tool& tool_;
    std::function<void(const std::optional<Target>&)> show_;
    bool twice_;
};

} // namespace druse::ui
