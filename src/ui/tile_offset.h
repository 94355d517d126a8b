#pragma once

#include "ui/shown_tile.h"

#include <optional>

namespace druse::ui {

/// Where a layer of tiles that is dragged over the one below it comes to rest.
struct TileOffset {
    Point2 at{0.0};          // of the layer above
    bool is_allowed = false; // the stack is isohedral
};

/// Draws an offset to places within `reach`: a point of the tile over a point of the layer below, else over an edge of a triangle there, as far as that
/// keeps the stack isohedral; else to the nearest offset that does. A stack of mirrors stays one; in a free one every offset is allowed.
TileOffset attract(const ShownTile& shape, const Point2& wanted, double reach);

} // namespace druse::ui
