// Points of a Pane: what a new place means, and adding, moving, merging and removing.
#include "pane/pane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse {

using Index = Pane::Index;

// --- what a place means -------------------------------------------------------------------------------------------------------------

bool Pane::is_inside_or_edge(const Place& at) const
{
    return triangulation_.is_inside(at.side) || (at.kind == Place::Kind::side && triangulation_.is_inside(triangulation_.twin(at.side)));
}

Pane::Meaning Pane::interpret(const Point2& p, double snap, Index ignored, bool only_inside) const
{
    Meaning meaning;
    meaning.at = p;
    const Triangulation& t = triangulation_;
    if (only_inside && !t.in_box(p)) refuse(Reason::outside, fmt::format("{} is outside the boundary", text(p)));
    const Place place = t.locate(p);
    const auto near = t.look_around(p, place, std::max(snap, state_.weld), ignored);
    if (near.vertex != none) {
        meaning.vertex = near.vertex;
        return meaning;
    }
    if (snap > 0 && near.fixed != none && near.fixed_distance2 <= snap * snap)
        return on_edge(p, t.origin(near.fixed), t.target(near.fixed), snap, ignored);
    const bool is_inside = is_inside_or_edge(place);
    if (only_inside && !is_inside) refuse(Reason::outside, fmt::format("{} is outside the boundary", text(p)));
    if (is_inside && snap > 0 && near.free != none && near.free_distance2 > 0 && near.free_distance2 <= snap * snap / 16) {
        meaning.at = foot(p, t.position(t.origin(near.free)), t.position(t.target(near.free)));
        meaning.vertex = t.look_around(meaning.at, t.locate(meaning.at), state_.weld, ignored).vertex;
        return meaning;
    }
    meaning.place = place;
    return meaning;
}

/// The foot on an edge, far enough from its ends; on a short edge, an end.
Pane::Meaning Pane::on_edge(const Point2& p, Index from, Index to, double snap, Index ignored) const
{
    const Triangulation& t = triangulation_;
    const Point2 &a = t.position(from), &b = t.position(to);
    const double length = glm::length(b - a);
    Meaning meaning;
    if (length < 2 * snap) {
        meaning.vertex = glm::length(p - a) <= glm::length(p - b) ? from : to;
        meaning.at = t.position(meaning.vertex);
        return meaning;
    }
    meaning.at = foot(p, a, b);
    if (snap > 0 && glm::length(meaning.at - a) < snap) meaning.at = foot(a + (b - a) * (snap / length), a, b);
    if (snap > 0 && glm::length(meaning.at - b) < snap) meaning.at = foot(b + (a - b) * (snap / length), a, b);
    meaning.vertex = t.look_around(meaning.at, t.locate(meaning.at), state_.weld, ignored).vertex;
    meaning.edge_from = from;
    meaning.edge_to = to;
    return meaning;
}

Pane::Meaning Pane::on_asked_edge(const Point2& p, const PaneEdge& edge) const
{
    const Index a = vertex_asked(edge.a), b = vertex_asked(edge.b), h = triangulation_.find_side(a, b);
    if (h == none || (!triangulation_.is_inside(h) && !triangulation_.is_inside(triangulation_.twin(h))))
        refuse(Reason::no_such_edge, fmt::format("{} and {} are not ends of an edge", text(a), text(b)));
    Meaning meaning = on_edge(p, a, b, 0, none);
    if (!triangulation_.is_fixed(h)) meaning.edge_from = meaning.edge_to = none;
    return meaning;
}

// --- making and forgetting ----------------------------------------------------------------------------------------------------------

void Pane::make_point(Index v, PointKind kind)
{
    while (points_.size() <= v) points_.add({});
    PointData& point = points_.change(v);
    point = {};
    point.id = PointId(vertex_of_.add(v));
    point.kind = kind;
    first_twin_.add(none);
    ++state_.points;
    report_.made.push_back(point.id);
}

void Pane::make_boundary(Index v, Index loop)
{
    PointData& point = points_.change(v);
    if (point.kind != PointKind::boundary) ++state_.boundary_points;
    point.kind = PointKind::boundary;
    point.loop = loop;
}

