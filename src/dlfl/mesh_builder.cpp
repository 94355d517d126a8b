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
    note(sides_dropped, "side of a face ran from a vertex to itself: left out", "sides of faces ran from a vertex to itself: left out");
    note(faces_dropped, "face had fewer than three different corners: left out", "faces had fewer than three different corners: left out");
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
    ASSERT(connect(mesh), "polygons that make a closed oriented 2-manifold");
    return mesh;
}

Mesh MeshBuilder::build(Repairs& repairs)
{
    Mesh mesh;
    if (connect(mesh)) return mesh;
    leave_out_repetitions(repairs);
    leave_out_loose_vertices(repairs);
    if ((repairs.sides_dropped > 0 || repairs.loose_vertices > 0) && connect(mesh = Mesh())) return mesh;
    return mend(repairs);
}

void MeshBuilder::hand_over(Mesh& mesh)
{
    mesh.corner_vertex_ = std::move(corners_);
    mesh.vertex_position_ = std::move(positions_);
    mesh.face_group_ = std::move(groups_);
    mesh.largest_group_.forget();
    ends_ = {};
}

bool MeshBuilder::connect(Mesh& mesh)
{
    // Everything is done in the order in which the polygons lie in memory, and in the mesh's own columns before they get their
    // values: on a large mesh the cost is that of touching memory, for the first time most of all.
    const std::uint32_t vertices = positions_.size(), faces = ends_.size(), corners = corners_.size();
    ASSERT(corners < Face::boundary_bit, "fewer than 2^31 corners");
    const Vertex* const vertex = corners_.view().data();
    const std::uint32_t* const ends = ends_.view().data();

    Corner* const next = mesh.corner_next_.extend(corners);
    Corner* const previous = mesh.corner_previous_.extend(corners);
    Face* const face = mesh.corner_face_.extend(corners);
    Edge* const edge = mesh.corner_edge_.extend(corners);
    Corner* const start = mesh.face_corner_.extend(faces);
    Corner* const vertex_corner = mesh.vertex_corner_.extend(vertices);
    std::array<Corner, 2>* const pair = mesh.edge_corners_.extend(std::max(corners / 2, vertices));

    // 1. Faces. A side is named by the corner it *ends* in, and hangs in a list at the lower-numbered of its two vertices.
    Column<Corner> lists;
    Corner* const list = lists.extend(vertices);
    Corner* const following = next; // in its list
    std::fill_n(list, vertices, Corner());
    std::uint32_t sides = 0;
    for (std::uint32_t f = faces; f-- > 0;) {
        const std::uint32_t begin = f > 0 ? ends[f - 1] : 0, end = ends[f];
        ASSERT(end > begin, "no face without corners");
        start[f] = Corner(begin);
        std::uint32_t into = begin, to = vertex[begin].index;
        for (std::uint32_t c = end; c-- > begin;) {
            const std::uint32_t from = vertex[c].index;
            ASSERT(from < vertices, "corners of vertices that exist");
            previous[into] = Corner(c);
            face[c] = Face(f);
            if (from == to) {
                if (end != begin + 1) return false;
                following[c] = Corner(c); // a point sphere
                break;
            }
            const std::uint32_t low = from < to ? from : to;
            following[into] = list[low];
            list[low] = Corner(into);
            ++sides;
            into = c;
            to = from;
        }
    }

    // 2. Partners. In the list of a vertex each edge must come twice, once in each direction. `met` says, for the other end of
    // an edge, which vertex's list it was last met in, and the side it was met with: so vertices of any valence take linear time.
    // A side that ends in corner c and the one against it tell the next corner of the vertex, counter-clockwise from c.
    struct Met {
        std::uint32_t low;
        Corner into; // none: both sides met
    };
    const auto met = [pair](std::uint32_t v) { return Met{pair[v][0].index, pair[v][1]}; };
    const auto set_met = [pair](std::uint32_t v, const Met& m) { pair[v] = {Corner(m.low), m.into}; };
    Corner* const turn = next; // takes the place of `following` where that has been read
    std::fill_n(pair, vertices, std::array<Corner, 2>{});
    std::uint32_t edges = 0;
    for (std::uint32_t low = 0; low < vertices; ++low)
        for (Corner into = list[low]; into.valid();) {
            const Corner rest = following[into.index], out = previous[into.index];
            const std::uint32_t to = vertex[into.index].index, high = low ^ to ^ vertex[out.index].index; // whichever is not `low`
            const Met m = met(high);
            if (m.low != low) {
                set_met(high, {low, into});
            } else {
                if (!m.into.valid() || vertex[m.into.index].index == to) return false; // a third side, or one that runs the same way
                turn[into.index] = previous[m.into.index];
                turn[m.into.index] = out;
                set_met(high, {low, Corner()});
                ++edges;
            }
            into = rest;
        }
    if (2 * edges != sides) return false; // open somewhere

    // 3. One rotation per vertex: then those that start at the vertices' first corners meet every corner.
    std::fill_n(vertex_corner, vertices, Corner());
    for (std::uint32_t c = corners; c-- > 0;) vertex_corner[vertex[c].index] = Corner(c);
    std::uint32_t turned = 0;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const Corner first = vertex_corner[v];
        if (!first.valid()) return false;
        Corner c = first;
        do {
            ++turned;
            c = turn[c.index];
        } while (c != first);
    }
    if (turned != corners) return false;

    // 4. Edges, as the faces first use them. The side that starts at c ends in the next corner.
    std::uint32_t made = 0, begin = 0;
    for (std::uint32_t f = 0; f < faces; ++f) {
        const std::uint32_t end = ends[f];
        if (end == begin + 1) {
            edge[begin] = Edge(); // `next` holds the corner itself already
            begin = end;
            continue;
        }
        const Corner last_across = turn[begin];
        for (std::uint32_t c = begin; c < end; ++c) {
            const Corner across = c + 1 < end ? turn[c + 1] : last_across;
            next[c] = Corner(c + 1 < end ? c + 1 : begin);
            if (across.index > c) {
                pair[made] = {Corner(c), across};
                edge[c] = Edge(made++);
            } else {
                edge[c] = edge[across.index];
            }
        }
        begin = end;
    }
    mesh.edge_corners_.truncate(edges);
    hand_over(mesh);
    return true;
}

void MeshBuilder::leave_out_repetitions(Repairs& repairs)
{
    std::uint32_t faces = 0, corners = 0, begin = 0;
    Vertex* const vertex = corners_.write(0, corners_.size());
    for (std::uint32_t f = 0; f < ends_.size(); ++f) {
        const std::uint32_t end = ends_[f], first = corners;
        for (std::uint32_t c = begin; c < end; ++c)
            if (c == begin || vertex[c] != vertex[corners - 1]) vertex[corners++] = vertex[c];
        while (corners - first > 1 && vertex[corners - 1] == vertex[first]) --corners;
        const std::uint32_t dropped = (end - begin) - (corners - first);
        begin = end;
        repairs.sides_dropped += dropped;
        if (dropped > 0 && corners - first < 3) {
            corners = first;
            ++repairs.faces_dropped;
            continue;
        }
        ends_.set(faces, corners);
        groups_.set(faces++, groups_[f]);
    }
    corners_.truncate(corners);
    ends_.truncate(faces);
    groups_.truncate(faces);
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
