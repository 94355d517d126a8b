#pragma once

#include "geom/point.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace druse {

/// Cosine and sine of the fraction i/n of a full turn, counter-clockwise from x. Directions that mirror each other come out with
/// the same digits, and multiples of 30 and 45 degrees exact, so that regular shapes are regular to the last bit they can be.
/// Precondition: n > 0.
inline Point2 turn(std::int64_t i, std::int64_t n)
{
    i %= n;
    if (i < 0) i += n;
    const std::int64_t quarter = 4 * i / n, r = 4 * i - quarter * n; // r/n of a quarter turn
    const auto within = [n](std::int64_t part) -> Point2 {           // at most half a quarter
        if (part == 0) return {1.0, 0.0};
        if (2 * part == n) return {std::sqrt(0.5), std::sqrt(0.5)};
        if (3 * part == n) return {std::sqrt(0.75), 0.5};
        const double angle = double(part) / double(n) * (0.5 * std::numbers::pi);
        return {std::cos(angle), std::sin(angle)};
    };
    Point2 p = 2 * r <= n ? within(r) : within(n - r);
    if (2 * r > n) p = {p.y, p.x};
    switch (quarter) {
    case 0: return p;
    case 1: return {-p.y, p.x};
    case 2: return {-p.x, -p.y};
    default: return {p.y, -p.x};
    }
}

/// Cosine and sine of an angle in degrees; exact for whole multiples of 30 and 45 degrees.
inline Point2 turn_by_degrees(double degrees)
{
    const double rest = std::fmod(degrees, 360.0);
    if (rest == std::trunc(rest)) return turn(static_cast<std::int64_t>(rest), 360);
    const double angle = rest * (std::numbers::pi / 180.0);
    return {std::cos(angle), std::sin(angle)};
}

} // namespace druse
