#include "render/gpu_mesh.h"

#include "render/shaders.h"

#include <algorithm>
#include <cstddef>

namespace druse {

namespace {

using TwoCorners = std::array<float, 6>;
using Line = std::array<std::uint32_t, 2>;

const void* at(std::size_t offset)
{
    return reinterpret_cast<const void*>(offset);
}

} // namespace

GpuMesh::GpuMesh(const GlApi& gl) : gl_(gl)
{
    gl_.GenVertexArrays(1, &face_array_);
    gl_.GenVertexArrays(1, &line_array_);
    for (Buffer* buffer : {&vertices_, &sides_, &smooth_, &triangles_, &edges_}) gl_.GenBuffers(1, &buffer->id);

    // A buffer keeps its name when it gets new storage, so the arrays are set up once.
    constexpr std::size_t stride = sizeof(DrawVertex);
    for (const GLuint array : {face_array_, line_array_}) attribute(array, vertices_, at_position, 3, GL_FLOAT, false, stride, 0);
    attribute(face_array_, vertices_, at_normal, 4, GL_INT_2_10_10_10_REV, false, stride, offsetof(DrawVertex, normal));
    attribute(face_array_, vertices_, at_colour, 4, GL_UNSIGNED_BYTE, false, stride, offsetof(DrawVertex, look));
    attribute(face_array_, vertices_, at_flags, 1, GL_UNSIGNED_BYTE, true, stride, offsetof(DrawVertex, look) + 3);
    attribute(face_array_, sides_, at_second, 3, GL_FLOAT, false, sizeof(TwoCorners), 0);
    attribute(face_array_, sides_, at_third, 3, GL_FLOAT, false, sizeof(TwoCorners), 3 * sizeof(float));
    attribute(face_array_, smooth_, at_smooth, 4, GL_INT_2_10_10_10_REV, false, sizeof(std::uint32_t), 0);
    gl_.BindVertexArray(face_array_);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_.id);
    gl_.BindVertexArray(line_array_);
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, edges_.id);
    gl_.BindVertexArray(0);
}

GpuMesh::~GpuMesh()
{
    for (const GLuint array : {face_array_, line_array_}) gl_.DeleteVertexArrays(1, &array);
    for (const Buffer* buffer : {&vertices_, &sides_, &smooth_, &triangles_, &edges_}) gl_.DeleteBuffers(1, &buffer->id);
}

void GpuMesh::attribute(GLuint array, const Buffer& buffer, GLuint where, GLint size, GLenum type, bool integer,
                        std::size_t stride, std::size_t offset) const
{
    gl_.BindVertexArray(array);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer.id);
    const GLboolean normalized = type != GL_FLOAT;
    if (integer)
        gl_.VertexAttribIPointer(where, size, type, static_cast<GLsizei>(stride), at(offset));
    else
        gl_.VertexAttribPointer(where, size, type, normalized, static_cast<GLsizei>(stride), at(offset));
    // The streams beside the vertices are bound where they are filled: see follow().
    if (&buffer == &vertices_) gl_.EnableVertexAttribArray(where);
}

/// Copies what is newer than the buffer, a run of changed blocks at a time. `values(first, count)` points at elements.
template <class T, class Values>
void GpuMesh::copy(GLenum target, Buffer& buffer, std::size_t size, std::span<const std::uint64_t> versions,
                   const DrawLists& lists, Values&& values)
{
    if (buffer.list == lists.id() && buffer.version == lists.version()) return;
    gl_.BindBuffer(target, buffer.id);
    const bool anew = buffer.list != lists.id() || size > buffer.capacity;
    if (anew && size > 0) {
        buffer.capacity = size + size / 8 + 1024;
        gl_.BufferData(target, static_cast<GLsizeiptr>(buffer.capacity * sizeof(T)), nullptr, GL_DYNAMIC_DRAW);
        gl_.BufferSubData(target, 0, static_cast<GLsizeiptr>(size * sizeof(T)), values(0, size));
    } else {
        const auto changed = [&](std::size_t block) { return block < versions.size() && versions[block] > buffer.version; };
        const std::size_t blocks = (size + (std::size_t(1) << DrawLists::block_bits) - 1) >> DrawLists::block_bits;
        for (std::size_t block = 0; block < blocks; ++block) {
            if (!changed(block)) continue;
            const std::size_t first = block << DrawLists::block_bits;
            while (block < blocks && changed(block)) ++block;
            const std::size_t count = std::min(block << DrawLists::block_bits, size) - first;
            gl_.BufferSubData(target, static_cast<GLintptr>(first * sizeof(T)), static_cast<GLsizeiptr>(count * sizeof(T)),
                              values(first, count));
        }
    }
    buffer.size = size;
    buffer.list = lists.id();
    buffer.version = lists.version();
}