/// The point v is no more; its vertex is gone or will be another's.
void Pane::forget_point(Index v)
{
    PointData& point = points_.change(v);
    --state_.points;
    if (point.kind == PointKind::boundary) --state_.boundary_points;
    vertex_of_.change(Index(point.id)) = none;
    point = {};
}

/// Puts a vertex at p, which may lie anywhere, also outside; a fixed edge there is split. `moved`: the point whose vertex was taken out just now;
/// else a new point is made, or the one that is there handed back.
Index Pane::put(const Point2& p, Index moved, Place at)
{
    Triangulation& t = triangulation_;
    if (at.side == none) at = t.locate(p);
    if (at.kind == Place::Kind::vertex) {
        if (moved != none) refuse(Reason::coincides, fmt::format("{} is at {}", text(t.origin(at.side)), text(p)));
        return t.origin(at.side);
    }
    const bool on_side = at.kind == Place::Kind::side;
    const std::uint32_t bits = on_side ? t.bits(at.side) : 0;
    const Index a = on_side ? t.origin(at.side) : none, b = on_side ? t.target(at.side) : none;
    const Index v = t.insert(p, at);
    if (moved == none) make_point(v, PointKind::interior);
    ASSERT(moved == none || moved == v, "a moved point keeps its number");
    if ((bits & Triangulation::loop_bit) != 0) {
        if (moved != none && points_[v].kind == PointKind::boundary)
            refuse(Reason::boundary_touches, fmt::format("{} would lie on the boundary", text(v)));
        make_boundary(v, points_[a].loop);
    }
    if ((bits & Triangulation::segment_bit) != 0) split_pieces(a, b, v);
    if (bits != 0) report_.splits.push_back({points_[v].id, points_[a].id, points_[b].id});
    return v;
}

/// Splits a fixed edge at p, which is on it but for rounding: where it is not exactly there, both parts are put in again through it.
Index Pane::split_edge(Index from, Index to, const Point2& p, Index moved)
{
    Triangulation& t = triangulation_;
    const Index h = t.find_side(from, to);
    ASSERT(h != none, "an edge that is split is there");
    if (orient(t.position(from), t.position(to), p) == 0) return put(p, moved, {h, Place::Kind::side});
    const std::uint32_t bits = t.bits(h);
    t.clear_bits(h, bits);
    t.legalise();
    const Index v = put(p, moved);
    lead_through(v, from, to, bits);
    return v;
}

/// What the edge from → to carried goes through v from now on.
void Pane::lead_through(Index v, Index from, Index to, std::uint32_t bits)
{
    if ((bits & Triangulation::loop_bit) != 0) {
        if (points_[v].kind == PointKind::boundary) refuse(Reason::boundary_touches, fmt::format("{} is on the boundary", text(v)));
        make_boundary(v, points_[from].loop);
        loops_changed_ = true;
    }
    if ((bits & Triangulation::segment_bit) != 0) split_pieces(from, to, v);
    pend(from, v, bits);
    pend(v, to, bits);
    report_.splits.push_back({points_[v].id, points_[from].id, points_[to].id});
}

/// Frees all edges at v of what they carry.
void Pane::untie(Index v)
{
    Triangulation& t = triangulation_;
    const Index first = t.out(v);
    Index h = first;
    do {
        t.clear_bits(h, Triangulation::edge_bits);
        h = t.turn(h);
    } while (h != first);
    t.legalise();
}

void Pane::pend_pieces(Index v)
{
    for (Index k = points_[v].first_knot; k != none; k = knots_[k].sibling)
        for (const Index other : {knots_[k].previous, knots_[k].next})
            if (other != none) pend(v, knots_[other].vertex, Triangulation::segment_bit);
}

// --- the edits themselves -----------------------------------------------------------------------------------------------------------

Index Pane::do_add(const Meaning& meaning)
{
    if (meaning.vertex != none) return meaning.vertex;
    if (meaning.edge_from != none) return split_edge(meaning.edge_from, meaning.edge_to, meaning.at);
    return put(meaning.at, none, meaning.place);
}

