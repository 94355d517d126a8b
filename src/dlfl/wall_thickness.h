#pragma once

#include "dlfl/ray_cast.h"

#include <limits>
#include <vector>

namespace druse {

/// How much material lies under the faces of a solid.
struct WallThickness {
    std::vector<double> under; // each face, by index: the least that was found; infinite where it was no less than `reach`
    double thinnest = std::numeric_limits<double>::infinity();
    Face where; // it was found; invalid if there is no wall
};

/// Measures from the inside of each triangle along its inward normal to the first triangle on the other side, where that is turned
/// away by no more than 45 degrees from facing it: what meets at a greater angle is an edge of the solid, not a wall. Triangles are
/// asked in the middle, and those longer than `reach` near each corner too; so a wall is found where it is about as wide as thick, or
/// as the triangles are. Faces look outward. Thicknesses from `reach` on are measured only as far as `thinnest` needs them.
/// Reports its part of the work as `from` to 1. Cost: one to four rays a triangle, 1 to 3 µs each. @throws Cancelled
WallThickness wall_thickness(const Mesh& mesh, const RayCast& rays, double reach, Progress& progress, double from);

} // namespace druse
