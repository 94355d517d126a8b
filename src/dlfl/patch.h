#pragma once

#include "dlfl/handle.h"

#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace druse {

/// A disc of polygons that takes the place of a face with `ring` corners; Mesh::replace_faces puts it in.
///
/// Local numbers 0 … ring − 1 name the corners of the face from its start corner (corners, not vertices: a face may visit a
/// vertex twice), ring … ring + inner − 1 the new vertices. Every side i → i + 1 of the ring belongs to exactly one polygon, every
/// other side to two that run against each other; no two of those join the same vertices. Polygons run counter-clockwise, start at the vertex listed first, and the
/// first one keeps the id of the replaced face.
///
/// connect() works out once, for all faces with as many corners, what each new corner, edge and face refers to, so that putting
/// the patch in is copying with an offset.
class Patch {
public:
    Patch(int ring, int inner) : ring_(ring), inner_(inner) {}

    void add(std::span<const int> polygon);
    void add(std::initializer_list<int> polygon) { add(std::span<const int>(polygon.begin(), polygon.size())); }

    /// Pairs the sides and numbers the edges as the polygons first use them. Fails an ASSERT if the polygons are no such disc.
    void connect();

    int ring() const { return ring_; }
    int new_vertices() const { return inner_; }
    int new_edges() const { return static_cast<int>(edges_.size()); }
    int new_faces() const { return static_cast<int>(starts_.size()) - 1; } // beside the one that keeps the id
    int new_corners() const { return static_cast<int>(vertex_.size()); }
    int polygon_count() const { return static_cast<int>(starts_.size()); }

private:
    friend class Mesh;

    void check_disc(std::span<const std::uint32_t> reference, std::span<const std::uint32_t> next_side, std::span<const std::uint32_t> partner) const;

    // A reference to a corner is its place in the ring (below `ring_`) or ring_ + its number among the new corners; to a vertex,
    // the local number; to a face, the number of the polygon.
    struct Fixup {
        std::uint32_t at, ring; // new corner `at` refers to corner or vertex `ring` of the ring
    };

    int ring_, inner_;
    std::vector<int> polygons_;         // local vertex numbers, polygon after polygon
    std::vector<int> polygon_ends_;

    std::vector<std::uint32_t> vertex_, next_, previous_, face_, edge_; // of the new corners; new corner k counts as k, ring 0
    std::vector<Fixup> vertex_fixups_, next_fixups_, previous_fixups_;
    std::vector<std::uint32_t> first_polygon_corners_;                  // new corners that belong to polygon 0
    std::vector<std::uint32_t> ring_next_, ring_previous_, ring_face_;  // of the ring's corners: references as above
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_;        // new corners, the first user first
    std::vector<std::uint32_t> starts_;                                 // of the polygons: references
    std::vector<std::uint32_t> vertex_corner_;                          // of the new vertices: new corners
};

} // namespace druse
