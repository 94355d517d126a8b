#pragma once

#include "cell/cell_solid.h"
#include "geom/progress.h"

#include <vector>

namespace druse {

/// The steps to all cells whose boxes come within `reach` of that of a solid of the tile, but itself; ascending. @throws CommandError where there are more than 100 000
std::vector<LatticeStep> cells_near(const CellTile& tile, const CellSolid& solid, double reach);

/// In which of the 26 directions (-1, 0 or 1 along each axis, not all 0) a cell leaves an assembly: one that lies on the surface of a block, so that cells whose centres
/// are ahead are not there. A triangle that looks ahead must not be against one that stays, and is asked in its middle for what it would run into later; so a very thin
/// obstacle may be missed. Where one direction is free, so is the opposite one. Cost: some microseconds a triangle and direction. @throws Cancelled
std::vector<Vector> free_directions(const CellTile& tile, const CellSolid& solid, Progress& progress);

/// The least distance between a solid of a tile and those of other cells, as far as `reach`: that, where they are farther. 0 where they cross.
double least_distance(const CellTile& tile, const CellSolid& solid, double reach, Progress& progress);

} // namespace druse
