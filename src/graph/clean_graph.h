#pragma once

#include "graph/graph.h"

#include <cstdint>
#include <string>
#include <vector>

namespace druse {

/// What had to be mended in a graph; 0 where nothing had to.
struct GraphRepairs {
    std::uint32_t repeated = 0; // edges between the ends of an earlier one
    std::uint32_t welded = 0;   // vertices at the place of an earlier one
    std::uint32_t isolated = 0; // vertices without an edge
    std::vector<std::string> notes() const; // one line each
};

/// A graph that struts can be made of: finite, each edge once and with a length, each vertex with an edge.
struct CleanGraph {
    Graph graph;
    std::vector<std::uint32_t> vertex_ids, edge_ids; // what its vertices and edges are called in the graph that was cleaned
};

/// Vertices within `weld` of each other, or exactly at the same place, become the first of them. Normals travel along. Cost: O(n log n) for vertices
/// that do not crowd within `weld`.
/// @throws CommandError for coordinates beyond reach, ends that are not there, an edge without length, and where there is no edge
CleanGraph cleaned(const Graph& graph, double weld, GraphRepairs& repairs);

/// For each point the first one that hangs together with it by steps of at most `reach`; 0: that lies at exactly the same place.
std::vector<std::uint32_t> first_within_reach(const std::vector<Point>& points, double reach);

/// Leaves out vertices without an edge; the others keep their order. @return how many there were
std::uint32_t drop_isolated(Graph& graph);

} // namespace druse
