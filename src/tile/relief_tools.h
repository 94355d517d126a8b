#pragma once

#include "geom/point.h"
#include "tile/layered_tile.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace druse {

/// How a ridge or a dome falls off from its height to nothing.
enum class ReliefProfile { round, straight };

// Heights that these points would have, in their order, for LayeredTile::set_heights(); nothing is changed yet. Only points that are there can rise, so a relief is
// as fine as the triangles of the tile. Points of the outline are looked at on all tiles that meet there.

/// Each height goes `amount` of the way to the mean of those around it, `times` over; points that are not among them stay as they are.
/// Cost: the triangles, each time.
std::vector<double> smoothed_heights(const LayeredTile& tile, std::span<const int> points, double amount, int times);

/// What a ridge along a chain of places adds: `height` on it, nothing from `width` on to both sides. Cost: points times places.
std::vector<double> ridged_heights(const LayeredTile& tile, std::span<const int> points, std::span<const Point2> chain, double height, double width, ReliefProfile profile);

/// What a dome adds: nothing on the outline, `height` from `width` on inwards; unset: as far inside as any of these points lies. Cost: points times sides of the outline.
std::vector<double> domed_heights(const LayeredTile& tile, std::span<const int> points, double height, std::optional<double> width, ReliefProfile profile);

/// Heights by place: x and y from 0 to 1 over the box of the outline.
std::vector<double> mapped_heights(const LayeredTile& tile, std::span<const int> points, const std::function<double(const Point2&)>& height_at);

} // namespace druse
