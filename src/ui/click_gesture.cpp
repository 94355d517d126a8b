#include "ui/click_gesture.h"

#include <utility>

namespace druse::ui {

ClickGesture::ClickGesture(Tool& tool, const Pointer& start, std::function<void(const std::optional<Target>&)> show)
    : tool_(tool), show_(std::move(show)), twice_(start.twice)
{
    show_(tool_.under(start));
}

void ClickGesture::move(const Pointer& pointer)
{
    Pointer p = pointer;
    p.twice = twice_;
    show_(tool_.under(p));
}

void ClickGesture::release(const Pointer& pointer)
{
    Pointer p = pointer;
    p.twice = twice_;
    const std::optional<Target> target = tool_.under(p);
    show_({});
    if (target) tool_.act(*target, p);
}

} // namespace druse::ui
