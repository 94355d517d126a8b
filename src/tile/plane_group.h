#pragma once

#include "tile/corner_motion.h"

#include <string>
#include <vector>

namespace druse {

/// A discrete group of motions of the plane with two independent translations: one motion for each linear part that occurs, and a basis of the
/// translations. All of it is linear in the corners of a tile.
struct PlaneGroup {
    std::vector<CornerMotion> representatives; // the identity first
    std::array<CornerShift, 2> lattice;        // anticlockwise from the first to the second

    /// The representative with that linear part. Precondition: there is one.
    int find(const Turning& turning) const;
};

/// A place in a lattice: i times its first vector and j times its second.
struct LatticePlace {
    int i = 0, j = 0;

    friend bool operator==(const LatticePlace&, const LatticePlace&) = default;
};

/// The group that `generators` generate, as it is at the corners `at`. The lattice is reduced: its vectors are the shortest independent ones.
/// Preconditions: linear parts are few (a plane group), and two independent translations arise.
PlaneGroup generate(const std::vector<CornerMotion>& generators, const CornerVector& at);

/// The lattice vector `shift`, with its coordinates in the basis. Precondition: it is in the lattice, to 1e-6 of a basis vector.
LatticePlace lattice_place(const PlaneGroup& group, const CornerVector& at, const Point2& shift);

/// All translations of at most `reach` basis vectors each way, without the zero.
std::vector<CornerShift> translations(const PlaneGroup& group, int reach);

/// The order of the rotations: 1, 2, 3, 4 or 6.
int rotation_order(const PlaneGroup& group);

/// Its crystallographic name: `p1`, `pgg`, `p31m`, ….
std::string name(const PlaneGroup& group, const CornerVector& at);

} // namespace druse
