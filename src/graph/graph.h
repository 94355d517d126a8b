#pragma once

#include "geom/point.h"

#include <array>
#include <cstdint>
#include <vector>

namespace druse {

/// Points joined by straight edges, without faces: what OBJ calls `v` and `l`, and what strut sculptures are made from.
struct Graph {
    std::vector<Point> vertices;
    std::vector<std::array<std::uint32_t, 2>> edges; // indices into `vertices`, 0-based

    friend bool operator==(const Graph&, const Graph&) = default;
};

} // namespace druse
