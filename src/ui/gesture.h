#pragma once

#include "ui/pointer.h"

namespace druse::ui {

/// What goes on between a press of a mouse button and its release: one small class for each kind.
class Gesture {
public:
    virtual ~Gesture() = default;
    virtual void move(const Pointer& pointer) = 0;
    virtual void release(const Pointer& pointer) = 0;
    /// Escape, or a second button: nothing is done.
    virtual void cancel() {}
};

} // namespace druse::ui
