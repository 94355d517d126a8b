#pragma once

#include "render/camera.h"
#include "render/thick_line.h"

#include <optional>
#include <vector>

namespace druse::ui {

/// The cross of axes in the top right corner of the view: it shows how the model is turned, and a click on an end looks along it.
class Gizmo {
public:
    /// Its lines, back to front, in pixels of the picture; the end under the pointer is drawn larger.
    static std::vector<ThickLine> lines(const Camera& camera, std::optional<Point2> pointer);
    /// The view that a click at (x, y) asks for; nothing beside the ends.
    static std::optional<ViewAngles> view_at(const Camera& camera, double x, double y);
};

} // namespace druse::ui
