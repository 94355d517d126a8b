#pragma once

#include "geom/point.h"
#include "graph/graph.h"

#include <cstdint>
#include <map>
#include <optional>

namespace druse {

/// What `druse info` says of a graph, clean or not: edges that are there twice count twice, and may have no length.
struct GraphFacts {
    std::uint32_t vertices = 0, edges = 0, components = 0;
    std::int64_t cycle_rank = 0;           // E − V + components: the genus of its struts
    std::optional<double> smallest_angle;  // degrees, between edges that meet and go to different places; nothing where none do
    std::map<int, std::uint32_t> valences; // vertices by number of edges
    Box bounds;
    double shortest_edge = 0, mean_edge = 0, longest_edge = 0;
};

/// Cost: linear but for the angles, of which few are measured at vertices of many edges.
GraphFacts facts(const Graph& graph);

} // namespace druse
