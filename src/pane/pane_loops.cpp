// The boundary of a Pane: what is inside, and the way along a loop.
#include "pane/pane.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace druse {

using Index = Pane::Index;

/// Flags every face, starting from the outside. Over an edge of the outer loop lies the inside, from there over an edge of a hole that hole; any other
/// order says that a loop is not where it should be. What lies outside now may not hold a point or a segment.
void Pane::flood()
{
    constexpr Index outside = 0, inside = 1, first_hole = 2, unknown = none;
    const Triangulation& t = triangulation_;
    region_.assign(t.side_end() / 4, unknown);
    flood_stack_.assign(1, Triangulation::face(t.out(t.corner(0))));
    region_[flood_stack_[0] >> 2] = outside;
    while (!flood_stack_.empty()) {
        const Index face = flood_stack_.back();
        flood_stack_.pop_back();
        const Index here = region_[face >> 2];
        triangulation_.set_inside(face, here == inside);
        for (Index h = face; h < face + 3; ++h) {
            if (here != inside && !t.is_corner(t.origin(h)) && points_[t.origin(h)].kind != PointKind::boundary)
                refuse(Reason::swallows_point, fmt::format("{} would be outside", text(t.origin(h))));
            const Index o = t.twin(h);
            if (o == none) continue;
            Index there = here;
            if ((t.bits(h) & Triangulation::loop_bit) != 0) {
                const Index loop = points_[t.origin(h)].loop;
                there = here == inside ? (loop == 0 ? outside : first_hole + loop) : inside;
                if ((here == outside && loop != 0) || (here >= first_hole && here != first_hole + loop))
                    refuse(Reason::boundary_crosses, fmt::format("the loop at {} is not within the outer one, or within a hole", text(t.origin(h))));
            } else if (here != inside && (t.bits(h) & Triangulation::segment_bit) != 0) {
                refuse(Reason::boundary_crosses, fmt::format("the segment from {} to {} would be outside", text(t.origin(h)), text(t.target(h))));
            }
            if (region_[o >> 2] != unknown) continue;
            region_[o >> 2] = there;
            flood_stack_.push_back(Triangulation::face(o));
        }
    }
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
