#include "dlfl/mesh_tables.h"

#include "dlfl/errors.h"

#include <algorithm>
#include <utility>

namespace druse {

MeshTables::MeshTables(std::uint64_t vertices, std::uint64_t edges, std::uint64_t faces, std::uint64_t corners)
    : corners_(static_cast<std::uint32_t>(corners))
{
    if (std::max({vertices, edges, faces, corners}) >= Face::boundary_bit)
        throw CommandError("the result would have more than 2^31 elements of a kind");
    const auto room = [](auto& column, std::uint64_t count) {
        column.reserve(static_cast<std::uint32_t>(count));
        return column.extend(static_cast<std::uint32_t>(count));
    };
    vertex = room(mesh_.corner_vertex_, corners);
    next = room(mesh_.corner_next_, corners);
    previous = room(mesh_.corner_previous_, corners);
    face = room(mesh_.corner_face_, corners);
    edge = room(mesh_.corner_edge_, corners);
    edge_corners = room(mesh_.edge_corners_, edges);
    start = room(mesh_.face_corner_, faces);
    group = room(mesh_.face_group_, faces);
    mesh_.largest_group_.forget();
    position = room(mesh_.vertex_position_, vertices);
    vertex_corner = room(mesh_.vertex_corner_, vertices);
}

Mesh MeshTables::take() { return std::move(mesh_); }

MeshTables::View MeshTables::view(const Mesh& mesh)
{
    return {mesh.corner_vertex_.view(), mesh.corner_next_.view(),  mesh.corner_previous_.view(), mesh.corner_face_.view(),
            mesh.corner_edge_.view(),   mesh.edge_corners_.view(), mesh.face_corner_.view()};
}

void MeshTables::exchange_positions(Mesh& mesh, Column<Point>& positions)
{
    ASSERT(positions.size() == mesh.vertex_limit() && !mesh.is_recording(), "a position for each vertex, and no change being recorded");
    std::swap(mesh.vertex_position_, positions);
}

void MeshTables::append_reversed(Mesh& mesh)
{
    ASSERT(!mesh.has_holes() && mesh.boundary_count() == 0, "a closed mesh without holes");
    const std::uint32_t vertices = mesh.vertex_limit(), edges = mesh.edge_limit(), faces = mesh.face_limit(), corners = mesh.corner_limit();
    if (2 * std::uint64_t(std::max(vertices, corners)) > Face::boundary_bit - 1)
        throw CommandError("the result would have more than 2^31 elements of a kind");

    Vertex* const vertex = mesh.corner_vertex_.extend(corners);
    Corner* const next = mesh.corner_next_.extend(corners);
    Corner* const previous = mesh.corner_previous_.extend(corners);
    Face* const face = mesh.corner_face_.extend(corners);
    Edge* const edge = mesh.corner_edge_.extend(corners);
    std::array<Corner, 2>* const pair = mesh.edge_corners_.extend(edges);
    Corner* const start = mesh.face_corner_.extend(faces);
    std::int32_t* const group = mesh.face_group_.extend(faces);
    Point* const position = mesh.vertex_position_.extend(vertices);
    Corner* const vertex_corner = mesh.vertex_corner_.extend(vertices);

    for (std::uint32_t c = 0; c < corners; ++c) vertex[c] = Vertex(mesh.corner_vertex_[c].index + vertices);
    for (std::uint32_t c = 0; c < corners; ++c) next[c] = Corner(mesh.corner_previous_[c].index + corners);
    for (std::uint32_t c = 0; c < corners; ++c) previous[c] = Corner(mesh.corner_next_[c].index + corners);
    for (std::uint32_t c = 0; c < corners; ++c) face[c] = Face(mesh.corner_face_[c].index + faces);
    // The side that started at a corner now ends there, so it belongs to the corner after it.
    std::fill_n(edge, corners, Edge());
    std::uint32_t made = 0;
    for (std::uint32_t f = 0; f < faces; ++f) {
        const Corner first = mesh.face_corner_[f];
        start[f] = Corner(first.index + corners);
        Corner c = first;
        do {
            const Corner before = mesh.corner_previous_[c.index]; // where the copy goes on
            if (!edge[c.index].valid() && mesh.corner_edge_[before.index].valid()) {
                const Corner beyond = mesh.corner_next_[mesh.opposite(before).index];
                edge[c.index] = edge[beyond.index] = Edge(edges + made);
                pair[made++] = {Corner(c.index + corners), Corner(beyond.index + corners)};
            }
            c = before;
        } while (c != first);
    }
    std::copy_n(group - faces, faces, group);
    mesh.largest_group_.forget();
    std::copy_n(position - vertices, vertices, position);
    for (std::uint32_t v = 0; v < vertices; ++v) vertex_corner[v] = Corner(mesh.vertex_corner_[v].index + corners);
}

} // namespace druse
