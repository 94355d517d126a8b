#pragma once

#include "graph/clean_graph.h"
#include "graph/strut_contacts.h"

#include <cstdint>
#include <vector>

namespace druse {

/// Two edges without a common vertex that meet all the same.
struct Crossing {
    std::uint32_t first, second; // edges
    double s, t;                 // where, as parts of their lengths
    Point place;
    bool along = false;          // more than a point of them does
};

/// Those among pairs of parts that come as near as `reach`.
std::vector<Crossing> crossings(const Graph& graph, const std::vector<PartPair>& pairs, double reach);

/// Puts a vertex where edges cross, or joins them at the end of one of them. The pieces of an edge keep its id, new vertices get those after all that
/// were given. Precondition: none of them runs along another. @throws Cancelled
CleanGraph split(const CleanGraph& clean, const std::vector<Crossing>& list, double reach, Progress& progress);

} // namespace druse
