#pragma once

#include "ui/pointer.h"

#include "render/renderer.h"

namespace druse::ui {

/// What goes on between a press of a mouse button and its release: one small class for each kind.
class Gesture {
public:
    virtual ~Gesture() = default;
    virtual void move(const Pointer& pointer) = 0;
    virtual void release(const Pointer& pointer) = 0;
    /// Escape, or a second button: nothing is done.
    virtual void cancel() {}
    /// Draws over the mesh what shows how far it has come.
    virtual void add_to(Overlay&) const {}
};

} // namespace druse::ui
