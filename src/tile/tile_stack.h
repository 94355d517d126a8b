#pragma once

#include "tile/tile_design.h"
#include "tile/tile_motion.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace druse {

/// The motion in the plane from each layer to the next one above.
Isometry stack_motion(const TileStack& stack);

/// Coordinates of a vector in a lattice.
Point2 lattice_coordinates(const std::array<Point2, 2>& lattice, const Point2& v);

/// The offsets d with which x ↦ S x + d carries a plane group G into itself: σ G σ⁻¹ = G. Then, and for a relief in general position only then, all
/// tiles of the stack are congruent by motions of the whole stack.
///
/// For each linear part R of G, with R′ = S R S⁻¹ and translations t, t′, that says (I − R′) d ≡ t′ − S t modulo the lattice: in coordinates of the lattice, linear
/// congruences with whole coefficients, which are solved exactly by their Smith normal form. What must be whole may differ by 1e-9.
class IsohedralOffsets {
public:
    /// `aspects`: one motion of G for each linear part; `linear`: S, its shift does not count.
    IsohedralOffsets(std::span<const Isometry> aspects, const std::array<Point2, 2>& lattice, const Isometry& linear);

    bool any() const { return any_; } // false: no offset does
    int freedom() const { return freedom_; } // 2: all offsets do, 1: all along some lines, 0: some points
    int classes() const { return static_cast<int>(starts_.size()); } // modulo the lattice and the free direction
    /// The nearest of them; of several that are as near, that which goes farthest the way of `offset`. Precondition: any().
    Point2 nearest(const Point2& offset) const;

private:
    bool any_ = true;
    int freedom_ = 2;
    std::array<Point2, 2> basis_{}; // of the lattice; of a freedom of 1, the second is along the free direction
    std::vector<Point2> starts_;    // one offset for each class
};

/// Why a stack is not isohedral, and what would be: `offset 5,5 of IH79: the nearest that is isohedral is 10,10`.
std::string not_isohedral_text(const std::string& type, std::span<const Isometry> aspects, const std::array<Point2, 2>& lattice, const TileStack& stack);

/// Which of the tiles of a layer, by aspect, have different bottoms where the offset of a stack is free: `member[a]` of aspect a, numbered from 0.
std::vector<int> stack_members(std::span<const Isometry> aspects, const std::array<Point2, 2>& lattice, const TileStack& stack);

} // namespace druse
