#pragma once

#include "geom/point.h"

#include <cmath>

namespace druse {

// Signs of determinants of coordinates, exact: what the numbers as they are stored say, not what rounding leaves of it.
//
// Each answers 1, 0 or -1. A formula in doubles comes first, with a bound of its error; where the bound leaves the sign open, the
// kernel of CGAL computes it without error. All are antisymmetric: an exchange of two points turns the sign round (in incircle and
// insphere, of two points that carry the circle or sphere). A zero means that the points are on one line, plane, circle or sphere.
//
// Precondition: the coordinates are finite; nothing else, a difference may overflow or underflow. Rounding to nearest, as everywhere.
// Cost: some nanoseconds, insphere some more; a microsecond where the points are degenerate but for rounding. Safe in several threads.
// Source: Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates* (1997), for formulas and bounds.

namespace filter {

// The same signs as far as doubles tell them; 0: they do not. Beside Shewchuk's bound, which supposes that nothing underflows, each
// error has a term for products that do: a product is off by 2^-1075 at most then, and what it is multiplied with is in the term.

constexpr double epsilon = 0x1p-53;
constexpr double underflow = 1e-300;

inline int sign(double determinant, double error) { return determinant > error ? 1 : -determinant > error ? -1 : 0; }

inline int orient(const Point2& a, const Point2& b, const Point2& c)
{
    const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
    return sign(left - right, (3 + 16 * epsilon) * epsilon * (std::abs(left) + std::abs(right)) + underflow);
}

inline int orient(const Point& a, const Point& b, const Point& c, const Point& d)
{
    const Vector ad = a - d, bd = b - d, cd = c - d;
    const double bc = bd.x * cd.y, cb = cd.x * bd.y, ca = cd.x * ad.y, ac = ad.x * cd.y, ab = ad.x * bd.y, ba = bd.x * ad.y;
    const double za = std::abs(ad.z), zb = std::abs(bd.z), zc = std::abs(cd.z);
    const double determinant = ad.z * (cb - bc) + bd.z * (ac - ca) + cd.z * (ba - ab);
    const double permanent =
        (std::abs(bc) + std::abs(cb)) * za + (std::abs(ca) + std::abs(ac)) * zb + (std::abs(ab) + std::abs(ba)) * zc;
    return sign(determinant, (7 + 56 * epsilon) * epsilon * permanent + underflow * (1 + za + zb + zc));
}

/// A point as it is seen from another, with the square of its distance.
struct Seen {
    double x, y, square;
};

inline Seen seen(const Point2& p, const Point2& from)
{
    const Point2 d = p - from;
    return {d.x, d.y, d.x * d.x + d.y * d.y};
}

/// The sign for the point that a, b and c are seen from.
inline int incircle(const Seen& a, const Seen& b, const Seen& c)
{
    const double bc = b.x * c.y, cb = c.x * b.y, ca = c.x * a.y, ac = a.x * c.y, ab = a.x * b.y, ba = b.x * a.y;
    const double determinant = a.square * (bc - cb) + b.square * (ca - ac) + c.square * (ab - ba);
    const double permanent =
        (std::abs(bc) + std::abs(cb)) * a.square + (std::abs(ca) + std::abs(ac)) * b.square + (std::abs(ab) + std::abs(ba)) * c.square;
    return sign(determinant, (10 + 96 * epsilon) * epsilon * permanent + underflow * (1 + a.square + b.square + c.square));
}

inline int incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) { return incircle(seen(a, d), seen(b, d), seen(c, d)); }

inline int insphere(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e)
{
    const Vector p = a - e, q = b - e, r = c - e, s = d - e;
    const double pq = p.x * q.y, qp = q.x * p.y, qr = q.x * r.y, rq = r.x * q.y, rs = r.x * s.y, sr = s.x * r.y;
    const double sp = s.x * p.y, ps = p.x * s.y, pr = p.x * r.y, rp = r.x * p.y, qs = q.x * s.y, sq = s.x * q.y;
    const double ab = pq - qp, bc = qr - rq, cd = rs - sr, da = sp - ps, ac = pr - rp, bd = qs - sq;
    const double abc = p.z * bc - q.z * ac + r.z * ab, bcd = q.z * cd - r.z * bd + s.z * bc;
    const double cda = r.z * da + s.z * ac + p.z * cd, dab = s.z * ab + p.z * bd + q.z * da;
    const double lp = glm::dot(p, p), lq = glm::dot(q, q), lr = glm::dot(r, r), ls = glm::dot(s, s);
    const double determinant = (lr * dab - ls * abc) + (lp * bcd - lq * cda);

    const double zp = std::abs(p.z), zq = std::abs(q.z), zr = std::abs(r.z), zs = std::abs(s.z);
    const double all_pq = std::abs(pq) + std::abs(qp), all_qr = std::abs(qr) + std::abs(rq), all_rs = std::abs(rs) + std::abs(sr);
    const double all_sp = std::abs(sp) + std::abs(ps), all_pr = std::abs(pr) + std::abs(rp), all_qs = std::abs(qs) + std::abs(sq);
    const double permanent = (all_rs * zq + all_qs * zr + all_qr * zs) * lp + (all_sp * zr + all_pr * zs + all_rs * zp) * lq +
                             (all_pq * zs + all_qs * zp + all_sp * zq) * lr + (all_qr * zp + all_pr * zq + all_pq * zr) * ls;
    const double reach = 1 + lp + lq + lr + ls;
    return sign(determinant, (16 + 224 * epsilon) * epsilon * permanent + underflow * reach * reach);
}

} // namespace filter

