#include "dlfl/mesh_assembler.h"

#include "dlfl/check.h"
#include "dlfl/errors.h"

#include <fmt/format.h>

#include <utility>

namespace druse {

void MeshAssembler::add_corner(std::uint32_t vertex)
{
    if (vertex >= positions_.size())
        throw CommandError(fmt::format("corner names vertex {}, there are {}", vertex, positions_.size()));
    vertex_.push_back(Vertex(vertex));
    next_.push_back(Corner());
    previous_.push_back(Corner());
    face_.push_back(Face());
    edge_.push_back(Edge());
}

void MeshAssembler::add_edge(std::uint32_t c1, std::uint32_t c2)
{
    for (const std::uint32_t c : {c1, c2}) {
        if (c >= vertex_.size()) throw CommandError(fmt::format("edge names corner {}, there are {}", c, vertex_.size()));
        if (edge_[c].valid())
            throw CommandError(fmt::format("edge names corner {}, which is in edge {} already", c, edge_[c].index));
    }
    if (c1 == c2) throw CommandError(fmt::format("edge names corner {} twice", c1));
    edge_.set(c1, Edge(edges_.size()));
    edge_.set(c2, Edge(edges_.size()));
    edges_.push_back({Corner(c1), Corner(c2)});
}

void MeshAssembler::add_to_face(std::uint32_t corner)
{
    if (corner >= vertex_.size()) throw CommandError(fmt::format("face names corner {}, there are {}", corner, vertex_.size()));
    if (face_[corner].valid())
        throw CommandError(fmt::format("face names corner {}, which is in face {} already", corner, face_[corner].index));
    const Corner c(corner);
    if (last_.valid()) {
        next_.set(last_.index, c);
        previous_.set(corner, last_);
        face_.set(corner, face_[last_.index]);
    } else {
        face_.set(corner, Face(face_count()));
        start_.push_back(c);
        open_.push_back(false);
    }
    last_ = c;
}

void MeshAssembler::end_face()
{
    if (!last_.valid()) throw CommandError("a face without corners");
    next_.set(last_.index, start_.back());
    previous_.set(start_.back().index, last_);
    last_ = Corner();
}

void MeshAssembler::mark_open(std::uint32_t face)
{
    if (face >= face_count()) throw CommandError(fmt::format("open names face {}, there are {}", face, face_count()));
    open_[face] = true;
}

Mesh MeshAssembler::assemble(std::span<const std::int32_t> groups, Repairs& repairs)
{
    ASSERT(groups.size() == start_.size() && !last_.valid(), "a group for each face, and no face half done");
    check_sides();
    Mesh mesh;
    number_faces(mesh, groups);
    close_openings(mesh, repairs);
    number_edges(mesh);
    split_vertices(mesh, repairs);
    mesh.corner_vertex_ = std::move(vertex_);
    mesh.corner_next_ = std::move(next_);
    mesh.corner_previous_ = std::move(previous_);
    mesh.corner_face_ = std::move(face_);
    mesh.corner_edge_ = std::move(edge_);
    mesh.vertex_position_ = std::move(positions_);
    *this = MeshAssembler();
    if (const std::string broken = check(mesh); !broken.empty()) throw CommandError(broken);
    return mesh;
}

void MeshAssembler::check_sides() const
{
    for (std::uint32_t c = 0; c < vertex_.size(); ++c) {
        if (!face_[c].valid()) throw CommandError(fmt::format("corner {} is in no face", c));
        if (is_open(c) && !edge_[c].valid())
            throw CommandError(fmt::format("corner {} of the open face {} has no edge", c, face_[c].index));
    }
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        const auto [a, b] = edges_[e];
        if (vertex_[a.index] != vertex_[next_[b.index].index] || vertex_[b.index] != vertex_[next_[a.index].index])
            throw CommandError(fmt::format("the sides at corners {} and {} do not run against each other, as edge {} says",
                                           a.index, b.index, e));
        if (is_open(a.index) && is_open(b.index))
            throw CommandError(
                fmt::format("edge {} lies between the open faces {} and {}", e, face_[a.index].index, face_[b.index].index));
    }
}

/// Faces that stand for an open boundary are numbered apart.
void MeshAssembler::number_faces(Mesh& mesh, std::span<const std::int32_t> groups)
{
    std::vector<Face> numbers;
    for (std::uint32_t f = 0; f < face_count(); ++f) {
        if (open_[f]) {
            numbers.push_back(Face::boundary(mesh.boundary_corner_.size()));
            mesh.boundary_corner_.push_back(start_[f]);
        } else {
            numbers.push_back(Face(mesh.face_corner_.size()));
            mesh.face_corner_.push_back(start_[f]);
            mesh.face_group_.push_back(groups[f]);
            mesh.largest_group_.add(groups[f]);
        }
    }
    for (std::uint32_t c = 0; c < face_.size(); ++c) face_.set(c, numbers[face_[c].index]);
}