Index Pane::do_add_boundary(const Point2& at, Index from, Index to)
{
    Triangulation& t = triangulation_;
    if (!t.in_box(at)) t.grow_box(at);
    while (points_.size() < t.vertex_end()) points_.add({});
    const Meaning meaning = interpret(at, state_.snap, none, false);
    const Index h = t.find_side(from, to);
    const bool on_this = (meaning.edge_from == from && meaning.edge_to == to) || (meaning.edge_from == to && meaning.edge_to == from);
    if (on_this && meaning.vertex == none) return split_edge(from, to, meaning.at);
    if (meaning.vertex != none && points_[meaning.vertex].kind == PointKind::boundary)
        refuse(Reason::boundary_touches, fmt::format("{} is at {}", text(meaning.vertex), text(at)));
    if (meaning.edge_from != none && (t.bits(t.find_side(meaning.edge_from, meaning.edge_to)) & Triangulation::loop_bit) != 0)
        refuse(Reason::boundary_touches, fmt::format("{} is on another edge of the boundary", text(at)));
    const std::uint32_t bits = t.bits(h);
    t.clear_bits(h, bits);
    t.legalise();
    const Index v = do_add({meaning.at, meaning.vertex, meaning.edge_from, meaning.edge_to, {}});
    lead_through(v, from, to, bits);
    return v;
}

Index Pane::do_move(Index v, const Point2& to, double snap)
{
    require_free(v);
    Triangulation& t = triangulation_;
    const bool boundary = points_[v].kind == PointKind::boundary;
    if (boundary && !t.in_box(to)) {
        t.grow_box(to);
        while (points_.size() < t.vertex_end()) points_.add({});
    }
    const Meaning meaning = interpret(to, snap, v, !boundary);
    if (meaning.vertex != none) return merge(v, meaning.vertex);
    if (meaning.edge_from == none && t.move(v, meaning.at)) return v;

    const auto [before, after] = boundary ? loop_neighbours(v) : std::pair<Index, Index>{none, none};
    untie(v);
    t.remove(v);
    if (meaning.edge_from == none) {
        const Place at = t.locate(meaning.at);
        if (!boundary && !is_inside_or_edge(at)) refuse(Reason::outside, fmt::format("{} is outside the boundary", text(to)));
        put(meaning.at, v, at);
    } else {
        split_edge(meaning.edge_from, meaning.edge_to, meaning.at, v);
    }
    pend_pieces(v);
    if (boundary) {
        pend(before, v, Triangulation::loop_bit);
        pend(v, after, Triangulation::loop_bit);
        loops_changed_ = true;
    }
    return v;
}

/// The point v goes to the place of w, and the two become one there: of its vertex, with the id that counts more.
Index Pane::merge(Index v, Index w)
{
    Triangulation& t = triangulation_;
    const PointData moving = points_[v], target = points_[w];
    const bool v_bounds = moving.kind == PointKind::boundary, w_bounds = target.kind == PointKind::boundary;
    const auto [before, after] = v_bounds ? loop_neighbours(v) : std::pair<Index, Index>{none, none};
    if (v_bounds && w_bounds) {
        if (before != w && after != w) refuse(Reason::boundary_touches, fmt::format("{} would touch the boundary at {}", text(v), text(w)));
        if (loop_size(v) <= 3) refuse(Reason::too_few_points, fmt::format("the loop of {} has 3 points", text(v)));
    }
    if (v_bounds && !w_bounds) require_free(w);
    const bool w_stays = w_bounds != v_bounds ? w_bounds : target.locked || target.id < moving.id;

    untie(v);
    t.remove(v);
    if (v_bounds) {
        if (loops_[moving.loop] == v) loops_.change(moving.loop) = w;
        if (!w_bounds) make_boundary(w, moving.loop);
        for (const Index end : {before, after})
            if (end != w) pend(end, w, Triangulation::loop_bit);
        loops_changed_ = true;
    } else if (!w_bounds && (target.kind == PointKind::interior || moving.kind == PointKind::interior)) {
        points_.change(w).kind = PointKind::interior;
    }

    // Segments through v pass through w; a piece between the two is no more.
    std::vector<Index> through;
    for (Index k = moving.first_knot; k != none;) {
        const Index sibling = knots_[k].sibling;
        Knot& knot = knots_.change(k);
        knot.vertex = w;
        knot.sibling = points_[w].first_knot;
        points_.change(w).first_knot = k;
        through.push_back(knot.segment);
        k = sibling;
    }
    points_.change(v).first_knot = none;
    std::sort(through.begin(), through.end());
    through.erase(std::unique(through.begin(), through.end()), through.end());
    for (const Index segment : through) shorten(segment);
    pend_pieces(w);

    const PointId gone = w_stays ? moving.id : target.id, stays = w_stays ? target.id : moving.id;
    forget_point(v);
    if (!w_stays) {
        vertex_of_.change(Index(target.id)) = none;
        vertex_of_.change(Index(stays)) = w;
        points_.change(w).id = stays;
    }
    report_.merged.push_back({gone, stays});
    for (const Index segment : through)
        if (segments_[segment].first != none && double_of(segment) != none) drop_segment(std::max(segment, double_of(segment)));
    return w;
}