namespace exact {

// The same signs from CGAL, whatever the points.
int orient(const Point2& a, const Point2& b, const Point2& c);
int orient(const Point& a, const Point& b, const Point& c, const Point& d);
int incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
int insphere(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e);

} // namespace exact

/// 1 if a, b, c run counter-clockwise, so that c is to the left of the line from a to b; -1 if clockwise.
inline int orient(const Point2& a, const Point2& b, const Point2& c)
{
    const int sign = filter::orient(a, b, c);
    return sign != 0 ? sign : exact::orient(a, b, c);
}

/// 1 if d is above the plane of a, b, c, where these run counter-clockwise seen from above: the side that the normal
/// (b − a) × (c − a) points to, outside for the corners of a face. -1 if below.
inline int orient(const Point& a, const Point& b, const Point& c, const Point& d)
{
    const int sign = filter::orient(a, b, c, d);
    return sign != 0 ? sign : exact::orient(a, b, c, d);
}

/// 1 if d is inside the circle through a, b, c, -1 if outside. Precondition: orient(a, b, c) > 0; else the sign is turned round with
/// it, and tells nothing where a, b, c are on a line.
inline int incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
    const int sign = filter::incircle(a, b, c, d);
    return sign != 0 ? sign : exact::incircle(a, b, c, d);
}

/// The order of points by x, then y.
inline bool is_before(const Point2& p, const Point2& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

/// As incircle(), but never 0 for four different points: on one circle, the first of them in the order of is_before() counts as lifted a little less
/// than its height, which keeps the diagonal at it. One set of points then has one Delaunay triangulation. Precondition: orient(a, b, c) > 0.
inline int incircle_in_order(const Point2& a, const Point2& b, const Point2& c, const Point2& d)
{
    if (const int sign = incircle(a, b, c, d); sign != 0) return sign;
    const bool ab = is_before(a, b), cd = is_before(c, d);
    const Point2 &first = ab ? a : b, &second = cd ? c : d;
    if (is_before(first, second)) return ab ? -orient(d, b, c) : -orient(a, d, c);
    return cd ? -orient(a, b, d) : 1;
}

/// 1 if e is inside the sphere through a, b, c, d, -1 if outside. Precondition: orient(a, b, c, d) > 0; else the sign is turned round
/// with it, and tells nothing where a, b, c, d are in a plane.
inline int insphere(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e)
{
    const int sign = filter::insphere(a, b, c, d, e);
    return sign != 0 ? sign : exact::insphere(a, b, c, d, e);
}

/// Where the lines a b and c d meet, rounded once. Precondition: they cross, and coordinates are at most 1e150. Cost: as the signs.
Point2 crossing(const Point2& a, const Point2& b, const Point2& c, const Point2& d);

/// The place on the line a b that is nearest to p, rounded once; a or b where it would lie beyond. Precondition: a != b, coordinates at most 1e150.
Point2 foot(const Point2& p, const Point2& a, const Point2& b);

/// Whether the processor and the compiler's flags leave the predicates exact: twenty signs that are known, most of them lost by a
/// computation in doubles. For the start of a program. Cost: some microseconds.
bool predicates_are_exact();

} // namespace druse
