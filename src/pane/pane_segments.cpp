// Segments of a Pane: chains of knots over points, and the edges that their pieces are.
#include "pane/pane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse {

using Index = Pane::Index;

namespace {

constexpr std::size_t most_crossings = 10000; // of one edit: beyond, rounding goes round in circles

double distance2_to_piece(const Point2& p, const Point2& a, const Point2& b)
{
    const Point2 u = b - a;
    const double along = std::clamp(glm::dot(p - a, u) / glm::dot(u, u), 0.0, 1.0);
    const Point2 apart = p - a - along * u;
    return glm::dot(apart, apart);
}

} // namespace

// --- knots --------------------------------------------------------------------------------------------------------------------------

/// A knot of `segment` at v, behind the knot `after` of it (none: as the first).
Index Pane::add_knot(Index v, Index segment, Index after)
{
    Index k = state_.free_knots;
    if (k != none) state_.free_knots = knots_[k].next;
    else k = knots_.add({});
    const Index next = after != none ? knots_[after].next : segments_[segment].first;
    knots_.change(k) = {v, segment, next, after, points_[v].first_knot};
    points_.change(v).first_knot = k;
    if (after != none) knots_.change(after).next = k;
    else segments_.change(segment).first = k;
    if (next != none) knots_.change(next).previous = k;
    else segments_.change(segment).last = k;
    return k;
}

void Pane::remove_knot(Index k)
{
    const Knot knot = knots_[k];
    if (knot.previous != none) knots_.change(knot.previous).next = knot.next;
    else segments_.change(knot.segment).first = knot.next;
    if (knot.next != none) knots_.change(knot.next).previous = knot.previous;
    else segments_.change(knot.segment).last = knot.previous;
    if (points_[knot.vertex].first_knot == k) {
        points_.change(knot.vertex).first_knot = knot.sibling;
    } else {
        Index at = points_[knot.vertex].first_knot;
        while (knots_[at].sibling != k) at = knots_[at].sibling;
        knots_.change(at).sibling = knot.sibling;
    }
    knots_.change(k) = {none, none, state_.free_knots, none, none};
    state_.free_knots = k;
}

bool Pane::has_piece(Index u, Index v) const
{
    for (Index k = points_[u].first_knot; k != none; k = knots_[k].sibling)
        for (const Index other : {knots_[k].previous, knots_[k].next})
            if (other != none && knots_[other].vertex == v) return true;
    return false;
}

/// The edge u v carries a segment no longer, if no chain runs over it.
void Pane::release_piece(Index u, Index v)
{
    if (has_piece(u, v)) return;
    const Index h = triangulation_.find_side(u, v);
    if (h != none) triangulation_.clear_bits(h, Triangulation::segment_bit);
}

/// Every chain that runs from u to v or back now passes w on its way.
void Pane::split_pieces(Index u, Index v, Index w)
{
    for (Index k = points_[u].first_knot; k != none; k = knots_[k].sibling) {
        const Index next = knots_[k].next, previous = knots_[k].previous, segment = knots_[k].segment;
        if (next != none && knots_[next].vertex == v) add_knot(w, segment, k);
        if (previous != none && knots_[previous].vertex == v) add_knot(w, segment, previous);
    }
}

Index Pane::new_segment()
{
    const Index segment = segments_.add({});
    ++state_.segments;
    report_.segments_made.push_back(SegmentId(segment));
    return segment;
}

void Pane::drop_segment(Index segment)
{
    while (segments_[segment].first != none) {
        const Index k = segments_[segment].first, v = knots_[k].vertex, next = knots_[k].next;
        const Index w = next != none ? knots_[next].vertex : none;
        remove_knot(k);
        if (w != none) release_piece(v, w);
        if (points_[v].kind == PointKind::crossing) loose_crossings_.push_back(v);
    }
    --state_.segments;
    report_.segments_removed.push_back(SegmentId(segment));
}

