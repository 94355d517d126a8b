#pragma once

#include "pane/pane.h"
#include "tile/corner_motion.h"

namespace druse {

/// What an isometry does to directions.
inline Point2 turned(const Isometry& m, const Point2& v) { return v.x * m.x + v.y * m.y; }

/// `b` first, then `a`.
inline Isometry operator*(const Isometry& a, const Isometry& b) { return {turned(a, b.x), turned(a, b.y), a(b.shift)}; }

inline Isometry inverse(const Isometry& m)
{
    Isometry back{{m.x.x, m.y.x}, {m.x.y, m.y.y}, {0, 0}};
    back.shift = -turned(back, m.shift);
    return back;
}

inline bool reflects(const Isometry& m) { return m.x.x * m.y.y - m.x.y * m.y.x < 0; }

/// The motion as it is for a tile with these corners, `size` times as large.
inline Isometry isometry(const CornerMotion& m, const CornerVector& corners, double size)
{
    return {m.turning.times({1, 0}), m.turning.times({0, 1}), size * m.shift.at(corners)};
}

} // namespace druse