/// Gives each side without an edge one, with a corner of a boundary face at its other side.
void MeshAssembler::close_openings(Mesh& mesh, Repairs& repairs)
{
    const std::uint32_t corners = vertex_.size();
    for (std::uint32_t c = 0; c < corners; ++c) {
        if (edge_[c].valid() || next_[c].index == c) continue; // next_ of itself: a point sphere
        const Corner against(vertex_.size());
        vertex_.push_back(vertex_[next_[c].index]);
        next_.push_back(Corner());
        previous_.push_back(Corner());
        face_.push_back(Face());
        edge_.push_back(Edge(edges_.size()));
        edge_.set(c, Edge(edges_.size()));
        edges_.push_back({Corner(c), against});
        ++repairs.boundary_edges;
    }
    // The boundary goes on, from where an open side starts, along the next open side clockwise around that vertex.
    const auto opposite = [&](Corner c) {
        const auto& pair = edges_[edge_[c.index].index];
        return pair[0] == c ? pair[1] : pair[0];
    };
    for (std::uint32_t b = corners; b < vertex_.size(); ++b) {
        Corner in = previous_[opposite(Corner(b)).index];
        while (opposite(in).index < corners) in = previous_[opposite(in).index];
        next_.set(b, opposite(in));
        previous_.set(opposite(in).index, Corner(b));
    }
    for (std::uint32_t b = corners; b < vertex_.size(); ++b) {
        if (face_[b].valid()) continue;
        const Face made = Face::boundary(mesh.boundary_corner_.size());
        mesh.boundary_corner_.push_back(Corner(b));
        for (Corner c(b); !face_[c.index].valid(); c = next_[c.index]) face_.set(c.index, made);
        ++repairs.boundary_loops;
    }
}

void MeshAssembler::number_edges(Mesh& mesh)
{
    std::vector<Edge> numbers(edges_.size());
    for (const Corner start : mesh.face_corner_.view()) {
        Corner c = start;
        do {
            const Edge e = edge_[c.index];
            if (e.valid() && !numbers[e.index].valid()) {
                numbers[e.index] = Edge(mesh.edge_corners_.size());
                const auto [a, b] = edges_[e.index];
                mesh.edge_corners_.push_back({c, a == c ? b : a});
            }
            c = next_[c.index];
        } while (c != start);
    }
    for (std::uint32_t c = 0; c < edge_.size(); ++c)
        if (edge_[c].valid()) edge_.set(c, numbers[edge_[c].index]);
}

/// A vertex for each rotation: the first keeps the number, others get new ones after all.
void MeshAssembler::split_vertices(Mesh& mesh, Repairs& repairs)
{
    std::vector<std::uint32_t> number(positions_.size(), Vertex::none); // without the vertices left out
    const Column<Point> given = std::exchange(positions_, {});
    std::vector<bool> met(given.size(), false), counted(given.size(), false), done(vertex_.size(), false);
    for (const Vertex v : vertex_.view()) met[v.index] = true;
    for (std::uint32_t v = 0; v < given.size(); ++v) {
        if (!met[v]) continue;
        number[v] = positions_.size();
        positions_.push_back(given[v]);
        mesh.vertex_corner_.push_back(Corner());
    }
    repairs.loose_vertices = given.size() - positions_.size();

    for (const Corner start : mesh.face_corner_.view()) {
        Corner of_face = start;
        do {
            if (!done[of_face.index]) {
                const std::uint32_t v = vertex_[of_face.index].index;
                Vertex own(number[v]);
                if (mesh.vertex_corner_[own.index].valid()) {
                    if (!counted[v]) ++repairs.vertices_split;
                    counted[v] = true;
                    own = Vertex(positions_.size());
                    positions_.push_back(given[v]);
                    mesh.vertex_corner_.push_back(of_face);
                }
                mesh.vertex_corner_.set(own.index, of_face);
                Corner c = of_face;
                do {
                    done[c.index] = true;
                    vertex_.set(c.index, own);
                    if (!edge_[c.index].valid()) break;
                    const Corner in = previous_[c.index];
                    const auto& pair = mesh.edge_corners_[edge_[in.index].index];
                    c = pair[0] == in ? pair[1] : pair[0];
                } while (c != of_face);
            }
            of_face = next_[of_face.index];
        } while (of_face != start);
    }
}

} // namespace druse