void Pane::do_remove(Index v, Through through)
{
    require_free(v);
    Triangulation& t = triangulation_;
    const PointData point = points_[v];
    const bool boundary = point.kind == PointKind::boundary;
    std::pair<Index, Index> ends{none, none};
    if (boundary) {
        if (loop_size(v) <= 3) refuse(Reason::too_few_points, fmt::format("the loop of {} has 3 points", text(v)));
        ends = loop_neighbours(v);
        if (loops_[point.loop] == v) loops_.change(point.loop) = ends.second;
        pend(ends.first, ends.second, Triangulation::loop_bit);
        loops_changed_ = true;
    }
    untie(v);
    while (points_[v].first_knot != none) {
        const Index k = points_[v].first_knot, segment = knots_[k].segment, previous = knots_[k].previous, next = knots_[k].next;
        if (previous != none && next != none && through == Through::cut) {
            cut_at(k);
            continue;
        }
        remove_knot(k);
        if (previous != none && next != none) pend(knots_[previous].vertex, knots_[next].vertex, Triangulation::segment_bit);
        shorten(segment);
    }
    t.remove(v);
    report_.removed.push_back(point.id);
    forget_point(v);
}

// --- edits as they are asked for ------------------------------------------------------------------------------------------------------

PointId Pane::add(const Point2& at, std::optional<PaneEdge> edge, bool strict)
{
    require_range(at);
    return edit([&] {
        const Meaning meaning = edge ? on_asked_edge(at, *edge) : interpret(at, state_.snap, none, true);
        if (meaning.vertex != none && strict) refuse(Reason::coincides, fmt::format("{} is at {}", text(meaning.vertex), text(at)));
        const Index v = do_add(meaning);
        const PointId made = points_[v].id;
        if (!report_.splits.empty() && twins_.size() > 0) {
            const auto split = report_.splits.front();
            twin_split(v, vertex(split.from), vertex(split.to));
        }
        return made;
    });
}

PointId Pane::add_boundary(const Point2& at, std::optional<PaneEdge> edge)
{
    require_range(at);
    return edit([&] {
        Index from = none, to = none;
        if (edge) {
            from = vertex_asked(edge->a);
            to = vertex_asked(edge->b);
            const Index h = triangulation_.find_side(from, to);
            if (h == none || (triangulation_.bits(h) & Triangulation::loop_bit) == 0)
                refuse(Reason::no_such_edge, fmt::format("{} and {} are not ends of a boundary edge", text(from), text(to)));
        } else {
            from = nearest_loop_edge(at);
            to = loop_neighbours(from).second;
        }
        const Index v = do_add_boundary(at, from, to);
        const PointId made = points_[v].id;
        if (twins_.size() > 0) twin_split(v, from, to);
        return made;
    });
}

