#pragma once

#include "dlfl/patch.h"

#include <array>
#include <initializer_list>
#include <map>
#include <memory>
#include <vector>

namespace druse {

/// The faces of an extrusion as one tile, repeated over every edge of the base: tiers of new vertices, rows of new faces.
///
/// `a(k)` is the vertex of tier `a` that belongs to the edge k places after the tile's own, `b(k)` with b = base() the base corner. A row is
/// written once, as it stands in the figure; on(n) is the patch it makes of a base with n corners.
/// Source: Landreneau 2005, III.1 (tile patterns).
class Tiling {
public:
    struct Spot {
        int orbit, offset;
    };
    struct Orbit {
        int index;
        Spot operator()(int offset) const { return {index, offset}; }
    };

    Orbit base() const { return {-1}; }
    /// A tier with one vertex for each base edge.
    Orbit tier();
    /// A tier with two vertices for each base edge, numbered in turn.
    std::array<Orbit, 2> paired_tier();
    /// A tier that is a single vertex.
    Orbit apex();

    /// The face that closes the block: comes first, keeps the id of the base, is what the next iteration extrudes.
    void top(Orbit orbit) { top_ = orbit.index; }
    /// The next row: one face for each base edge, starting at the vertex listed first.
    void row(std::initializer_list<Spot> face) { rows_.emplace_back(face); }

    bool has_top() const { return top_ >= 0; }
    int rows() const { return static_cast<int>(rows_.size()); }
    int tiers() const { return tiers_; }
    int new_vertices(int n) const { return vertices_per_edge_ * n + single_vertices_; }

    /// The connected patch for a base with n corners; kept for the next time.
    const Patch& on(int n) const;

private:
    struct Place {
        int before, stride, phase; // vertex of edge i: n·before + stride·i + phase; stride 0 for an apex
    };
    int local(Spot spot, int edge, int n) const;

    std::vector<Place> orbits_;
    std::vector<std::vector<Spot>> rows_;
    int top_ = -1, tiers_ = 0, vertices_per_edge_ = 0, single_vertices_ = 0;
    mutable std::map<int, std::unique_ptr<Patch>> patches_;
};

} // namespace druse