/// Takes pieces without length out of a segment, and the segment away if nothing is left of it.
void Pane::shorten(Index segment)
{
    for (Index k = segments_[segment].first; k != none; k = knots_[k].next)
        while (knots_[k].next != none && knots_[knots_[k].next].vertex == knots_[k].vertex) remove_knot(knots_[k].next);
    const auto [first, last] = segments_[segment];
    if (first != none && first == last) remove_knot(first);
    if (segments_[segment].first != none) return;
    --state_.segments;
    report_.segments_removed.push_back(SegmentId(segment));
}

/// Ends a segment before the knot k, and begins another one behind it.
void Pane::cut_at(Index k)
{
    const Index segment = knots_[k].segment, rest = knots_[k].next, behind = new_segment();
    segments_.change(behind) = {rest, segments_[segment].last};
    for (Index i = rest; i != none; i = knots_[i].next) knots_.change(i).segment = behind;
    knots_.change(rest).previous = none;
    knots_.change(k).next = none;
    segments_.change(segment).last = k;
    remove_knot(k);
    shorten(segment);
    shorten(behind);
}

/// Another segment over the same points in the same or the reverse order, or none.
Index Pane::double_of(Index segment) const
{
    const auto [first, last] = segments_[segment];
    const auto runs_along = [&](Index k, bool forward) {
        Index i = first;
        while (i != none && k != none && knots_[i].vertex == knots_[k].vertex) {
            i = knots_[i].next;
            k = forward ? knots_[k].next : knots_[k].previous;
        }
        return i == none && k == none;
    };
    Index found = none; // of several the first, whatever the order of knots
    for (Index k = points_[knots_[first].vertex].first_knot; k != none; k = knots_[k].sibling) {
        const Index other = knots_[k].segment;
        if (other == segment || other >= found) continue;
        if ((segments_[other].first == k && runs_along(k, true)) || (segments_[other].last == k && runs_along(k, false))) found = other;
    }
    return found;
}

// --- pieces become edges ------------------------------------------------------------------------------------------------------------

/// Makes an edge of each pending piece. What stands in the way of a segment becomes part of it: a point exactly on it is passed through, another
/// segment is met in a crossing point. In the way of a loop nothing may stand.
void Pane::realise()
{
    Triangulation& t = triangulation_;
    while (true) {
        t.legalise();
        if (pending_.empty()) return;
        Pending piece = pending_.back();
        pending_.pop_back();
        if ((piece.bits & Triangulation::segment_bit) != 0 && !has_piece(piece.from, piece.to)) piece.bits &= ~Triangulation::segment_bit;
        if (piece.bits == 0 || piece.from == piece.to) continue;
        const auto met = t.trace(piece.from, piece.to);
        switch (met.met) {
        case Triangulation::Trace::Met::edge: t.set_bits(met.at, piece.bits); break;
        case Triangulation::Trace::Met::free: t.set_bits(t.force_edge(piece.from, piece.to), piece.bits); break;
        case Triangulation::Trace::Met::fixed: meet(piece, met.at); continue;
        case Triangulation::Trace::Met::vertex: {
            const Index w = met.at;
            if ((piece.bits & Triangulation::loop_bit) != 0)
                refuse(points_[w].kind == PointKind::boundary ? Reason::boundary_touches : Reason::swallows_point,
                       fmt::format("the boundary from {} to {} would run over {}", text(piece.from), text(piece.to), text(w)));
            split_pieces(piece.from, piece.to, w);
            pend(piece.from, w, piece.bits);
            pend(w, piece.to, piece.bits);
            continue;
        }
        }
        if ((piece.bits & Triangulation::segment_bit) != 0) new_pieces_.emplace_back(piece.from, piece.to);
    }
}

