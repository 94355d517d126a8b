#include "render/thick_line_painter.h"

#include <glm/gtc/type_ptr.hpp>

#include <cstddef>

namespace druse {

namespace {

struct Instance {
    float from[3], to[3];
    std::uint8_t colour[4];
    float width;
};

} // namespace

ThickLinePainter::~ThickLinePainter()
{
    if (array_ == 0) return;
    gl_.DeleteVertexArrays(1, &array_);
    gl_.DeleteBuffers(1, &buffer_);
}

void ThickLinePainter::draw(const std::vector<ThickLine>& lines, const Point& origin, const glm::mat4& to_clip, int width,
                            int height, std::optional<double> depth_shift)
{
    if (lines.empty()) return;
    if (!program_) {
        program_.emplace(gl_, "", thick_vertex_source, thick_fragment_source);
        gl_.GenVertexArrays(1, &array_);
        gl_.GenBuffers(1, &buffer_);
        gl_.BindVertexArray(array_);
        gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
        const auto attribute = [&](GLuint at, GLint size, GLenum type, GLboolean normalized, std::size_t offset) {
            gl_.VertexAttribPointer(at, size, type, normalized, sizeof(Instance), reinterpret_cast<const void*>(offset));
            gl_.EnableVertexAttribArray(at);
            gl_.VertexAttribDivisor(at, 1);
        };
        attribute(0, 3, GL_FLOAT, GL_FALSE, offsetof(Instance, from));
        attribute(1, 3, GL_FLOAT, GL_FALSE, offsetof(Instance, to));
        attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(Instance, colour));
        attribute(3, 1, GL_FLOAT, GL_FALSE, offsetof(Instance, width));
    }
    std::vector<Instance> instances;
    instances.reserve(lines.size());
    for (const ThickLine& line : lines) {
        const Vector a = line.from - origin, b = line.to - origin;
        const Colour c = line.colour;
        instances.push_back({{float(a.x), float(a.y), float(a.z)},
                             {float(b.x), float(b.y), float(b.z)},
                             {c.red, c.green, c.blue, static_cast<std::uint8_t>(line.opacity * 255.0 + 0.5)},
                             float(line.width)});
    }
    gl_.BindVertexArray(array_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)), instances.data(),
                   GL_STREAM_DRAW);

    program_->use();
    gl_.UniformMatrix4fv(program_->uniform("to_clip"), 1, GL_FALSE, glm::value_ptr(to_clip));
    gl_.Uniform2f(program_->uniform("half_size"), 0.5f * float(width), 0.5f * float(height));
    gl_.Uniform1f(program_->uniform("nearer"), float(depth_shift.value_or(0.0)));
    if (!depth_shift) gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_CULL_FACE);
    gl_.DepthMask(GL_FALSE);
    gl_.Enable(GL_BLEND);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
    gl_.Disable(GL_BLEND);
    gl_.DepthMask(GL_TRUE);
    gl_.Enable(GL_DEPTH_TEST);
}

} // namespace druse
