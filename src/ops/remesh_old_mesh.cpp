#include "ops/remesh_old_mesh.h"

#include "dlfl/errors.h"
#include "dlfl/measures.h"
#include "dlfl/mesh_tables.h"
#include "geom/do_both.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace druse::remesh {

namespace {

template <class T>
T* room(Column<T>& column, std::uint32_t count)
{
    column.reserve(count);
    return column.extend(count);
}

/// True if the corners come face after face, each face from its start corner.
bool in_face_order(const MeshTables::View& view)
{
    const auto count = static_cast<std::uint32_t>(view.next.size());
    std::uint32_t c = 0;
    for (const Corner start : view.start) {
        if (start.index != c) return false;
        while (view.next[c].index == c + 1) ++c;
        if (view.next[c] != start) return false;
        ++c;
    }
    return c == count;
}

} // namespace

OldMesh::OldMesh(const Mesh& mesh, int least_valence) : mesh_(mesh)
{
    if (mesh.boundary_count() > 0) throw CommandError(fmt::format("the model is open: {} boundary edges", boundary_edge_count(mesh)));
    ASSERT(!mesh.has_holes(), "no holes in a mesh to remesh");
    const MeshTables::View view = MeshTables::view(mesh);
    bool too_large = false;
    do_both(
        corners() > worth_a_thread,
        [&] {
            if (in_face_order(view)) read_in_order();
            else renumber();
        },
        [&] {
            std::uint32_t* const valence = room(valence_, vertices());
            std::fill_n(valence, vertices(), 0);
            for (const Vertex v : view.vertex) ++valence[v.index];
            // Every formula is a mean with weights of moderate size; with such coordinates no sum can overflow.
            constexpr double most = 1e290;
            for (const Point& p : mesh.positions()) too_large |= std::abs(p.x) > most || std::abs(p.y) > most || std::abs(p.z) > most;
        });
    for (std::uint32_t v = 0; v < vertices(); ++v)
        if (valence(v) < static_cast<std::uint32_t>(least_valence))
            throw CommandError(fmt::format("vertex {} has valence {}", v, mesh.valence(Vertex(v)))); // 0 on a point sphere, which has a corner
    for (std::uint32_t f = 0; f < faces(); ++f)
        if (const std::uint32_t n = end(f) - begin(f); n < 3) throw CommandError(fmt::format("face {} has {} side{}", f, n, n == 1 ? "" : "s"));
    if (too_large) throw CommandError("coordinates beyond 1e290 are too large");
}

std::size_t OldMesh::bytes() const
{
    std::size_t sum = own_vertex_.bytes() + own_face_.bytes() + own_next_.bytes() + own_previous_.bytes() + own_corner_of_side_.bytes();
    for (const Column<std::uint32_t>* column : {&begin_, &across_, &side_, &valence_, &place_around_, &corner_around_, &number_}) sum += column->bytes();
    return sum;
}

void OldMesh::read_in_order()
{
    const MeshTables::View view = MeshTables::view(mesh_);
    vertex_ = view.vertex;
    face_ = view.face;
    next_ = view.next;
    previous_ = view.previous;
    corner_of_side_ = view.edge_corners;
    std::uint32_t* const begin = room(begin_, faces() + 1);
    for (std::uint32_t f = 0; f < faces(); ++f) begin[f] = view.start[f].index;
    begin[faces()] = corners();

    std::uint32_t* const across = room(across_, corners());
    std::uint32_t* const side = room(side_, corners());
    for (std::uint32_t c = 0; c < corners(); ++c) {
        const std::uint32_t e = view.edge[c].index;
        if (e == Edge::none) { // a point sphere: refused when valences are looked at
            across[c] = side[c] = 0;
            continue;
        }
        const auto [a, b] = view.edge_corners[e];
        const bool second = b.index == c;
        across[c] = second ? a.index : b.index;
        side[c] = 2 * e + second;
    }
}

void OldMesh::renumber()
{
    const MeshTables::View view = MeshTables::view(mesh_);
    std::uint32_t* const number_of = room(number_, corners());
    std::uint32_t* const begin = room(begin_, faces() + 1);
    Vertex* const vertex = room(own_vertex_, corners());
    Face* const face = room(own_face_, corners());
    Corner* const next = room(own_next_, corners());
    Corner* const previous = room(own_previous_, corners());
    std::uint32_t at = 0;
    for (std::uint32_t f = 0; f < faces(); ++f) {
        begin[f] = at;
        Corner c = view.start[f];
        do {
            number_of[c.index] = at;
            vertex[at] = view.vertex[c.index];
            face[at] = Face(f);
            next[at] = Corner(at + 1);
            previous[at] = Corner(at - 1);
            ++at;
            c = view.next[c.index];
        } while (c != view.start[f]);
        next[at - 1] = Corner(begin[f]);
        previous[begin[f]] = Corner(at - 1);
    }
    begin[faces()] = at;

    std::uint32_t* const across = room(across_, corners());
    std::uint32_t* const side = room(side_, corners());
    std::fill_n(across, corners(), 0);
    std::fill_n(side, corners(), 0);
    std::array<Corner, 2>* const corner_of_side = room(own_corner_of_side_, edges());
    for (std::uint32_t e = 0; e < edges(); ++e) {
        const std::uint32_t a = number_of[view.edge_corners[e][0].index], b = number_of[view.edge_corners[e][1].index];
        corner_of_side[e] = {Corner(a), Corner(b)};
        across[a] = b;
        across[b] = a;
        side[a] = 2 * e;
        side[b] = 2 * e + 1;
    }
    vertex_ = own_vertex_.view();
    face_ = own_face_.view();
    next_ = own_next_.view();
    previous_ = own_previous_.view();
    corner_of_side_ = own_corner_of_side_.view();
}

void OldMesh::order_around(bool with_places)
{
    std::uint32_t* const place = with_places ? room(place_around_, corners()) : nullptr;
    std::uint32_t* const order = room(corner_around_, corners());
    std::vector<std::uint32_t> ring; // the corners of a vertex, from any one on
    std::uint32_t at = 0;
    for (std::uint32_t v = 0; v < vertices(); ++v) {
        const std::uint32_t first = number_.size() > 0 ? number_[mesh_.corner(Vertex(v)).index] : mesh_.corner(Vertex(v)).index;
        ring.clear();
        std::size_t start = 0;
        std::uint32_t least = ~std::uint32_t(0), c = first;
        do {
            const std::uint32_t before = back(c);
            c = across(before);
            // Its side leads where the one before came from. Of several edges to the same neighbour the one with the lowest id counts.
            const std::uint32_t there = vertex(before);
            if (there < least || (there == least && edge(c) < edge(ring[start]))) {
                start = ring.size();
                least = there;
            }
            ring.push_back(c);
        } while (c != first);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::uint32_t next = ring[start + i < ring.size() ? start + i : start + i - ring.size()];
            if (with_places) place[next] = at;
            order[at++] = next;
        }
    }
}

} // namespace druse::remesh
