#include "dlfl/mesh_tables.h"

#include "dlfl/errors.h"

#include <algorithm>

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
    position = room(mesh_.vertex_position_, vertices);
    vertex_corner = room(mesh_.vertex_corner_, vertices);
}

Mesh MeshTables::take() { return std::move(mesh_); }

MeshTables::View MeshTables::view(const Mesh& mesh)
{
    return {mesh.corner_vertex_.view(), mesh.corner_next_.view(),  mesh.corner_previous_.view(), mesh.corner_face_.view(),
            mesh.corner_edge_.view(),   mesh.edge_corners_.view(), mesh.face_corner_.view()};
}

} // namespace druse
