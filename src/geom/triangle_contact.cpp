#include "geom/triangle_contact.h"

#include "geom/predicates.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace druse {

namespace {

Point2 flat(const Point& p, int axis) { return {p[axis == 2 ? 0 : axis + 1], p[axis == 0 ? 2 : axis - 1]}; }

using FlatTriangle = std::array<Point2, 3>;

FlatTriangle flat(const Triangle& t, int axis) { return {flat(t[0], axis), flat(t[1], axis), flat(t[2], axis)}; }

/// Is every corner of `other` strictly outside one and the same side of `t`, whose corners run in the direction of `turn`?
bool beyond_a_side(const FlatTriangle& t, int turn, const FlatTriangle& other)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const Point2 &p = t[i], &q = t[(i + 1) % 3];
        if (orient(p, q, other[0]) == -turn && orient(p, q, other[1]) == -turn && orient(p, q, other[2]) == -turn) return true;
    }
    return false;
}

/// Are the shadows apart? Two triangles of one plane are, if and only if they are apart themselves (separating axes).
bool shadows_apart(const Triangle& a, Shadow shadow, const Triangle& b)
{
    const FlatTriangle p = flat(a, shadow.axis), q = flat(b, shadow.axis);
    if (beyond_a_side(p, shadow.turn, q)) return true;
    const int turn = orient(q[0], q[1], q[2]);
    return turn != 0 && beyond_a_side(q, turn, p);
}

// --- no corner in common ----------------------------------------------------------------------------------------------------------

using Sides = std::array<int, 3>; // of the corners of a triangle: above a plane, in it, below

template <int (*side)(const Point&, const Point&, const Point&, const Point&)>
Sides sides_of(const Triangle& plane, const Triangle& t)
{
    return {side(plane[0], plane[1], plane[2], t[0]), side(plane[0], plane[1], plane[2], t[1]), side(plane[0], plane[1], plane[2], t[2])};
}

bool all_on_one_side(const Sides& s) { return s[0] != 0 && s[0] == s[1] && s[0] == s[2]; }

bool any_zero(const Sides& s) { return s[0] == 0 || s[1] == 0 || s[2] == 0; }

void decide(Sides& s, const Triangle& plane, const Triangle& t)
{
    for (std::size_t i = 0; i < 3; ++i)
        if (s[i] == 0) s[i] = exact::orient(plane[0], plane[1], plane[2], t[i]);
}

/// Turns the corners so that the first is alone: the two others are on the other side of the plane, or in it, but not all three.
/// @return 1 if the lonely corner's side is above, -1 if below
int put_lonely_corner_first(Triangle& t, const Sides& s)
{
    const auto above = std::count(s.begin(), s.end(), 1), below = std::count(s.begin(), s.end(), -1);
    const int lonely = above == 1 ? 1 : above == 2 ? (below == 1 ? -1 : 0) : below == 1 ? -1 : 0;
    std::rotate(t.begin(), t.begin() + (std::find(s.begin(), s.end(), lonely) - s.begin()), t.end());
    return above == 1 || (above == 0 && below == 2) ? 1 : -1;
}

bool meet_apart(Triangle a, Shadow shadow, Triangle b)
{
    Sides of_b = sides_of<filter::orient>(a, b);
    if (all_on_one_side(of_b)) return false;
    Sides of_a = sides_of<filter::orient>(b, a);
    if (all_on_one_side(of_a)) return false;
    if (any_zero(of_a) || any_zero(of_b)) {
        if (shadows_apart(a, shadow, b)) return false; // far cheaper than the signs that are open
        decide(of_b, a, b);
        if (of_b == Sides{0, 0, 0}) return true; // in one plane
        if (all_on_one_side(of_b)) return false;
        decide(of_a, b, a);
        if (all_on_one_side(of_a)) return false;
    }
    // Both planes hold the line in which they meet, and each triangle a piece of it, from one of the lonely corner's sides to the
    // other. With both lonely corners above, the pieces overlap if each begins before the other ends.
    const int a_above = put_lonely_corner_first(a, of_a), b_above = put_lonely_corner_first(b, of_b);
    if (b_above < 0) std::swap(a[1], a[2]);
    if (a_above < 0) std::swap(b[1], b[2]);
    return orient(a[0], a[1], b[0], b[1]) <= 0 && orient(a[0], a[2], b[2], b[0]) <= 0;
}

