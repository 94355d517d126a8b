#pragma once

#include "geom/point.h"
#include "geom/progress.h"

#include <cstdint>
#include <vector>

namespace druse {

/// For each point the first one that hangs together with it by steps of at most `reach`; 0: that lies at exactly the same place.
///
/// Points are halved at the median again and again. Boxes that are apart, or hold nothing that does not hang together already, are not looked into; so
/// crowds within `reach` cost no more than others. Cost: O(n log n) for points of any density. @throws Cancelled
std::vector<std::uint32_t> first_within_reach(const std::vector<Point>& points, double reach, Progress& progress);

} // namespace druse
