#pragma once

#include "dlfl/errors.h"
#include "geom/progress.h"
#include "pane/triangulation.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace druse {

/// Names of points and segments: numbers that are never given twice while a pane lives, in the order in which things were made.
enum class PointId : std::uint32_t {};
enum class SegmentId : std::uint32_t {};

enum class PointKind : std::uint8_t { boundary, interior, crossing };

/// Why an edit of a pane did not take place; the pane is as it was, bit for bit.
class PaneRefusal : public CommandError {
public:
    enum class Reason : std::uint8_t {
        outside, coincides, boundary_crosses, boundary_touches, swallows_point, too_few_points, locked, same_point,
        no_such_point, no_such_segment, no_such_edge, unresolvable, range, angle_too_large
    };
    PaneRefusal(Reason reason, const std::string& what);
    Reason reason() const { return reason_; }

private:
    Reason reason_;
};

/// The word for a reason in messages, as `boundary-crosses`.
const char* name(PaneRefusal::Reason reason);

/// A motion of the plane, or a reflection: p ↦ (p.x·x + p.y·y) + shift.
struct Isometry {
    Point2 x{1, 0}, y{0, 1}, shift{0, 0};
    Point2 operator()(const Point2& p) const { return p.x * x + p.y * y + shift; }
};

/// Two points that are ends of an edge, in either order.
struct PaneEdge {
    PointId a, b;
};

/// What an edit did, by ids: for the caller's data on points.
struct PaneReport {
    struct Split {
        PointId made, from, to; // a point made on the edge from → to, which carried a segment or the boundary
    };
    struct Merge {
        PointId gone, into;
    };
    std::vector<PointId> made, removed; // those merged are in `merged` only
    std::vector<Split> splits;
    std::vector<Merge> merged;
    std::vector<SegmentId> segments_made, segments_removed;
    std::vector<std::string> notes;

    void clear();
};

/// Is told what an edit did, after it is done and not if it was refused. It must not edit the pane.
class PaneListener {
public:
    virtual ~PaneListener() = default;
    virtual void split(PointId /*made*/, PointId /*from*/, PointId /*to*/) {}
    virtual void merged(PointId /*gone*/, PointId /*into*/) {}
    virtual void removed(PointId /*gone*/) {}
};

class Refiner;

/// A flat region with a boundary, points and constraint segments, kept triangulated after every edit.
///
/// The boundary is one outer loop, counter-clockwise, and hole loops, clockwise. A segment is a chain of points whose pieces are edges. Triangles are
/// constrained Delaunay and depend on points, segments and loops alone, not on the order of edits (see Triangulation for ties).
///
/// `snap` is how near a new place means a thing that is there: nearest point, else nearest boundary edge or piece of a segment (the foot on
/// it), else, within a quarter of it, nearest free edge. 0: never. No two points are nearer than `weld`; a place nearer to a point is that point.
///
/// Every edit happens whole or throws PaneRefusal and changes nothing. Points with twins take these along in the same edit.
/// Cost: an edit of one point, beside what it changes, a microsecond or two at any size; an edit that takes a loop elsewhere, a walk through it too.
/// Not for several threads at once, reading included: looking for a place remembers where it was found.
/// Sources: Howison & Séquin 2009, section 2, and those of Triangulation; Ruppert 1995 and Shewchuk 2002 for refine().
class Pane {
public:
    using Index = Triangulation::Index;
    using Reason = PaneRefusal::Reason;
    static constexpr Index none = Triangulation::none;

    struct Settings {
        std::optional<double> snap; // unset: 1/500 of the longer side of the boundary's box
        std::optional<double> weld; // unset: 1e-9 of it
    };
    enum class Through : std::uint8_t { join, cut }; // segments through a removed point: run on straight, or end before it

    /// Points are numbered along the loop, then along each hole, as they are given; a loop that turns the wrong way is turned round, with a note.
    Pane(std::span<const Point2> loop, std::span<const std::vector<Point2>> holes, const Settings& settings);
    Pane(std::span<const Point2> loop, std::span<const std::vector<Point2>> holes) : Pane(loop, holes, Settings()) {}
    explicit Pane(std::span<const Point2> loop) : Pane(loop, {}, Settings()) {}

