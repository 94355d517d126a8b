#include "graph/strut_surface.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "geom/angle.h"
#include "geom/do_both.h"
#include "graph/strut_ball.h"
#include "graph/strut_rim.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace druse {

namespace {

constexpr std::uint32_t worth_a_thread = 512; // ends of edges

class SurfaceMaker {
public:
    SurfaceMaker(const Graph& graph, const Incidence& incidence, const StrutPlacer& placer, const StrutPlacement& placement, const StrutShape& shape,
                 Progress& progress)
        : graph_(graph), incidence_(incidence), placer_(placer), placement_(placement), shape_(shape), progress_(progress),
          rim_placer_(graph, placer, shape), n_(static_cast<std::uint32_t>(shape.sides)), ends_(static_cast<std::uint32_t>(2 * graph.edges.size())),
          rims_(std::size_t(n_) * ends_)
    {
    }

    StrutSurface make();

private:
    void check_sizes() const;
    void place_rims(std::uint32_t from, std::uint32_t to);
    void make_balls(std::uint32_t from, std::uint32_t to, BallFaces& out);
    void put_balls(const BallFaces& faces, std::uint32_t apexes_before);
    void put_struts();
    void put_cap(std::uint32_t v);
    void put_ring(std::uint32_t end, const Point& center, double radius);
    void put(std::initializer_list<std::uint32_t> ring, int group) { builder_.add_face(std::span(ring.begin(), ring.size()), group); }
    void put_band(std::uint32_t a, std::uint32_t b, int group, int diagonal);

