#pragma once

#include <optional>
#include <span>
#include <vector>

namespace druse {

/// A symmetry of the polygons round a vertex: slot i goes to shift + i, or to shift − i if it is a reflection. Modulo their number.
struct SlotSymmetry {
    int shift = 0;
    bool mirrored = false;
};

/// How the vertices of a vertex-uniform tessellation are joined: the adjacency symbol of Grünbaum & Shephard.
///
/// k polygons lie round a vertex, numbered counter-clockwise; slot i, an edge, is between polygon i − 1 on its right and polygon i on its
/// left, looking out. The edge in slot i is that in slot partners[i].slot of the vertex at its other end, whose polygons are numbered the same
/// way round, or the other way if `mirrored`. All this is meant up to the symmetries of a vertex, a subgroup of those of its polygons.
struct AdjacencySymbol {
    struct Partner {
        int slot = 0;
        bool mirrored = false;
        friend bool operator==(const Partner&, const Partner&) = default;
    };

    std::vector<Partner> partners;
    std::vector<SlotSymmetry> stabiliser; // of a vertex; the identity is one of them

    /// After how many steps round the polygon of a corner its corners repeat, up to the stabiliser. It divides the number of sides.
    int period(int corner) const;
    /// Whether the tessellation has a mirror line that halves this corner.
    bool is_mirrored_at(int corner) const;
};

/// The symbol of the most symmetric vertex-uniform tessellation with these polygons round each vertex, or nothing if there is none.
///
/// Tries the groups that a vertex may keep from the largest to the smallest; for each of them symbols without mirrored partners first, and of
/// those the one that comes first in the order of slots. Precondition: 3 to 12 polygons.
/// Cost: a search with backtracking that walks round polygons prune; µs as a rule, 0.1 s for twelve polygons nearly all of which are the same.
/// Source: Grünbaum & Shephard 1987, 2.1 and 6.3.
std::optional<AdjacencySymbol> find_symbol(std::span<const int> polygons);

} // namespace druse