/// What was made on the edge a b is made on its image too, wherever both ends have a twin by one map.
void Pane::twin_split(Index made, Index a, Index b)
{
    const PointId id_made = points_[made].id;
    const Point2 place = triangulation_.position(made);
    const auto same = [](const Isometry& g, const Isometry& h) { return g.x == h.x && g.y == h.y && g.shift == h.shift; };
    for (Index i = first_twin_[Index(points_[a].id)]; i != none; i = twins_[i].next)
        for (Index j = first_twin_[Index(points_[b].id)]; j != none; j = twins_[j].next) {
            if (!same(twins_[i].map, twins_[j].map)) continue;
            settle();
            const Isometry map = twins_[i].map;
            if (!exists(PointId(twins_[i].other)) || !exists(PointId(twins_[j].other))) continue;
            const Index from = vertex_of_[twins_[i].other], to = vertex_of_[twins_[j].other], h = triangulation_.find_side(from, to);
            if (h == none || !triangulation_.is_fixed(h)) continue; // done, where the edge is its own image
            const bool boundary = (triangulation_.bits(h) & Triangulation::loop_bit) != 0;
            const Point2 image = map(place);
            const Index v = boundary ? do_add_boundary(image, from, to) : split_edge(from, to, image);
            const Isometry back{{map.x.x, map.y.x}, {map.x.y, map.y.y}, {-glm::dot(map.x, map.shift), -glm::dot(map.y, map.shift)}};
            for (const auto& [p, q, g] : {std::tuple{id_made, points_[v].id, map}, std::tuple{points_[v].id, id_made, back}}) {
                const Index link = twins_.add({Index(p), Index(q), first_twin_[Index(p)], g});
                first_twin_.change(Index(p)) = link;
            }
        }
}

PointId Pane::move(PointId point, const Point2& to)
{
    require_range(to);
    return edit([&] {
        const Index v = do_move(vertex_asked(point), to, state_.snap);
        const Point2 place = triangulation_.position(v);
        const PointId left = points_[v].id;
        for (Index i = first_twin_[Index(point)]; i != none; i = twins_[i].next) {
            settle();
            const auto other = PointId(twins_[i].other);
            if (!exists(other) || other == left) continue;
            const Point2 image = twins_[i].map(place);
            require_range(image);
            do_move(vertex(other), image, 0);
        }
        return left;
    });
}

void Pane::remove(PointId point, Through through)
{
    edit([&] {
        do_remove(vertex_asked(point), through);
        for (Index i = first_twin_[Index(point)]; i != none; i = twins_[i].next) {
            settle();
            if (exists(PointId(twins_[i].other))) do_remove(vertex_of_[twins_[i].other], through);
        }
        return 0;
    });
}

void Pane::lock(std::span<const PointId> points, bool on)
{
    edit([&] {
        for (const PointId point : points) points_.change(vertex_asked(point)).locked = on;
        return 0;
    });
}

void Pane::add_twin(PointId point, PointId other, const Isometry& map)
{
    edit([&] {
        vertex_asked(other);
        vertex_asked(point);
        const Index link = twins_.add({Index(point), Index(other), first_twin_[Index(point)], map});
        first_twin_.change(Index(point)) = link;
        return 0;
    });
}

void Pane::set_snap(double snap)
{
    if (!(snap >= 0 && snap <= 1e150)) refuse(Reason::range, fmt::format("snap={}: expected 0 to 1e150", snap));
    edit([&] {
        state_.snap = snap;
        return 0;
    });
}

std::vector<PointId> Pane::add_all(std::span<const Point2> points)
{
    for (const Point2& p : points) require_range(p);
    return edit([&] {
        for (const Point2& p : points)
            if (!triangulation_.in_box(p)) refuse(Reason::outside, fmt::format("{} is outside the boundary", text(p)));
        std::vector<Index> vertices;
        std::vector<Triangulation::Split> splits;
        const Index refused = triangulation_.insert_all(points, state_.weld, vertices, splits);
        if (refused != none) refuse(Reason::outside, fmt::format("{} is outside the boundary", text(points[refused])));
        vertex_of_.reserve(vertex_of_.size() + points.size());
        points_.reserve(triangulation_.vertex_end());
        while (points_.size() < triangulation_.vertex_end()) points_.add({});
        std::vector<PointId> ids(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (points_[vertices[i]].id == PointId(none)) make_point(vertices[i], PointKind::interior);
            ids[i] = points_[vertices[i]].id;
        }
        for (const auto& [made, from, to, bits] : splits) { // in the order in which they were made: each edge was there, then
            if ((bits & Triangulation::loop_bit) != 0) make_boundary(made, points_[from].loop);
            if ((bits & Triangulation::segment_bit) != 0) split_pieces(from, to, made);
            report_.splits.push_back({points_[made].id, points_[from].id, points_[to].id});
        }
        return ids;
    });
}

} // namespace druse
