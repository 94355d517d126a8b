#include "dlfl/mesh_builder.h"

#include "dlfl/errors.h"

#include <fmt/format.h>

namespace druse {

std::vector<std::string> Repairs::notes() const
{
    std::vector<std::string> lines;
    const auto note = [&lines](std::uint32_t count, const char* one, const char* many) {
        if (count > 0) lines.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
    };
    note(loose_vertices, "vertex belongs to no face: left out", "vertices belong to no face: left out");
    note(edges_split, "edge had three or more faces: split into pairs", "edges had three or more faces: split into pairs");
    note(faces_turned, "face was wound against its neighbours: turned", "faces were wound against their neighbours: turned");
    note(vertices_split, "vertex joined surfaces in a point only: split", "vertices joined surfaces in a point only: split");
    if (boundary_edges > 0)
        lines.push_back(fmt::format("the surface is open: {} boundary edge{} in {} loop{}", boundary_edges, boundary_edges == 1 ? "" : "s",
                                    boundary_loops, boundary_loops == 1 ? "" : "s"));
    return lines;
}

void MeshBuilder::reserve(std::uint32_t vertices, std::uint32_t faces, std::uint32_t corners)
{
    positions_.reserve(vertices);
    corners_.reserve(corners);
    ends_.reserve(faces);
    groups_.reserve(faces);
}

Mesh MeshBuilder::build()
{
    Mesh mesh;
    ASSERT(pair_directly(mesh), "polygons that make a closed oriented 2-manifold");
    hand_over(mesh);
    return mesh;
}

Mesh MeshBuilder::build(Repairs& repairs)
{
    leave_out_loose_vertices(repairs);
    Mesh mesh;
    if (!pair_directly(mesh)) return mend(repairs);
    hand_over(mesh);
    return mesh;
}

void MeshBuilder::hand_over(Mesh& mesh)
{
    mesh.corner_vertex_ = std::move(corners_);
    mesh.vertex_position_ = std::move(positions_);
    mesh.face_group_ = std::move(groups_);
    ends_ = {};
}

bool MeshBuilder::pair_directly(Mesh& mesh)
{
    const std::uint32_t vertices = positions_.size(), faces = ends_.size(), corners = corners_.size();
    ASSERT(corners < Face::boundary_bit, "fewer than 2^31 corners");

    // A side is looked for among the edges kept at one of its ends, the one with fewer corners: then even the apex of a huge
    // pyramid costs nothing, and the whole search is linear on any mesh of bounded genus.
    std::vector<std::uint32_t> corner_count(vertices, 0);
    for (const Vertex v : corners_.view()) {
        ASSERT(v.index < vertices, "corners of vertices that exist");
        ++corner_count[v.index];
    }
    constexpr std::uint32_t none = Edge::none;
    struct Kept {
        std::uint32_t far, next; // the other end; the next edge kept at the same vertex
    };
    std::vector<std::uint32_t> first_kept(vertices, none);
    std::vector<Kept> kept;
    kept.reserve(corners / 2);

    Corner* const next = mesh.corner_next_.extend(corners);
    Corner* const previous = mesh.corner_previous_.extend(corners);
    Face* const face = mesh.corner_face_.extend(corners);
    Edge* const edge = mesh.corner_edge_.extend(corners);
    Corner* const start = mesh.face_corner_.extend(faces);
    Corner* const vertex_corner = mesh.vertex_corner_.extend(vertices);
    std::fill_n(vertex_corner, vertices, Corner());
    mesh.edge_corners_.reserve(corners / 2);
    const std::span<const Vertex> corner_vertex = corners_.view();

    std::uint32_t begin = 0, closed = 0;
    for (std::uint32_t f = 0; f < faces; ++f) {
        const std::uint32_t end = ends_[f];
        ASSERT(end > begin, "no face without corners");
        start[f] = Corner(begin);
        if (end == begin + 1) {
            next[begin] = previous[begin] = Corner(begin);
            face[begin] = Face(f);
            edge[begin] = Edge();
            vertex_corner[corner_vertex[begin].index] = Corner(begin);
            begin = end;
            continue;
        }
        for (std::uint32_t c = begin; c < end; ++c) {
            const std::uint32_t after = c + 1 < end ? c + 1 : begin;
            next[c] = Corner(after);
            previous[after] = Corner(c);
            face[c] = Face(f);
            const std::uint32_t a = corner_vertex[c].index, b = corner_vertex[after].index;
            if (a == b) return false;
            if (!vertex_corner[a].valid()) vertex_corner[a] = Corner(c);
            const bool at_a = corner_count[a] < corner_count[b] || (corner_count[a] == corner_count[b] && a < b);
            const std::uint32_t near = at_a ? a : b, far = at_a ? b : a;
            std::uint32_t e = first_kept[near];
            while (e != none && kept[e].far != far) e = kept[e].next;
            if (e == none) {
                e = mesh.edge_corners_.size();
                mesh.edge_corners_.push_back({Corner(c), Corner()});
                kept.push_back({far, first_kept[near]});
                first_kept[near] = e;
            } else {
                auto& pair = mesh.edge_corners_.write(e, 1)[0];
                if (pair[1].valid() || corner_vertex[pair[0].index].index == a) return false; // a third side, or one that runs the same way
                pair[1] = Corner(c);
                ++closed;
            }
            edge[c] = Edge(e);
        }
        begin = end;
    }
    if (closed != mesh.edge_corners_.size()) return false; // open somewhere

    // One rotation per vertex: then the rotations that start at the vertices' first corners meet every corner.
    std::uint64_t met = 0;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const Corner first = vertex_corner[v];
        if (!first.valid()) return false;
        Corner c = first;
        do {
            ++met;
            if (!edge[c.index].valid()) break;
            const Corner in = previous[c.index];
            const auto& pair = mesh.edge_corners_[edge[in.index].index];
            c = pair[0] == in ? pair[1] : pair[0];
        } while (c != first);
    }
    return met == corners;
}

void MeshBuilder::leave_out_loose_vertices(Repairs& repairs)
{
    std::vector<bool> used(positions_.size(), false);
    for (const Vertex v : corners_.view()) {
        ASSERT(v.index < used.size(), "corners of vertices that exist");
        used[v.index] = true;
    }
    std::vector<std::uint32_t> renamed;
    std::uint32_t kept = 0;
    for (std::uint32_t v = 0; v < positions_.size(); ++v) {
        if (!used[v] && renamed.empty()) {
            renamed.resize(positions_.size());
            for (std::uint32_t w = 0; w < v; ++w) renamed[w] = w;
        }
        if (!used[v]) continue;
        if (!renamed.empty()) {
            positions_.set(kept, positions_[v]);
            renamed[v] = kept;
        }
        ++kept;
    }
    repairs.loose_vertices = positions_.size() - kept;
    if (renamed.empty()) return;
    positions_.truncate(kept);
    Vertex* const corner = corners_.write(0, corners_.size());
    for (std::uint32_t c = 0; c < corners_.size(); ++c) corner[c] = Vertex(renamed[corner[c].index]);
}

} // namespace druse
