#pragma once

#include "render/draw_lists.h"
#include "tile/layered_tile.h"
#include "tile/tile_solid.h"

#include <map>
#include <optional>
#include <string>

namespace druse::ui {

/// A tile in space, as it is drawn while it is edited: its points are the first vertices.
struct ReliefPicture {
    DrawLists lists;
    std::optional<double> thinnest; // between top and bottom
    Point thinnest_top{0.0}, thinnest_bottom{0.0}; // there
    std::string trouble;            // what is wrong with the solid
    std::optional<double> volume;   // of it
    int solids = 0;                 // that the stack needs

    /// Of the tiles around it, which are shown where this is above 0: scaled about their own middles, so that joints open; 1 is touching.
    double neighbours = 0;
    bool is_shown = true; // else a mesh is, in its place

    /// Follows a tile; without one nothing is drawn. Cost: carving where more than heights and thickness have changed; else linear.
    void follow(const LayeredTile* tile);

private:
    TileSolid solid_of(const LayeredTile& tile, int aspect);
    Mesh mesh_of(const LayeredTile& tile, const TileSolid& solid, double shrink);

    std::map<int, SolidPlan> plans_; // of the solids that were drawn last, by aspect
};

} // namespace druse::ui
