#pragma once

#include "geom/point.h"

#include <span>
#include <string>
#include <vector>

namespace druse {

/// What is done to a path from (0,0) to (1,0) before it is put on an edge: nothing, the half turn about (½,0), the mirror x → 1 − x, or the mirror
/// y → −y. The middle two exchange its ends, and it is run backwards.
enum class Preparation { none, half_turn, flip, mirror }; // written + r f g

/// The symmetry that a path must have, to be the same for all edges it is put on.
enum class PathShape { free, half_turn, flip, straight }; // written J S U I

char letter(Preparation preparation);
char letter(PathShape shape);

/// One after the other; the order does not matter.
inline Preparation operator*(Preparation a, Preparation b) { return static_cast<Preparation>(static_cast<int>(a) ^ static_cast<int>(b)); }

/// The inner points of a path, in the order in which they are met on an edge.
std::vector<Point2> prepared(std::span<const Point2> inner, Preparation preparation);

/// Carries (0,0)-(1,0) to `from`-`to`.
inline Point2 on_edge(const Point2& p, const Point2& from, const Point2& to)
{
    const Point2 along = to - from;
    return from + p.x * along + p.y * Point2(-along.y, along.x);
}

} // namespace druse
