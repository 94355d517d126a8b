#pragma once

#include "geom/point.h"

namespace druse::ui {

/// What part of a plane a picture shows: y upward in the plane, downward in the picture, in pixels from its top left corner.
struct PlaneView {
    int width = 1, height = 1;
    Point2 centre{0.0};    // seen in the middle
    double pixels = 20;    // per unit

    Point2 picture(const Point2& p) const { return {0.5 * width + (p.x - centre.x) * pixels, 0.5 * height - (p.y - centre.y) * pixels}; }
    Point2 plane(const Point2& q) const { return {centre.x + (q.x - 0.5 * width) / pixels, centre.y - (q.y - 0.5 * height) / pixels}; }

    /// Moves what is shown by so many pixels.
    void pan(const Point2& by) { centre += Point2(-by.x, by.y) / pixels; }
    /// Shows everything `factor` times as large; what is at `q` stays there.
    void zoom(double factor, const Point2& q)
    {
        constexpr double least = 1e-6, most = 1e9;
        const double before = pixels;
        pixels = glm::clamp(pixels * factor, least, most);
        const Point2 off = q - Point2(0.5 * width, 0.5 * height);
        centre += Point2(off.x, -off.y) * (1 / before - 1 / pixels);
    }
    /// Shows all of a box, and as much around it as `margin` times its size on each side.
    void fit(const Point2& low, const Point2& high, double margin)
    {
        const Point2 size = glm::max(high - low, Point2(1e-9)) * (1 + 2 * margin);
        centre = 0.5 * (low + high);
        pixels = std::fmin(width / size.x, height / size.y);
    }
};

} // namespace druse::ui
