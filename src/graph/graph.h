#pragma once

#include "geom/point.h"
#include "graph/disk.h"
#include "graph/strut_table.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace druse {

/// Points joined by straight edges, without faces: what OBJ calls `v` and `l`, and what strut sculptures are made from.
struct Graph {
    std::vector<Point> vertices;
    std::vector<std::array<std::uint32_t, 2>> edges; // indices into `vertices`, 0-based
    std::vector<Vector> normals{};                   // by edge, the mean unit normal of the faces it lay between, or 0; empty: it came from no mesh
    StrutTable struts{};                             // the faces of the mesh that were made of it
    std::optional<Disk> disk{};                      // what is at the centre of one that graph.tess made in the unit disk; a file does not keep it

    friend bool operator==(const Graph&, const Graph&) = default;
};

} // namespace druse
