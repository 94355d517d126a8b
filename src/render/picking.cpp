#include "render/picking.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace druse {

namespace {

/// Whether the ray enters the box before `nearest`. The box is taken a little larger, so that rounding loses no triangle.
bool meets(const Ray& ray, const Vector& inverse, const Box& box, double nearest, double tolerance)
{
    double enter = 0, leave = nearest;
    for (int axis = 0; axis < 3; ++axis) {
        double from = (box.min[axis] - tolerance - ray.origin[axis]) * inverse[axis];
        double to = (box.max[axis] + tolerance - ray.origin[axis]) * inverse[axis];
        if (from > to) std::swap(from, to);
        // Written so that 0 · ∞ (a ray along a side of the box) leaves the interval as it is.
        if (from > enter) enter = from;
        if (to < leave) leave = to;
    }
    return enter <= leave;
}

struct TriangleHit {
    double distance;
    bool from_behind;
};

std::optional<TriangleHit> meet(const Ray& ray, const Point& a, const Point& b, const Point& c)
{
    constexpr double slack = 1e-12; // of barycentric coordinates: both faces beside a side own it
    const Vector ab = b - a, ac = c - a;
    const Vector p = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0) return std::nullopt;
    const Vector from_a = ray.origin - a;
    const double u = glm::dot(from_a, p) / determinant;
    if (u < -slack || u > 1 + slack) return std::nullopt;
    const Vector q = glm::cross(from_a, ab);
    const double v = glm::dot(ray.direction, q) / determinant;
    if (v < -slack || u + v > 1 + slack) return std::nullopt;
    const double distance = glm::dot(ac, q) / determinant;
    if (!(distance >= 0)) return std::nullopt;
    return TriangleHit{distance, determinant < 0};
}

/// Distance in the picture from `p` to the segment a b.
double distance_to(const Point2& p, const Point2& a, const Point2& b)
{
    const Point2 ab = b - a;
    const double square = glm::dot(ab, ab);
    const double t = square > 0 ? std::clamp(glm::dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * ab);
}

/// The first face met before `nearest`, copies left aside.
std::optional<FaceHit> pick_first(const DrawLists& lists, const Ray& ray, double nearest)
{
    const Vector inverse = 1.0 / ray.direction;
    const double reach =
        std::max({1.0, glm::length(lists.bounds().min), glm::length(lists.bounds().max), glm::length(ray.origin)});
    const double tolerance = 1e-12 * reach;
    std::optional<FaceHit> best;
    if (!meets(ray, inverse, lists.bounds(), nearest + tolerance, tolerance)) return best;
    const std::span<const Box> boxes = lists.pick_boxes();
    const std::uint32_t count = static_cast<std::uint32_t>(lists.triangles().size());
    for (std::uint32_t block = 0; block < boxes.size(); ++block) {
        if (boxes[block].empty() || !meets(ray, inverse, boxes[block], nearest + tolerance, tolerance)) continue;
        const std::uint32_t end = std::min((block + 1) << DrawLists::pick_bits, count);
        for (std::uint32_t t = block << DrawLists::pick_bits; t < end; ++t) {
            const Face face = lists.face(t);
            if (!face.valid()) continue;
            const auto hit = meet(ray, lists.corner(t, 0), lists.corner(t, 1), lists.corner(t, 2));
            if (!hit) continue;
            // Two faces that meet in the point are met at distances that differ by rounding only.
            const bool same = best && std::abs(hit->distance - nearest) <= tolerance;
            if (same ? face >= best->face : hit->distance >= nearest) continue;
            nearest = same ? std::min(nearest, hit->distance) : hit->distance;
            best = FaceHit{face, ray.origin + hit->distance * ray.direction, hit->distance, hit->from_behind};
        }
    }
    return best;
}

} // namespace

std::optional<FaceHit> pick_face(const DrawLists& lists, const Ray& ray)
{
    std::optional<FaceHit> best = pick_first(lists, ray, std::numeric_limits<double>::infinity());
    for (std::uint32_t k = 0; k < lists.copies().size(); ++k) {
        // As the copy is to the lists, the ray is to one that meets them, whose distances are shorter by the scale.
        const DrawLists::Copy& copy = lists.copies()[k];
        const Ray there{(ray.origin - copy.shift) / copy.scale, ray.direction};
        const double limit = best ? best->distance / copy.scale : std::numeric_limits<double>::infinity();
        if (auto hit = pick_first(lists, there, limit))
            best = FaceHit{hit->face, copy.at(hit->point), copy.scale * hit->distance, hit->from_behind, k + 1};
    }
    return best;
}

std::optional<Edge> pick_edge(const DrawLists& lists, const Camera& camera, double x, double y)
{
    const Point2 pointer(x, y);
    double nearest = pick_radius;
    const auto measure = [&](std::uint32_t a, std::uint32_t b) {
        const auto p = camera.project(lists.position(a)), q = camera.project(lists.position(b));
        return p && q ? distance_to(pointer, *p, *q) : std::numeric_limits<double>::infinity();
    };
    std::optional<Edge> best;
    if (const auto hit = pick_face(lists, camera.ray(x, y))) {
        if (hit->copy > 0) return best;
        std::array<std::uint32_t, 2> side{DrawLists::none, DrawLists::none};
        for (const auto& ends : lists.sides(hit->face)) {
            const double away = measure(ends[0], ends[1]);
            if (away > nearest) continue;
            nearest = away;
            side = ends;
        }
        if (side[0] == DrawLists::none) return best;
        const std::array<std::uint32_t, 2> reversed{side[1], side[0]};
        for (std::uint32_t e = 0; e < lists.edge_limit(); ++e)
            if (lists.edges()[e] == side || lists.edges()[e] == reversed) return Edge(e);
        return best;
    }
    for (std::uint32_t e = 0; e < lists.edge_limit(); ++e) {
        const auto& [a, b] = lists.edges()[e];
        if (a == DrawLists::none) continue;
        const double away = measure(a, b);
        if (away > nearest || (best && away == nearest)) continue;
        nearest = away;
        best = Edge(e);
    }
    return best;
}

std::optional<Vertex> pick_vertex(const DrawLists& lists, const Camera& camera, double x, double y)
{
    const Point2 pointer(x, y);
    double nearest = pick_radius;
    std::optional<Vertex> best;
    const auto consider = [&](std::uint32_t v) {
        const auto p = camera.project(lists.position(v));
        if (!p) return;
        const double away = glm::distance(pointer, *p);
        if (away > nearest || (best && away == nearest && best->index <= v)) return;
        nearest = away;
        best = Vertex(v);
    };
    if (const auto hit = pick_face(lists, camera.ray(x, y))) {
        if (hit->copy > 0) return best;
        const DrawLists::Range range = lists.triangles(hit->face);
        for (std::uint32_t t = range.first; t < range.first + range.count; ++t)
            for (const std::uint32_t copy : lists.triangles()[t]) consider(lists.vertex_of(copy));
        return best;
    }
    for (std::uint32_t v = 0; v < lists.vertex_limit(); ++v) consider(v);
    return best;
}

} // namespace druse
