#pragma once

#include "geom/point.h"

#include <array>
#include <cstdint>

namespace druse {

using Triangle = std::array<Point, 3>;

/// How a triangle can be drawn in a plane of two axes without losing its area.
struct Shadow {
    std::int8_t axis = 0; // the coordinate that is left out
    std::int8_t turn = 0; // 1: the corners run counter-clockwise in the two that follow it cyclically; -1: clockwise; 0: it has no area
};

/// Exact. The axis is the one closest to the normal, as far as doubles tell.
Shadow shadow_of(const Triangle& t);

/// Do two triangles meet anywhere but in corners and sides that they have in common?
///
/// Corners are common if they are at the same place, sides if both ends are. So neighbours in a mesh may have a corner or a side in
/// common and no more, whichever vertices hold it; a corner of one that touches the other's side or inside is a contact, and so are
/// two triangles upon each other. Exact: every branch is a sign of predicates.h.
/// Preconditions: finite, and both with an area, of which `shadow` is that of `a`.
/// Cost: 20 to 100 ns; a few microseconds where the two are nearly in one plane and not apart in it.
/// Source: Guigue & Devillers 2003, for two triangles without a common corner.
bool meet_beyond_common(const Triangle& a, Shadow shadow, const Triangle& b);

} // namespace druse
