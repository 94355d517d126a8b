#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace druse {

/// The triangles of a pane with what splits and flips made of them, without places. Points are numbered as they are in the pane, counter-clockwise along its
/// outline from corner 0, then those inside; behind them come those that splits made, in order.
struct PaneMesh {
    using Index = std::uint32_t;
    using Corners = std::array<Index, 3>;

    struct Made {
        int split = 0;
        int side = -1; // of the pane, on which it lies; -1: inside
        friend bool operator==(const Made&, const Made&) = default;
    };
    /// A side of a triangle.
    struct Place {
        Index triangle = 0, side = 0;
    };

    std::vector<Corners> triangles; // counter-clockwise
    std::vector<Index> rim;         // counter-clockwise, from corner 0
    Index own = 0;                  // points that are not of splits
    std::vector<Made> made;         // the others

    Index point_count() const { return own + static_cast<Index>(made.size()); }
    Index opposite(const Place& p) const { return triangles[p.triangle][(p.side + 2) % 3]; }
    /// The side of a triangle that runs from a to b.
    std::optional<Place> find(Index a, Index b) const;

    // Each makes one point, whose number it hands back: of the parts of a triangle the first keeps its number, the others come last.
    Index split_triangle(Index triangle, int split);
    /// Between a and b, which are the ends of an edge; side: that of the pane on which it lies, or −1.
    Index split_edge(Index a, Index b, int split, int side);
    /// Turns the edge between two triangles into the other diagonal. Precondition: there are two.
    void flip(Index a, Index b);
    /// The point behind one of the rim.
    Index next_on_rim(Index point) const;

    friend bool operator==(const PaneMesh&, const PaneMesh&) = default;
};

} // namespace druse
