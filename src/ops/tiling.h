#pragma once

#include "dlfl/patch.h"

#include <initializer_list>
#include <map>
#include <memory>
#include <vector>

namespace druse {

/// The faces of an extrusion as one tile, repeated around the base: tiers of new vertices, rows of new faces.
///
/// A tile (wedge) carries `edges` base edges, so a base with n corners takes n / edges of them. `a(k)` is the vertex of orbit `a`
/// k wedges after the tile's own. A row is written once, as it stands in the figure; on(n) is the patch it makes of n corners.
/// Vertices are numbered tier by tier, in a tier wedge by wedge, in a wedge by orbit; an apex comes last.
/// Source: Landreneau 2005, III.1 (tile patterns), for tiles with one edge.
class Tiling {
public:
    struct Spot {
        int orbit, wedge;
    };
    struct Orbit {
        int index;
        Spot operator()(int wedge) const { return {index, wedge}; }
    };

    explicit Tiling(int edges_per_wedge = 1) : edges_(edges_per_wedge) {}

    /// The base corner where base edge `edge` of the wedge starts.
    Orbit base(int edge = 0) const { return {-1 - edge}; }
    /// The next tier: so many vertices in each wedge.
    std::vector<Orbit> tier(int vertices);
    Orbit tier() { return tier(1)[0]; }
    /// A tier that is a single vertex.
    Orbit apex();

    /// The face that closes the block, these vertices from each wedge: comes first, keeps the id of the base, is what the next
    /// iteration extrudes. Where it would have two corners in all it is an edge instead.
    void top(std::vector<Orbit> orbits) { top_ = std::move(orbits); }
    /// The next row: one face for each wedge, starting at the vertex listed first.
    void row(std::vector<Spot> face) { rows_.push_back(std::move(face)); }

    int edges_per_wedge() const { return edges_; }
    int wedges(int n) const { return n / edges_; }
    int top_corners(int n) const { return static_cast<int>(top_.size()) * wedges(n); }
    bool has_top(int n) const { return top_corners(n) >= 3; }
    int rows() const { return static_cast<int>(rows_.size()); }
    int tiers() const { return tiers_; }
    int new_vertices(int n) const { return orbits_per_wedge_ * wedges(n) + (apex_ ? 1 : 0); }
    int new_faces(int n) const { return rows() * wedges(n) + (has_top(n) ? 1 : 0); } // the one that keeps the id included

    /// The number of a vertex among the corners of the base and the new vertices after them.
    int local(Spot spot, int wedge, int n) const;
    /// The new faces in order, by those numbers.
    std::vector<std::vector<int>> polygons(int n) const;
    /// The connected patch for a base with n corners, kept for the next time. Precondition: n is a multiple of edges_per_wedge().
    const Patch& on(int n) const;

private:
    struct Place {
        int before, stride, phase; // orbits in tiers below, in this tier, and in this tier before this one; stride 0 for the apex
    };

    int edges_;
    std::vector<Place> orbits_;
    std::vector<std::vector<Spot>> rows_;
    std::vector<Orbit> top_;
    int tiers_ = 0, orbits_per_wedge_ = 0;
    bool apex_ = false;
    mutable std::map<int, std::unique_ptr<Patch>> patches_;
};

} // namespace druse