// --- one corner, p, in common -----------------------------------------------------------------------------------------------------

/// Is q in the wedge at p that runs counter-clockwise from `from` to `to`, less than half a turn? Precondition: q ≠ p.
bool in_wedge(const Point2& p, const Point2& from, const Point2& to, const Point2& q) { return orient(p, from, q) >= 0 && orient(p, q, to) >= 0; }

/// Where triangles with a common corner meet elsewhere too, they do so from there on in some direction.
bool meet_at_corner(const Point& p, Point a1, Point a2, const Point& b1, const Point& b2, Shadow shadow)
{
    if (shadow.turn < 0) std::swap(a1, a2);
    const auto flattened = [axis = shadow.axis](const Point& q) { return flat(q, axis); };
    const Point2 o = flattened(p), from = flattened(a1), to = flattened(a2), q1 = flattened(b1), q2 = flattened(b2);
    // Neighbours in a flat part are told apart here, without a sign in space that is hard to have.
    if (orient(o, from, q1) < 0 && orient(o, from, q2) < 0) return false;
    if (orient(o, to, q1) > 0 && orient(o, to, q2) > 0) return false;

    const int side1 = orient(p, b1, b2, a1), side2 = orient(p, b1, b2, a2);
    if (side1 == side2) {
        if (side1 != 0) return false;
        const bool turned = orient(o, q1, q2) < 0;
        const Point2 &start = turned ? q2 : q1, &end = turned ? q1 : q2;
        return in_wedge(o, from, to, start) || in_wedge(o, start, end, from);
    }
    const int other1 = orient(p, a1, a2, b1), other2 = orient(p, a1, a2, b2);
    if (other1 == other2) return false;
    // Each holds a piece of the line in which the planes meet, from p on. They go the same way if the side a1 a2 pierces the other
    // plane where b1 b2 crosses the line: on that side of p b1 where b2 is, or if p b1 is the line, on that side of p b2 where b1 is.
    const int down = side1 > side2 ? 1 : -1; // the side a1 a2 goes down through the plane of b
    return other1 != 0 ? orient(a1, a2, p, b1) * down < 0 : orient(a1, a2, p, b2) * down > 0;
}

// --- a side, p q, in common -------------------------------------------------------------------------------------------------------

/// In one plane, and to the same side of it. The shadow is asked first: in flat parts, where the sign in space is hard to have, the
/// other corners are on different sides.
bool meet_at_side(const Point& p, const Point& q, const Point& a, const Point& b, Shadow shadow)
{
    const Point2 from = flat(p, shadow.axis), to = flat(q, shadow.axis);
    return orient(from, to, flat(a, shadow.axis)) == orient(from, to, flat(b, shadow.axis)) && orient(p, q, a, b) == 0;
}

} // namespace

Shadow shadow_of(const Triangle& t)
{
    const Vector normal = glm::abs(glm::cross(t[1] - t[0], t[2] - t[0]));
    const int best = normal.x > normal.y ? (normal.x > normal.z ? 0 : 2) : normal.y > normal.z ? 1 : 2;
    for (int i = 0; i < 3; ++i) {
        const int axis = (best + i) % 3;
        const FlatTriangle f = flat(t, axis);
        if (const int turn = orient(f[0], f[1], f[2]); turn != 0) return {static_cast<std::int8_t>(axis), static_cast<std::int8_t>(turn)};
    }
    return {};
}

bool meet_beyond_common(const Triangle& a, Shadow shadow, const Triangle& b)
{
    std::array<std::size_t, 3> of_a{}, of_b{}; // common corners
    std::size_t common = 0;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            if (a[i] == b[j]) {
                of_a[common] = i;
                of_b[common++] = j;
            }
    switch (common) {
    case 0: return meet_apart(a, shadow, b);
    case 1: {
        const std::size_t i = of_a[0], j = of_b[0];
        return meet_at_corner(a[i], a[(i + 1) % 3], a[(i + 2) % 3], b[(j + 1) % 3], b[(j + 2) % 3], shadow);
    }
    case 2: return meet_at_side(a[of_a[0]], a[of_a[1]], a[3 - of_a[0] - of_a[1]], b[3 - of_b[0] - of_b[1]], shadow);
    default: return true;
    }
}

} // namespace druse
