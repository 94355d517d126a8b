#pragma once

#include "tile/tile_solid.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace druse {

/// What holds of a tile, and by how much; what should be 0 is so but for rounding.
struct TileCheck {
    std::vector<std::string> faults; // what does not hold of what a tile promises; and a top under the bottom

    int aspects = 0, orbits = 0;
    double area = 0, cell = 0;   // aspects · area is the area of a cell of the lattice
    double edge_mismatch = 0;    // of pieces of the outline and those of the neighbours that lie there, the other way round

    struct Solid { // of a tile with thickness
        double volume = 0, volume_expected = 0; // thickness · area
        double carved_area = 0;
        double bottom_mismatch = 0;  // of the bottom and the top of the layer below
        double aspect_mismatch = 0;  // of bottoms that are carved for different aspects; not of a free stack
        int members = 1;             // different solids
        Thinnest thinnest;           // of all of them
        double clearance = 0;        // least distance from any neighbour, as far as twice what was asked for; 0: not asked for
        double volume_left = 0;      // of the solids with clearance, on the average
        double lost = 0;             // area that the clearance cuts off the outline, of all of them
        std::vector<std::array<int, 3>> leaves; // the ways a tile of the uppermost layer can go at first; none: it is locked
    };
    std::optional<Solid> solid;
    std::vector<TilePart> parts; // the different solids

    bool sound() const { return faults.empty(); }
};

/// Looks at all of it: the covering lemma (outline simple, each piece shared with exactly one copy, aspects · area = cell), the volume, the bottoms of all aspects against
/// the layer below, the least thickness, and which of the 26
/// directions of a cube's sides, edges and corners no wall and no bottom bars. With a clearance, the distance of each different solid from all its neighbours too.
TileCheck check(const LayeredTile& tile, double clearance = 0);

} // namespace druse
