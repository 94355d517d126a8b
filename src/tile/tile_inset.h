#pragma once

#include "geom/point.h"

#include <span>
#include <vector>

namespace druse {

/// A smaller polygon, and what was cut off it.
struct Inset {
    std::vector<Point2> polygon;
    double lost = 0; // area of the pieces that fell off
};

/// What is left of a simple anticlockwise polygon when each of its sides moves inwards by `by`; at reflex corners the sides meet in front of the corner, at most
/// four times as far. What falls apart is lost but for its largest piece; the polygon is empty where nothing is left.
/// The sides as they move cross each other where parts of the polygon vanish. Of the regions that they bound, those are left that they go round once more than
/// not; a Pane finds them by exact signs. Corners of what is left are `weld` apart: sides may lie off by as much.
Inset inset(std::span<const Point2> polygon, double by, double weld);

} // namespace druse
