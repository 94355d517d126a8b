// CreatePipe: a band in place of two faces.
#include "ops/pipe.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_tables.h"
#include "ops/group.h"
#include "ops/handle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse {

Corner corner_from(const Mesh& mesh, Edge e, Vertex v)
{
    const Corner c = mesh.corner(e, 0);
    return mesh.vertex(c) == v ? c : mesh.corner(e, 1);
}

Corner split_side(Mesh& mesh, Corner out, const Point& p)
{
    // The side goes, and its two halves come: the first one is put up like an antenna, the second one parts the faces again.
    const Edge e = mesh.edge(out);
    const Corner back = mesh.opposite(out);
    const Face left = mesh.face(out), right = mesh.face(back);
    const Vertex u = mesh.vertex(out), w = mesh.vertex(back);
    struct Side {
        Edge edge;
        Vertex from;
    };
    const auto side = [&mesh](Corner c) { return Side{mesh.edge(c), mesh.vertex(c)}; };
    const Side left_start = side(mesh.corner(left)), right_start = side(mesh.corner(right)), after = side(mesh.next(out));
    const int left_group = mesh.group(left), right_group = mesh.group(right);

    const Vertex v = mesh.create_vertex(p);
    const Edge first_half = mesh.insert_edge(out, mesh.corner(v));
    mesh.delete_edge(e);
    mesh.set_start(left < right ? corner_from(mesh, first_half, u) : mesh.next(mesh.corner(v))); // the part that keeps the lower id
    const Edge second_half = mesh.insert_edge(mesh.corner(v), corner_from(mesh, after.edge, after.from));

    mesh.set_group(left, left_group);
    mesh.set_group(right, right_group);
    const auto start = [&](const Side& s) {
        const Edge now = s.edge != e ? s.edge : s.from == u ? first_half : second_half;
        mesh.set_start(corner_from(mesh, now, s.from));
    };
    start(left_start);
    start(right_start);
    const Corner made = corner_from(mesh, second_half, v);
    ASSERT(mesh.face(made) == left && mesh.target(made) == w && mesh.vertex(mesh.previous(made)) == u, "two halves in place of a side");
    return made;
}

// --- CreatePipe -------------------------------------------------------------------------------------------------------------------

void PipeMaker::read(Corner from, Corner to)
{
    const auto fill = [this](std::vector<Corner>& corners, Corner first) {
        corners.clear();
        Corner c = first;
        do {
            corners.push_back(c);
            c = mesh_.next(c);
        } while (c != first);
    };
    fill(from_, from);
    fill(to_, to);
}

void PipeMaker::create(Corner from, Corner to, std::span<const Rung> rungs, std::vector<Face>& walls)
{
    read(from, to);
    MeshTables::join_faces(mesh_, from_, to_, rungs, walls);
}

void PipeMaker::create_facing(Corner from, Corner to, std::vector<Face>& walls)
{
    read(from, to);
    const auto n = static_cast<int>(from_.size());
    ASSERT(to_.size() == from_.size(), "faces with equally many corners");
    if (facing_.size() != from_.size()) {
        facing_.clear();
        for (int i = 0; i < n; ++i) facing_.push_back({i, i > 0 ? n - i : 0});
    }
    MeshTables::join_faces(mesh_, from_, to_, facing_, walls);
}

// --- what can be joined -----------------------------------------------------------------------------------------------------------

