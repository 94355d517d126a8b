#pragma once

#include "graph/strut_placement.h"

#include <vector>

namespace druse {

/// The directions, square to each other and to an edge, that corners are counted from.
struct StrutAxes {
    Vector f, g; // f × g runs along the edge
};
StrutAxes strut_axes(const Graph& graph, const StrutPlacer& placer, StrutFrame frame, std::uint32_t edge);

/// Writes the corners of polygons.
class RimPlacer {
public:
    RimPlacer(const Graph& graph, const StrutPlacer& placer, const StrutShape& shape);

    /// Those at both ends of an edge: `sides` for its first end, then as many for its second.
    void place(const StrutPlacement& placement, std::uint32_t edge, Point* corners) const;
    /// Points on a circle of radius 1, as steps along the two axes, as the polygon at the first or second end has them.
    const std::vector<Point2>& circle(std::uint32_t end) const { return circles_[end % 2]; }
    /// Which diagonal cuts the quads of the band between two polygons, a at the first end of an edge and b at its second: 1 that from the earlier
    /// corner on a, −1 that from the later one, 0 none as all of them are flat. Of the two ways to cut a skew quad one folds outward; it is the same all round.
    int diagonal(const Point* a, const Point* b) const;

private:
    const Graph& graph_;
    const StrutPlacer& placer_;
    const StrutShape& shape_;
    double twist_; // what is left of it, degrees: a whole number of sides only renames corners
    std::vector<Point2> circles_[2];
};

} // namespace druse
