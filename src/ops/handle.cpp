// Curved handles: pipes one after the other along a Hermite curve.
#include "ops/handle.h"

#include "dlfl/errors.h"
#include "dlfl/patch.h"
#include "geom/angle.h"
#include "ops/group.h"
#include "ops/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace druse {

namespace {

Point mean(std::span<const Point> points)
{
    Point sum(0.0);
    for (const Point& p : points) sum += p / double(points.size());
    return sum;
}

/// Newell's normal, of length 1.
Vector normal(std::span<const Point> points)
{
    Vector sum(0.0);
    for (std::size_t i = 0; i < points.size(); ++i) sum += glm::cross(points[i] - points[0], points[(i + 1) % points.size()] - points[0]);
    return direction(sum);
}

/// Any direction square to a given one.
Vector square_to(const Vector& axis)
{
    const Vector other = std::abs(axis.x) <= std::min(std::abs(axis.y), std::abs(axis.z)) ? Vector(1, 0, 0)
                         : std::abs(axis.y) <= std::abs(axis.z)                           ? Vector(0, 1, 0)
                                                                                          : Vector(0, 0, 1);
    return unit(glm::cross(axis, other));
}

Vector mirrored(const Vector& v, const Vector& along)
{
    const double square = glm::dot(along, along);
    return square > 0 ? v - 2 * glm::dot(along, v) / square * along : v;
}

/// From 0 to 1 with level ends.
double smooth(double x) { return x * x * (3 - 2 * x); }

} // namespace

HandlePath::HandlePath(const PipeFaces& faces, const HandleShape& shape) : shape_(shape)
{
    const Point c0 = mean(faces.from_points), c1 = mean(faces.to_points);
    const double distance = glm::distance(c0, c1);
    double radius = 0;
    for (const Point& p : faces.from_points) radius = std::max(radius, glm::distance(c0, p));
    if (!(distance > 1e-12 * radius)) throw CommandError("the two faces have the same centre");
    if (shape.curve == HandleCurve::line) {
        straight(c0, c1);
    } else {
        const Vector n0 = normal(faces.from_points), n1 = normal(faces.to_points);
        for (const auto& [n, f] : {std::pair(n0, faces.from), std::pair(n1, faces.to)})
            if (n == Vector(0.0)) throw CommandError(fmt::format("face {} has no area", f.index));
        const bool look_away = glm::dot(n0, c1 - c0) < 0 && glm::dot(n1, c0 - c1) < 0;
        const bool in = shape.side == HandleSide::in || (shape.side == HandleSide::automatic && look_away);
        const double s = in ? -distance : distance;
        follow(c0, s * shape.weight * n0, c1, -s * shape.weight2 * n1);
    }
    carry_frame(faces.from_points[0] - c0);

    const auto seen = [](std::span<const Point> points, const Station& at) {
        std::vector<Point> local;
        for (const Point& p : points) {
            const Vector d = p - at.centre;
            local.emplace_back(glm::dot(d, at.x), glm::dot(d, at.y), glm::dot(d, at.axis));
        }
        return local;
    };
    from_ = seen(faces.from_points, stations_.front());
    to_ = seen(faces.to_points, stations_.back());
}

void HandlePath::straight(const Point& c0, const Point& c1)
{
    for (int k = 0; k <= shape_.segments; ++k) {
        const double u = double(k) / shape_.segments;
        stations_.push_back({(1 - u) * c0 + u * c1, direction(c1 - c0), {}, {}});
    }
}

void HandlePath::follow(const Point& c0, const Vector& t0, const Point& c1, const Vector& t1)
{
    const auto at = [&](double t) {
        const double t2 = t * t, t3 = t2 * t;
        return (2 * t3 - 3 * t2 + 1) * c0 + (t3 - 2 * t2 + t) * t0 + (3 * t2 - 2 * t3) * c1 + (t3 - t2) * t1;
    };
    const auto slope = [&](double t) { return 6 * (t - t * t) * (c1 - c0) + (3 * t * t - 4 * t + 1) * t0 + (3 * t * t - 2 * t) * t1; };

    // Arc lengths by chords, and the curve's parameter at equal ones.
    const int samples = 16 * shape_.segments;
    std::vector<double> length(std::size_t(samples) + 1, 0.0);
    Point last = c0;
    for (int k = 1; k <= samples; ++k) {
        const Point p = at(double(k) / samples);
        length[std::size_t(k)] = length[std::size_t(k) - 1] + glm::distance(last, p);
        last = p;
    }
    const double least = 1e-9 * glm::distance(c0, c1);
    std::size_t k = 1;
    for (int station = 0; station <= shape_.segments; ++station) {
        const double wanted = length.back() * station / shape_.segments;
        while (k < std::size_t(samples) && length[k] < wanted) ++k;
        const double step = length[k] - length[k - 1];
        const double t = station == 0 ? 0.0 : station == shape_.segments ? 1.0 : (double(k) - (step > 0 ? (length[k] - wanted) / step : 0.0)) / samples;
        const Vector d = slope(t);
        stations_.push_back({at(t), glm::length(d) > least ? direction(d) : Vector(0.0), {}, {}});
    }
    // Where the curve stands still, the neighbour's direction: of the next one that has any, or else of the last.
    for (std::size_t i = stations_.size() - 1; i-- > 0;)
        if (stations_[i].axis == Vector(0.0)) stations_[i].axis = stations_[i + 1].axis;
    for (std::size_t i = 1; i < stations_.size(); ++i)
        if (stations_[i].axis == Vector(0.0)) stations_[i].axis = stations_[i - 1].axis;
    if (stations_.front().axis == Vector(0.0))
        for (Station& s : stations_) s.axis = direction(c1 - c0);
}

