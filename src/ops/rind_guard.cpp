// How thick a crust may be: where a corner of a face would turn over, and where opposite walls would meet.
#include "dlfl/measures.h"
#include "dlfl/ray_cast.h"
#include "dlfl/triangulate.h"
#include "geom/do_both.h"
#include "geom/infinity.h"
#include "geom/sort_unique.h"
#include "ops/rind.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace druse {

namespace {

/// The least t > 0 at which c + b t + a t² is 0, for c > 0. Roots that rounding has parted, or made vanish, count as one.
double least_positive_root(double a, double b, double c)
{
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < -1e-9 * b * b) return infinity;
    const double q = -0.5 * (b + std::copysign(std::sqrt(std::max(0.0, discriminant)), b));
    double least = infinity;
    for (const double root : {q / a, c / q})
        if (root > 0 && root < least) least = root; // neither for 0/0
    return least;
}

constexpr double straight_sine = 1e-9;

/// The thickness at which the first corner of a face turns over, seen along the face's normal. Reflex and straight corners do no harm.
template <class Moves>
ThicknessLimit first_turn(const Mesh& mesh, Moves&& moves, Progress& progress)
{
    ThicknessLimit least;
    for (const Face f : mesh.faces()) {
        if (f.index % 4096 == 0 && progress.cancelled()) throw Cancelled();
        const Vector n = unit_normal(mesh, f);
        for (const Corner b : mesh.corners(f)) {
            const Corner a = mesh.previous(b), c = mesh.next(b);
            const Vector in = mesh.position(b) - mesh.position(a), out = mesh.position(c) - mesh.position(b);
            const double now = glm::dot(glm::cross(in, out), n);
            if (!(now > straight_sine * glm::length(in) * glm::length(out))) continue;
            const Vector in_moves = moves(b) - moves(a), out_moves = moves(c) - moves(b);
            const double once = glm::dot(glm::cross(in, out_moves) + glm::cross(in_moves, out), n);
            const double twice = glm::dot(glm::cross(in_moves, out_moves), n);
            if (const double t = least_positive_root(twice, once, now); t < least.safe) least = {t, ThicknessLimit::By::turn, mesh.vertex(b), f};
        }
    }
    return least;
}

bool has_reflex_corner(const Mesh& mesh, Face f)
{
    const Vector n = unit_normal(mesh, f);
    for (const Corner b : mesh.corners(f)) {
        const Vector in = mesh.position(b) - mesh.position(mesh.previous(b)), out = mesh.position(mesh.next(b)) - mesh.position(b);
        if (glm::dot(glm::cross(in, out), n) < -straight_sine * glm::length(in) * glm::length(out)) return true;
    }
    return false;
}

/// Rays from a surface in the direction in which it moves, to the first face that the start is not part of. That face comes the other half
/// of the way.
class OppositeWalls {
public:
    OppositeWalls(const Mesh& mesh, const RayCast& rays, std::span<const Vector> outward, double sign, const ThicknessLimit& most)
        : least(most), mesh_(mesh), rays_(rays), outward_(outward), sign_(sign)
    {
    }

    void ask_from_vertices(Progress& progress, double done)
    {
        for (const Vertex v : mesh_.vertices()) {
            if (v.index % 1024 == 0) progress.step(done + (1 - done) * v.index / mesh_.vertex_limit());
            const auto is_elsewhere = [&](std::uint32_t t) {
                for (const Corner c : mesh_.corners(rays_.triangles().face(t)))
                    if (mesh_.vertex(c) == v) return false;
                return true;
            };
            if (ask(mesh_.position(v), sign_ * outward_[v.index], is_elsewhere)) least = {least.safe, ThicknessLimit::By::vertex, v, {}};
        }
    }

    void ask_from_faces(Progress& progress)
    {
        const TriangleList& triangles = rays_.triangles();
        for (std::uint32_t i = 0, end = 0; i < triangles.size(); i = end) {
            const Face f = triangles.face(i);
            if (f.index % 64 == 0 && progress.cancelled()) throw Cancelled();
            while (end < triangles.size() && triangles.face(end) == f) ++end;
            Vector move(0.0);
            for (const Corner c : mesh_.corners(f)) move += outward_[mesh_.vertex(c).index];
            if (ask(middle(f, i, end), sign_ / double(mesh_.valence(f)) * move, [&](std::uint32_t t) { return triangles.face(t) != f; }))
                least = {least.safe, ThicknessLimit::By::face, {}, f};
        }
    }

    ThicknessLimit least; // so far

private:
    /// The mean of the corners; for a face with a reflex corner, where that may lie beside the face, the middle of its largest triangle.
    Point middle(Face f, std::uint32_t first, std::uint32_t end) const
    {
        if (end - first == 1 || !has_reflex_corner(mesh_, f)) return vertex_mean(mesh_, f);
        Point at(0.0);
        double largest = -1;
        for (std::uint32_t i = first; i < end; ++i) {
            const auto [a, b, c] = rays_.triangles()[i];
            const Vector area = glm::cross(b - a, c - a);
            if (!(glm::dot(area, area) > largest)) continue;
            largest = glm::dot(area, area);
            at = (a + b + c) / 3.0;
        }
        return at;
    }

