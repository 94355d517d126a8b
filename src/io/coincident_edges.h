#pragma once

#include "dlfl/mesh.h"
#include "io/output_files.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace druse {

/// Edges that lie upon each other, for a format of loose facets: columns that holes of a rind leave where they meet at a corner, the rungs of
/// walls without thickness, solids that touch along an edge. A reader finds neighbours by places only, and would have four facets at one side to
/// choose from. So all but one of such edges get a point of their own in the file, and faces beside them are cut so that their triangles have no
/// side in common with others there.
///
/// Places are those in single precision. Edges on both sides of a two-sided face are one, since the file does not hold the face.
class CoincidentEdges {
public:
    /// Cost: O(vertices and edges).
    explicit CoincidentEdges(const Mesh& mesh);

    bool empty() const { return divided_.empty(); }
    /// True if one of the sides of the face lies upon another edge.
    bool concern(Face f) const;

    /// The triangles of a face, `cut` as Triangulator does it, as they go into the file. Precondition: concern(f).
    const std::vector<std::array<Point, 3>>& triangles(const std::vector<std::array<Corner, 3>>& cut);

    /// Says how many edges are divided, and whether there are walls without thickness between them, as rind.punch leaves.
    void note(OutputFiles& out) const;

private:
    using Sides = std::uint64_t; // two places, the lower one first
    Sides between(Corner a, Corner b) const;
    Edge without_lunes(Edge e) const;
    void put(const std::array<Corner, 3>& t);

    const Mesh& mesh_;
    std::vector<std::uint32_t> place_;                 // by vertex
    std::unordered_map<std::uint32_t, Point> divided_; // by edge
    std::unordered_set<std::uint32_t> upon_others_;    // edges, also those that are not divided
    std::unordered_set<Sides> taken_;                  // sides of triangles inside faces
    std::vector<std::array<Point, 3>> triangles_;
    std::vector<Point> ring_;
};

} // namespace druse
