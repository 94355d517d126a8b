#pragma once

#include "render/draw_lists.h"
#include "render/gl_api.h"

#include <cstdint>
#include <vector>

namespace druse {

/// Draw lists on the graphics card, kept in step with them by copying the blocks that changed.
class GpuMesh {
public:
    explicit GpuMesh(const GlApi& gl);
    GpuMesh(const GpuMesh&) = delete;
    GpuMesh& operator=(const GpuMesh&) = delete;
    ~GpuMesh();

    /// Brings everything up to date that the next draws need: `sides` (24 bytes a vertex) for edges drawn by the face shader,
    /// `smooth` (4 bytes a vertex) for smooth shading.
    void follow(const DrawLists& lists, bool sides, bool smooth);

    void draw_triangles() const;
    void draw_edges() const;
    /// Only the triangles of some faces. Precondition: `lists` are those followed last.
    void draw_faces(const DrawLists& lists, const std::vector<Face>& faces) const;

private:
    /// A buffer with room to spare, so that a local edit need not move it.
    struct Buffer {
        GLuint id = 0;
        std::size_t capacity = 0, size = 0; // in elements
        std::uint64_t version = 0;          // of the lists when last copied
        std::uint64_t list = 0;             // their id
    };

    template <class T, class Values>
    void copy(GLenum target, Buffer& buffer, std::size_t size, std::span<const std::uint64_t> versions, const DrawLists& lists,
              Values&& values);
    void copy_sides(const DrawLists& lists);
    void attribute(GLuint array, const Buffer& buffer, GLuint at, GLint size, GLenum type, bool integer, std::size_t stride,
                   std::size_t offset) const;

    const GlApi& gl_;
    GLuint face_array_ = 0, line_array_ = 0;
    Buffer vertices_, sides_, smooth_, triangles_, edges_;
};

} // namespace druse
