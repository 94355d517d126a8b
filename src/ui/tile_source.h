#pragma once

#include "ui/shown_tile.h"

#include "ops/scene.h"
#include "tile/layered_tile.h"

#include <vector>

namespace druse::ui {

/// The layered tile that a scene holds; null if there is none.
const LayeredTile* layered_tile(const Scene& scene);

/// What the editor shows of a tile; without a type if there is none. Cost: linear in its points.
ShownTile shown_tile(const LayeredTile* tile);

/// The aspects that stand for the different solids of its stack, mirror images counted apart: the first of each kind.
std::vector<int> different_solids(const LayeredTile& tile);

} // namespace druse::ui