void HandlePath::carry_frame(const Vector& first_x)
{
    const auto settle = [](Station& s, const Vector& x) {
        s.x = unit(x - glm::dot(x, s.axis) * s.axis, 1e-12 * glm::length(x), square_to(s.axis));
        s.y = glm::cross(s.axis, s.x);
    };
    settle(stations_.front(), first_x);
    for (std::size_t i = 1; i < stations_.size(); ++i) {
        // The step's mirror, then the one that brings the axis to where it must be.
        const Station& before = stations_[i - 1];
        const Vector step = stations_[i].centre - before.centre;
        const Vector x = mirrored(before.x, step), axis = mirrored(before.axis, step);
        settle(stations_[i], mirrored(x, stations_[i].axis - axis));
    }
}

std::vector<std::vector<Point>> HandlePath::rings(std::span<const Rung> rungs) const
{
    double cross = 0, dot = 0;
    for (const Rung& r : rungs) {
        const Point &p = from_[std::size_t(r.from)], &q = to_[std::size_t(r.to)];
        cross += p.x * q.y - p.y * q.x;
        dot += p.x * q.x + p.y * q.y;
    }
    const double residual = std::atan2(cross, dot);
    const auto turned = [](const Point& p, double angle) {
        const double c = std::cos(angle), s = std::sin(angle);
        return Point(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
    };
    std::vector<std::vector<Point>> result;
    for (int k = 0; k <= shape_.segments; ++k) {
        const double u = double(k) / shape_.segments;
        const double bump = smooth(u < shape_.middle ? u / shape_.middle : (1 - u) / (1 - shape_.middle));
        const double size = 1 + (shape_.scale - 1) * bump, angle = u * (residual + 2 * pi * shape_.twist);
        const Station& s = stations_[std::size_t(k)];
        std::vector<Point>& ring = result.emplace_back();
        for (const Rung& r : rungs) {
            const Point blend = (1 - u) * from_[std::size_t(r.from)] + u * turned(to_[std::size_t(r.to)], -residual);
            const Point local = size * turned(blend, angle);
            ring.push_back(s.centre + local.x * s.x + local.y * s.y + local.z * s.axis);
        }
    }
    return result;
}

namespace {

/// A band on a face with `sides` corners, and a lid over its far ring: the lid comes last, and starts at the first rung.
Patch band_with_lid(int sides, std::span<const Rung> rungs)
{
    const auto n = static_cast<int>(rungs.size());
    Patch patch(sides, n);
    std::vector<int> lid;
    for (int k = 0; k < n; ++k) {
        const int following = k + 1 < n ? k + 1 : 0;
        const int here = rungs[std::size_t(k)].from, there = rungs[std::size_t(following)].from;
        if (here == there) patch.add({here, sides + following, sides + k});
        else patch.add({here, there, sides + following, sides + k});
        lid.push_back(sides + k);
    }
    patch.add(lid);
    patch.connect();
    return patch;
}

} // namespace

std::vector<Face> create_handle(Mesh& mesh, const PipeFaces& faces, const HandlePath& path, std::span<const Rung> rungs)
{
    const std::vector<std::vector<Point>> points = path.rings(rungs);
    const auto n = static_cast<std::uint32_t>(rungs.size());
    faces.split(mesh);
    // The first face grows towards the other one, band after band, and a pipe joins them. The lid hands its id on to the band that follows it,
    // so that the ids of a band are consecutive.
    Face end = faces.from;
    std::vector<Rung> band(rungs.begin(), rungs.end());
    std::vector<Face> walls;
    std::optional<Patch> patch;
    for (int segment = 1; segment < path.segments(); ++segment) {
        if (segment <= 2) patch = band_with_lid(mesh.valence(end), band);
        std::ranges::copy(points[std::size_t(segment)], mesh.vertex_room(n).begin());
        const std::uint32_t first = mesh.face_limit();
        mesh.replace_face(end, *patch);
        walls.push_back(end);
        for (std::uint32_t k = 1; k < n; ++k) walls.emplace_back(first + k - 1);
        end = Face(first + n - 1);
        for (std::uint32_t k = 0; k < n; ++k) band[k].from = static_cast<int>(k);
    }
    PipeMaker(mesh).create(mesh.corner(end), mesh.corner(faces.to), band, walls);
    return walls;
}

std::vector<int> tight_stations(const HandlePath& path, const std::vector<std::vector<Point>>& rings)
{
    std::vector<int> tight;
    for (int k = 1; k <= path.segments(); ++k) {
        const auto &ring = rings[std::size_t(k)], &before = rings[std::size_t(k) - 1];
        for (std::size_t i = 0; i < ring.size(); ++i)
            if (glm::dot(ring[i] - before[i], path.axis(k)) <= 0) {
                tight.push_back(k);
                break;
            }
    }
    return tight;
}

// --- registration ---------------------------------------------------------------------------------------------------------------

namespace {

struct HandleParameters : PipeEnds, HandleShape {};

/// A handle as it is planned.
struct Plan {
    PipeFaces faces;
    HandlePath path;
    std::vector<Rung> rungs;

    Plan(const Mesh& mesh, const PipeEnds& ends, const HandleShape& shape, Progress& progress)
        : faces(mesh, ends), path(faces, shape), rungs(pair_corners(path.from_points(), path.to_points(), faces.pairing, progress))
    {
        if (shape.segments == 1) require_apart(mesh, faces.from, faces.to);
    }
};

void run_handle(Scene& scene, const HandleParameters& p, Context& context)
{
    const auto [faces, path, rungs] = Plan(scene.mesh, p, p, context.progress);
    if (const std::vector<int> tight = tight_stations(path, path.rings(rungs)); !tight.empty()) {
        std::vector<std::string> numbers;
        for (const int k : tight) numbers.push_back(std::to_string(k));
        context.note(fmt::format("the handle bends more tightly than it is wide at station{} {}", tight.size() == 1 ? "" : "s", listing(numbers, "and")));
    }
    const int group = first_new_group(scene.mesh, 1);
    select_walls(scene, create_handle(scene.mesh, faces, path, rungs), group);
}

} // namespace

std::vector<std::array<Point, 2>> preview_handle(const Mesh& mesh, const PipeEnds& ends, const HandleShape& shape, Progress& progress)
{
    const Plan plan(mesh, ends, shape, progress);
    const std::vector<std::vector<Point>> rings = plan.path.rings(plan.rungs);
    std::vector<std::array<Point, 2>> lines;
    for (std::size_t k = 1; k < rings.size(); ++k)
        for (std::size_t i = 0; i < rings[k].size(); ++i) lines.push_back({rings[k - 1][i], rings[k][i]});
    return lines;
}

Operator handle_operator()
{
    using P = HandleParameters;
    auto definition = define<P>("topology.handle", "Join two faces by a curved handle, or a curved hole");
    add_pipe_ends(definition);
    definition.param(&P::segments, "segments", Unit::count, {1, 256}, "how many bands along the handle")
        .param(&P::curve, "curve", words({"hermite", "line"}), "what its middle follows")
        .param(&P::weight, "weight", Unit::ratio, {-8, 8}, "how far it leaves the first face straight, in distances of the faces; negative: inward first")
        .param(&P::weight2, "weight2", Unit::ratio, {-8, 8}, "the same at the second face")
        .param(&P::side, "side", words({"auto", "out", "in"}), "outside the solid or through it; auto: through it where the faces look away from each other")
        .param(&P::twist, "twist", Unit::count, {-16, 16}, "whole turns more about its middle")
        .param(&P::scale, "scale", Unit::ratio, {0.05, 10}, "its size in the middle")
        .param(&P::middle, "middle", Unit::ratio, {0.05, 0.95}, "where along it that size is reached")
        .example("topology.handle from=0 to=5 segments=6 weight=2")
        .cites("Srinivasan, Akleman & Chen 2002; Wang, Jüttler, Zheng & Liu 2008")
        .euler_change(-2)
        .run(run_handle);
    return definition;
}

std::vector<std::array<Point, 2>> preview_band(const Operator& op, const void* parameters, const Mesh& mesh, Progress& progress)
{
    if (op.name == "topology.pipe") return preview_pipe(mesh, *static_cast<const PipeParameters*>(parameters), progress);
    if (op.name != "topology.handle") return {};
    const auto& p = *static_cast<const HandleParameters*>(parameters);
    return preview_handle(mesh, p, p, progress);
}

} // namespace druse