namespace {

constexpr int small = 8; // corners that are compared each with each

Vertex twice_in(const Mesh& mesh, Face f, int n)
{
    if (n <= small) {
        for (Corner c = mesh.corner(f); n-- > 1; c = mesh.next(c)) {
            Corner d = mesh.next(c);
            for (int i = 0; i < n; ++i, d = mesh.next(d))
                if (mesh.vertex(c) == mesh.vertex(d)) return mesh.vertex(c);
        }
        return {};
    }
    std::vector<Vertex> vertices;
    for (const Corner c : mesh.corners(f)) vertices.push_back(mesh.vertex(c));
    std::ranges::sort(vertices);
    const auto twice = std::ranges::adjacent_find(vertices);
    return twice != vertices.end() ? *twice : Vertex();
}

/// The first vertex of `to` that is one of `from` too.
Vertex shared(const Mesh& mesh, Face from, Face to)
{
    if (mesh.valence(from) <= small) {
        for (const Corner c : mesh.corners(to))
            for (const Corner d : mesh.corners(from))
                if (mesh.vertex(c) == mesh.vertex(d)) return mesh.vertex(c);
        return {};
    }
    std::vector<Vertex> vertices;
    for (const Corner c : mesh.corners(from)) vertices.push_back(mesh.vertex(c));
    std::ranges::sort(vertices);
    for (const Corner c : mesh.corners(to))
        if (std::ranges::binary_search(vertices, mesh.vertex(c))) return mesh.vertex(c);
    return {};
}

/// Ascending, without repeats.
void sort_faces(std::vector<Face>& faces, const Mesh& mesh)
{
    if (faces.size() < mesh.face_limit() / 64) {
        std::ranges::sort(faces);
        faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
        return;
    }
    std::vector<bool> there(mesh.face_limit(), false);
    for (const Face f : faces) there[f.index] = true;
    faces.clear();
    for (std::uint32_t f = 0; f < mesh.face_limit(); ++f)
        if (there[f]) faces.emplace_back(f);
}

} // namespace

void require_pipe_end(const Mesh& mesh, Face f)
{
    const int n = mesh.valence(f);
    if (n < 3) throw CommandError(fmt::format("face {} has {} side{}", f.index, n, n == 1 ? "" : "s"));
    if (const Vertex v = twice_in(mesh, f, n); v.valid()) throw CommandError(fmt::format("face {} visits vertex {} twice", f.index, v.index));
}

void require_apart(const Mesh& mesh, Face from, Face to)
{
    if (from == to) throw CommandError(fmt::format("from and to are the same face {}", from.index));
    if (const Vertex v = shared(mesh, from, to); v.valid()) throw CommandError(fmt::format("faces {} and {} share vertex {}", from.index, to.index, v.index));
}

void select_walls(Scene& scene, std::vector<Face> walls, int group)
{
    for (const Face f : walls) scene.mesh.set_group(f, group);
    sort_faces(walls, scene.mesh);
    scene.selection = Selection{std::move(walls), {}, {}};
}

// --- as commands say it -------------------------------------------------------------------------------------------------------

namespace {

/// Halves the longest of the distances between points in a circle until there are `n`. The sides it halves, each counted with what came before.
std::vector<int> split_longest(std::vector<Point>& points, std::size_t n)
{
    std::vector<int> sides;
    std::vector<double> lengths;
    for (std::size_t i = 0; i < points.size(); ++i) lengths.push_back(glm::distance(points[i], points[(i + 1) % points.size()]));
    while (points.size() < n) {
        const auto longest = std::ranges::max_element(lengths);
        const auto at = static_cast<std::size_t>(longest - lengths.begin());
        const Point middle = 0.5 * points[at] + 0.5 * points[(at + 1) % points.size()];
        *longest *= 0.5;
        lengths.insert(longest, *longest);
        points.insert(points.begin() + std::ptrdiff_t(at) + 1, middle);
        sides.push_back(static_cast<int>(at));
    }
    return sides;
}

void require_corner(Face f, int sides, int corner)
{
    if (corner >= sides) throw CommandError(fmt::format("corners: face {} has corners 0 to {}, not {}", f.index, sides - 1, corner));
}

} // namespace

