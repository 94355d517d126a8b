#pragma once

#include "geom/point.h"
#include "geom/predicates.h"
#include "pane/journaled.h"

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace druse {

/// The constrained Delaunay triangulation of points in a box: vertices and edges of the plane, without ids, segments or loops.
///
/// A side (half-edge) is the number 4t + k, k = 0 … 2, of face t; it leaves origin(h) and has its face to the left. The fourth word pair of a face
/// holds its flags. Faces and vertices live in flat arrays with free lists; their numbers change hands when something is removed.
/// The four corners of the box are vertices 0 … 3 at first; growing the box makes others. Nothing outside the pane is ever shown them.
///
/// After each public edit, every edge that nothing constrains is locally Delaunay by the exact in-circle sign; of four points on a circle
/// the diagonal at the lexicographically smallest is kept. So the edges are a function of points and constraints alone.
/// Sources: Lawson 1977 (flips), Devillers, Pion & Teillaud 2002 (walks), Devillers 2002 (removal), Anglada 1997 (constraints).
class Triangulation {
public:
    using Index = std::uint32_t;
    static constexpr Index none = 0xffffffffu;

    // What may lie on an edge; both of its sides carry it.
    static constexpr std::uint32_t segment_bit = 1, loop_bit = 0x10, hull_bit = 0x100;
    static constexpr std::uint32_t edge_bits = segment_bit | loop_bit | hull_bit;

    /// Where a place lies: in the face left of `side`, on that side, or at its origin.
    struct Place {
        enum class Kind : std::uint8_t { face, side, vertex };
        Index side = none;
        Kind kind = Kind::face;
    };

    /// The nearest things within some reach of a place.
    struct Nearby {
        Index vertex = none;
        Index fixed = none; // a side that carries a segment or a loop
        Index free = none;  // a side that carries nothing
        double vertex_distance2 = 0, fixed_distance2 = 0, free_distance2 = 0;
    };

    /// What a straight line from u to v meets first: the side u → v itself, a vertex, an edge that carries something, or nothing but free
    /// edges, which are then remembered for force_edge().
    struct Trace {
        enum class Met : std::uint8_t { edge, vertex, fixed, free };
        Met met = Met::free;
        Index at = none; // side or vertex
    };

    Triangulation() = default;
    Triangulation(const Point2& min, const Point2& max);

    // --- reading -------------------------------------------------------------------------------------------------------------------
    Index origin(Index h) const { return sides_[h].origin; }
    Index twin(Index h) const { return sides_[h].twin; } // none on the box
    static Index next(Index h) { return (h & 3) == 2 ? h - 2 : h + 1; }
    static Index previous(Index h) { return (h & 3) == 0 ? h + 2 : h - 1; }
    static Index face(Index h) { return h & ~3u; } // the first side of the face
    Index target(Index h) const { return origin(next(h)); }
    Index apex(Index h) const { return origin(previous(h)); }
    Index out(Index v) const { return vertices_[v].out; } // a side that leaves v
    Index turn(Index h) const { return twin(previous(h)); } // the next side that leaves origin(h), counter-clockwise; none on the box
    const Point2& position(Index v) const { return vertices_[v].place; }
    std::uint32_t bits(Index h) const { return (flags(h) >> (h & 3)) & edge_bits; }
    bool is_fixed(Index h) const { return bits(h) != 0; }
    bool is_inside(Index h) const { return (flags(h) & inside_bit) != 0; } // of the face
    bool is_face(Index h) const { return (flags(h) & dead_bit) == 0; }
    Index side_end() const { return sides_.size(); } // faces are face(h) for h = 0, 4, … below this, where is_face(h)
    Index vertex_end() const { return vertices_.size(); }
    bool is_corner(Index v) const { return v == state_.corners[0] || v == state_.corners[1] || v == state_.corners[2] || v == state_.corners[3]; }
    Index corner(int i) const { return state_.corners[std::size_t(i)]; }
    bool in_box(const Point2& p) const;
    /// The side from u to v, or none. Precondition: neither is a corner of the box. Cost: the lesser of their valences.
    Index find_side(Index u, Index v) const;
    std::size_t vertex_count() const { return state_.vertices; } // corners of the box included

    // --- finding -------------------------------------------------------------------------------------------------------------------
    /// Precondition: in_box(p). `from`: any side to start at; without it, a grid of known sides or the last place found.
    /// Cost: a few steps where places follow one another or points are spread evenly, √n at worst likely.
    Place locate(const Point2& p) const;
    Place locate(const Point2& p, Index from) const;
    /// What is near p, which lies at `at`. Vertex `ignored` and its edges do not count.
    Nearby look_around(const Point2& p, const Place& at, double reach, Index ignored = none) const;
    Trace trace(Index u, Index v);

    // --- changing ------------------------------------------------------------------------------------------------------------------
    /// Makes a vertex at p, which lies at `at`, not at a vertex; on an edge both parts carry what it carried. Takes the number that was freed last.
    Index insert(const Point2& p, const Place& at);
    /// Precondition: no edge at v carries anything, all edges there are Delaunay.
    void remove(Index v);
    /// Moves v if every face around it keeps turning counter-clockwise; else changes nothing and returns false.
    bool move(Index v, const Point2& p);
    /// Makes the edge that trace() found to be free of obstacles; returns its side from u to v.
    Index force_edge(Index u, Index v);
    void set_bits(Index h, std::uint32_t bits);   // adds them
    void clear_bits(Index h, std::uint32_t bits); // takes them away; legalise() then follows
    void set_inside(Index h, bool inside);
    /// Faces that changed since bits of a loop were taken away, some of them several times, some gone; until forget_changed(). Where that was not
    /// recorded, knows_changed() is false.
    bool knows_changed() const { return sides_.is_watching(); }
    template <class F>
    void for_changed(F&& f) const
    {
        for (const std::uint32_t block : sides_.watched())
            if (is_face(4 * block)) f(Index(4 * block));
    }
    void forget_changed() { sides_.unwatch(); }
    /// Flips edges that are not Delaunay, starting with those whose bits were cleared.
    void legalise();
    /// Encloses p too, with room to spare. Precondition: coordinates of p are finite.
    void grow_box(const Point2& p);
    /// Many vertices at once, in an order that keeps neighbours near in memory and in time. `made[i]` becomes the vertex of points[i]: one that was
    /// there, or was made for another of the points, where that is nearer than `weld`. A place outside the flagged part ends it: its number is
    /// returned, else `none`. Each vertex made on an edge that carries something is told in `splits`, with the ends of that edge.
    struct Split {
        Index made, from, to;
        std::uint32_t bits; // of the edge
    };
    Index insert_all(std::span<const Point2> points, double weld, std::vector<Index>& made, std::vector<Split>& splits);

    // --- recording -----------------------------------------------------------------------------------------------------------------
    struct State { // what is not in an array
        std::array<Index, 4> corners{none, none, none, none};
        Index free_faces = none, free_vertices = none;
        std::uint32_t vertices = 0;
        friend bool operator==(const State&, const State&) = default;
    };
    struct Side {
        Index origin, twin; // of the fourth in a face: flags, and the next free face
    };
    struct Vertex {
        Point2 place;
        Index out; // a side that leaves it; of a free vertex, the next free one
    };
    struct Change {
        Journaled<Side, 2>::Change sides;
        Journaled<Vertex>::Change vertices;
        State state;
        std::size_t bytes() const { return sides.bytes() + vertices.bytes(); }
    };
    void begin();
    void end() noexcept;
    Change take(); // of the recording that ended last; once
    void roll_back() noexcept;
    void prepare(Change& change, bool to_undo); // takes the memory for what follows
    void undo(Change& change) noexcept;
    void redo(Change& change) noexcept;
    std::size_t bytes() const { return sides_.bytes() + vertices_.bytes(); }
    /// A number that differs, as good as surely, where any byte of the structure does.
    std::uint64_t fingerprint() const;

private:
    static constexpr std::uint32_t any_bits = edge_bits * 7; // of any of the three sides
    static constexpr std::uint32_t inside_bit = 0x10000, dead_bit = 0x20000;

    std::uint32_t flags(Index h) const { return sides_[h | 3].origin; }
    void touch(Index h) { sides_.keep(h >> 2); }
    Side& side(Index h) { return sides_.kept(h); }
    void set_out(Index v, Index h) { vertices_.change(v).out = h; }
    Index new_face(std::uint32_t flags);
    void free_face(Index h);
    Index new_vertex(const Point2& p);
    void free_vertex(Index v);
    void glue(Index g, Index h, std::uint32_t bits);
    void put_bits(Index h, std::uint32_t bits);
    void lead_back(Index h, Index g);
    void split_face(Index h, Index v);
    void split_side(Index h, Index v);
    void join(Index v, const Place& at);
    void flip(Index h);
    bool wants_flip(Index h) const;
    void legalise_star(Index v);
    Index start_near(const Point2& p) const;
    Index far_start(const Point2& p) const;
    void lay_grid() const;
    std::size_t cell(const Point2& p) const;
    void remember(const Point2& p, Index h) const;
    bool is_near_a_side(const Point2& p, Index of_face, double reach) const;
    void fill_chain(Index base, Index first, Index last);

    Journaled<Side, 2> sides_;
    Journaled<Vertex> vertices_;
    State state_, before_;

    // Where walks start: nothing that a result depends on.
    mutable std::vector<Index> grid_;
    mutable std::size_t grid_width_ = 0, grid_points_ = 0;
    mutable Point2 grid_min_{0, 0}, grid_scale_{0, 0}, last_place_{0, 0};
    mutable Index last_ = 0;
    mutable std::uint32_t random_ = 1;

    // Scratch memory of one edit, kept for the next.
    struct ChainSide { // of the rim of what trace() crossed
        Index origin, glued;
        std::uint32_t bits;
        Index made; // in its place
    };
    std::vector<Index> queue_;
    std::vector<Index> crossed_faces_, left_rim_, right_rim_;
    std::vector<ChainSide> chain_;
    std::vector<std::array<Index, 3>> chain_stack_;
    std::vector<Index> spare_faces_;
    mutable std::vector<Index> waiting_;
    mutable std::vector<std::uint32_t> seen_;
    mutable std::uint32_t seen_now_ = 0;
};

/// The order of a Hilbert curve through the box of the points, by numbers into `points`. Cost: linear.
std::vector<std::uint32_t> hilbert_order(std::span<const Point2> points);

} // namespace druse
