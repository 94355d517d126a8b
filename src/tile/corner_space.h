#pragma once

#include "tile/corner_motion.h"

#include <span>
#include <vector>

namespace druse {

/// Movements of the corners of a tile: the linear combinations of some directions, which are orthogonal and of length 1.
struct CornerSpace {
    std::vector<CornerVector> directions;

    int dimension() const { return static_cast<int>(directions.size()); }

    /// The movement nearest to `v`.
    CornerVector project(const CornerVector& v) const;

    /// The smallest movement that brings corner k as near as it can come to a place `by` away.
    CornerVector drag(int k, const Point2& by) const;

    /// In how many dimensions corner k can be moved: 0, 1 or 2.
    int freedom(int k) const;
};

/// All that give 0 in every one of `conditions`, of the first `count` coordinates. Conditions may depend on each other; what differs by less
/// than 1e-9 of their size counts as dependent.
CornerSpace solutions(std::span<const CornerVector> conditions, int count);

/// The coordinates, of those in `order`, that can be chosen freely one after the other, until they settle all others.
std::vector<int> free_coordinates(const CornerSpace& space, std::span<const int> order);

/// Movements by which the coordinates in `parameters` change by 1, one each. Precondition: they are what free_coordinates() chose.
std::vector<CornerVector> unit_movements(const CornerSpace& space, std::span<const int> parameters);

} // namespace druse
