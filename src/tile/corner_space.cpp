#include "tile/corner_space.h"

#include "dlfl/errors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace druse {

namespace {

constexpr double dependent = 1e-9; // part of a unit vector that is left when the others are taken off

/// `v` without its parts along `directions`, which are orthonormal; twice, so that what is left is orthogonal to the last digit.
template <class V>
V without(V v, const std::vector<V>& directions)
{
    for (int round = 0; round < 2; ++round)
        for (const V& d : directions) {
            double along = 0;
            for (std::size_t i = 0; i < v.size(); ++i) along += v[i] * d[i];
            for (std::size_t i = 0; i < v.size(); ++i) v[i] -= along * d[i];
        }
    return v;
}

template <class V>
double norm(const V& v)
{
    double sum = 0;
    for (const double x : v) sum += x * x;
    return std::sqrt(sum);
}

template <class V>
V scaled(V v, double factor)
{
    for (double& x : v) x *= factor;
    return v;
}

/// Solves a x = b, with complete pivoting. Precondition: the rows of `a` are independent.
std::vector<std::vector<double>> inverse_of(std::vector<std::vector<double>> a)
{
    const std::size_t n = a.size();
    std::vector<std::vector<double>> inverse(n, std::vector<double>(n, 0.0));
    for (std::size_t i = 0; i < n; ++i) inverse[i][i] = 1.0;
    for (std::size_t c = 0; c < n; ++c) {
        std::size_t best = c;
        for (std::size_t r = c + 1; r < n; ++r)
            if (std::abs(a[r][c]) > std::abs(a[best][c])) best = r;
        ASSERT(std::abs(a[best][c]) > dependent, "independent parameters");
        std::swap(a[c], a[best]);
        std::swap(inverse[c], inverse[best]);
        const double factor = 1.0 / a[c][c];
        a[c] = scaled(std::move(a[c]), factor);
        inverse[c] = scaled(std::move(inverse[c]), factor);
        for (std::size_t r = 0; r < n; ++r) {
            if (r == c || a[r][c] == 0.0) continue;
            const double times = a[r][c];
            for (std::size_t i = 0; i < n; ++i) {
                a[r][i] -= times * a[c][i];
                inverse[r][i] -= times * inverse[c][i];
            }
        }
    }
    return inverse;
}

/// The directions in which a corner moves: rows of the space at its two coordinates, as a symmetric matrix, by eigenvalue.
struct CornerFreedom {
    double large = 0, small = 0;
    Point2 along{1.0, 0.0}; // of the larger one
};

CornerFreedom freedom_of(const CornerSpace& space, int k)
{
    double xx = 0, xy = 0, yy = 0;
    for (const CornerVector& d : space.directions) {
        const Point2 p = corner(d, k);
        xx += p.x * p.x;
        xy += p.x * p.y;
        yy += p.y * p.y;
    }
    const double half = 0.5 * (xx + yy), off = std::hypot(0.5 * (xx - yy), xy);
    const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
    return {half + off, half - off, {std::cos(angle), std::sin(angle)}};
}

constexpr double held = 1e-9; // an eigenvalue below it: in that direction the corner does not move

} // namespace

CornerVector CornerSpace::project(const CornerVector& v) const
{
    CornerVector sum{};
    for (const CornerVector& d : directions) sum = plus(sum, d, dot(v, d));
    return sum;
}

CornerVector CornerSpace::drag(int k, const Point2& by) const
{
    const CornerFreedom f = freedom_of(*this, k);
    Point2 pull(0.0);
    const Point2 across(-f.along.y, f.along.x);
    if (f.large > held) pull += f.along * (glm::dot(f.along, by) / f.large);
    if (f.small > held) pull += across * (glm::dot(across, by) / f.small);
    CornerVector movement{};
    for (const CornerVector& d : directions) movement = plus(movement, d, glm::dot(corner(d, k), pull));
    return movement;
}

int CornerSpace::freedom(int k) const
{
    const CornerFreedom f = freedom_of(*this, k);
    return (f.large > held) + (f.small > held);
}

CornerSpace solutions(std::span<const CornerVector> conditions, int count)
{
    std::vector<CornerVector> taken; // orthonormal: first what the conditions forbid, then what is left
    for (const CornerVector& condition : conditions) {
        const double size = norm(condition);
        if (size < dependent) continue;
        const CornerVector rest = without(scaled(condition, 1.0 / size), taken);
        if (const double left = norm(rest); left > dependent) taken.push_back(scaled(rest, 1.0 / left));
    }
    CornerSpace space;
    while (static_cast<int>(taken.size()) < count) {
        // The axis of which most is left: no digits are lost.
        CornerVector best{};
        double most = 0;
        for (int i = 0; i < count; ++i) {
            CornerVector axis{};
            axis[i] = 1.0;
            const CornerVector rest = without(axis, taken);
            if (const double left = norm(rest); left > most + dependent) {
                most = left;
                best = rest;
            }
        }
        taken.push_back(scaled(best, 1.0 / most));
        space.directions.push_back(taken.back());
    }
    return space;
}

std::vector<int> free_coordinates(const CornerSpace& space, std::span<const int> order)
{
    std::vector<int> chosen;
    std::vector<std::vector<double>> taken;
    for (const int i : order) {
        std::vector<double> row;
        for (const CornerVector& d : space.directions) row.push_back(d[i]);
        row = without(row, taken);
        if (const double left = norm(row); left > 1e-7) { // rows are no unit vectors: a coordinate that is settled may be left with some rounding
            taken.push_back(scaled(row, 1.0 / left));
            chosen.push_back(i);
        }
    }
    return chosen;
}

std::vector<CornerVector> unit_movements(const CornerSpace& space, std::span<const int> parameters)
{
    const std::size_t m = parameters.size();
    std::vector<std::vector<double>> rows(m);
    for (std::size_t r = 0; r < m; ++r)
        for (const CornerVector& d : space.directions) rows[r].push_back(d[parameters[r]]);
    const auto weights = inverse_of(std::move(rows));
    std::vector<CornerVector> movements(m);
    for (std::size_t p = 0; p < m; ++p) {
        CornerVector sum{};
        for (std::size_t d = 0; d < m; ++d) sum = plus(sum, space.directions[d], weights[d][p]);
        for (std::size_t r = 0; r < m; ++r) sum[parameters[r]] = r == p ? 1.0 : 0.0;
        movements[p] = sum;
    }
    return movements;
}

} // namespace druse
