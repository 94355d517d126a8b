#include "ui/click_gesture.h"

#include <utility>

namespace druse::ui {

ClickGesture::ClickGesture(Tool& tool, const Pointer& start, Tool::ShowTarget show) : tool_(tool), show_(std::move(show)), twice_(start.twice)
{
    aim(start);
}

void ClickGesture::aim(const Pointer& pointer)
{
    target_ = tool_.under(pointer);
    show_(target_);
}

void ClickGesture::move(const Pointer& pointer)
{
    Pointer p = pointer;
    p.twice = twice_;
    aim(p);
}

void ClickGesture::release(const Pointer& pointer)
{
    Pointer p = pointer;
    p.twice = twice_;
    const std::optional<Target> target = tool_.under(p);
    show_({});
    if (target) tool_.act(*target, p);
}

void ClickGesture::add_to(Overlay& overlay) const
{
    if (target_) tool_.preview(*target_, overlay);
}

} // namespace druse::ui
