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

    /// `to_clip` takes places relative to `origin`; width and height are those of the viewport. With `hidden_by_depth`, what lies
    /// behind the faces drawn so far is not seen.
    void draw(const std::vector<ThickLine>& lines, const Point& origin, const glm::mat4& to_clip, int width, int height,
              bool hidden_by_depth);

private:
    const GlApi& gl_;
    std::optional<Program> program_;
    GLuint array_ = 0, buffer_ = 0;
};

} // namespace druse
