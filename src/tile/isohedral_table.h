#pragma once

#include <span>
#include <string_view>

namespace druse {

/// One of the eleven ways in which equal corners can surround a tile, with a polygon for it: the tile of the most regular net, all of whose
/// edges touch one circle. It is an admissible tile of every type on that net.
struct TileNet {
    std::string_view name;     // valences round the tile, `3^4.6`
    std::string_view valences; // of corner 0, 1, …
    std::span<const double> corners; // x0 y0 x1 y1 …
    int held = 0;              // the corner at the origin
};

/// One type of isohedral tiling: everything else is derived from this line.
struct TileLine {
    int number = 0;
    int net = 0;
    std::string_view tile, adjacency; // the incidence symbol
    std::string_view placed;          // partners of edges 0, 1, …, by which each tile is reached once; `=`: those of the symbol
};

std::span<const TileNet> tile_nets();

/// The 81 types that tiles without marks can have, of 93; by number. Source: Grünbaum & Shephard 1987, ch. 6.
std::span<const TileLine> tile_lines();

} // namespace druse