/// The crossing of a piece with an edge that carries something is rounded, and from then on a point like others: both lines go through it, wherever it
/// lies, and what that brings them across is found when their parts are put in.
void Pane::meet(const Pending& piece, Index crossed)
{
    Triangulation& t = triangulation_;
    const Index u = piece.from, v = piece.to, a = t.origin(crossed), b = t.target(crossed);
    if ((piece.bits & Triangulation::loop_bit) != 0 || (loops_changed_ && (t.bits(crossed) & Triangulation::loop_bit) != 0))
        refuse(Reason::boundary_crosses, fmt::format("the line from {} to {} would cross that from {} to {}", text(u), text(v), text(a), text(b)));
    if ((t.bits(crossed) & Triangulation::loop_bit) != 0)
        refuse(Reason::outside, fmt::format("the line from {} to {} leaves the boundary between {} and {}", text(u), text(v), text(a), text(b)));
    if (++crossings_made_ > most_crossings) refuse(Reason::unresolvable, fmt::format("more than {} crossings", most_crossings));

    const Point2 x = crossing(t.position(u), t.position(v), t.position(a), t.position(b));
    const Place at = t.locate(x, crossed);
    Index w = t.look_around(x, at, state_.weld).vertex;
    if (w == none) {
        w = put(x, none, at);
        if (points_[w].kind == PointKind::interior) points_.change(w).kind = PointKind::crossing;
    }
    if (w != a && w != b) {
        const Index h = t.find_side(a, b);
        if (h != none && (t.bits(h) & Triangulation::segment_bit) != 0) {
            t.clear_bits(h, Triangulation::segment_bit);
            split_pieces(a, b, w);
            pend(a, w, Triangulation::segment_bit);
            pend(w, b, Triangulation::segment_bit);
        }
    }
    if (w != u && w != v) {
        split_pieces(u, v, w);
        pend(u, w, piece.bits);
        pend(w, v, piece.bits);
    } else {
        pend(u, v, piece.bits);
    }
}

/// A crossing that fewer than two segments pass is removed; what passes it runs on straight.
void Pane::tidy_crossings()
{
    std::vector<Index> candidates;
    candidates.swap(loose_crossings_);
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    for (const Index v : candidates) {
        const PointData& point = points_[v];
        if (point.id == PointId(none) || point.kind != PointKind::crossing || point.locked) continue;
        bool shared = false;
        for (Index k = point.first_knot; k != none; k = knots_[k].sibling) shared |= knots_[k].segment != knots_[point.first_knot].segment;
        if (!shared) do_remove(v, Through::join);
    }
}

// --- edits of segments --------------------------------------------------------------------------------------------------------------

