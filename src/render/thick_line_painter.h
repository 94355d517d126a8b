#pragma once

#include "render/shaders.h"
#include "render/thick_line.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <vector>

namespace druse {

/// Draws lines of any width as rectangles in the picture. For highlights, not for all edges of a mesh.
class ThickLinePainter {
public:
    explicit ThickLinePainter(const GlApi& gl) : gl_(gl) {}
    ThickLinePainter(const ThickLinePainter&) = delete;
    ThickLinePainter& operator=(const ThickLinePainter&) = delete;
    ~ThickLinePainter();

    /// `to_clip` takes places relative to `origin`; width and height are those of the viewport. With a depth shift (see
    /// Camera::depth_shift), which should be that of the width of the lines, what lies behind the faces drawn so far is not seen:
    /// a line along an edge lies half behind the faces beside it, and brought nearer it is seen in full width.
    void draw(const std::vector<ThickLine>& lines, const Point& origin, const glm::mat4& to_clip, int width, int height,
              std::optional<double> depth_shift);

private:
    const GlApi& gl_;
    std::optional<Program> program_;
    GLuint array_ = 0, buffer_ = 0;
};

} // namespace druse