    // --- edits of points ---------------------------------------------------------------------------------------------------------------
    /// A point at `at`, or the one that is there. On a piece of a segment or a boundary edge it splits that; `edge` names it if it is known.
    /// Refused: outside; coincides, if `strict` and a point is there.
    PointId add(const Point2& at, std::optional<PaneEdge> edge = {}, bool strict = false);
    /// Splits a boundary edge (without `edge` the nearest) and takes the new point to `at`.
    PointId add_boundary(const Point2& at, std::optional<PaneEdge> edge = {});
    /// Takes a point with its segments elsewhere; onto another point, the two become one. The id that is left is handed back.
    PointId move(PointId point, const Point2& to);
    void remove(PointId point, Through through = Through::join);
    /// Points that may not be moved or removed.
    void lock(std::span<const PointId> points, bool on = true);
    /// From now on `other` is where `map` takes `point`: moved and removed with it, split with it where both ends of an edge have twins by one map.
    /// Say both directions.
    void add_twin(PointId point, PointId other, const Isometry& map);
    /// Many interior points at once. Places are taken as they are given: only `weld` counts. Cost: n log n, with small factors.
    std::vector<PointId> add_all(std::span<const Point2> points);

    /// Another `snap` for the edits to come, 0 to 1e150.
    void set_snap(double snap);

    // --- edits of segments ----------------------------------------------------------------------------------------------------------------
    /// A segment along a path of points, straight from each to the next; it passes through points within `snap` of it, and meets other
    /// segments in crossing points. One that is there already is handed back, with a note.
    SegmentId constrain(std::span<const PointId> path);
    SegmentId constrain(PointId from, PointId to) { return constrain(std::array{from, to}); }
    SegmentId constrain_line(std::span<const Point2> line);
    /// Many segments between two points each; only points that lie on one exactly are passed through. Those from a point to itself, and those over
    /// the way of another, are left out of what is handed back.
    std::vector<SegmentId> constrain_all(std::span<const std::pair<PointId, PointId>> ends);
    /// Crossing points that two segments no longer share go with it.
    void unconstrain(SegmentId segment);
    void unconstrain(PointId from, PointId to);

    // --- quality -------------------------------------------------------------------------------------------------------------------------
    struct Refinement {
        double min_angle = 20;          // degrees, at most 30
        std::optional<double> max_area; // of a triangle
        bool split_boundary = false;    // else loops stay as they are, and angles beside them may fall short
    };
    struct Refined {
        std::size_t made = 0;          // points
        std::size_t falling_short = 0; // triangles whose smallest angle is still less, or whose area more
        std::size_t too_large = 0;     // those of them whose area is more
        bool complete = true;          // false: so many points did not do as were allowed
    };
    static constexpr std::size_t most_refined = 1'000'000; // points that one refinement may make
    /// Adds points until no angle is smaller than asked for, but those that lines of the pane make: Ruppert's method, with Shewchuk's shells of lengths
    /// about sharp corners. Areas are brought down beside edges that may not be split too, where the angles stay small. Angles above 20.7 degrees it may not meet: then it
    /// ends at fifty points for each that was there, and what areas take beside. Refused: angle-too-large; range, where the areas take more than most_refined. @throws Cancelled through `progress`
    Refined refine(const Refinement& refinement, Progress* progress = nullptr);
    Refined refine() { return refine(Refinement()); }
    /// Removes the points of the last refinement that are still there and free.
    void unrefine();
    /// Moves each interior point that nothing holds towards the middle of what is nearest to it, `rounds` times.
    void spread(int rounds = 5);

