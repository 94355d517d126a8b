#pragma once

#include "ui/tile_view.h"

#include "render/image.h"

namespace druse::ui {

/// Draws the plane of a tile as the view shows it; `scale` is that of the layout. The image has the size of the view.
void draw_tile_plane(const TileView& view, bool dark, double scale, Image& image);

} // namespace druse::ui
