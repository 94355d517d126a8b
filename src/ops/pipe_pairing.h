#pragma once

#include "dlfl/rung.h"
#include "geom/point.h"
#include "geom/progress.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace druse {

struct Pairing {
    std::optional<std::array<int, 2>> first; // the corners that the first rung joins; else those that give the least twist
    int shift = 0;                           // turns the band on by so many corners; for faces with equally many
};

/// The rungs of a band between the boundaries of two faces, whose corners lie at these points, in face order.
///
/// Going up in the one face is going down in the other, since facing boundaries run against each other. Between n corners each there are
/// n rungs, and the sum of their squared lengths is the least of all n pairings; of pairings that differ by less than 1e-9 of it, the one
/// that is nearest to joining the closest two corners counts. Between n and m < n corners there are n rungs, m quads and n − m triangles,
/// and the sum is the least of all bands.
/// Cost: O(n²); between different numbers O(n² m), above 5e7 the bands from the 16 nearest pairs only, O(n m).
/// @throws CommandError if n · m passes 2³⁰; Cancelled
/// Source: Fuchs, Kedem & Uselton 1977, for different numbers.
std::vector<Rung> pair_corners(std::span<const Point> from, std::span<const Point> to, const Pairing& pairing, Progress& progress);

} // namespace druse
