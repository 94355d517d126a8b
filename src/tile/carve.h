#pragma once

#include "tile/height_field.h"
#include "tile/layered_tile.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace druse {

/// Where a point of a carving has its height from: points of the tile that it lies upon, between or among.
struct HeightSource {
    std::array<std::uint32_t, 3> of{}; // at the first one,
    std::array<double, 2> share{};     // so far on the way to the others
};

/// What a cutter cuts out of the relief of a layer.
struct Carving {
    HeightField field;                        // its first points are those of the cutter, at the very same places
    std::vector<std::vector<std::uint32_t>> rim; // below each side of the cutter: the points on it, both corners among them
    std::vector<HeightSource> sources;        // of each point of the field

    /// The field as it is with other heights of the tile: no place and no triangle depends on these, so that it is what carve() makes, to the last digit.
    /// Precondition: `relief` is the surface of a tile with the same points and triangles in the plane. Cost: linear, some microseconds for 2 000 points.
    HeightField over(const HeightField& relief) const;
};

/// The relief of the layer of `tile` as `carried` brings it, cut out along a polygon: the height at x is layer_height(inverse(carried)(x)). All edges of the relief that
/// lie inside are edges of the field.
///
/// Points of the relief within weld() of a corner or side of the cutter are moved there, and edges of it within weld() of a corner run through that; from then on exact signs decide, in a
/// Pane of what lies along the cutter. What lies farther inside is taken as it is. Points that copies of the tile have in common are one point, with the same digits.
/// Precondition: `cutter` is simple and anticlockwise; its corners are weld() apart.
/// With a larger `weld`, that is meant instead of weld(), and points of the relief that are nearer to each other are one: no edge of the field is shorter.
/// Cost: linear in the triangles that the cutter covers, with a large factor only for those along its sides.
/// Source: Howison & Séquin 2009, section 2.2; here copies are found by their boxes instead of by a walk.
Carving carve(const LayeredTile& tile, std::span<const Point2> cutter, const Isometry& carried);
Carving carve(const LayeredTile& tile, std::span<const Point2> cutter, const Isometry& carried, double weld);

} // namespace druse
