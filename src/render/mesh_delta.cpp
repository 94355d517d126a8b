#include "render/mesh_delta.h"

#include "geom/sort_unique.h"

#include <algorithm>

namespace druse {

namespace {

/// Calls `differs(i)` for each index below `limit` whose value now, `value(i)`, is not the one in `change`.
template <class T, class Value, class Differs>
void compare(const ColumnChange<T>& change, std::uint32_t limit, Value&& value, Differs&& differs)
{
    std::size_t at = 0;
    for (const std::uint32_t page : change.pages) {
        const std::uint32_t first = page << Column<T>::page_bits;
        const std::uint32_t count = std::min(Column<T>::page_size, change.common - first);
        for (std::uint32_t i = first; i < first + count; ++i, ++at)
            if (!(change.contents[at] == value(i))) differs(i);
    }
    for (std::uint32_t i = change.common; i < limit; ++i) differs(i);
}

} // namespace

MeshDelta difference(const Mesh& now, const MeshChange& other)
{
    MeshDelta delta;
    if (other.corner_vertex.whole || other.corner_next.whole || other.corner_face.whole || other.edge_corners.whole ||
        other.face_corner.whole || other.vertex_position.whole || other.face_group.whole) {
        delta.whole = true;
        return delta;
    }

    // A face whose cycle changed has another start corner, is gone, or still has a corner with another vertex, follower or face.
    const auto corner_changed = [&](std::uint32_t i) {
        const Corner c(i);
        if (!now.is_alive(c)) return;
        for (const Corner d : {c, now.previous(c)}) {
            if (!now.face(d).is_boundary()) delta.faces.push_back(now.face(d));
            if (now.edge(d).valid()) delta.edges.push_back(now.edge(d));
        }
    };
    const std::uint32_t corners = now.corner_limit();
    compare(
        other.corner_vertex, corners, [&](std::uint32_t i) { return now.vertex(Corner(i)); }, corner_changed);
    compare(
        other.corner_next, corners, [&](std::uint32_t i) { return now.next(Corner(i)); }, corner_changed);
    compare(
        other.corner_face, corners, [&](std::uint32_t i) { return now.face(Corner(i)); }, corner_changed);

    compare(
        other.edge_corners, now.edge_limit(),
        [&](std::uint32_t i) {
            return std::array<Corner, 2>{now.corner(Edge(i), 0), now.corner(Edge(i), 1)};
        },
        [&](std::uint32_t i) { delta.edges.push_back(Edge(i)); });
    compare(
        other.face_corner, now.face_limit(), [&](std::uint32_t i) { return now.corner(Face(i)); },
        [&](std::uint32_t i) { delta.faces.push_back(Face(i)); });
    compare(
        other.face_group, now.face_limit(), [&](std::uint32_t i) { return now.group(Face(i)); },
        [&](std::uint32_t i) { delta.regrouped.push_back(Face(i)); });
    compare(
        other.vertex_position, now.vertex_limit(), [&](std::uint32_t i) { return now.position(Vertex(i)); },
        [&](std::uint32_t i) { delta.vertices.push_back(Vertex(i)); });

    sort_unique(delta.faces);
    sort_unique(delta.edges);
    return delta;
}

} // namespace druse
