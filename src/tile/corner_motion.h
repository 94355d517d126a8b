#pragma once

#include "geom/point.h"
#include "tile/incidence_symbol.h"

#include <array>

namespace druse {

/// The corners of a tile, or anything with one number for each of their coordinates: x0 y0 x1 y1 …, zeros behind the last.
using CornerVector = std::array<double, 2 * most_corners>;

inline Point2 corner(const CornerVector& v, int k) { return {v[2 * k], v[2 * k + 1]}; }
double dot(const CornerVector& a, const CornerVector& b);

/// a + factor b.
CornerVector plus(const CornerVector& a, const CornerVector& b, double factor = 1.0);

/// Angles that are multiples of 15°, as a number from 0 to 23.
inline constexpr int full_turn = 24;
inline constexpr int turns(int n) { return ((n % full_turn) + full_turn) % full_turn; }

/// A vector of the plane that depends linearly on the corners of a tile.
struct CornerShift {
    CornerVector x{}, y{};

    Point2 at(const CornerVector& corners) const { return {dot(x, corners), dot(y, corners)}; }
};
CornerShift plus(const CornerShift& a, const CornerShift& b, double factor = 1.0);

/// The linear part of a motion: a rotation, or the reflection that turns the direction at angle φ to angle − φ.
struct Turning {
    int angle = 0; // full_turn is 360°
    bool reflects = false;

    Point2 times(const Point2& p) const;
    friend bool operator==(const Turning&, const Turning&) = default;
};
Turning operator*(const Turning& a, const Turning& b);
Turning inverse(const Turning& t);

/// A motion of the plane that belongs to a tile whatever its corners are: x ↦ M x + T V, with M fixed and a translation that is linear in the
/// corners V. The corners of a tile may move freely, and its neighbours follow.
struct CornerMotion {
    Turning turning;
    CornerShift shift;

    Point2 apply(const Point2& p, const CornerVector& corners) const { return turning.times(p) + shift.at(corners); }
};
CornerMotion operator*(const CornerMotion& a, const CornerMotion& b); // b first
CornerMotion inverse(const CornerMotion& m);

/// The motion with that linear part that carries corner `from` to corner `to`.
CornerMotion motion_of_corner(const Turning& turning, int from, int to);

} // namespace druse
