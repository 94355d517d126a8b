#pragma once

#include "ui/gesture.h"

#include "render/camera.h"

namespace druse::ui {

/// Turns the camera about its target: a drag across the picture is about half a turn. `free`: about axes of the picture, as a ball is rolled;
/// else z stays upright in it, if it is.
class OrbitGesture : public Gesture {
public:
    OrbitGesture(Camera& camera, const Pointer& start, bool free) : camera_(camera), last_(start), free_(free) {}
    void move(const Pointer& p) override
    {
        constexpr double degrees_per_pixel = 0.35;
        const double across = degrees_per_pixel * (p.x - last_.x), down = degrees_per_pixel * (p.y - last_.y);
        last_ = p;
        if (free_ || camera_.angles().roll != 0) {
            camera_.turn(camera_.up(), -across);
            camera_.turn(camera_.right(), -down);
        } else {
            camera_.orbit(-across, down);
        }
    }
    void release(const Pointer&) override {}

private:
    Camera& camera_;
    Pointer last_;
    bool free_;
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
