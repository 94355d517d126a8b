#include "graph/hyperbolic.h"

#include "geom/angle.h"

#include <cstdint>
#include <numeric>

namespace druse {

Geometry geometry_of(std::span<const int> polygons)
{
    // Of all numbers up to 40 the least common multiple is 5.3e15: twelve times as much is well inside 64 bits.
    std::int64_t common = 1, sum = 0;
    for (const int p : polygons) common = std::lcm(common, std::int64_t(p));
    for (const int p : polygons) sum += common / p;
    const std::int64_t excess = (static_cast<std::int64_t>(polygons.size()) - 2) * common - 2 * sum; // of Σ(1 − 2/p) over 2
    return excess > 0 ? Geometry::hyperbolic : excess == 0 ? Geometry::euclidean : Geometry::spherical;
}

double interior_angle(int sides, double length) { return 2.0 * std::asin(std::cos(pi / sides) / std::cosh(0.5 * length)); }

double edge_length(std::span<const int> polygons)
{
    const auto excess = [polygons](double length) {
        double sum = -2.0 * pi;
        for (const int p : polygons) sum += interior_angle(p, length);
        return sum;
    };
    // The angles fall from those of flat polygons, which are too large together, to 0.
    double low = 0.0, high = 1.0;
    while (excess(high) > 0.0) high *= 2.0;
    for (;;) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) return middle;
        (excess(middle) > 0.0 ? low : high) = middle;
    }
}

double circumradius(int sides, double length) { return std::asinh(std::sinh(0.5 * length) / std::sin(pi / sides)); }

} // namespace druse
