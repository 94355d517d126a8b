#include "geom/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>

#include <cmath>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace druse {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 of(const Point2& p) { return {p.x, p.y}; }
Kernel::Point_3 of(const Point& p) { return {p.x, p.y, p.z}; }

/// a − b where that needs no rounding.
bool subtract(double a, double b, double& difference)
{
    difference = a - b;
    const double virtual_b = a - difference, virtual_a = difference + virtual_b;
    return a - virtual_a == 0 && b - virtual_b == 0;
}

/// The sign of a determinant of whole numbers below 2^54 in size. A 2 × 2 minor has 110 bits, so the sum is kept in two parts.
int sign_of_determinant(const std::array<std::int64_t, 3>& a, const std::array<std::int64_t, 3>& b, const std::array<std::int64_t, 3>& c)
{
    __extension__ using Wide = __int128;
    Wide high = 0, low = 0; // high · 2^64 + low
    const auto add = [&](std::int64_t factor, const Wide& minor) {
        high += Wide(factor) * Wide(static_cast<std::int64_t>(minor >> 64));
        low += Wide(factor) * Wide(static_cast<std::uint64_t>(minor));
    };
    add(a[2], Wide(b[1]) * c[0] - Wide(b[0]) * c[1]);
    add(b[2], Wide(c[1]) * a[0] - Wide(c[0]) * a[1]);
    add(c[2], Wide(a[1]) * b[0] - Wide(a[0]) * b[1]);
    high += low >> 64;
    if (high != 0) return high > 0 ? 1 : -1;
    return static_cast<std::uint64_t>(low) != 0 ? 1 : 0;
}

/// Points that are nearly in a plane are most often neighbours on a grid: numbers of about the same size, so that their differences need no
/// rounding and are multiples of the last digit of the largest by less than 2^54. Then whole numbers tell the sign, many times faster than what is
/// made for all numbers. @return false if they are not
bool orient_on_grid(const Point& a, const Point& b, const Point& c, const Point& d, int& sign)
{
    std::array<double, 9> difference;
    double largest = 0;
    for (std::size_t i = 0; i < 9; ++i) {
        const Point& p = i < 3 ? a : i < 6 ? b : c;
        const int k = static_cast<int>(i % 3);
        if (!subtract(p[k], d[k], difference[i])) return false;
        largest = std::max(largest, std::abs(difference[i]));
    }
    if (!(largest > 1e-280 && largest < 1e280)) return false;
    const double scale = std::ldexp(1.0, 52 - std::ilogb(largest));
    std::array<std::array<std::int64_t, 3>, 3> whole;
    for (std::size_t i = 0; i < 9; ++i) {
        const double scaled = difference[i] * scale;
        std::int64_t& x = whole[i / 3][i % 3];
        x = static_cast<std::int64_t>(scaled);
        if (double(x) != scaled || (x == 0 && difference[i] != 0)) return false;
    }
    sign = sign_of_determinant(whole[0], whole[1], whole[2]);
    return true;
}

/// True if in one coordinate all points agree: the plainest of degenerate cases, and in models made of cubes the commonest.
bool agree(double a, double b, double c, double d) { return a == b && a == c && a == d; }

} // namespace

namespace exact {

int orient(const Point2& a, const Point2& b, const Point2& c)
{
    if ((a.x == b.x && a.x == c.x) || (a.y == b.y && a.y == c.y)) return 0;
    return static_cast<int>(Kernel().orientation_2_object()(of(a), of(b), of(c)));
}

int orient(const Point& a, const Point& b, const Point& c, const Point& d)
{
    if (agree(a.x, b.x, c.x, d.x) || agree(a.y, b.y, c.y, d.y) || agree(a.z, b.z, c.z, d.z)) return 0;
    if (int sign = 0; orient_on_grid(a, b, c, d, sign)) return sign;
    return static_cast<int>(Kernel().orientation_3_object()(of(a), of(b), of(c), of(d)));
}

int incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
    return static_cast<int>(Kernel().side_of_oriented_circle_2_object()(of(a), of(b), of(c), of(d)));
}

int insphere(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e)
{
    return static_cast<int>(Kernel().side_of_oriented_sphere_3_object()(of(a), of(b), of(c), of(d), of(e)));
}

} // namespace exact

namespace {

/// The sum of two doubles of which the second is at most half a last digit of the first: some 32 decimal digits.
struct Double2 {
    double high, low;
};

Double2 sum(double a, double b)
{
    const double s = a + b, part = s - a;
    return {s, (a - (s - part)) + (b - part)};
}

Double2 sum(Double2 a, Double2 b)
{
    const Double2 s = sum(a.high, b.high), t = sum(a.low, b.low);
    const Double2 once = sum(s.high, s.low + t.high);
    return sum(once.high, once.low + t.low);
}

Double2 product(Double2 a, Double2 b)
{
    const double p = a.high * b.high;
    return sum(p, std::fma(a.high, b.high, -p) + (a.high * b.low + a.low * b.high));
}

Double2 operator-(Double2 a) { return {-a.high, -a.low}; }

Double2 quotient(Double2 a, Double2 b)
{
    const double first = a.high / b.high;
    const Double2 rest = sum(a, -product({first, 0}, b));
    return sum(first, rest.high / b.high);
}

/// a·d − b·c, and whether at least 60 bits of it are right.
struct Cross {
    Double2 value;
    bool good;
};

Cross cross(Double2 a, Double2 b, Double2 c, Double2 d)
{
    const Double2 left = product(a, d), right = product(b, c), value = sum(left, -right);
    const double size = std::abs(left.high) + std::abs(right.high);
    return {value, size > 1e-200 && std::abs(value.high) > size * 0x1p-36};
}

// Where even those digits do not do, places are computed in rational numbers and rounded at the end.
using Rational = CGAL::Gmpq;

/// The nearest double; to_double() may be the one beside it.
double rounded(const Rational& x)
{
    const double near = CGAL::to_double(x);
    const Rational rest = x - Rational(near);
    if (rest == 0) return near;
    const double beyond = std::nextafter(near, rest > 0 ? HUGE_VAL : -HUGE_VAL);
    return CGAL::abs(Rational(beyond) - x) < CGAL::abs(rest) ? beyond : near;
}

Point2 rounded(const Rational& x, const Rational& y) { return {rounded(x), rounded(y)}; }

Point2 along(const Point2& a, Double2 t, Double2 ux, Double2 uy)
{
    const Double2 x = sum({a.x, 0}, product(t, ux)), y = sum({a.y, 0}, product(t, uy));
    return {x.high + x.low, y.high + y.low};
}

} // namespace

