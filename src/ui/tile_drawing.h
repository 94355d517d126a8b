#pragma once

#include "ui/tile_view.h"

#include "render/image.h"

#include <cstdint>

namespace druse::ui {

/// Draws the plane of a tile as a view shows it, and keeps what lies below the tile itself for the next time: while only that changes, its copies and the grid
/// are not drawn again.
class TileDrawing {
public:
    /// `scale` is that of the layout. The image has the size of the view.
    void draw(const TileView& view, bool dark, double scale, Image& image);

private:
    Image backdrop_;
    std::uint64_t version_ = 0; // of the view, when that was drawn
    bool dark_ = false;
};

} // namespace druse::ui