    /// True if there is a wall nearer than all before.
    template <class Counts>
    bool ask(const Point& from, const Vector& move, Counts&& counts)
    {
        const double speed = glm::length(move);
        if (!(speed > 0)) return false;
        const double reach = std::min(2 * least.safe * speed, std::numeric_limits<double>::max());
        const auto hit = rays_.first_of(from, move / speed, reach, counts);
        if (!hit || !(0.5 * hit->distance / speed < least.safe)) return false;
        least.safe = 0.5 * hit->distance / speed;
        return true;
    }

    const Mesh& mesh_;
    const RayCast& rays_;
    std::span<const Vector> outward_;
    double sign_;
};

/// The vertices whose offset leads out of one of their faces, or along it; ascending. A warped face is what its triangles are.
std::vector<Vertex> vertices_past_a_face(const Mesh& mesh, const CrustOffsets& offsets)
{
    constexpr double along = 1e-9; // cosine
    std::vector<Vertex> list;
    Triangulator triangulator;
    for (const Face f : mesh.faces())
        for (const auto& t : triangulator.triangles(mesh, f)) {
            const Point& p = mesh.position(t[0]);
            const Vector n = glm::cross(mesh.position(t[1]) - p, mesh.position(t[2]) - p);
            const double size = glm::length(n);
            if (!(size > 0)) continue;
            for (const Corner c : t)
                if (!(glm::dot(offsets.outward[mesh.vertex(c).index], n) > along * size)) list.push_back(mesh.vertex(c));
        }
    sort_unique(list);
    return list;
}

/// The first of these vertices at which a crust of that thickness crosses itself where the surface alone does not.
Vertex first_crossing(const Mesh& mesh, const std::vector<Vertex>& vertices, const CrustOffsets& offsets, double thickness, Progress& progress)
{
    std::vector<bool> crosses(mesh.face_limit(), false);
    bool any = false;
    for (const Face f : crust_crossings(mesh, offsets, thickness, progress).faces)
        if (f.index < 2 * mesh.face_limit()) any = crosses[f.index % mesh.face_limit()] = true;
    if (!any) return {};
    for (const Face f : self_intersections(mesh, progress, CrustFaults::most).faces) crosses[f.index] = false;
    for (const Vertex v : vertices)
        for (const Corner c : mesh.around(v))
            if (!mesh.face(c).is_boundary() && crosses[mesh.face(c).index]) return v;
    return {};
}

} // namespace

SelfIntersections crust_crossings(const Mesh& mesh, const CrustOffsets& offsets, double thickness, Progress& progress)
{
    Scene crust;
    crust.mesh = mesh;
    add_reversed_copy(crust);
    const std::uint32_t first_moved = thickness < 0 ? 0 : mesh.vertex_limit();
    for (const Vertex v : mesh.vertices())
        crust.mesh.set_position(Vertex(first_moved + v.index), mesh.position(v) - thickness * offsets.outward[v.index]);
    return self_intersections(crust.mesh, progress, CrustFaults::most);
}

std::string ThicknessLimit::text() const
{
    switch (by) {
    case By::nothing: break;
    case By::turn: return fmt::format("face {} turns over at vertex {}", face.index, vertex.index);
    case By::vertex: return fmt::format("vertex {} meets the opposite wall", vertex.index);
    case By::face: return fmt::format("face {} meets the opposite wall", face.index);
    case By::stuck: return fmt::format("vertex {} sinks below some of its faces only", vertex.index);
    }
    return {};
}

ThicknessLimit thickness_limit(const Mesh& mesh, const CrustOffsets& offsets, bool outward, Progress& progress, double enough)
{
    constexpr double share = 0.95;
    const bool apart = mesh.face_count() > 2000;
    const double sign = outward ? 1 : -1;
    ThicknessLimit most;
    most.safe = enough / share;
    std::optional<RayCast> rays;
    do_both(
        apart, [&] { rays.emplace(mesh, progress, 0.3); },
        [&] {
            const ThicknessLimit turn = first_turn(mesh, [&](Corner c) { return sign * offsets.outward[mesh.vertex(c).index]; }, progress);
            if (turn.safe < most.safe) most = turn;
        });
    OppositeWalls from_vertices(mesh, *rays, offsets.outward, sign, most), from_faces = from_vertices;
    do_both(apart, [&] { from_vertices.ask_from_vertices(progress, 0.3); }, [&] { from_faces.ask_from_faces(progress); });
    ThicknessLimit least = from_faces.least.safe < from_vertices.least.safe ? from_faces.least : from_vertices.least;
    if (!(least.safe > 0)) return least;

    if (const std::vector<Vertex> past = vertices_past_a_face(mesh, offsets); !past.empty()) {
        // So thin that nothing but what touches can meet, and so thick that rounding does not matter.
        const double size = bounds(mesh).diagonal(), thin = 1e-9 * size;
        const double thickness = std::min(std::isinf(least.safe) ? 1e-6 * size : std::max(1e-6 * least.safe, thin), 0.5 * least.safe);
        if (const Vertex v = first_crossing(mesh, past, offsets, -sign * thickness, progress); v.valid())
            return {0, ThicknessLimit::By::stuck, v, {}};
    }
    if (least.by == ThicknessLimit::By::nothing) least.safe = infinity;
    else least.safe *= share;
    return least;
}

} // namespace druse
