#pragma once

#include "geom/colour.h"
#include "tile/layered_tile.h"

#include <array>
#include <optional>
#include <string>

namespace druse {

/// A picture that lies behind a tile, to draw after. Nothing is made of it.
struct TileTrace {
    std::string image; // its file, by its full name
    /// Where (u, v) of the picture lies in the tile frame: x = p0·u + p1·v + p2, y = p3·u + p4·v + p5. The picture's lower edge runs from (0,0) to (1,0).
    std::array<double, 6> place{1, 0, 0, 0, 1, 0};
    double opacity = 0.5;

    friend bool operator==(const TileTrace&, const TileTrace&) = default;
};
/// @throws CommandError where a picture so placed would have no area
void check_trace(const TileTrace& trace);

/// How a tile is drawn: what its file says of that under "view". Nothing else of the tile depends on it.
struct TileLook {
    std::optional<TileTrace> trace;
    std::array<Colour, 3> colours{{{204, 51, 51}, {238, 238, 238}, {51, 102, 204}}}; // of the tiling, by the numbers of TileColours

    friend bool operator==(const TileLook&, const TileLook&) = default;
};

/// What a design says of it; what it says that is none is passed over.
TileLook look(const TileDesign& design);

/// The same tile with another look. Cost: that of making it anew.
LayeredTile with_look(const LayeredTile& tile, const TileLook& look);

} // namespace druse
