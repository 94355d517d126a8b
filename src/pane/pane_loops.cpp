// The boundary of a Pane: what is inside, and the way along a loop.
#include "pane/pane.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace druse {

using Index = Pane::Index;

namespace {

/// What the loops make of a face; behind these, one for each loop that is a hole. Or what is known of it.
struct Region {
    static constexpr Index outside = 0, inside = 1, first_hole = 2, unknown = Pane::none, changed = Pane::none - 1;
};

} // namespace

/// Flags faces, starting from the outside: all of them, or, if it is known which changed since a loop did, those and what they show to be flagged wrong.
/// What did not change is right or wrong as one with what did not change beside it, so that all that is wrong is reached from faces that did.
void Pane::flood()
{
    const Triangulation& t = triangulation_;
    for (const Index face : flooded_) region_[face >> 2] = Region::unknown;
    flooded_.clear();
    region_.resize(std::max<std::size_t>(region_.size(), t.side_end() / 4), Region::unknown);
    Index known = Triangulation::face(t.out(t.corner(0)));
    if (!t.knows_changed()) {
        spread_region(known, Region::outside, true);
        return;
    }
    t.for_changed([&](Index face) {
        if (region_[face >> 2] == Region::changed) return;
        region_[face >> 2] = Region::changed;
        flooded_.push_back(face);
    });
    const std::size_t count = flooded_.size();
    flooded_.push_back(known);
    spread_region(known, Region::outside, false);
    for (std::size_t i = 0; i < count; ++i) {
        const Index face = flooded_[i];
        if (region_[face >> 2] == Region::changed) spread_region(face, region_far(known, face), false);
        known = face;
    }
    triangulation_.forget_changed();
}

/// What lies over a side, seen from its face. Over an edge of the outer loop lies the inside, from there over an edge of a hole that hole; any other
/// order says that a loop is not where it should be.
Index Pane::region_over(Index h, Index here) const
{
    if ((triangulation_.bits(h) & Triangulation::loop_bit) == 0) return here;
    const Index v = triangulation_.origin(h), loop = points_[v].loop;
    if ((here == Region::outside && loop != 0) || (here >= Region::first_hole && here != Region::first_hole + loop))
        refuse(Reason::boundary_crosses, fmt::format("the loop at {} is not within the outer one, or within a hole", text(v)));
    return here != Region::inside ? Region::inside : loop == 0 ? Region::outside : Region::first_hole + loop;
}

/// Flags a face, and from there all that is not flagged yet; or only what changed, or is flagged wrong. What lies outside now may not hold a point or a segment.
void Pane::spread_region(Index start, Index region, bool all)
{
    const Triangulation& t = triangulation_;
    region_[start >> 2] = region;
    if (all) flooded_.push_back(start);
    flood_stack_.assign(1, start);
    while (!flood_stack_.empty()) {
        const Index face = flood_stack_.back();
        flood_stack_.pop_back();
        const Index here = region_[face >> 2];
        triangulation_.set_inside(face, here == Region::inside);
        for (Index h = face; h < face + 3; ++h) {
            if (here != Region::inside && !t.is_corner(t.origin(h)) && points_[t.origin(h)].kind != PointKind::boundary)
                refuse(Reason::swallows_point, fmt::format("{} would be outside", text(t.origin(h))));
            const Index o = t.twin(h);
            if (o == none) continue;
            const Index there = region_over(h, here);
            if (here != Region::inside && there == here && (t.bits(h) & Triangulation::segment_bit) != 0)
                refuse(Reason::boundary_crosses, fmt::format("the segment from {} to {} would be outside", text(t.origin(h)), text(t.target(h))));
            Index& found = region_[o >> 2];
            if (found == Region::unknown && !all && t.is_inside(o) == (there == Region::inside)) continue;
            if (found != Region::unknown && found != Region::changed) continue;
            if (found == Region::unknown) flooded_.push_back(Triangulation::face(o));
            found = there;
            flood_stack_.push_back(Triangulation::face(o));
        }
    }
}

/// The region of a face, by a walk to it from one whose region is known: over any edge that has a corner of it on the other side, then about that corner.
/// Which edge is tried first is as good as random, since the walk could go round in circles else.
Index Pane::region_far(Index known, Index face) const
{
    const Triangulation& t = triangulation_;
    Index corner = t.origin(face);
    for (Index k = face; t.is_corner(corner); corner = t.origin(++k)) continue;
    const Point2& to = t.position(corner);
    Index here = region_[known >> 2], h = known, came = none;
    const auto step_over = [&](Index side) {
        here = region_over(side, here);
        came = t.twin(side);
        h = Triangulation::face(came);
    };
    std::uint32_t random = 1;
    for (bool there = false; !there;) {
        random = random * 1664525u + 1013904223u;
        there = true;
        Index side = h + (random >> 16) % 3;
        for (int i = 0; i < 3 && there; ++i, side = Triangulation::next(side))
            if (side != came && orient(t.position(t.origin(side)), t.position(t.target(side)), to) < 0) {
                step_over(side);
                there = false;
            }
    }
    while (h != face) {
        Index at = h;
        while (t.origin(at) != corner) at = Triangulation::next(at);
        step_over(Triangulation::previous(at));
    }
    return here;
}

std::pair<Index, Index> Pane::loop_neighbours(Index v) const
{
    const Triangulation& t = triangulation_;
    std::pair<Index, Index> found{none, none};
    const Index first = t.out(v);
    Index h = first;
    do {
        if ((t.bits(h) & Triangulation::loop_bit) != 0) (t.is_inside(h) ? found.second : found.first) = t.target(h);
        h = t.turn(h);
    } while (h != first);
    return found;
}

std::size_t Pane::loop_size(Index v) const
{
    std::size_t size = 0;
    Index w = v;
    do {
        ++size;
        w = loop_neighbours(w).second;
    } while (w != v);
    return size;
}

/// A side of the boundary, by its start. Cost: the boundary.
Index Pane::nearest_loop_edge(const Point2& p) const
{
    Index best = none;
    double least = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < loops_.size(); ++i) {
        Index v = loops_[i];
        do {
            const Index w = loop_neighbours(v).second;
            const Point2 a = triangulation_.position(v), u = triangulation_.position(w) - a;
            const double along = std::clamp(glm::dot(p - a, u) / glm::dot(u, u), 0.0, 1.0), far = glm::length(p - a - along * u);
            if (far < least || (far == least && best != none && id(v) < id(best))) {
                least = far;
                best = v;
            }
            v = w;
        } while (v != loops_[i]);
    }
    return best;
}

} // namespace druse
