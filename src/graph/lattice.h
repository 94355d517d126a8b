#pragma once

#include "geom/progress.h"
#include "graph/graph.h"

#include <array>
#include <optional>

namespace druse {

enum class Net { diamond, srs };
enum class Trim { cell, box, ball };

/// A piece of a crystal net. Coordinates are whole numbers with period 4, a cubic cell.
struct LatticeShape {
    Net kind = Net::diamond;
    std::array<int, 3> cells{2, 2, 2};
    bool twin = false;          // the second net, in the gaps of the first
    Trim trim = Trim::box;
    bool leaves = true;         // false: vertices with one edge are taken away until there are none
    double bond = 1;            // length of the edges
    std::optional<double> size; // radius of Trim::ball in cells; half the least of `cells` if it is not given
};

/// The piece, centred at the origin. Per cell and net the diamond has 8 vertices and 16 edges, valence 4, 109.47° between them; srs, the net
/// (10,3)-a, has 8 and 12, valence 3, 120° and all three in a plane, and no ring of fewer than 10 edges. It is chiral, and its twin the mirror image.
///
/// Vertices that have lost all their edges are left out. They are numbered from below, then from least y, then from least x, the first net first;
/// edges by their lower, then by their higher end.
/// @throws CommandError if nothing is left, or a ball holds more than 10 million vertices; Cancelled
/// Source: Wells 1977; Hyde, O'Keeffe & Proserpio 2008.
Graph lattice(const LatticeShape& shape, Progress& progress);

} // namespace druse
