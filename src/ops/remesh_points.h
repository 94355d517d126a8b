#pragma once

#include "geom/cut_corners.h"
#include "geom/progress.h"
#include "ops/remesh_old_mesh.h"

#include <cstdint>
#include <numbers>

/// Positions that several remeshing schemes share. What is written goes by vertex, edge, side, face or corner, as NewPoints says.
namespace druse::remesh {

/// visit(f, begin, end) for every face, with its corners. Ends with Cancelled if that is asked for.
template <class Visit>
void for_each_face(const OldMesh& old, const Progress& progress, Visit&& visit)
{
    for (std::uint32_t f = 0; f < old.faces(); ++f) {
        if (f % 16384 == 0 && progress.cancelled()) throw Cancelled();
        visit(f, old.begin(f), old.end(f));
    }
}

/// The mean of the corners of a face.
Point mean(const OldMesh& old, std::uint32_t f);
/// Newell's normal of a face, of length 1; zero where the face has no area.
Vector normal(const OldMesh& old, std::uint32_t f);
/// The point at the fraction `t` of the side of a corner.
inline Point along(const OldMesh& old, std::uint32_t c, double t)
{
    const Point& v = old.position(c);
    return v + t * (old.position(old.on(c)) - v);
}

/// The weight of the own corner in TopMod's honeycomb and root-4 schemes.
inline double honeycomb_weight(int n) { return std::numbers::sqrt2 / 2 + CornerCutter::doo_sabin(n) - 0.5; }

void write_old_vertices(const OldMesh& old, Point* to);
void write_edge_midpoints(const OldMesh& old, Point* to);
/// On every side, at the fraction `t` from the corner where it starts.
void write_side_points(const OldMesh& old, double t, Point* to);
void write_face_means(const OldMesh& old, Point* to, Progress& progress);
/// Old vertices, each moved towards the mean of its neighbours by the fraction `weight(m)` of the way, m its valence.
void write_relaxed_vertices(const OldMesh& old, double (*weight)(int m), Point* to);
/// The same where `to` has the sums of the neighbours already.
void relax_from_sums(const OldMesh& old, double (*weight)(int m), Point* to);

/// For each corner c the point at(c), brought nearer to the mean of its face's corners: a fraction `s` of its distance is left.
template <class At>
void write_inner_points(const OldMesh& old, double s, At&& at, Point* to, Progress& progress)
{
    for_each_face(old, progress, [&](std::uint32_t f, std::uint32_t begin, std::uint32_t end) {
        const Point center = mean(old, f);
        for (std::uint32_t c = begin; c < end; ++c) to[c] = center + s * (at(c) - center);
    });
}

} // namespace druse::remesh