void GpuMesh::follow(const DrawLists& lists, bool sides, bool smooth)
{
    gl_.BindVertexArray(face_array_);
    if (sides) copy_sides(lists);
    if (smooth && smooth_.version != lists.shape_version()) {
        const std::vector<std::uint32_t>& normals = lists.smooth_normals();
        smooth_.list = 0;
        copy<std::uint32_t>(GL_ARRAY_BUFFER, smooth_, normals.size(), {}, lists,
                            [&](std::size_t first, std::size_t) { return normals.data() + first; });
        smooth_.version = lists.shape_version();
    }
    copy<DrawVertex>(GL_ARRAY_BUFFER, vertices_, lists.draw_vertices().size(), lists.vertex_versions(), lists,
                     [&](std::size_t first, std::size_t) { return lists.draw_vertices().data() + first; });
    copy<DrawLists::Triangle>(GL_ELEMENT_ARRAY_BUFFER, triangles_, lists.triangles().size(), lists.triangle_versions(), lists,
                              [&](std::size_t first, std::size_t) { return lists.triangles().data() + first; });
    const auto use = [&](GLuint where, bool on) {
        if (on)
            gl_.EnableVertexAttribArray(where);
        else
            gl_.DisableVertexAttribArray(where);
    };
    use(at_second, sides);
    use(at_third, sides);
    use(at_smooth, smooth);

    gl_.BindVertexArray(line_array_);
    std::vector<Line> lines;
    copy<Line>(
        GL_ELEMENT_ARRAY_BUFFER, edges_, lists.edges().size(), lists.edge_versions(), lists,
        [&](std::size_t first, std::size_t count) {
            lines.clear();
            for (const auto& [a, b] : lists.edges().subspan(first, count))
                lines.push_back(a == DrawLists::none ? Line{0, 0} : Line{lists.draw_vertex_of(a), lists.draw_vertex_of(b)});
            return lines.data();
        });
}

/// For each draw vertex in which a triangle ends, where the two other corners are.
void GpuMesh::copy_sides(const DrawLists& lists)
{
    const std::span<const DrawVertex> vertices = lists.draw_vertices();
    const auto others = [&](const DrawLists::Triangle& t) {
        const DrawVertex &a = vertices[t[0]], &b = vertices[t[1]];
        return TwoCorners{a.x, a.y, a.z, b.x, b.y, b.z};
    };
    const auto changed = [&](std::uint64_t version) { return version > sides_.version; };
    const bool much = 4 * std::ranges::count_if(lists.triangle_versions(), changed) > std::ssize(lists.triangle_versions()); // one by one they would take longer
    if (sides_.list != lists.id() || vertices.size() > sides_.capacity || much) {
        std::vector<TwoCorners> all(vertices.size());
        for (const DrawLists::Triangle& t : lists.triangles())
            if (t[0] != t[2]) all[t[2]] = others(t);
        sides_.list = 0;
        copy<TwoCorners>(GL_ARRAY_BUFFER, sides_, all.size(), {}, lists,
                         [&](std::size_t first, std::size_t) { return all.data() + first; });
        return;
    }
    if (sides_.version == lists.version()) return;
    gl_.BindBuffer(GL_ARRAY_BUFFER, sides_.id);
    for (std::size_t block = 0; block < lists.triangle_versions().size(); ++block) {
        if (lists.triangle_versions()[block] <= sides_.version) continue;
        const std::size_t end = std::min((block + 1) << DrawLists::block_bits, lists.triangles().size());
        for (std::size_t i = block << DrawLists::block_bits; i < end; ++i) {
            const DrawLists::Triangle& t = lists.triangles()[i];
            if (t[0] == t[2]) continue;
            const TwoCorners corners = others(t);
            gl_.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(t[2] * sizeof corners), sizeof corners, corners.data());
        }
    }
    sides_.version = lists.version();
}

void GpuMesh::draw_triangles() const
{
    gl_.BindVertexArray(face_array_);
    gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles_.size * 3), GL_UNSIGNED_INT, nullptr);
}

void GpuMesh::draw_edges() const
{
    gl_.BindVertexArray(line_array_);
    gl_.DrawElements(GL_LINES, static_cast<GLsizei>(edges_.size * 2), GL_UNSIGNED_INT, nullptr);
}

void GpuMesh::draw_faces(const DrawLists& lists, const std::vector<Face>& faces) const
{
    gl_.BindVertexArray(face_array_);
    DrawLists::Range run;
    const auto draw_run = [&] {
        if (run.count == 0) return;
        gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(run.count * 3), GL_UNSIGNED_INT, at(run.first * sizeof(DrawLists::Triangle)));
    };
    for (const Face f : faces) {
        const DrawLists::Range range = lists.triangles(f);
        if (run.count > 0 && range.first == run.first + run.count) {
            run.count += range.count;
            continue;
        }
        draw_run();
        run = range;
    }
    draw_run();
}

} // namespace druse
