// How thick a crust may be: where a corner of a face would turn over, and where opposite walls would meet.
#include "dlfl/measures.h"
#include "dlfl/ray_cast.h"
#include "ops/rind.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace druse {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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

/// The thickness at which the first corner of a face turns over, seen along the face's normal. Reflex and straight corners do no harm.
template <class Moves>
double first_turn(const Mesh& mesh, Moves&& moves, Progress& progress)
{
    constexpr double straight = 1e-9; // sine
    double least = infinity;
    for (const Face f : mesh.faces()) {
        if (f.index % 4096 == 0) progress.step(0.0);
        const Vector n = unit_normal(mesh, f);
        for (const Corner b : mesh.corners(f)) {
            const Corner a = mesh.previous(b), c = mesh.next(b);
            const Vector in = mesh.position(b) - mesh.position(a), out = mesh.position(c) - mesh.position(b);
            const double now = glm::dot(glm::cross(in, out), n);
            if (!(now > straight * glm::length(in) * glm::length(out))) continue;
            const Vector in_moves = moves(b) - moves(a), out_moves = moves(c) - moves(b);
            const double once = glm::dot(glm::cross(in, out_moves) + glm::cross(in_moves, out), n);
            const double twice = glm::dot(glm::cross(in_moves, out_moves), n);
            least = std::min(least, least_positive_root(twice, once, now));
        }
    }
    return least;
}

} // namespace

double safe_thickness(const Mesh& mesh, const CrustOffsets& offsets, bool outward, Progress& progress)
{
    const double sign = outward ? 1 : -1;
    const auto moves = [&](Corner c) { return sign * offsets.outward[mesh.vertex(c).index]; };
    double least = first_turn(mesh, moves, progress);

    // From each vertex, and from the middle of each face, to the first face that it is not part of. That one comes the other half of the way.
    // The middle of a face is that of its largest triangle: the mean of its corners may lie beside it, or in one of them.
    const RayCast rays(mesh, progress, 0.3);
    const TriangleList& triangles = rays.triangles();
    const auto ask = [&](const Point& from, const Vector& move, auto&& counts) {
        const double speed = glm::length(move);
        if (!(speed > 0)) return;
        const double reach = std::min(2 * least * speed, std::numeric_limits<double>::max());
        if (const auto hit = rays.first_of(from, move / speed, reach, counts)) least = std::min(least, 0.5 * hit->distance / speed);
    };
    const double asked = double(mesh.vertex_limit()) + triangles.size();
    for (const Vertex v : mesh.vertices()) {
        if (v.index % 1024 == 0) progress.step(0.3 + 0.7 * v.index / asked);
        const auto without_it = [&](std::uint32_t t) {
            for (const Corner c : mesh.corners(triangles.face(t)))
                if (mesh.vertex(c) == v) return false;
            return true;
        };
        ask(mesh.position(v), sign * offsets.outward[v.index], without_it);
    }
    for (std::uint32_t i = 0; i < triangles.size();) {
        const Face f = triangles.face(i);
        Point middle(0.0);
        double largest = -1;
        for (; i < triangles.size() && triangles.face(i) == f; ++i) {
            if (i % 1024 == 0) progress.step(0.3 + 0.7 * (double(mesh.vertex_limit()) + i) / asked);
            const auto [a, b, c] = triangles[i];
            const Vector area = glm::cross(b - a, c - a);
            if (!(glm::dot(area, area) > largest)) continue;
            largest = glm::dot(area, area);
            middle = (a + b + c) / 3.0;
        }
        Vector move(0.0);
        for (const Corner c : mesh.corners(f)) move += moves(c);
        ask(middle, move / double(mesh.valence(f)), [&](std::uint32_t t) { return triangles.face(t) != f; });
    }
    return 0.95 * least;
}

} // namespace druse
