#pragma once

#include "ui/gesture.h"

#include "render/camera.h"

namespace druse::ui {

/// Turns the camera about its target: a drag across the picture is about half a turn.
class OrbitGesture : public Gesture {
public:
    OrbitGesture(Camera& camera, const Pointer& start) : camera_(camera), last_(start) {}
    void move(const Pointer& p) override
    {
        constexpr double degrees_per_pixel = 0.35;
        camera_.orbit(-degrees_per_pixel * (p.x - last_.x), degrees_per_pixel * (p.y - last_.y));
        last_ = p;
    }
    void release(const Pointer&) override {}

private:
    Camera& camera_;
    Pointer last_;
};

/// Moves the model with the pointer.
class PanGesture : public Gesture {
public:
    PanGesture(Camera& camera, const Pointer& start) : camera_(camera), last_(start) {}
    void move(const Pointer& p) override
    {
        camera_.pan(p.x - last_.x, p.y - last_.y);
        last_ = p;
    }
    void release(const Pointer&) override {}

private:
    Camera& camera_;
    Pointer last_;
};

/// Up goes nearer to what was pressed, down away from it.
class ZoomGesture : public Gesture {
public:
    ZoomGesture(Camera& camera, const Pointer& start) : camera_(camera), start_(start), last_(start) {}
    void move(const Pointer& p) override;
    void release(const Pointer&) override {}

private:
    Camera& camera_;
    Pointer start_, last_;
};

} // namespace druse::ui
