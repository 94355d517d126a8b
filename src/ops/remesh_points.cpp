#include "ops/remesh_points.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace druse::remesh {

Point mean(const OldMesh& old, std::uint32_t f)
{
    Vector sum(0.0);
    for (std::uint32_t c = old.begin(f); c < old.end(f); ++c) sum += old.position(c);
    return sum / double(old.end(f) - old.begin(f));
}

Vector normal(const OldMesh& old, std::uint32_t f)
{
    const std::uint32_t begin = old.begin(f), end = old.end(f);
    const Point origin = old.position(begin);
    double size = 0.0; // so that products neither overflow nor vanish
    for (std::uint32_t c = begin + 1; c < end; ++c) {
        const Vector d = glm::abs(old.position(c) - origin);
        size = std::max({size, d.x, d.y, d.z});
    }
    if (!(size > 0.0)) return Vector(0.0);
    Vector sum(0.0), last = (old.position(begin + 1) - origin) / size;
    for (std::uint32_t c = begin + 2; c < end; ++c) {
        const Vector next = (old.position(c) - origin) / size;
        sum += glm::cross(last, next);
        last = next;
    }
    return unit(sum);
}

void write_old_vertices(const OldMesh& old, Point* to)
{
    const std::span<const Point> from = old.positions();
    std::copy(from.begin(), from.end(), to);
}

void write_edge_midpoints(const OldMesh& old, Point* to)
{
    for (std::uint32_t e = 0; e < old.edges(); ++e)
        to[e] = 0.5 * (old.position(old.corner_of_side(2 * e)) + old.position(old.corner_of_side(2 * e + 1)));
}

void write_side_points(const OldMesh& old, double t, Point* to)
{
    for (std::uint32_t side = 0; side < old.corners(); side += 2) {
        const Point& v = old.position(old.corner_of_side(side));
        const Point& w = old.position(old.corner_of_side(side + 1));
        to[side] = v + t * (w - v);
        to[side + 1] = w + t * (v - w);
    }
}

void write_face_means(const OldMesh& old, Point* to, Progress& progress)
{
    for_each_face(old, progress, [&](std::uint32_t f, std::uint32_t, std::uint32_t) { to[f] = mean(old, f); });
}

void write_relaxed_vertices(const OldMesh& old, double (*weight)(int m), Point* to)
{
    std::fill_n(to, old.vertices(), Point(0.0));
    for (std::uint32_t f = 0; f < old.faces(); ++f) {
        const std::uint32_t begin = old.begin(f), last = old.end(f) - 1;
        const Point& first = old.position(begin);
        for (std::uint32_t c = begin; c < last; ++c) to[old.vertex(c)] += old.position(c + 1);
        to[old.vertex(last)] += first;
    }
    relax_from_sums(old, weight, to);
}

void relax_from_sums(const OldMesh& old, double (*weight)(int m), Point* to)
{
    std::vector<double> known; // weights by valence, NaN where not asked for yet
    for (std::uint32_t v = 0; v < old.vertices(); ++v) {
        const std::uint32_t m = old.valence(v);
        if (m >= known.size()) known.resize(m + 1, std::nan(""));
        if (std::isnan(known[m])) known[m] = weight(static_cast<int>(m));
        const Point& at = old.positions()[v];
        to[v] = at + known[m] * (to[v] / double(m) - at);
    }
}

} // namespace druse::remesh
