#pragma once

#include "dlfl/mesh.h"
#include "dlfl/mesh_builder.h"
#include "io/output_files.h"
#include "io/point_welder.h"

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace druse {

/// Edges that lie upon each other, for a format of triangles whose reader goes by places: columns that holes of a rind leave where they meet at a corner, the rungs of
/// walls without thickness, solids that touch along an edge. A reader finds neighbours by places only, and would have four facets at one side to
/// choose from. So all but one of such edges get a point of their own in the file, and so do sides across the faces beside them, and across faces
/// that meet at a vertex with two edges, wherever another side has the same two ends. However many sides these faces have, and however many lie
/// upon each other, each side of their facets then belongs to two facets.
///
/// Places are those in single precision, and a point goes where there is none yet. Two things do not hold: where two ends are so near that there is
/// no place between them the sides stay upon each other, which is said of edges; and other faces are not looked at, so that a side across one may lie upon an
/// edge far from all that, as where a quad was made by taking away one edge of a tetrahedron.
/// Edges on both sides of a two-sided face are one, since the file does not hold the face.
class CoincidentEdges {
public:
    /// Cost: O(vertices and edges).
    explicit CoincidentEdges(const Mesh& mesh);

    bool empty() const { return near_.empty(); }
    /// True if facets of the face may have a side upon others, so that triangles() is to be asked.
    bool concern(Face f) const;

    /// The triangles of a face, `cut` as Triangulator does it, as they go into the file. Precondition: concern(f). Each face is to be asked for once.
    const std::vector<std::array<Point, 3>>& triangles(const std::vector<std::array<Corner, 3>>& cut);

    /// Says how many edges are divided, and how many could not be, and whether there are walls without thickness between them, as rind.punch leaves.
    void note(OutputFiles& out) const;

private:
    using Sides = std::uint64_t; // two places, the lower one first
    struct Place {
        Point at;
        std::uint32_t number;
    };
    static Sides between(std::uint32_t p, std::uint32_t q) { return std::uint64_t(std::min(p, q)) << 32 | std::max(p, q); }
    Place place(Corner c) const { return {mesh_.position(c), place_[mesh_.vertex(c).index]}; }
    Edge without_lunes(Edge e) const;
    void mark_near(const std::unordered_set<std::uint32_t>& upon_others, const std::vector<Vertex>& folds);
    std::optional<Place> new_place(const Point& p);
    std::optional<Place> point_between(const Point& a, const Point& b, int first);
    std::optional<Place> point_in_side(Corner from, Corner to);
    void put(const std::array<Corner, 3>& t);
    bool is_free_around(std::size_t hub) const;

    const Mesh& mesh_;
    MeshBuilder places_; // of vertices, and of points that were added
    PointWelder welder_{places_};
    std::uint32_t place_count_ = 0;
    std::vector<std::uint32_t> place_;                 // by vertex
    std::vector<bool> near_;                           // by place: a face with edges upon others has a corner there. Empty if there is none
    std::unordered_map<std::uint32_t, Place> divided_; // by edge
    std::uint32_t left_ = 0;                           // edges that could not be divided
    std::unordered_set<Sides> taken_;                  // sides of triangles between those places
    std::unordered_map<std::uint64_t, std::optional<Place>> across_; // points in sides across the face at hand, by their two corners
    std::vector<std::array<Point, 3>> triangles_;
    std::vector<Place> ring_;
};

} // namespace druse
