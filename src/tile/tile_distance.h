#pragma once

#include "tile/tile_solid.h"

namespace druse {

/// The least distance between two solids, as far as `reach`: that, where they are farther apart. Precondition: they do not meet.
/// Cost: as the triangles of both that come within reach of each other, seen from above.
double distance(const TileSolid& a, const SolidPlace& place_a, const TileSolid& b, const SolidPlace& place_b, double reach);

} // namespace druse
