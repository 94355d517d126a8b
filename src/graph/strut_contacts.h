#pragma once

#include "geom/progress.h"
#include "graph/strut_placement.h"
#include "graph/strut_surface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace druse {

/// Two parts of struts that do not belong together, by number: edge e is e, and vertex v is E + v.
using PartPair = std::array<std::uint32_t, 2>;

/// Where parts of a surface meet.
struct StrutContacts {
    static constexpr std::uint64_t most = 10'000; // pairs of triangles to look for
    std::uint64_t pairs = 0;     // of triangles
    std::vector<Face> faces;     // that hold one of them, ascending
    std::vector<PartPair> parts; // that do
};

/// Tells which parts of struts may meet where the graph does not join them.
///
/// A strut lies in the points as near to its edge as its larger end is wide, a ball in the sphere that its corners are on. Where these are
/// disjoint for all edges without a common vertex, for vertices and edges elsewhere, and for vertices that are not neighbours, nothing meets; parts
/// that a graph joins meet in their common polygon only, by construction.
class StrutNeighbours {
public:
    StrutNeighbours(const Graph& graph, const Incidence& incidence) : graph_(graph), incidence_(incidence) {}

    /// Pairs of parts that may meet, and all pairs of edges that come as near as `least`. Ascending. Cost: O(n log n) and what it tells. @throws Cancelled
    std::vector<PartPair> near(const StrutPlacement& placement, double least, Progress& progress) const;
    /// Whether two parts may meet.
    bool is_near(const PartPair& pair, const StrutPlacement& placement) const;
    /// Finds triangles of pairs of parts that meet, until there are too many. Exact, as self_intersections(). Cost: O(triangles) for each pair. @throws Cancelled
    StrutContacts contacts(const StrutSurface& surface, const std::vector<PartPair>& pairs, Progress& progress) const;

private:
    void list_faces(const StrutTable& table, std::uint32_t part, std::vector<Face>& faces) const;
    double radius(std::uint32_t part, const StrutPlacement& placement) const;
    double distance(const PartPair& pair) const;
    bool joined(const PartPair& pair) const;

    const Graph& graph_;
    const Incidence& incidence_;
};

/// The largest factor, at most 1, by which radii are multiplied so that none of the pairs, which are all that may meet, does any more; 0 if none does.
double clearing_factor(const StrutNeighbours& neighbours, const StrutPlacer& placer, const std::vector<PartPair>& pairs);

} // namespace druse
