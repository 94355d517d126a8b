#pragma once

#include "geom/progress.h"
#include "graph/strut_placement.h"
#include "graph/strut_surface.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace druse {

/// Two parts of struts that do not belong together, by number: edge e is e, and vertex v is E + v.
using PartPair = std::array<std::uint32_t, 2>;

/// Parts that come near each other. Lists are ascending, and no longer than memory is worth: a crowd of thick struts has pairs without number.
struct NearParts {
    static constexpr std::size_t most = 1'000'000; // in a list
    std::vector<PartPair> pairs;   // that may meet
    bool complete = true;          // those are all there are
    std::vector<PartPair> meeting; // of edges that come as near as was asked for
};

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

    /// Pairs of parts that may meet, and pairs of edges that come as near as `least`. Cost: O(n log n) and what it tells. @throws Cancelled
    NearParts near(const StrutPlacement& placement, double least, Progress& progress) const;
    /// Calls f with all pairs that may meet, ascending and at most NearParts::most at a time, until it returns false. `known` is what near() told of
    /// the same placement: where that is not complete, they are looked for anew.
    void for_each_list(const NearParts& known, const StrutPlacement& placement, Progress& progress,
                       const std::function<bool(const std::vector<PartPair>&)>& f) const;
    /// Adds triangles of pairs of parts that meet, until there are too many. Exact, as self_intersections(). Cost: O(triangles) for each pair.
    /// @return whether there is room for more  @throws Cancelled
    bool add_contacts(const StrutSurface& surface, const std::vector<PartPair>& pairs, StrutContacts& found, Progress& progress) const;

    /// The largest factor, at most `most`, by which radii are multiplied so that none of the pairs, which are all that may meet, does any more; 0 if
    /// none does.
    double clearing_factor(const StrutPlacer& placer, const std::vector<PartPair>& pairs, double most) const;

private:
    template <class F>
    void walk(const std::vector<Box>& boxes, Progress& progress, F&& f) const;
    std::vector<Box> boxes(const StrutPlacement* placement, double least) const;
    void list_faces(const StrutTable& table, std::uint32_t part, std::vector<Face>& faces) const;
    double radius(std::uint32_t part, const StrutPlacement& placement) const;
    double distance(const PartPair& pair) const;
    bool joined(const PartPair& pair) const;

    const Graph& graph_;
    const Incidence& incidence_;
};

} // namespace druse
