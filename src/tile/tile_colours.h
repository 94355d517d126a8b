#pragma once

#include <vector>

namespace druse {

struct IsohedralType;

/// A colouring in which tiles that share an edge differ. It repeats after `period` places of the lattice each way.
struct TileColours {
    int count = 2;  // three where three tiles meet at a corner
    int period = 1; // the least that does
    std::vector<int> colour; // of aspect a at (i, j): (a · period + i mod period) · period + j mod period

    int of(int aspect, int i, int j) const;
};

/// Precondition: the neighbours of the type are known.
TileColours colour_tiles(const IsohedralType& type);

} // namespace druse