    const Graph& graph_;
    const Incidence& incidence_;
    const StrutPlacer& placer_;
    const StrutPlacement& placement_;
    const StrutShape& shape_;
    Progress& progress_;
    RimPlacer rim_placer_;
    std::uint32_t n_, ends_;
    std::vector<Point> rims_;
    MeshBuilder builder_;
};

/// So that the corners of polygons stay apart when they are rounded, and those of the rings of a round cap, which are half as large.
void SurfaceMaker::check_sizes() const
{
    constexpr double steps = 8;
    const double side = 2 * std::sin(pi / n_); // of a polygon, in radii
    for (std::uint32_t end = 0; end < ends_; ++end) {
        const std::uint32_t v = graph_.edges[end / 2][end % 2];
        const double radius = placement_.ends[end].radius;
        if (radius >= StrutPlacement::least_size && radius * side >= steps * CoordinateGrid(graph_.vertices[v], placement_.reach[v]).step()) continue;
        throw CommandError(fmt::format("{}: its {} too thin{}", placer_.vertex_name(v), incidence_.valence(v) == 1 ? "strut is" : "struts are",
                                       radius >= StrutPlacement::least_size ? " for coordinates of that size" : ""));
    }
}

void SurfaceMaker::place_rims(std::uint32_t from, std::uint32_t to)
{
    for (std::uint32_t e = from; e < to; ++e) rim_placer_.place(placement_, e, rims_.data() + std::size_t(2) * n_ * e);
}

void SurfaceMaker::make_balls(std::uint32_t from, std::uint32_t to, BallFaces& out)
{
    BallMaker maker(graph_, incidence_, placer_, placement_, shape_, rims_, progress_);
    std::uint64_t ends = 0;
    for (std::uint32_t v = from; v < to; ++v) ends += incidence_.valence(v);
    const std::uint64_t corners = ends * n_;
    out.corners.reserve(3 * (corners + 2 * ends)); // of as many triangles as the hull has without what lies in polygons
    out.ends.reserve(corners + 2 * ends);
    out.ball_ends.reserve(to - from);
    for (std::uint32_t v = from; v < to; ++v) {
        if (v % 64 == 0) progress_.step(0.1 + 0.6 * double(v - from) / (to - from));
        if (incidence_.valence(v) > 1) maker.make(v, out);
        else out.ball_ends.push_back(static_cast<std::uint32_t>(out.ends.size()));
    }
}

void SurfaceMaker::put_balls(const BallFaces& faces, std::uint32_t apexes_before)
{
    std::uint32_t begin = 0;
    const std::uint32_t first_apex = n_ * ends_ + apexes_before;
    for (const std::uint32_t end : faces.ends) {
        for (; begin < end; ++begin) {
            const std::uint32_t c = faces.corners[begin];
            builder_.add_corner(c & BallFaces::apex ? first_apex + (c ^ BallFaces::apex) : c);
        }
        builder_.end_face(strut_group::ball);
    }
}

/// A band between two rings of vertices from a and from b on, which it leaves on its left and on its right. A diagonal cuts each quad: 1 from the
/// earlier corner on a, −1 from the later one, 0 none.
void SurfaceMaker::put_band(std::uint32_t a, std::uint32_t b, int group, int diagonal)
{
    for (std::uint32_t k = 0; k < n_; ++k) {
        const std::uint32_t l = k + 1 < n_ ? k + 1 : 0;
        if (diagonal == 0) {
            put({a + k, a + l, b + l, b + k}, group);
        } else if (diagonal > 0) {
            put({a + k, a + l, b + l}, group);
            put({a + k, b + l, b + k}, group);
        } else {
            put({a + k, a + l, b + k}, group);
            put({a + l, b + l, b + k}, group);
        }
    }
}

void SurfaceMaker::put_struts()
{
    const std::uint32_t edges = ends_ / 2;
    for (std::uint32_t e = 0; e < edges; ++e) {
        if (e % 1024 == 0) progress_.step(0.75 + 0.1 * double(e) / edges);
        const std::uint32_t a = 2 * e * n_, b = a + n_;
        const int diagonal = rim_placer_.diagonal(rims_.data() + a, rims_.data() + b);
        put_band(a, b, strut_group::strut, diagonal == 0 && shape_.triangulate ? 1 : diagonal);
    }
}

void SurfaceMaker::put_ring(std::uint32_t end, const Point& center, double radius)
{
    const StrutAxes axes = strut_axes(graph_, placer_, shape_.frame, end / 2);
    for (const Point2& step : rim_placer_.circle(end))
        builder_.add_vertex(center + radius * (step.x * axes.f + step.y * axes.g));
}

void SurfaceMaker::put_cap(std::uint32_t v)
{
    const std::uint32_t end = incidence_.ends(v)[0], rim = end * n_;
    const bool first = end % 2 == 0;
    const Vector out = first ? -placer_.direction(end / 2) : placer_.direction(end / 2); // from the strut to the vertex and on
    const auto before = [this](std::uint32_t k) { return k > 0 ? k - 1 : n_ - 1; };
    const auto after = [this](std::uint32_t k) { return k + 1 < n_ ? k + 1 : 0; };
    const auto put_cone = [&](std::uint32_t ring, std::uint32_t pole) {
        for (std::uint32_t k = 0; k < n_; ++k) {
            if (first) put({ring + k, pole, ring + after(k)}, strut_group::cap);
            else put({ring + k, ring + after(k), pole}, strut_group::cap);
        }
    };
    switch (shape_.cap) {
    case StrutCap::flat:
        if (shape_.triangulate) {
            for (std::uint32_t k = 1; k + 1 < n_; ++k) {
                if (first) put({rim, rim + k + 1, rim + k}, strut_group::cap);
                else put({rim, rim + k, rim + k + 1}, strut_group::cap);
            }
        } else {
            for (std::uint32_t k = 0, i = 0; i < n_; ++i, k = first ? before(k) : after(k)) builder_.add_corner(rim + k);
            builder_.end_face(strut_group::cap);
        }
        break;
    case StrutCap::point: put_cone(rim, builder_.add_vertex(graph_.vertices[v])); break;
    case StrutCap::round: {
        const double r = placement_.ends[end].radius;
        const Point center = graph_.vertices[v] - r * out;
        std::uint32_t last = rim;
        for (const double angle : {30, 60}) {
            const std::uint32_t ring = builder_.vertex_count();
            put_ring(end, center + r * std::sin(radians(angle)) * out, r * std::cos(radians(angle)));
            const int diagonal = shape_.triangulate ? 1 : 0;
            if (first) put_band(ring, last, strut_group::cap, diagonal);
            else put_band(last, ring, strut_group::cap, diagonal);
            last = ring;
        }
        put_cone(last, builder_.add_vertex(graph_.vertices[v]));
        break;
    }
    }
}

StrutSurface SurfaceMaker::make()
{
    const auto vertices = static_cast<std::uint32_t>(graph_.vertices.size());
    const bool apart = ends_ > worth_a_thread;
    progress_.step(0);
    check_sizes();
    do_both(apart, [&] { place_rims(0, ends_ / 4); }, [&] { place_rims(ends_ / 4, ends_ / 2); });
    std::uint32_t middle = 0; // about half of the edges' ends lie at vertices before
    for (std::uint32_t sum = 0; middle < vertices && sum < ends_ / 2; ++middle) sum += incidence_.valence(middle);
    std::array<BallFaces, 2> balls;
    do_both(apart, [&] { make_balls(0, middle, balls[0]); }, [&] { make_balls(middle, vertices, balls[1]); });

    StrutSurface result;
    StrutTable& table = result.table;
    const std::size_t corners = balls[0].corners.size() + balls[1].corners.size() + 4 * rims_.size();
    builder_.reserve(static_cast<std::uint32_t>(rims_.size() + balls[0].apexes.size() + balls[1].apexes.size()),
                     static_cast<std::uint32_t>(balls[0].ends.size() + balls[1].ends.size() + rims_.size()), static_cast<std::uint32_t>(corners));
    for (const Point& p : rims_) builder_.add_vertex(p);
    for (const BallFaces& half : balls)
        for (const Point& p : half.apexes) builder_.add_vertex(p);
    std::uint32_t apexes = 0;
    for (BallFaces& half : balls) {
        const std::uint32_t before = builder_.face_count();
        for (const std::uint32_t end : half.ball_ends) table.ball_ends.push_back(before + end);
        put_balls(half, apexes);
        apexes += static_cast<std::uint32_t>(half.apexes.size());
        half = {}; // gives its memory back
    }
    const std::uint32_t before_struts = builder_.face_count();
    put_struts();
    const std::uint32_t before_caps = builder_.face_count();
    for (std::uint32_t v = 0; v < vertices; ++v) {
        if (incidence_.valence(v) == 1) put_cap(v);
        table.cap_ends.push_back(builder_.face_count() - before_caps);
    }
    table.per_strut = (before_caps - before_struts) / (ends_ / 2);
    rims_ = {};
    progress_.step(0.9);
    result.mesh = builder_.build(); // which sees to it that each side has one against it, and each vertex one rotation
    const auto& [made_vertices, made_edges, made_faces] = result.mesh.counts();
    ASSERT(std::int64_t(made_vertices) - made_edges + made_faces == 2 * (std::int64_t(vertices) - ends_ / 2), "genus E - V + C of struts in C components");
    table.vertex_ids.resize(vertices);
    table.edge_ids.resize(ends_ / 2);
    std::iota(table.vertex_ids.begin(), table.vertex_ids.end(), 0u);
    std::iota(table.edge_ids.begin(), table.edge_ids.end(), 0u);
    table.hold(result.mesh);
    return result;
}

} // namespace

std::uint64_t count_edges(const Graph& graph, const Incidence& incidence, const StrutShape& shape)
{
    // Of the surface in triangles, with an apex at each vertex at most: 3/2 of 4 (sides + 1) E − 4 V + 2 A. Its bands are cut in two or not.
    const std::uint64_t sides = static_cast<std::uint64_t>(shape.sides), edges = graph.edges.size(), vertices = graph.vertices.size();
    std::uint64_t leaves = 0;
    for (std::size_t v = 0; v < vertices; ++v) leaves += incidence.valence(v) == 1;
    const std::uint64_t rounds = shape.cap == StrutCap::round ? 6 * sides * leaves : 0;
    return 6 * (sides + 1) * edges - 3 * vertices - (shape.triangulate || shape.twist != 0 ? 0 : sides * edges) + rounds;
}

StrutSurface strut_surface(const Graph& graph, const Incidence& incidence, const StrutPlacer& placer, const StrutPlacement& placement,
                           const StrutShape& shape, Progress& progress)
{
    return SurfaceMaker(graph, incidence, placer, placement, shape, progress).make();
}

} // namespace druse
