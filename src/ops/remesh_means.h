#pragma once

#include "geom/progress.h"
#include "geom/turn.h"
#include "ops/remesh_old_mesh.h"

#include <vector>

namespace druse::remesh {

/// The mean of the corners of each face.
void write_face_means(const OldMesh& old, Point* to, Progress& progress);

/// The weight α = constant + over_sides / n with which a corner of an n-sided face counts at its own new point.
struct CornerWeight {
    double constant, over_sides;
};

/// For each corner i of each face the point Σ_j W(n, i, j) at(j), W = α for j = i, else (1 − α)(3 + 2 cos(2π(i − j)/n))/(3n − 5). The
/// weights sum to 1. As the cosine of a difference is a sum of products, a face costs as much as it has corners.
/// `at(c)` is the point that counts for corner c.
/// Source: Doo & Sabin (1978), where α = 1/4 + 5/(4n).
template <class At>
void write_weighted_corners(const OldMesh& old, CornerWeight weight, Point* to, Progress& progress, At&& at)
{
    std::vector<Point2> directions; // of n corners, evenly around
    for (std::uint32_t f = 0; f < old.faces(); ++f) {
        if (f % 16384 == 0) progress.step(0.5 + 0.5 * f / old.faces());
        const std::uint32_t begin = old.begin(f), n = old.end(f) - begin;
        if (directions.size() != n) {
            directions.resize(n);
            for (std::uint32_t i = 0; i < n; ++i) directions[i] = turn(i, n);
        }
        // Relative to the first one, so that a face far from the origin loses no digits.
        const Point origin = at(begin);
        Vector sum(0.0), cosines(0.0), sines(0.0);
        for (std::uint32_t i = 0; i < n; ++i) {
            const Vector p = at(begin + i) - origin;
            sum += p;
            cosines += directions[i].x * p;
            sines += directions[i].y * p;
        }
        const double alpha = weight.constant + weight.over_sides / n, w = (1.0 - alpha) / (3.0 * n - 5.0);
        for (std::uint32_t i = 0; i < n; ++i)
            to[begin + i] = origin + (w * (3.0 * sum + 2.0 * (directions[i].x * cosines + directions[i].y * sines)) +
                                      (alpha - 5.0 * w) * (at(begin + i) - origin));
    }
}

} // namespace druse::remesh
