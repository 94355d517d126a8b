#include "dlfl/mesh.h"

#include "dlfl/errors.h"
#include "dlfl/patch.h"

#include <algorithm>
#include <functional>

namespace druse {

std::size_t MeshChange::bytes() const
{
    return corner_vertex.bytes() + corner_next.bytes() + corner_previous.bytes() + corner_face.bytes() + corner_edge.bytes() +
           edge_corners.bytes() + face_corner.bytes() + face_group.bytes() + boundary_corner.bytes() + vertex_position.bytes() +
           vertex_corner.bytes();
}

// --- navigation -------------------------------------------------------------------------------------------------------------

int Mesh::valence(Face f) const
{
    int n = 0;
    const Corner first = corner(f);
    for (Corner c = first; n == 0 || c != first; c = next(c)) ++n;
    return n;
}

int Mesh::valence(Vertex v) const
{
    if (is_point_sphere(v)) return 0;
    int n = 0;
    const Corner first = corner(v);
    for (Corner c = first; n == 0 || c != first; c = rotate(c)) ++n;
    return n;
}

Corner Mesh::corner(Face f, int k) const
{
    Corner c = corner(f);
    for (; k > 0; --k) c = next(c);
    return c;
}

void Mesh::set_start(Corner c) { set_face_corner(face(c), c); }

int Mesh::largest_group() const { return largest_group_.is_known() ? largest_group_.value() : find_largest_group().group; }

LargestGroup::State Mesh::find_largest_group() const
{
    LargestGroup found;
    for (std::uint32_t i = 0; i < face_limit(); ++i)
        if (face_corner_[i].valid()) found.add(face_group_[i]);
    return found.state();
}

// --- elements ---------------------------------------------------------------------------------------------------------------

std::uint32_t Mesh::take(Holes& h)
{
    std::pop_heap(h.begin(), h.end(), std::greater<>());
    const std::uint32_t index = h.back();
    h.pop_back();
    return index;
}

void Mesh::give(Holes& h, std::uint32_t index)
{
    h.push_back(index);
    std::push_heap(h.begin(), h.end(), std::greater<>());
}

Vertex Mesh::new_vertex(const Point& p)
{
    if (free_vertices_.empty()) {
        ASSERT(vertex_limit() < Face::boundary_bit, "fewer than 2^31 vertices");
        vertex_position_.push_back(p);
        vertex_corner_.push_back(Corner());
        return Vertex(vertex_limit() - 1);
    }
    const Vertex v(take(free_vertices_));
    vertex_position_.set(v.index, p);
    return v;
}

Edge Mesh::new_edge(Corner a, Corner b)
{
    Edge e(edge_limit());
    if (free_edges_.empty()) {
        ASSERT(edge_limit() < Face::boundary_bit, "fewer than 2^31 edges");
        edge_corners_.push_back({a, b});
    } else {
        e = Edge(take(free_edges_));
        edge_corners_.set(e.index, {a, b});
    }
    corner_edge_.set(a.index, e);
    corner_edge_.set(b.index, e);
    return e;
}

Face Mesh::new_face(Corner start, int group)
{
    largest_group_.add(group);
    if (free_faces_.empty()) {
        ASSERT(face_limit() < Face::boundary_bit - 1, "fewer than 2^31 faces");
        face_corner_.push_back(start);
        face_group_.push_back(group);
        return Face(face_limit() - 1);
    }
    const Face f(take(free_faces_));
    face_corner_.set(f.index, start);
    face_group_.set(f.index, group);
    return f;
}

Corner Mesh::new_corner(Vertex v)
{
    if (free_corners_.empty()) {
        ASSERT(corner_limit() < Corner::none - 1, "fewer than 2^32 corners");
        corner_vertex_.push_back(v);
        corner_next_.push_back(Corner());
        corner_previous_.push_back(Corner());
        corner_face_.push_back(Face());
        corner_edge_.push_back(Edge());
        return Corner(corner_limit() - 1);
    }
    const Corner c(take(free_corners_));
    corner_vertex_.set(c.index, v);
    corner_edge_.set(c.index, Edge());
    return c;
}

void Mesh::free_vertex(Vertex v)
{
    vertex_corner_.set(v.index, Corner());
    give(free_vertices_, v.index);
}

void Mesh::free_edge(Edge e)
{
    edge_corners_.set(e.index, {Corner(), Corner()});
    give(free_edges_, e.index);
}

void Mesh::free_face(Face f)
{
    largest_group_.remove(face_group_[f.index]);
    face_corner_.set(f.index, Corner());
    give(free_faces_, f.index);
}

void Mesh::free_corner(Corner c)
{
    corner_vertex_.set(c.index, Vertex());
    give(free_corners_, c.index);
}

void Mesh::replace_edge_corner(Edge e, Corner from, Corner to)
{
    std::array<Corner, 2> pair = edge_corners_[e.index];
    pair[pair[0] == from ? 0 : 1] = to;
    edge_corners_.set(e.index, pair);
}

// --- bulk -------------------------------------------------------------------------------------------------------------------

std::span<Point> Mesh::vertex_room(std::size_t count)
{
    if (count + vertex_limit() > Face::boundary_bit - 1) throw CommandError("the result would have more than 2^31 elements of a kind");
    return {vertex_position_.room(static_cast<std::uint32_t>(count)), count};
}

std::uint32_t Mesh::replace_face(Face f, const Patch& patch)
{
    const Patch* one = &patch;
    return replace_faces({&f, 1}, {&one, 1});
}

std::uint32_t Mesh::replace_faces(std::span<const Face> faces, std::span<const Patch* const> patch_of)
{
    ASSERT(faces.size() == patch_of.size(), "one patch for each face");
    ASSERT(!has_holes(), "no holes when faces are replaced in bulk");
    std::uint64_t vertices = 0, edges = 0, polygons = 0, corners = 0;
    for (const Patch* patch : patch_of) {
        vertices += static_cast<std::uint64_t>(patch->new_vertices());
        edges += static_cast<std::uint64_t>(patch->new_edges());
        polygons += static_cast<std::uint64_t>(patch->new_faces());
        corners += static_cast<std::uint64_t>(patch->new_corners());
    }
    constexpr std::uint64_t most = Face::boundary_bit - 1;
    if (vertices + vertex_limit() > most || edges + edge_limit() > most || polygons + face_limit() > most || corners + corner_limit() > most)
        throw CommandError("the result would have more than 2^31 elements of a kind");

    const std::uint32_t first_vertex = vertex_limit(), first_edge = edge_limit(), first_face = face_limit(), first_corner = corner_limit();
    vertex_position_.extend(static_cast<std::uint32_t>(vertices));
    vertex_corner_.extend(static_cast<std::uint32_t>(vertices));
    edge_corners_.extend(static_cast<std::uint32_t>(edges));
    face_corner_.extend(static_cast<std::uint32_t>(polygons));
    face_group_.extend(static_cast<std::uint32_t>(polygons));
    corner_vertex_.extend(static_cast<std::uint32_t>(corners));
    corner_next_.extend(static_cast<std::uint32_t>(corners));
    corner_previous_.extend(static_cast<std::uint32_t>(corners));
    corner_face_.extend(static_cast<std::uint32_t>(corners));
    corner_edge_.extend(static_cast<std::uint32_t>(corners));
    replace_in_order(faces, patch_of, first_vertex, first_edge, first_face, first_corner);
    return first_vertex;
}

namespace {

template <class H>
void copy_shifted(H* __restrict out, const std::uint32_t* __restrict in, std::uint32_t count, std::uint32_t shift)
{
    for (std::uint32_t k = 0; k < count; ++k) out[k].index = in[k] + shift;
}

} // namespace

void Mesh::replace_in_order(std::span<const Face> faces, std::span<const Patch* const> patch_of, std::uint32_t first_vertex,
                            std::uint32_t first_edge, std::uint32_t first_face, std::uint32_t first_corner)
{
    // The ends of the columns are new and belong to this call alone, so they are written without going through set().
    Vertex* const vertex_out = corner_vertex_.write(first_corner, 0);
    Corner* const next_out = corner_next_.write(first_corner, 0);
    Corner* const previous_out = corner_previous_.write(first_corner, 0);
    Face* const face_out = corner_face_.write(first_corner, 0);
    Edge* const edge_out = corner_edge_.write(first_corner, 0);
    std::array<Corner, 2>* const pair_out = edge_corners_.write(first_edge, 0);
    Corner* const start_out = face_corner_.write(first_face, 0);
    std::int32_t* const group_out = face_group_.write(first_face, 0);
    Corner* const vertex_corner_out = vertex_corner_.write(first_vertex, 0);

    std::vector<Corner> ring;
    std::uint32_t v = 0, e = 0, f = 0, c = 0; // made so far
    for (std::size_t which = 0; which < faces.size(); ++which) {
        const Face face = faces[which];
        const Patch& patch = *patch_of[which];
        const auto n = static_cast<std::uint32_t>(patch.ring_);
        ring.resize(n);
        ASSERT(is_alive(face), "faces that are there");
        Corner walk = corner(face);
        ring[0] = walk;
        for (std::uint32_t i = 1; i < n; ++i) {
            ring[i] = walk = next(walk);
            ASSERT(walk != ring[0], "a patch with as many ring corners as the face");
        }
        ASSERT(next(walk) == ring[0], "a patch with as many ring corners as the face");

        const std::uint32_t corner0 = first_corner + c, vertex0 = first_vertex + v, edge0 = first_edge + e, face0 = first_face + f;
        const auto corners = static_cast<std::uint32_t>(patch.vertex_.size());
        // New corner k of the template counts as k here and as corner0 + k in the mesh; where it refers to the ring, it is mended after.
        copy_shifted(vertex_out + c, patch.vertex_.data(), corners, vertex0);
        copy_shifted(next_out + c, patch.next_.data(), corners, corner0);
        copy_shifted(previous_out + c, patch.previous_.data(), corners, corner0);
        copy_shifted(face_out + c, patch.face_.data(), corners, face0);
        copy_shifted(edge_out + c, patch.edge_.data(), corners, edge0);
        for (const auto& x : patch.vertex_fixups_) vertex_out[c + x.at] = corner_vertex_[ring[x.ring].index];
        for (const auto& x : patch.next_fixups_) next_out[c + x.at] = ring[x.ring];
        for (const auto& x : patch.previous_fixups_) previous_out[c + x.at] = ring[x.ring];
        for (const std::uint32_t k : patch.first_polygon_corners_) face_out[c + k] = face;

        const auto resolve = [&](std::uint32_t ref) { return ref < n ? ring[ref] : Corner(corner0 + ref - n); };
        for (std::uint32_t i = 0; i < n; ++i) {
            corner_next_.set(ring[i].index, resolve(patch.ring_next_[i]));
            corner_previous_.set(ring[i].index, resolve(patch.ring_previous_[i]));
            const std::uint32_t polygon = patch.ring_face_[i];
            if (polygon > 0) corner_face_.set(ring[i].index, Face(face0 + polygon - 1));
        }
        const auto edges = static_cast<std::uint32_t>(patch.edges_.size());
        for (std::uint32_t k = 0; k < edges; ++k)
            pair_out[e + k] = {Corner(corner0 + patch.edges_[k].first), Corner(corner0 + patch.edges_[k].second)};
        const auto inner = static_cast<std::uint32_t>(patch.inner_);
        for (std::uint32_t k = 0; k < inner; ++k) vertex_corner_out[v + k] = Corner(corner0 + patch.vertex_corner_[k]);
        face_corner_.set(face.index, resolve(patch.starts_[0]));
        const auto polygons = static_cast<std::uint32_t>(patch.starts_.size()) - 1;
        const std::int32_t old_group = face_group_[face.index];
        for (std::uint32_t k = 0; k < polygons; ++k) {
            start_out[f + k] = resolve(patch.starts_[k + 1]);
            group_out[f + k] = old_group;
        }
        largest_group_.add(old_group, polygons);
        v += inner;
        e += edges;
        f += polygons;
        c += corners;
    }
}

namespace {

/// Old index to new index for everything below `limit`, holes left out; `none` for a hole.
std::vector<std::uint32_t> closing(std::vector<std::uint32_t> holes, std::uint32_t limit)
{
    std::sort(holes.begin(), holes.end());
    std::vector<std::uint32_t> map(limit);
    std::size_t passed = 0;
    for (std::uint32_t i = 0; i < limit; ++i) {
        if (passed < holes.size() && holes[passed] == i) {
            map[i] = Corner::none;
            ++passed;
        } else {
            map[i] = i - static_cast<std::uint32_t>(passed);
        }
    }
    return map;
}

template <class T>
void move_down(Column<T>& column, const std::vector<std::uint32_t>& map)
{
    std::uint32_t kept = 0;
    for (std::uint32_t i = 0; i < column.size(); ++i) {
        if (map[i] == Corner::none) continue;
        if (map[i] != i) column.set(map[i], column[i]);
        ++kept;
    }
    column.truncate(kept);
}

template <class H>
void rename(Column<H>& column, const std::vector<std::uint32_t>& map)
{
    for (std::uint32_t i = 0; i < column.size(); ++i) {
        const std::uint32_t old = column[i].index;
        if (old < map.size() && map[old] != old) column.set(i, H(map[old])); // boundary faces and `none` lie above the map
    }
}

} // namespace

Renumbering Mesh::compact()
{
    Renumbering result;
    if (!free_vertices_.empty()) {
        result.vertices = closing(std::exchange(free_vertices_, {}), vertex_limit());
        move_down(vertex_position_, result.vertices);
        move_down(vertex_corner_, result.vertices);
        rename(corner_vertex_, result.vertices);
    }
    if (!free_edges_.empty()) {
        result.edges = closing(std::exchange(free_edges_, {}), edge_limit());
        move_down(edge_corners_, result.edges);
        rename(corner_edge_, result.edges);
    }
    if (!free_faces_.empty()) {
        result.faces = closing(std::exchange(free_faces_, {}), face_limit());
        move_down(face_corner_, result.faces);
        move_down(face_group_, result.faces);
        rename(corner_face_, result.faces);
    }
    if (!free_corners_.empty()) close_corner_holes();
    return result;
}

/// Nobody outside knows a corner by its index, so the last ones move into the holes: work and undo grow with the holes, not the mesh.
void Mesh::close_corner_holes()
{
    Holes gone = std::exchange(free_corners_, {});
    std::sort(gone.begin(), gone.end());
    const std::uint32_t kept = corner_limit() - holes(gone);
    std::size_t hole = 0, beyond = static_cast<std::size_t>(std::ranges::lower_bound(gone, kept) - gone.begin());
    for (std::uint32_t from = kept; from < corner_limit(); ++from)
        if (beyond < gone.size() && gone[beyond] == from) ++beyond;
        else move_corner(Corner(from), Corner(gone[hole++]));
    corner_vertex_.truncate(kept);
    corner_next_.truncate(kept);
    corner_previous_.truncate(kept);
    corner_face_.truncate(kept);
    corner_edge_.truncate(kept);
}

void Mesh::move_corner(Corner from, Corner to)
{
    const Vertex v = vertex(from);
    const Face f = face(from);
    const Edge e = edge(from);
    const Corner before = previous(from), after = next(from);
    corner_vertex_.set(to.index, v);
    corner_face_.set(to.index, f);
    corner_edge_.set(to.index, e);
    link(before == from ? to : before, to);
    link(to, after == from ? to : after);
    if (corner(v) == from) vertex_corner_.set(v.index, to);
    if (corner(f) == from) set_face_corner(f, to);
    if (e.valid()) replace_edge_corner(e, from, to);
}

void Mesh::replace_with(Mesh&& other) { *this = std::move(other); }

namespace {

template <class T, class F>
void append_column(Column<T>& to, const Column<T>& from, F&& shifted)
{
    const std::uint32_t count = from.size();
    T* out = to.extend(count);
    for (std::uint32_t i = 0; i < count; ++i) out[i] = shifted(from[i]);
}

} // namespace

void Mesh::append(const Mesh& other)
{
    ASSERT(!has_holes() && !other.has_holes(), "no holes when meshes are joined");
    const std::uint32_t v0 = vertex_limit(), e0 = edge_limit(), f0 = face_limit(), c0 = corner_limit(), b0 = boundary_count();
    constexpr std::uint64_t most = Face::boundary_bit - 1;
    // There are at least as many corners as faces, and twice as many as edges.
    if (std::uint64_t(v0) + other.vertex_limit() > most || std::uint64_t(c0) + other.corner_limit() > most)
        throw CommandError("the result would have more than 2^31 elements of a kind");
    const auto corner = [c0](Corner c) { return Corner(c.index + c0); };
    const auto face = [f0, b0](Face f) { return f.is_boundary() ? Face::boundary(f.boundary_index() + b0) : Face(f.index + f0); };
    append_column(corner_vertex_, other.corner_vertex_, [v0](Vertex v) { return Vertex(v.index + v0); });
    append_column(corner_next_, other.corner_next_, corner);
    append_column(corner_previous_, other.corner_previous_, corner);
    append_column(corner_face_, other.corner_face_, face);
    append_column(corner_edge_, other.corner_edge_, [e0](Edge e) { return e.valid() ? Edge(e.index + e0) : e; });
    append_column(edge_corners_, other.edge_corners_,
                  [corner](const std::array<Corner, 2>& p) { return std::array<Corner, 2>{corner(p[0]), corner(p[1])}; });
    append_column(face_corner_, other.face_corner_, corner);
    append_column(face_group_, other.face_group_, [](std::int32_t g) { return g; });
    largest_group_.forget();
    append_column(boundary_corner_, other.boundary_corner_, corner);
    append_column(vertex_position_, other.vertex_position_, [](const Point& p) { return p; });
    append_column(vertex_corner_, other.vertex_corner_, corner);
}

// --- going back -------------------------------------------------------------------------------------------------------------

void Mesh::begin_change()
{
    ASSERT(!is_recording(), "one change recorded at a time");
    ASSERT(!has_holes(), "no holes when a change begins");
    if (!largest_group_.is_known()) largest_group_.set(find_largest_group());
    largest_group_.begin_change();
    for_each_column([](auto& column, auto) { column.begin_change(); });
}

MeshChange Mesh::end_change()
{
    ASSERT(is_recording(), "a change being recorded");
    ASSERT(!has_holes(), "no holes when a change ends");
    MeshChange change;
    change.largest_group = largest_group_.end_change();
    for_each_column([&change](auto& column, auto member) { change.*member = column.end_change(); });
    return change;
}

void Mesh::exchange(MeshChange& change)
{
    ASSERT(!is_recording() && !has_holes(), "no change being recorded, and no holes, when going back or forth");
    for_each_column([&change](auto& column, auto member) { column.exchange(change.*member); });
    largest_group_.exchange(change.largest_group);
}

void Mesh::roll_back()
{
    ASSERT(is_recording(), "a change being recorded");
    free_vertices_.clear();
    free_edges_.clear();
    free_faces_.clear();
    free_corners_.clear();
    for_each_column([](auto& column, auto) { column.roll_back(); });
    largest_group_.roll_back();
}

namespace {

template <class T>
bool same(const Column<T>& a, const Column<T>& b)
{
    return std::ranges::equal(a.view(), b.view());
}

} // namespace

bool operator==(const Mesh& a, const Mesh& b)
{
    return same(a.corner_vertex_, b.corner_vertex_) && same(a.corner_next_, b.corner_next_) &&
           same(a.corner_previous_, b.corner_previous_) && same(a.corner_face_, b.corner_face_) &&
           same(a.corner_edge_, b.corner_edge_) && same(a.edge_corners_, b.edge_corners_) && same(a.face_corner_, b.face_corner_) &&
           same(a.face_group_, b.face_group_) && same(a.boundary_corner_, b.boundary_corner_) &&
           same(a.vertex_position_, b.vertex_position_) && same(a.vertex_corner_, b.vertex_corner_);
}

std::size_t Mesh::bytes() const
{
    return corner_vertex_.bytes() + corner_next_.bytes() + corner_previous_.bytes() + corner_face_.bytes() + corner_edge_.bytes() +
           edge_corners_.bytes() + face_corner_.bytes() + face_group_.bytes() + boundary_corner_.bytes() + vertex_position_.bytes() +
           vertex_corner_.bytes();
}

} // namespace druse