PipeFaces::PipeFaces(const Mesh& mesh, const PipeEnds& ends) : from(ends.from.resolve(mesh)), to(ends.to.resolve(mesh))
{
    if (from == to) throw CommandError(fmt::format("from and to are the same face {}", from.index));
    require_pipe_end(mesh, from);
    require_pipe_end(mesh, to);
    for (const Corner c : mesh.corners(from)) from_points.push_back(mesh.position(c));
    for (const Corner c : mesh.corners(to)) to_points.push_back(mesh.position(c));
    const auto n = static_cast<int>(from_points.size()), m = static_cast<int>(to_points.size());
    if (n != m && ends.unequal == Unequal::error)
        throw CommandError(fmt::format("face {} has {} sides, face {} has {} (unequal=error)", from.index, n, to.index, m));
    if (n != m && ends.shift != 0)
        throw CommandError(fmt::format("shift={}: face {} has {} sides, face {} has {}", ends.shift, from.index, n, to.index, m));
    pairing.shift = ends.shift;
    if (ends.corners.word.empty()) {
        pairing.first = ends.corners.value;
        require_corner(from, n, (*pairing.first)[0]);
        require_corner(to, m, (*pairing.first)[1]);
    }
    if (n == m || ends.unequal != Unequal::split) return;

    std::vector<Point>& fewer = n < m ? from_points : to_points;
    splits_ = split_longest(fewer, std::max(from_points.size(), to_points.size()));
    if (!pairing.first) return;
    int& corner = (*pairing.first)[n < m ? 0 : 1];
    for (const int side : splits_)
        if (side < corner) ++corner;
}

void PipeFaces::split(Mesh& mesh) const
{
    if (splits_.empty()) return;
    const Face face = from_points.size() - splits_.size() == std::size_t(mesh.valence(from)) ? from : to;
    const std::vector<Point>& points = face == from ? from_points : to_points;
    // The points that come, in the order in which they do.
    std::vector<int> order(points.size() - splits_.size(), -1);
    for (std::size_t k = 0; k < splits_.size(); ++k) order.insert(order.begin() + splits_[k] + 1, static_cast<int>(k));
    std::vector<Point> made(splits_.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        if (order[i] >= 0) made[std::size_t(order[i])] = points[i];
    for (std::size_t k = 0; k < splits_.size(); ++k) {
        const Corner out = mesh.corner(face, splits_[k]);
        if (mesh.is_on_boundary(mesh.edge(out)))
            throw CommandError(fmt::format("edge {} lies on an open boundary and cannot be split", mesh.edge(out).index));
        split_side(mesh, out, made[k]);
    }
}

std::vector<std::array<Point, 2>> preview_pipe(const Mesh& mesh, const PipeEnds& ends, Progress& progress)
{
    const PipeFaces faces(mesh, ends);
    require_apart(mesh, faces.from, faces.to);
    std::vector<std::array<Point, 2>> lines;
    for (const Rung& r : pair_corners(faces.from_points, faces.to_points, faces.pairing, progress))
        lines.push_back({faces.from_points[std::size_t(r.from)], faces.to_points[std::size_t(r.to)]});
    return lines;
}

namespace {

void run_pipe(Scene& scene, const PipeParameters& p, Context& context)
{
    const PipeFaces faces(scene.mesh, p);
    require_apart(scene.mesh, faces.from, faces.to);
    const std::vector<Rung> rungs = pair_corners(faces.from_points, faces.to_points, faces.pairing, context.progress);
    const int group = first_new_group(scene.mesh, 1);
    if (p.segments > 1) {
        HandleShape straight;
        straight.segments = p.segments;
        straight.curve = HandleCurve::line;
        const HandlePath path(faces, straight);
        select_walls(scene, create_handle(scene.mesh, faces, path, rungs), group);
        return;
    }
    Mesh& mesh = scene.mesh;
    faces.split(mesh);
    std::vector<Face> walls;
    PipeMaker(mesh).create(mesh.corner(faces.from), mesh.corner(faces.to), rungs, walls);
    select_walls(scene, std::move(walls), group);
}

} // namespace

Operator pipe_operator()
{
    auto definition = define<PipeParameters>("topology.pipe", "Take two faces away and join their boundaries by a band: a handle, or one component of two");
    add_pipe_ends(definition);
    definition.param(&PipeParameters::segments, "segments", Unit::count, {1, 256}, "how many bands one after the other")
        .example("topology.pipe from=0 to=5")
        .cites("Akleman, Chen & Srinivasan 2003; Fuchs, Kedem & Uselton 1977")
        .euler_change(-2)
        .run(run_pipe);
    return definition;
}

} // namespace druse
