#pragma once

#include "render/draw_lists.h"
#include "tile/layered_tile.h"

#include <optional>
#include <string>

namespace druse::ui {

/// A tile in space, as it is drawn while it is edited: its points are the first vertices.
struct ReliefPicture {
    DrawLists lists;
    std::optional<double> thinnest; // between top and bottom
    Point thinnest_top{0.0}, thinnest_bottom{0.0}; // there
    std::string trouble;            // what is wrong with the solid

    /// Follows a tile; without one nothing is drawn.
    void follow(const LayeredTile* tile);
};

} // namespace druse::ui
