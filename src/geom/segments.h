#pragma once

#include "geom/point.h"

namespace druse {

/// Where two segments are nearest to each other: a + s (b − a) on the first, c + t (d − c) on the second, s and t from 0 to 1.
struct NearestPoints {
    double s = 0, t = 0;
    double distance = 0;
};

/// Either may be a single point. Source: Ericson 2005, 5.1.9.
NearestPoints nearest_points(const Point& a, const Point& b, const Point& c, const Point& d);

/// The least distance of a point from a segment. Source: Ericson 2005, 5.1.2.
double distance_to_segment(const Point& p, const Point& a, const Point& b);

} // namespace druse
