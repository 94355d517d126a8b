#pragma once

#include "geom/progress.h"
#include "graph/graph.h"

#include <array>
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

/// A graph that struts can be made of: finite, each edge once and with a length, each vertex with an edge. It remembers what its parts are called in the
/// graph that was given.
struct CleanGraph {
    Graph graph;
    std::uint32_t given = 0;                                  // vertices there; ids from that one on are of vertices that were put where edges cross
    std::vector<std::uint32_t> vertex_ids, edge_ids;
    std::vector<std::array<std::uint32_t, 2>> edge_ends{};    // vertices there; both pieces of an edge that was split have those of the whole

    std::string vertex_name(std::uint32_t v) const;           // `vertex 4`, or `the crossing at 0,0.5,0`
    std::string edge_name(std::uint32_t e, std::uint32_t from = 0) const; // `(4 9)`, or `(9 4)` from its second end
};

/// Vertices within `weld` of each other, or exactly at the same place, become the first of them. Normals travel along. Cost: O(n log n).
/// @throws CommandError for coordinates beyond reach, ends that are not there, an edge without length, and where there is no edge; Cancelled
CleanGraph cleaned(const Graph& graph, double weld, GraphRepairs& repairs, Progress& progress);

/// Leaves out vertices without an edge; the others keep their order. @return how many there were
std::uint32_t drop_isolated(Graph& graph);

} // namespace druse