    // --- reading -------------------------------------------------------------------------------------------------------------------------
    std::size_t point_count() const { return state_.points; }
    std::size_t boundary_count() const { return state_.boundary_points; }
    std::size_t hole_count() const { return loops_.size() - 1; }
    std::size_t segment_count() const { return state_.segments; }
    std::size_t triangle_count() const { return 2 * point_count() + 2 * hole_count() - boundary_count() - 2; } // inside, as Euler's formula says
    std::size_t edge_count() const { return 3 * point_count() + 3 * hole_count() - boundary_count() - 3; }
    PointId next_point() const { return PointId(vertex_of_.size()); }
    SegmentId next_segment() const { return SegmentId(segments_.size()); }
    bool exists(PointId point) const { return std::uint32_t(point) < vertex_of_.size() && vertex_of_[std::uint32_t(point)] != none; }
    bool exists(SegmentId segment) const { return std::uint32_t(segment) < segments_.size() && segments_[std::uint32_t(segment)].first != none; }
    const Point2& position(PointId point) const { return triangulation_.position(vertex(point)); }
    PointKind kind(PointId point) const { return points_[vertex(point)].kind; }
    bool is_locked(PointId point) const { return points_[vertex(point)].locked; }
    bool is_refined(PointId point) const { return points_[vertex(point)].refined; } // by the last refinement
    std::vector<PointId> points() const; // ascending
    std::vector<PointId> loop(std::size_t i) const; // 0: the outer one; each with the inside to its left, from its smallest id
    std::vector<SegmentId> segments() const;
    std::vector<PointId> chain(SegmentId segment) const;
    double snap() const { return state_.snap; }
    double weld() const { return state_.weld; }
    /// The triangulation of the pane and of what lies around it, by vertex; id() tells the points, none for the corners of its box.
    const Triangulation& triangulation() const { return triangulation_; }
    PointId id(Index vertex) const { return points_[vertex].id; }
    Index vertex(PointId point) const;
    /// Calls f(a, b, c) with the ids of each triangle inside, counter-clockwise.
    template <class F>
    void for_triangles(F&& f) const
    {
        for (Index h = 0; h < triangulation_.side_end(); h += 4)
            if (triangulation_.is_face(h) && triangulation_.is_inside(h))
                f(id(triangulation_.origin(h)), id(triangulation_.origin(h + 1)), id(triangulation_.origin(h + 2)));
    }
    /// Calls f(point, other, map) for the twins whose points are both still there.
    template <class F>
    void for_twins(F&& f) const
    {
        for (Index i = 0; i < twins_.size(); ++i)
            if (exists(PointId(twins_[i].point)) && exists(PointId(twins_[i].other))) f(PointId(twins_[i].point), PointId(twins_[i].other), twins_[i].map);
    }
    const PaneReport& report() const { return report_; } // of the last edit
    void set_listener(PaneListener* listener) { listener_ = listener; }
    std::uint64_t fingerprint() const; // of every byte that an edit could change
    std::size_t bytes() const;         // of memory, beside the pane itself
    /// The same to everyone who asks by ids, wherever it lies in memory. Cost: n log n.
    friend bool operator==(const Pane& a, const Pane& b);

    // --- going back --------------------------------------------------------------------------------------------------------------------------
    struct PointData {
        PointId id{none};
        Index first_knot = none;
        Index loop = none; // of a boundary point
        PointKind kind = PointKind::interior;
        bool locked = false, refined = false;
    };
    struct Knot { // where a segment passes a point
        Index vertex = none, segment = none, next = none, previous = none;
        Index sibling = none; // the next knot at the same point
    };
    struct Ends {
        Index first = none, last = none;
    };
    struct Twin {
        Index point = none, other = none, next = none;
        Isometry map;
    };
    struct State {
        std::size_t points = 0, boundary_points = 0, segments = 0;
        Index free_knots = none;
        double snap = 0, weld = 0;
    };
    /// The way back to before an edit, and forth again.
    struct Change {
        Triangulation::Change triangulation;
        Journaled<PointData>::Change points;
        Journaled<Index>::Change vertex_of, loops, first_twin;
        Journaled<Knot>::Change knots;
        Journaled<Ends>::Change segments;
        Journaled<Twin>::Change twins;
        State state;
        std::size_t bytes() const;
    };
    /// What the last edit changed; once for each edit.
    Change take_change();
    void undo(Change& change);
    void redo(Change& change);

private:
    using Place = Triangulation::Place;

    /// What a new place means.
    struct Meaning {
        Point2 at{0, 0};
        Index vertex = none;                  // a point that is there
        Index edge_from = none, edge_to = none; // an edge that carries something
        Place place;                          // where `at` lies, if its side is set
    };
    struct Pending { // a piece of a segment or loop that is to become an edge
        Index from, to;
        std::uint32_t bits;
    };

