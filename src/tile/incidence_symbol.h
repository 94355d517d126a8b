#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace druse {

/// Corners, and edges, of an isohedral tile: at most this many.
inline constexpr int most_corners = 6;

/// How a tile meets the tiles around it: the incidence symbol of an isohedral tiling. Corners run anticlockwise, and edge k from corner k
/// to corner k + 1. Edges with the same letter are carried into one another by the symmetries of the tile.
/// Source: Grünbaum & Shephard 1987, ch. 6.
struct IncidenceSymbol {
    /// What the neighbour across an edge with some letter has there.
    struct Answer {
        int letter = 0, sign = 0;
    };

    int corners = 0;
    std::array<int, most_corners> valence{}; // tiles at each corner
    std::array<int, most_corners> letter{};  // of each edge, a = 0
    std::array<int, most_corners> arrow{};   // of each edge: 1 anticlockwise, −1 clockwise, 0 none
    std::array<Answer, most_corners> answer{}; // by letter

    /// Reads the tile symbol, like `ab+c+dc-b-`, and the adjacency symbol, like `dc-b-a`. Precondition: both are well formed.
    static IncidenceSymbol parse(std::string_view valences, std::string_view tile, std::string_view adjacency);

    int corner(int k) const { return ((k % corners) + corners) % corners; }
};

/// The neighbour across `edge`, moved back to the tile, has its edge `partner` there. Directly, by a rotation or translation, the ends of
/// the two change places; otherwise, by a reflection or glide, start lies on start.
struct TileCrossing {
    int edge = 0, partner = 0;
    bool direct = true;

    friend bool operator==(const TileCrossing&, const TileCrossing&) = default;
};

/// A symmetry of the tile: corner k goes to k + shift, or, reflecting, to shift − k.
struct OwnSymmetry {
    int shift = 0;
    bool reflects = false;

    int corner(int k) const { return reflects ? shift - k : shift + k; }
    int edge(int k) const { return reflects ? shift - k - 1 : shift + k; }
};

/// All symmetries that keep valences, letters and arrows; the identity first.
std::vector<OwnSymmetry> own_symmetries(const IncidenceSymbol& symbol);

/// All partners of all edges, edge by edge.
std::vector<TileCrossing> crossings(const IncidenceSymbol& symbol);

/// One partner for each edge: `d+e-…` names the edges (a = 0), `+` for direct; `=` means what crossings() says, where that is one each.
std::vector<TileCrossing> parse_placed(const IncidenceSymbol& symbol, std::string_view text);

/// Whether the tiles close round every corner: walking round it, all corners met have its valence, and the walk is back (up to the
/// symmetries of the tile) after a number of steps that divides it.
bool closes(const IncidenceSymbol& symbol);

} // namespace druse
