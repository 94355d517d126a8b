#include "ui/camera_gestures.h"

#include <cmath>

namespace druse::ui {

void ZoomGesture::move(const Pointer& p)
{
    camera_.zoom(std::exp((last_.y - p.y) / 150), start_.x, start_.y);
    last_ = p;
}

} // namespace druse::ui
