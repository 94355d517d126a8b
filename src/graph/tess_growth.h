#pragma once

#include "graph/hyperbolic.h"
#include "graph/symbol.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace druse {

/// A patch of a tessellation while it grows: vertices with a frame each, and half-edges, by number vertex · k + slot, that know what they are joined to.
class TessGrowth {
public:
    using Half = std::uint32_t;
    static constexpr Half none = std::numeric_limits<Half>::max();

    TessGrowth(std::span<const int> polygons, AdjacencySymbol symbol);

    /// Begins with one polygon, one vertex or one edge.
    void seed_face(int corner);
    void seed_vertex();
    void seed_edge(int slot);

    /// Adds the faces that are missing at a vertex, counter-clockwise from one that is there.
    void complete(std::uint32_t vertex);

    std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(frames_.size()); }
    std::uint32_t edge_count() const { return static_cast<std::uint32_t>(edges_.size()); }
    std::uint32_t face_count() const { return static_cast<std::uint32_t>(faces_.size()); }
    std::uint32_t vertex(Half h) const { return h / k_; }
    /// The half-edge at the lower vertex of an edge, in the order in which edges were made; and the one that it is joined to.
    Half edge(std::uint32_t e) const { return edges_[e]; }
    Half other(Half h) const { return link_[h]; }
    /// One half-edge of each face, which has the face on its left; and the next one round the face.
    Half face(std::uint32_t f) const { return faces_[f]; }
    Half next_in_face(Half h) const { return clockwise(link_[h]); }
    int sides(Half h) const { return polygons_[corner(h)]; } // of the face on its left

    /// Where a vertex is in the Poincaré disk; the point of an edge at part t of its hyperbolic length from the vertex of h.
    Motion::Complex place(std::uint32_t v) const { return frames_[v].origin(); }
    Motion::Complex along(Half h, double t) const;
    double length() const { return length_; }

private:
    std::uint32_t slot(Half h) const { return h % k_; }
    Half at(std::uint32_t v, std::uint32_t slot) const { return v * k_ + slot; }
    Half turned(Half h, bool up) const;
    Half counter_clockwise(Half h) const { return turned(h, !mirrored_[vertex(h)]); }
    Half clockwise(Half h) const { return turned(h, mirrored_[vertex(h)]); }
    /// Which corner of its vertex is on the left of a half-edge.
    std::uint32_t corner(Half h) const { return mirrored_[vertex(h)] ? slot(turned(h, false)) : slot(h); }
    bool has_face(Half h) const { return (covered_[vertex(h)] >> corner(h) & 1u) != 0; }

    std::uint32_t add_vertex(const Motion& frame, bool mirrored);
    void join(Half a, Half b);
    Half step(Half h);
    std::uint32_t key(Half h) const { return slot(h) + (mirrored_[vertex(h)] ? k_ : 0); }
    void place_from(Half h);
    void place_between(Half ahead, Half behind, int count);
    Half forced_end_ahead(Half h) const;
    Half forced_end_behind(Half h) const;
    void add_face(Half h);

    std::vector<int> polygons_;
    AdjacencySymbol symbol_;
    std::uint32_t k_;
    double length_;
    std::vector<double> angles_;          // of each slot from slot 0
    std::vector<Motion> steps_;           // from a vertex to its neighbour, by keys of the half-edge there and of the one that it is joined to
    std::vector<Motion> frames_;          // by vertex
    std::vector<char> mirrored_;          // by vertex: its slots run clockwise
    std::vector<std::uint16_t> covered_;  // by vertex: a bit for each corner that has its face
    std::vector<Half> link_;              // by half-edge
    std::vector<Half> edges_, faces_;
};

} // namespace druse