/// The points within reach of the straight line from u to v, in its order: those of the faces that it comes near, as far as the next loop.
std::vector<Index> Pane::near_line(Index u, Index v, double reach) const
{
    const Triangulation& t = triangulation_;
    const Point2 &from = t.position(u), &to = t.position(v);
    const double reach2 = reach * reach;
    const auto near = [&](Index h) {
        const Point2 &a = t.position(t.origin(h)), &b = t.position(t.target(h));
        if (orient(from, to, a) * orient(from, to, b) <= 0 && orient(a, b, from) * orient(a, b, to) <= 0) return true;
        return std::min({distance2_to_piece(a, from, to), distance2_to_piece(b, from, to), distance2_to_piece(from, a, b),
                         distance2_to_piece(to, a, b)}) <= reach2;
    };
    std::vector<bool> seen(t.side_end() / 4);
    std::vector<Index> waiting, found;
    const auto visit = [&](Index h) {
        if (h == none || seen[h >> 2] || !t.is_inside(h)) return;
        seen[h >> 2] = true;
        waiting.push_back(Triangulation::face(h));
    };
    const Index first = t.out(u);
    for (Index h = first;;) {
        visit(h);
        h = t.turn(h);
        if (h == first) break;
    }
    while (!waiting.empty()) {
        const Index face = waiting.back();
        waiting.pop_back();
        for (Index h = face; h < face + 3; ++h) {
            const Index w = t.origin(h);
            const double along = glm::dot(t.position(w) - from, to - from);
            if (w != u && w != v && along > 0 && along < glm::dot(to - from, to - from) && distance2_to_piece(t.position(w), from, to) <= reach2)
                found.push_back(w);
            if (near(h)) visit(t.twin(h));
        }
    }
    const auto along = [&](Index w) { return glm::dot(t.position(w) - from, to - from); };
    std::sort(found.begin(), found.end(), [&](Index a, Index b) {
        return along(a) != along(b) ? along(a) < along(b) : is_before(t.position(a), t.position(b));
    });
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

SegmentId Pane::do_constrain(std::span<const Index> path)
{
    const Index segment = new_segment();
    Index last = add_knot(path[0], segment, none);
    for (std::size_t i = 1; i < path.size(); ++i) {
        if (path[i] == path[i - 1]) continue;
        std::vector<Index> stops;
        if (state_.snap > 0) stops = near_line(path[i - 1], path[i], state_.snap);
        stops.push_back(path[i]);
        for (const Index stop : stops) {
            pend(knots_[last].vertex, stop, Triangulation::segment_bit);
            last = add_knot(stop, segment, last);
        }
    }
    if (segments_[segment].first == segments_[segment].last) refuse(Reason::same_point, fmt::format("a segment from {} to itself", text(path[0])));
    return SegmentId(segment);
}

namespace {

/// Leaves an edit that would repeat a segment.
struct Repeated {
    SegmentId segment;
};

} // namespace

template <class F>
SegmentId Pane::constrain_once(F&& find_path)
{
    try {
        return edit([&] {
            const SegmentId segment = do_constrain(find_path());
            settle();
            if (const Index other = double_of(Index(segment)); other != none) throw Repeated{SegmentId(other)};
            return segment;
        });
    } catch (const Repeated& repeated) {
        report_.notes.push_back(fmt::format("duplicate: segment {} is there already", Index(repeated.segment)));
        return repeated.segment;
    }
}

SegmentId Pane::constrain(std::span<const PointId> path)
{
    return constrain_once([&] {
        std::vector<Index> vertices;
        for (const PointId point : path) vertices.push_back(vertex_asked(point));
        if (path.size() < 2) refuse(Reason::too_few_points, "a segment needs two points");
        return vertices;
    });
}

SegmentId Pane::constrain_line(std::span<const Point2> line)
{
    for (const Point2& p : line) require_range(p);
    return constrain_once([&] {
        if (line.size() < 2) refuse(Reason::too_few_points, "a line needs two points");
        std::vector<Index> vertices;
        for (const Point2& p : line) {
            vertices.push_back(do_add(interpret(p, state_.snap, none, true)));
            settle();
        }
        return vertices;
    });
}

std::vector<SegmentId> Pane::constrain_all(std::span<const std::pair<PointId, PointId>> ends)
{
    return edit([&] {
        // Along the curve that vertices are numbered by, so that each is found in memory near the one before.
        std::vector<std::array<Index, 3>> order;
        order.reserve(ends.size());
        for (const auto& [from, to] : ends) {
            const Index u = vertex_asked(from), v = vertex_asked(to);
            order.push_back({u, v, static_cast<Index>(order.size())});
        }
        std::vector<SegmentId> made;
        made.reserve(ends.size());
        for (const auto& [u, v, i] : order) {
            if (u == v) continue;
            const Index segment = new_segment();
            add_knot(v, segment, add_knot(u, segment, none));
            made.push_back(SegmentId(segment));
        }
        std::sort(order.begin(), order.end());
        for (const auto& [u, v, i] : order)
            if (u != v) {
                pend(u, v, Triangulation::segment_bit);
                realise();
            }
        settle();
        for (std::size_t i = made.size(); i-- > 0;) // the first of several stays
            if (double_of(Index(made[i])) != none) drop_segment(Index(made[i]));
        std::erase_if(made, [&](SegmentId segment) { return !exists(segment); });
        return made;
    });
}

void Pane::unconstrain(SegmentId segment)
{
    edit([&] {
        if (!exists(segment)) refuse(Reason::no_such_segment, fmt::format("there is no segment {}", Index(segment)));
        drop_segment(Index(segment));
        return 0;
    });
}

void Pane::unconstrain(PointId from, PointId to)
{
    const Index u = vertex_asked(from), v = vertex_asked(to);
    Index found = none; // of several the first
    for (Index k = points_[u].first_knot; k != none; k = knots_[k].sibling) {
        const auto [first, last] = segments_[knots_[k].segment];
        if ((first == k && knots_[last].vertex == v) || (last == k && knots_[first].vertex == v)) found = std::min(found, knots_[k].segment);
    }
    if (found == none) refuse(Reason::no_such_segment, fmt::format("no segment runs from {} to {}", text(u), text(v)));
    unconstrain(SegmentId(found));
}

} // namespace druse
