#pragma once

#include "render/still.h"
#include "tile/layered_tile.h"

namespace druse {

/// A picture of the flat tiling of a tile, the copies and colours of its `.svg`, framed on one colour: white, or the background of the options,
/// of which size and background count. Cost: that of the pixels, and of the points of each copy.
Image flat_tiling(const LayeredTile& tile, const StillOptions& options);

} // namespace druse
