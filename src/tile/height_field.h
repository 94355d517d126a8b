#pragma once

#include "geom/point.h"
#include "tile/flat_grid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace druse {

/// A triangulated piece of the plane with a height at each point; linear between them.
struct HeightField {
    std::vector<Point> points;
    std::vector<std::array<std::uint32_t, 3>> triangles; // anticlockwise seen from above
};

/// How far a point is from the three sides of a triangle, in heights over them: all from 0 to 1 inside, and 1 together. Of a triangle without area,
/// those of the nearest place on its longest side.
std::array<double, 3> shares(const Point2& p, const Point2& a, const Point2& b, const Point2& c);

/// Finds heights of a field, which must stay as it is meanwhile. Cost: linear to make, some triangles each time.
class HeightFinder {
public:
    explicit HeightFinder(const HeightField& field);

    /// The height at `p`; beside the field, that of a near triangle at its rim. Precondition: the field is not empty.
    double at(const Point2& p) const;

private:
    const HeightField& field_;
    FlatGrid grid_;
};

/// Where two fields over one region come nearest to each other.
struct Thinnest {
    double thickness = 0; // of `top` over `bottom`, each as it is
    Point2 at{0.0};
};

/// The least of top − bottom, exactly: the difference is linear on each cell of the two triangulations laid over each other, so it is least at a corner of
/// a cell, and all of these are looked at. Cost: as the number of pairs of triangles that overlap.
Thinnest thinnest(const HeightField& top, const HeightField& bottom);

} // namespace druse
