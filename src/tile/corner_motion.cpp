#include "tile/corner_motion.h"

#include "geom/turn.h"

#include <numeric>

namespace druse {

namespace {

/// M T, for a linear part M.
CornerShift times(const Turning& m, const CornerShift& t)
{
    CornerShift result;
    for (std::size_t i = 0; i < t.x.size(); ++i) {
        const Point2 p = m.times({t.x[i], t.y[i]});
        result.x[i] = p.x;
        result.y[i] = p.y;
    }
    return result;
}

} // namespace

double dot(const CornerVector& a, const CornerVector& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }

CornerVector plus(const CornerVector& a, const CornerVector& b, double factor)
{
    CornerVector sum = a;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * b[i];
    return sum;
}

CornerShift plus(const CornerShift& a, const CornerShift& b, double factor) { return {plus(a.x, b.x, factor), plus(a.y, b.y, factor)}; }

Point2 Turning::times(const Point2& p) const
{
    const Point2 t = turn(angle, full_turn);
    const double y = reflects ? -p.y : p.y;
    return {t.x * p.x - t.y * y, t.y * p.x + t.x * y};
}

Turning operator*(const Turning& a, const Turning& b)
{
    return {turns(a.reflects ? a.angle - b.angle : a.angle + b.angle), a.reflects != b.reflects};
}

Turning inverse(const Turning& t) { return t.reflects ? t : Turning{turns(-t.angle), false}; }

CornerMotion operator*(const CornerMotion& a, const CornerMotion& b)
{
    return {a.turning * b.turning, plus(times(a.turning, b.shift), a.shift)};
}

CornerMotion inverse(const CornerMotion& m)
{
    const Turning back = inverse(m.turning);
    return {back, plus(CornerShift{}, times(back, m.shift), -1.0)};
}

CornerMotion motion_of_corner(const Turning& turning, int from, int to)
{
    const Point2 x = turning.times({1.0, 0.0}), y = turning.times({0.0, 1.0});
    CornerShift shift;
    shift.x[2 * to] += 1.0;
    shift.y[2 * to + 1] += 1.0;
    shift.x[2 * from] -= x.x;
    shift.x[2 * from + 1] -= y.x;
    shift.y[2 * from] -= x.y;
    shift.y[2 * from + 1] -= y.y;
    return {turning, shift};
}

} // namespace druse
