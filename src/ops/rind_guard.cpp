// How thick a crust may be: where a corner of a face would turn over, and where opposite walls would meet.
#include "dlfl/measures.h"
#include "dlfl/ray_cast.h"
#include "geom/do_both.h"
#include "geom/infinity.h"
#include "ops/rind.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

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
double first_turn(const Mesh& mesh, Moves&& moves, Progress& progress)
{
    double least = infinity;
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
            least = std::min(least, least_positive_root(twice, once, now));
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
    OppositeWalls(const Mesh& mesh, const RayCast& rays, std::span<const Vector> outward, double sign, double most)
        : least(most), mesh_(mesh), rays_(rays), outward_(outward), sign_(sign)
    {
    }

    void ask_from_vertices(Progress& progress, double done)
    {
        for (const Vertex v : mesh_.vertices()) {
            if (v.index % 1024 == 0) progress.step(done + (1 - done) * v.index / mesh_.vertex_limit());
            ask(mesh_.position(v), sign_ * outward_[v.index], [&](std::uint32_t t) {
                for (const Corner c : mesh_.corners(rays_.triangles().face(t)))
                    if (mesh_.vertex(c) == v) return false;
                return true;
            });
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
            ask(middle(f, i, end), sign_ / double(mesh_.valence(f)) * move, [&](std::uint32_t t) { return triangles.face(t) != f; });
        }
    }

    double least; // thickness

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

    template <class Counts>
    void ask(const Point& from, const Vector& move, Counts&& counts)
    {
        const double speed = glm::length(move);
        if (!(speed > 0)) return;
        const double reach = std::min(2 * least * speed, std::numeric_limits<double>::max());
        if (const auto hit = rays_.first_of(from, move / speed, reach, counts)) least = std::min(least, 0.5 * hit->distance / speed);
    }

    const Mesh& mesh_;
    const RayCast& rays_;
    std::span<const Vector> outward_;
    double sign_;
};

} // namespace

Vertex stuck_vertex(const Mesh& mesh, const CrustOffsets& offsets)
{
    constexpr double along = 1e-9; // cosine
    Vertex stuck;
    for (const Face f : mesh.faces()) {
        const Vector n = unit_normal(mesh, f);
        if (n == Vector(0.0)) continue;
        for (const Corner c : mesh.corners(f))
            if (const Vertex v = mesh.vertex(c); v < stuck && !(glm::dot(offsets.outward[v.index], n) > along)) stuck = v;
    }
    return stuck;
}

double safe_thickness(const Mesh& mesh, const CrustOffsets& offsets, bool outward, Progress& progress, double enough)
{
    constexpr double share = 0.95;
    if (stuck_vertex(mesh, offsets).valid()) return 0;
    const bool apart = mesh.face_count() > 2000;
    const double sign = outward ? 1 : -1;
    const double most = enough / share;
    double least = most;
    std::optional<RayCast> rays;
    do_both(
        apart, [&] { rays.emplace(mesh, progress, 0.3); },
        [&] { least = std::min(least, first_turn(mesh, [&](Corner c) { return sign * offsets.outward[mesh.vertex(c).index]; }, progress)); });
    OppositeWalls from_vertices(mesh, *rays, offsets.outward, sign, least), from_faces = from_vertices;
    do_both(apart, [&] { from_vertices.ask_from_vertices(progress, 0.3); }, [&] { from_faces.ask_from_faces(progress); });
    least = std::min(from_vertices.least, from_faces.least);
    return least < most ? share * least : infinity;
}

} // namespace druse
