// Edges that must be there: what a straight line meets in a Triangulation, and the faces on both sides of it made anew.
#include "dlfl/errors.h"
#include "pane/triangulation.h"

namespace druse {

using Index = Triangulation::Index;

Triangulation::Trace Triangulation::trace(Index u, Index v)
{
    const Point2 &from = position(u), &to = position(v);
    // Around u: the side to v, a vertex on the way, or the face u a b with a to the right of the line and b to the left.
    Index h = out(u);
    const Index first = h;
    int side_of_a = orient(from, to, position(target(h)));
    while (true) {
        const Index a = target(h);
        if (a == v) return {Trace::Met::edge, h};
        if (side_of_a == 0 && glm::dot(position(a) - from, to - from) > 0) return {Trace::Met::vertex, a};
        const int side_of_b = orient(from, to, position(apex(h)));
        if (side_of_a < 0 && side_of_b > 0) break;
        side_of_a = side_of_b;
        h = turn(h);
        ASSERT(h != first, "a line leaves a vertex through one of its faces");
    }
    crossed_faces_.assign(1, face(h));
    right_rim_.assign(1, h);
    left_rim_.assign(1, previous(h));
    for (Index crossed = next(h);;) { // runs from the right of the line to the left
        if (is_fixed(crossed)) return {Trace::Met::fixed, crossed};
        const Index o = twin(crossed), c = apex(o);
        crossed_faces_.push_back(face(o));
        if (c == v) {
            right_rim_.push_back(next(o));
            left_rim_.push_back(previous(o));
            return {Trace::Met::free, none};
        }
        const int side_of_c = orient(from, to, position(c));
        if (side_of_c == 0) return {Trace::Met::vertex, c};
        if (side_of_c > 0) {
            left_rim_.push_back(previous(o));
            crossed = next(o);
        } else {
            right_rim_.push_back(next(o));
            crossed = previous(o);
        }
    }
}

/// The two polygons beside the new edge are filled by the vertex whose circle through the base holds no other of the chain, then likewise on both
/// sides of it (Anglada 1997). What trace() crossed was Delaunay, so the result is.
Index Triangulation::force_edge(Index u, Index v)
{
    const std::uint32_t kind = flags(crossed_faces_[0]) & inside_bit;
    const auto rights = static_cast<Index>(right_rim_.size()), lefts = static_cast<Index>(left_rim_.size());
    // Right of the line its rim runs from u to v, left of it from v to u: one chain round the hole.
    chain_.clear();
    for (const Index h : right_rim_) chain_.push_back({origin(h), twin(h), bits(h), none});
    for (Index i = lefts; i-- > 0;) chain_.push_back({origin(left_rim_[i]), twin(left_rim_[i]), bits(left_rim_[i]), none});

    // An edge of the rim may lie within the hole, with the hole on both its sides. Its two places in the chain then name each other.
    for (const Index t : crossed_faces_) {
        touch(t);
        side(t | 3).origin = dead_bit;
    }
    const auto old_side = [&](Index i) { return i < rights ? right_rim_[i] : left_rim_[lefts - 1 - (i - rights)]; };
    for (Index i = 0; i < chain_.size(); ++i) side(old_side(i)).origin = i;
    for (ChainSide& c : chain_)
        if (c.glued != none && !is_face(c.glued)) {
            c.made = origin(c.glued); // its partner's number, until it has a side
            c.glued = none;
            c.bits |= dead_bit;
        }

    spare_faces_.assign(crossed_faces_.begin(), crossed_faces_.end());
    for (const Index t : spare_faces_) side(t | 3) = {kind, none};
    chain_stack_.clear();
    const Index left = spare_faces_[0], right = spare_faces_[lefts - 1]; // their first sides will be the new edge
    fill_chain(none, rights, rights + lefts);
    fill_chain(left, 0, rights);
    ASSERT(spare_faces_.empty() && origin(left) == u && origin(right) == v, "two polygons take as many faces as their edge crossed");
    return left;
}

/// Fills the polygon of the chain first … last − 1 and the straight line from its end to its start, which becomes a side glued to `base`.
void Triangulation::fill_chain(Index base, Index first, Index last)
{
    chain_stack_.push_back({base, first, last});
    std::size_t used = 0;
    while (!chain_stack_.empty()) {
        const auto [glued, i, j] = chain_stack_.back();
        chain_stack_.pop_back();
        if (j - i == 1) { // the chain's own edge: `glued` is its side in the new face
            ChainSide& c = chain_[i];
            if ((c.bits & dead_bit) == 0) {
                glue(glued, c.glued, c.bits);
            } else if (ChainSide& partner = chain_[c.made]; partner.glued == none) {
                c.glued = glued; // the partner will find it here
            } else {
                glue(glued, partner.glued, c.bits & edge_bits);
            }
            set_out(c.origin, glued);
            continue;
        }
        const Index a = chain_[j == chain_.size() ? 0 : j].origin, b = chain_[i].origin;
        Index best = i + 1;
        for (Index m = i + 2; m < j; ++m)
            if (incircle_in_order(position(a), position(b), position(chain_[best].origin), position(chain_[m].origin)) > 0) best = m;
        const Index c = chain_[best].origin, t = spare_faces_[used++];
        ASSERT(orient(position(a), position(b), position(c)) > 0, "faces turn counter-clockwise");
        side(t).origin = a;
        side(t + 1).origin = b;
        side(t + 2).origin = c;
        if (glued != none) glue(t, glued, 0);
        chain_stack_.push_back({t + 1, i, best});
        chain_stack_.push_back({t + 2, best, j});
    }
    spare_faces_.erase(spare_faces_.begin(), spare_faces_.begin() + std::ptrdiff_t(used));
}

} // namespace druse
