#include "geom/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace druse {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 of(const Point2& p) { return {p.x, p.y}; }
Kernel::Point_3 of(const Point& p) { return {p.x, p.y, p.z}; }

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
