#pragma once

#include "geom/point.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace druse {

/// Fills in vectors at points of a flat triangulation, those in `unknown`, so that they vary as little as the others let them: the harmonic map, linear on each
/// triangle. So vectors that are a linear function of the place are filled in by that function. `values` of all points are given, and changed in place.
/// Cost: that of conjugate gradients, some tens of passes over the triangles.
/// Source: Pinkall & Polthier 1993, section 2, for the weights.
void fill_harmonic(std::span<const Point2> points, std::span<const std::array<std::uint32_t, 3>> triangles, std::span<const std::uint32_t> unknown,
                   std::vector<Vector>& values);

} // namespace druse