    template <class F>
    auto edit(F&& f);
    void begin();
    void settle();
    void finish();
    void roll_back() noexcept;

    // points
    [[noreturn]] void refuse(Reason reason, const std::string& what) const;
    std::string text(const Point2& p) const;
    std::string text(Index v) const;
    void require_range(const Point2& p) const;
    void require_free(Index v) const;
    Index vertex_asked(PointId point) const;
    Meaning interpret(const Point2& p, double snap, Index ignored, bool only_inside) const;
    Meaning on_edge(const Point2& p, Index from, Index to, double snap, Index ignored) const;
    Meaning on_asked_edge(const Point2& p, const PaneEdge& edge) const;
    bool is_inside_or_edge(const Place& at) const;
    void make_point(Index v, PointKind kind);
    void make_boundary(Index v, Index loop);
    Index put(const Point2& p, Index moved = none, Place at = {});
    Index split_edge(Index from, Index to, const Point2& p, Index moved = none);
    void lead_through(Index v, Index from, Index to, std::uint32_t bits);
    Index do_add(const Meaning& meaning);
    Index do_add_boundary(const Point2& at, Index from, Index to);
    Index do_move(Index v, const Point2& to, double snap);
    Index merge(Index v, Index w);
    void do_remove(Index v, Through through);
    void forget_point(Index v);
    void untie(Index v);
    void pend_pieces(Index v);
    std::pair<Index, Index> loop_neighbours(Index v) const; // before and after it
    std::size_t loop_size(Index v) const;
    Index nearest_loop_edge(const Point2& p) const;
    void twin_split(Index made, Index a, Index b);

    // segments
    Index add_knot(Index v, Index segment, Index after);
    void remove_knot(Index k);
    void cut_at(Index k);
    void shorten(Index k);
    bool has_piece(Index u, Index v) const;
    void release_piece(Index u, Index v);
    void split_pieces(Index u, Index v, Index w);
    void pend(Index u, Index v, std::uint32_t bits) { pending_.push_back({u, v, bits}); }
    void realise();
    void meet(const Pending& piece, Index crossed);
    Index new_segment();
    void drop_segment(Index segment);
    Index double_of(Index segment) const;
    void tidy_crossings();
    std::vector<Index> near_line(Index u, Index v, double reach) const;
    SegmentId do_constrain(std::span<const Index> path);
    template <class F>
    SegmentId constrain_once(F&& find_path); // and not where it is there already

    // quality
    friend class Refiner;

    // restoring
    friend Pane restore(const struct PaneRecord& record);
    void take_ids(std::span<const std::uint32_t> ids, std::span<const std::uint32_t> new_of, std::uint32_t next);
    void take_segment(std::uint32_t id, std::span<const PointId> path);
    void take_marks(std::span<const PointId> crossings, std::span<const PointId> refined);
    void skip_segments(std::uint32_t next);

    // loops
    void flood();
    Index region_over(Index h, Index here) const;
    void spread_region(Index start, Index region, bool all);
    Index region_far(Index known, Index face) const;

    template <class Self, class F>
    static void for_arrays(Self& self, F&& f);

    Triangulation triangulation_;
    Journaled<PointData> points_;      // by vertex
    Journaled<Index> vertex_of_;       // by id
    Journaled<Knot> knots_;
    Journaled<Ends> segments_;         // by id
    Journaled<Index> loops_;           // a vertex of each
    Journaled<Index> first_twin_;      // by id
    Journaled<Twin> twins_;
    State state_, before_;
    PaneReport report_;
    PaneListener* listener_ = nullptr;

    // Of the edit under way.
    bool loops_changed_ = false;
    std::size_t crossings_made_ = 0;
    std::vector<Pending> pending_;
    std::vector<std::pair<Index, Index>> new_pieces_;
    std::vector<Index> loose_crossings_;
    std::vector<Index> flood_stack_;
    std::vector<Index> region_, flooded_; // of faces; those whose region is known
};

/// Runs f as one edit: all of it, or nothing if anything throws.
template <class F>
auto Pane::edit(F&& f)
{
    begin();
    try {
        const auto result = f();
        finish();
        return result;
    } catch (...) {
        roll_back();
        throw;
    }
}

} // namespace druse
