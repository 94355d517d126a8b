#pragma once

#include "cell/cell_tile.h"
#include "io/tile_json.h"

namespace druse {

/// The cell of a `.tile` file of that kind. Keys that this program does not know are kept for the writer.
/// @throws InputError with line and path of the key where something is not what it should be
CellTile read_cell(const TileJsonFile& file);

/// The file of a cell, as a tree.
TileJson cell_json(const CellTile& tile);

} // namespace druse
