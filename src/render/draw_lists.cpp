#include "render/draw_lists.h"

#include "dlfl/measures.h"
#include "render/palette.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace druse {

namespace {

constexpr std::uint32_t cache_reach = 256;     // triangles after which a vertex is no longer at hand in a vertex cache
constexpr std::uint32_t copies_looked_at = 16; // when a copy to use again is searched
constexpr std::uint32_t largest_room = 64;     // free runs up to this length are used again
constexpr std::uint32_t slack = 4096;          // room for a few local edits before a column must grow

std::uint64_t next_version()
{
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

} // namespace

std::uint32_t pack_normal(const Vector& n)
{
    const auto field = [](double x) { return static_cast<std::uint32_t>(static_cast<int>(std::lrint(x * 511.0))) & 1023u; };
    return field(n.x) | field(n.y) << 10 | field(n.z) << 20;
}

Division::Division(const Mesh& old, std::vector<std::uint32_t> faces, std::span<const Vector> vertex_normals)
    : old_face(std::move(faces)), normals(vertex_normals), old_bounds(bounds(old))
{
    for (const Edge e : old.edges()) old_mean_edge += length(old, e);
    if (old.edge_count() > 0) old_mean_edge /= old.edge_count();
}

// --- building ---------------------------------------------------------------------------------------------------------------

/// The middle of the box on a grid as coarse as the box: near enough for single precision, and the same for a model that changed
/// a little. For a model about the origin it is the origin.
Point DrawLists::origin_for(const Box& box)
{
    const double cell = box.empty() || box.diagonal() == 0 ? 1.0 : std::exp2(std::ceil(std::log2(box.diagonal())));
    return glm::round(box.center() / cell) * cell;
}

void DrawLists::clear(const Box& box)
{
    origin_ = origin_for(box);
    live_triangles_ = 0;
    edge_sum_ = 0;
    draw_vertices_.truncate(0);
    vertex_of_.truncate(0);
    next_copy_.truncate(0);
    triangles_.truncate(0);
    triangle_face_.truncate(0);
    positions_.truncate(0);
    newest_.truncate(0);
    face_triangles_.truncate(0);
    face_group_.truncate(0);
    face_selected_.truncate(0);
    edge_ends_.truncate(0);
    boundary_sides_.clear();
    selected_.clear();
    pick_boxes_.clear();
    room_.clear();
    vertex_versions_.clear();
    triangle_versions_.clear();
    edge_versions_.clear();
    is_divided_ = false;
    id_ = version_ = shape_version_ = next_version();
}

void DrawLists::new_version()
{
    version_ = next_version();
}

void DrawLists::build(const Mesh& mesh, const GroupColours& colours) { build(mesh, colours, nullptr); }

void DrawLists::build(const Mesh& mesh, const GroupColours& colours, const Division& division)
{
    build(mesh, colours, &division);
    is_divided_ = true;
    mean_edge_ = division.old_mean_edge;
    if (!division.normals.empty()) take_normals(division.normals);
    if (division.old_bounds.empty()) return;
    reach_.add(division.old_bounds.min);
    reach_.add(division.old_bounds.max);
}

void DrawLists::build(const Mesh& mesh, const GroupColours& colours, const Division* division)
{
    Box box;
    for (const Vertex v : mesh.vertices()) box.add(mesh.position(v));
    clear(box);

    const std::uint32_t corners = mesh.corner_limit(), faces = mesh.face_limit();
    const std::uint32_t triangle_guess = std::max(corners, 2 * faces) - 2 * faces;
    const std::uint32_t vertex_guess = std::max(triangle_guess, mesh.vertex_limit());
    draw_vertices_.reserve(vertex_guess + vertex_guess / 8 + slack);
    vertex_of_.reserve(vertex_guess + vertex_guess / 8 + slack);
    next_copy_.reserve(vertex_guess + vertex_guess / 8 + slack);
    triangles_.reserve(triangle_guess + slack);
    triangle_face_.reserve(triangle_guess + slack);
    resize(mesh);

    Palette palette(colours);
    std::vector<std::uint32_t> last_use(mesh.vertex_limit(), 0);
    for (const Face f : mesh.faces()) {
        face_group_.set(f.index, mesh.group(f));
        put_triangles(mesh, f, palette, &last_use, division);
    }
    for (const Vertex v : mesh.vertices())
        if (newest_[v.index] == none) copy_vertex(v.index); // ends of edges that bound no triangle

    put_edges(mesh, division);
    take_boundary(mesh);

    for (std::uint32_t block = 0; block << pick_bits < triangles_.size(); ++block) renew_box(block);
    renew_bounds();
}

void DrawLists::put_edges(const Mesh& mesh, const Division* division)
{
    if (division) edge_ends_.truncate(0);
    for (const Edge e : mesh.edges()) {
        const auto [a, b] = mesh.ends(e);
        if (division) {
            const auto [f, g] = mesh.faces(e);
            if (division->old_face[f.index] != division->old_face[g.index]) edge_ends_.push_back({a.index, b.index});
        } else {
            edge_ends_.set(e.index, {a.index, b.index});
            edge_sum_ += length(e);
        }
    }
    mean_edge_ = mesh.edge_count() > 0 ? edge_sum_ / mesh.edge_count() : 0.0;
    edge_versions_.assign((std::size_t(edge_limit()) >> block_bits) + 1, version_);
}

void DrawLists::build(const Graph& graph)
{
    Box box;
    for (const Point& p : graph.vertices) box.add(p);
    clear(box);
    for (const Point& p : graph.vertices) {
        positions_.push_back(p);
        newest_.push_back(none);
        copy_vertex(positions_.size() - 1);
    }
    for (const auto& [a, b] : graph.edges) {
        edge_ends_.push_back({a, b});
        edge_sum_ += glm::distance(graph.vertices[a], graph.vertices[b]);
    }
    mean_edge_ = graph.edges.empty() ? 0.0 : edge_sum_ / double(graph.edges.size());
    edge_versions_.assign((graph.edges.size() >> block_bits) + 1, version_);
    bounds_ = reach_ = box;
}

/// Brings the columns beside the mesh to its limits; new elements are empty.
void DrawLists::resize(const Mesh& mesh)
{
    const auto fit = [](auto& column, std::uint32_t limit, auto empty) {
        if (limit < column.size()) column.truncate(limit);
        const std::uint32_t more = limit - column.size();
        std::fill_n(column.extend(more), more, empty);
    };
    const std::uint32_t known = positions_.size();
    // The copies of vertices that are gone wait here for the next ones of these numbers.
    fit(newest_, std::max(newest_.size(), mesh.vertex_limit()), none);
    fit(positions_, mesh.vertex_limit(), Point(0.0));
    for (std::uint32_t v = known; v < positions_.size(); ++v) positions_.set(v, mesh.position(Vertex(v)));
    fit(face_triangles_, mesh.face_limit(), Range{});
    fit(face_group_, mesh.face_limit(), std::int32_t(0));
    fit(face_selected_, mesh.face_limit(), std::uint8_t(0));
    fit(edge_ends_, mesh.edge_limit(), std::array{none, none});
}

double DrawLists::length(Edge e) const
{
    const auto& [a, b] = edge_ends_[e.index];
    return a == none ? 0.0 : glm::distance(positions_[a], positions_[b]);
}

void DrawLists::take_boundary(const Mesh& mesh)
{
    boundary_sides_.clear();
    for (const Face f : mesh.boundary_faces())
        for (const Corner c : mesh.corners(f)) boundary_sides_.push_back({mesh.vertex(c).index, mesh.target(c).index});
}

// --- triangles --------------------------------------------------------------------------------------------------------------

std::uint32_t DrawLists::copy_vertex(std::uint32_t v)
{
    const std::uint32_t copy = draw_vertices_.size();
    const Vector p = positions_[v] - origin_;
    draw_vertices_.push_back({float(p.x), float(p.y), float(p.z), 0, 0});
    vertex_of_.push_back(v);
    next_copy_.push_back(newest_[v]);
    newest_.set(v, copy);
    touch(vertex_versions_, copy);
    return copy;
}

/// A copy of `v` in which no triangle ends yet, or `none`.
std::uint32_t DrawLists::unclaimed_copy(std::uint32_t v) const
{
    std::uint32_t copy = newest_[v];
    for (std::uint32_t n = 0; n < copies_looked_at && copy != none; ++n, copy = next_copy_[copy])
        if ((draw_vertices_[copy].look & DrawVertex::claimed_flag) == 0) return copy;
    return none;
}

/// Which of a triangle's vertices shall be its last: one whose newest copy is free, or else the one that would be fetched again
/// anyway because its last use is long ago. With `last_use` missing (a local update), any free copy will do.
std::size_t DrawLists::choose_last(const std::array<std::uint32_t, 3>& v, std::vector<std::uint32_t>* last_use)
{
    const auto is_free = [&](std::uint32_t copy) {
        return copy == none || (draw_vertices_[copy].look & DrawVertex::claimed_flag) == 0;
    };
    for (std::size_t k = 0; k < 3; ++k)
        if (is_free(newest_[v[k]])) return k;
    for (std::size_t k = 0; k < 3; ++k)
        if (last_use ? live_triangles_ - (*last_use)[v[k]] > cache_reach : unclaimed_copy(v[k]) != none) return k;
    return 0;
}

void DrawLists::put_triangles(const Mesh& mesh, Face f, Palette& palette, std::vector<std::uint32_t>* last_use, const Division* division)
{
    const auto& pieces = triangulator_.triangles(mesh, f);
    if (pieces.empty()) return;
    const std::uint32_t count = static_cast<std::uint32_t>(pieces.size());
    const std::uint32_t first = find_room(count);
    face_triangles_.set(f.index, {first, count});

    // Newell's normal of the polygon is the sum of those of its triangles, however it was cut.
    Vector area(0.0);
    for (const std::array<Corner, 3>& piece : pieces) {
        const Point& p = mesh.position(piece[0]);
        area += glm::cross(mesh.position(piece[1]) - p, mesh.position(piece[2]) - p);
    }
    const std::uint32_t normal = pack_normal(unit(area));
    const auto is_side = [&](Corner from, Corner to) {
        return mesh.next(from) == to && (!division || division->old_face[f.index] != division->old_face[mesh.face(mesh.opposite(from)).index]);
    };
    const std::uint32_t look =
        palette(face_group_[f.index]) | DrawVertex::claimed_flag | (face_selected_[f.index] ? DrawVertex::selected_flag : 0u);
    std::uint32_t t = first;
    for (const std::array<Corner, 3>& piece : pieces) {
        const std::array<std::uint32_t, 3> v{mesh.vertex(piece[0]).index, mesh.vertex(piece[1]).index,
                                             mesh.vertex(piece[2]).index};
        const std::size_t k = choose_last(v, last_use), k1 = (k + 1) % 3, k2 = (k + 2) % 3;

        std::uint32_t last = last_use ? newest_[v[k]] : unclaimed_copy(v[k]);
        if (last == none || (draw_vertices_[last].look & DrawVertex::claimed_flag) != 0) last = copy_vertex(v[k]);
        for (const std::size_t other : {k1, k2})
            if (newest_[v[other]] == none) copy_vertex(v[other]);
        if (last_use)
            for (const std::uint32_t used : v) (*last_use)[used] = live_triangles_;

        std::uint32_t sides = 0;
        for (std::size_t side = 0; side < 3; ++side)
            if (is_side(piece[(k + side) % 3], piece[(k + side + 1) % 3])) sides |= DrawVertex::side_flag << side;

        DrawVertex& vertex = *draw_vertices_.write(last, 1);
        vertex.normal = normal;
        vertex.look = look | sides;
        touch(vertex_versions_, last);
        triangles_.set(t, {newest_[v[k1]], newest_[v[k2]], last});
        triangle_face_.set(t, f.index);
        touch(triangle_versions_, t);
        ++t;
        ++live_triangles_;
    }
}

/// Where `count` triangles in a row can go.
std::uint32_t DrawLists::find_room(std::uint32_t count)
{
    if (count < room_.size() && !room_[count].empty()) {
        const std::uint32_t first = room_[count].back();
        room_[count].pop_back();
        return first;
    }
    const std::uint32_t first = triangles_.size();
    std::fill_n(triangles_.extend(count), count, Triangle{0, 0, 0});
    std::fill_n(triangle_face_.extend(count), count, none);
    return first;
}

/// Takes the triangles of a face away; the vertices they ended in are free for others.
void DrawLists::release(Face f)
{
    const Range range = face_triangles_[f.index];
    if (range.count == 0) return;
    for (std::uint32_t t = range.first; t < range.first + range.count; ++t) {
        const std::uint32_t last = triangles_[t][2];
        draw_vertices_.write(last, 1)->look = 0;
        touch(vertex_versions_, last);
        triangles_.set(t, {0, 0, 0});
        triangle_face_.set(t, none);
        touch(triangle_versions_, t);
    }
    live_triangles_ -= range.count;
    face_triangles_.set(f.index, {});
    if (range.count <= largest_room) {
        if (room_.size() <= range.count) room_.resize(range.count + 1);
        room_[range.count].push_back(range.first);
    }
}

// --- boxes and normals ------------------------------------------------------------------------------------------------------

void DrawLists::renew_box(std::uint32_t block)
{
    if (block >= pick_boxes_.size()) pick_boxes_.resize(block + 1);
    Box box;
    const std::uint32_t end = std::min((block + 1) << pick_bits, triangles_.size());
    for (std::uint32_t t = block << pick_bits; t < end; ++t)
        if (triangle_face_[t] != none)
            for (std::size_t k = 0; k < 3; ++k) box.add(corner(t, k));
    pick_boxes_[block] = box;
}

void DrawLists::renew_bounds()
{
    bounds_ = Box();
    for (const Box& box : pick_boxes_) {
        if (box.empty()) continue;
        bounds_.add(box.min);
        bounds_.add(box.max);
    }
    if (!has_faces())
        for (const Point& p : positions_.view()) bounds_.add(p);
    reach_ = bounds_;
}

Box DrawLists::with_copies(const Box& box) const
{
    Box all = box;
    if (box.empty()) return all;
    for (const Copy& copy : copies_) {
        all.add(copy.at(box.min));
        all.add(copy.at(box.max));
    }
    return all;
}

std::vector<std::array<std::uint32_t, 2>> DrawLists::sides(Face f) const
{
    std::vector<std::array<std::uint32_t, 2>> result;
    const Range range = triangles(f);
    for (std::uint32_t t = range.first; t < range.first + range.count; ++t) {
        const Triangle& triangle = triangles_[t];
        const std::uint32_t look = draw_vertices_[triangle[2]].look;
        for (std::size_t side = 0; side < 3; ++side)
            if (look & (DrawVertex::side_flag << side))
                result.push_back({vertex_of_[triangle[(side + 2) % 3]], vertex_of_[triangle[side]]});
    }
    return result;
}

const std::vector<std::uint32_t>& DrawLists::smooth_normals() const
{
    if (smooth_version_ == shape_version_) return smooth_normals_;
    std::vector<Vector> sum(vertex_limit(), Vector(0.0));
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
        if (triangle_face_[t] == none) continue;
        const Point p[3] = {corner(t, 0), corner(t, 1), corner(t, 2)};
        const Vector side[3] = {unit(p[1] - p[0]), unit(p[2] - p[1]), unit(p[0] - p[2])};
        const Vector normal = unit(glm::cross(side[0], side[1]));
        for (std::size_t k = 0; k < 3; ++k)
            sum[vertex_of_[triangles_[t][k]]] += std::acos(std::clamp(-glm::dot(side[k], side[(k + 2) % 3]), -1.0, 1.0)) * normal;
    }
    for (Vector& n : sum) n = unit(n);
    take_normals(sum);
    return smooth_normals_;
}

void DrawLists::take_normals(std::span<const Vector> normals) const
{
    smooth_normals_.assign(draw_vertices_.size(), 0);
    for (std::uint32_t i = 0; i < smooth_normals_.size(); ++i)
        if (vertex_of_[i] < normals.size()) smooth_normals_[i] = pack_normal(normals[vertex_of_[i]]);
    smooth_version_ = shape_version_;
}

} // namespace druse
