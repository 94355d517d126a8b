#pragma once

#include "geom/point.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace druse {

/// Cuts a polygon in the plane into n − 2 triangles by clipping ears.
///
/// Counter-clockwise simple polygons, concave ones included, are cut exactly along diagonals inside them; a polygon that crosses
/// itself, touches itself or has no area still gives n − 2 triangles that together have its boundary. Triangles run like the
/// polygon and name its corners by their place. Sliver ears are put off while better ones are left.
/// Cost: O(n) for convex polygons, O(n log n) for ordinary concave ones; at worst O(n · reflex corners).
/// Source: Meisters, *Polygons have ears* (1975); the search for blocking corners goes through a grid.
void clip_ears(std::span<const Point2> polygon, std::vector<std::array<std::uint32_t, 3>>& triangles);

} // namespace druse