Point2 crossing(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
    {
        const Double2 ux = sum(b.x, -a.x), uy = sum(b.y, -a.y), vx = sum(d.x, -c.x), vy = sum(d.y, -c.y), wx = sum(c.x, -a.x), wy = sum(c.y, -a.y);
        const Cross n = cross(wx, wy, vx, vy), m = cross(ux, uy, vx, vy);
        if (n.good && m.good) return along(a, quotient(n.value, m.value), ux, uy);
    }
    const Rational ux = Rational(b.x) - Rational(a.x), uy = Rational(b.y) - Rational(a.y);
    const Rational vx = Rational(d.x) - Rational(c.x), vy = Rational(d.y) - Rational(c.y);
    const Rational wx = Rational(c.x) - Rational(a.x), wy = Rational(c.y) - Rational(a.y);
    const Rational t = (wx * vy - wy * vx) / (ux * vy - uy * vx);
    return rounded(Rational(a.x) + t * ux, Rational(a.y) + t * uy);
}

Point2 foot(const Point2& p, const Point2& a, const Point2& b)
{
    {
        const Double2 ux = sum(b.x, -a.x), uy = sum(b.y, -a.y), wx = sum(p.x, -a.x), wy = sum(p.y, -a.y);
        const Cross n = cross(wx, wy, -uy, ux), m = cross(ux, uy, -uy, ux); // wx ux + wy uy
        if (n.good && m.good) {
            if (n.value.high <= 0) return a;
            if (sum(n.value, -m.value).high >= 0) return b;
            return along(a, quotient(n.value, m.value), ux, uy);
        }
    }
    const Rational ux = Rational(b.x) - Rational(a.x), uy = Rational(b.y) - Rational(a.y);
    const Rational t = ((Rational(p.x) - Rational(a.x)) * ux + (Rational(p.y) - Rational(a.y)) * uy) / (ux * ux + uy * uy);
    if (t <= 0) return a;
    if (t >= 1) return b;
    return rounded(Rational(a.x) + t * ux, Rational(a.y) + t * uy);
}

bool predicates_are_exact()
{
    // Powers of two around 1, where a last digit more or less decides; `least` is the distance from 1 to the next number.
    constexpr double least = 0x1p-52, tiny = 0x1p-1000, huge = 0x1p1000;
    const Point2 o(0, 0), x(1, 0), y(0, 1), diagonal(1, 1), far(12, 12), farther(24, 24);
    const Point O(0, 0, 0), X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1);
    bool good = true;

    // In the plane: a point beside the diagonal by the least that there is, and triangles whose area underflows or overflows.
    good &= orient(o, x, y) == 1 && orient(o, y, x) == -1;
    good &= orient(far, farther, Point2(0.5, 0.5)) == 0;
    good &= orient(far, farther, Point2(0.5, 0.5 + least / 2)) == 1;
    good &= orient(far, farther, Point2(0.5 + least / 2, 0.5)) == -1;
    good &= orient(o, tiny * x, tiny * y) == 1;
    good &= orient(-huge * diagonal, huge * x, huge * diagonal) == 1;

    // In space: the same beside the plane x + y + z = 3.
    good &= orient(O, X, Y, Z) == 1 && orient(O, Y, X, Z) == -1;
    good &= orient(3.0 * X, 3.0 * Y, 3.0 * Z, Point(1, 1, 1)) == 0;
    good &= orient(3.0 * X, 3.0 * Y, 3.0 * Z, Point(1, 1, 1 + least)) == 1;
    good &= orient(3.0 * X, 3.0 * Y, 3.0 * Z, Point(1 - least, 1, 1)) == -1;
    good &= orient(O, tiny * X, tiny * Y, tiny * Z) == 1;

    // On the circle of radius 5, and on the sphere of radius 3, which go through whole numbers.
    good &= incircle({3, 4}, {-4, 3}, {0, -5}, {5, 0}) == 0;
    good &= incircle({3, 4}, {-4, 3}, {0, -5}, {5 + 4 * least, 0}) == -1;
    good &= incircle({3, 4}, {-4, 3}, {0, -5}, {5 - 4 * least, 0}) == 1;
    good &= incircle(tiny * x, tiny * y, -tiny * x, o) == 1;
    good &= insphere({3, 0, 0}, {0, 3, 0}, {-3, 0, 0}, {1, 2, 2}, {2, -1, 2}) == 0;
    good &= insphere({3, 0, 0}, {0, 3, 0}, {-3, 0, 0}, {1, 2, 2}, {2, -1, 2 + 2 * least}) == -1;
    good &= insphere({3, 0, 0}, {0, 3, 0}, {-3, 0, 0}, {1, 2, 2}, {2, -1, 2 - least}) == 1;
    return good;
}

} // namespace druse
