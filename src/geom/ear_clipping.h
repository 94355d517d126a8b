#pragma once

#include "geom/point.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace druse {

/// Cuts a polygon in the plane into n − 2 triangles without new points; fewer than 3 corners give none.
///
/// Strictly convex polygons are cut ring by ring: every other corner goes, then every other one of those that are left. Others
/// are clipped ear by ear, the best shaped one first. A simple polygon, concave ones and ones with straight corners included, also
/// where rounding bent these a little, comes out as triangles with an area of their own, none upon another. A polygon that crosses or touches itself, or has no
/// area, still gives n − 2 triangles that together have its boundary. Triangles run like the polygon and name its corners by
/// their place; the same polygon gives the same triangles in the same order, and so does one that differs by rounding.
/// Cost: O(n) for strictly convex polygons, O(n log n) for ordinary others; at worst O(n · reflex corners).
/// Source: Meisters, *Polygons have ears* (1975); Held, *FIST: fast industrial-strength triangulation of polygons* (2001), for
/// the order of the ears and the grid that finds what blocks one.
void clip_ears(std::span<const Point2> polygon, std::vector<std::array<std::uint32_t, 3>>& triangles);

} // namespace druse
