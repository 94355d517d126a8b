#include "pane/pane.h"

#ifdef DRUSE_FULL_CHECKS
#include "pane/pane_check.h"
#endif

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace druse {

using Index = Pane::Index;

PaneRefusal::PaneRefusal(Reason reason, const std::string& what) : CommandError(fmt::format("{}: {}", name(reason), what)), reason_(reason) {}

const char* name(PaneRefusal::Reason reason)
{
    constexpr std::array names{"outside", "coincides", "boundary-crosses", "boundary-touches", "swallows-point", "too-few-points", "locked",
                               "same-point", "no-such-point", "no-such-segment", "no-such-edge", "unresolvable", "range", "angle-too-large"};
    return names[std::size_t(reason)];
}

void PaneReport::clear()
{
    made.clear();
    removed.clear();
    splits.clear();
    merged.clear();
    segments_made.clear();
    segments_removed.clear();
    notes.clear();
}

// --- making a pane ------------------------------------------------------------------------------------------------------------------

namespace {

/// 1 if the loop turns counter-clockwise: the turn at its first point by x, then y. 0 where two edges lie on each other there.
int orientation(std::span<const Point2> loop)
{
    std::size_t least = 0;
    for (std::size_t i = 1; i < loop.size(); ++i)
        if (is_before(loop[i], loop[least])) least = i;
    return orient(loop[least == 0 ? loop.size() - 1 : least - 1], loop[least], loop[least + 1 == loop.size() ? 0 : least + 1]);
}

} // namespace

Pane::Pane(std::span<const Point2> loop, std::span<const std::vector<Point2>> holes, const Settings& settings)
{
    std::vector<std::span<const Point2>> rings{loop};
    rings.insert(rings.end(), holes.begin(), holes.end());
    std::vector<Point2> places;
    Point2 min(1e300), max(-1e300);
    for (const auto& ring : rings) {
        if (ring.size() < 3) refuse(Reason::too_few_points, fmt::format("a loop has {} points, and needs 3", ring.size()));
        for (const Point2& p : ring) {
            require_range(p);
            places.push_back(p);
            if (&ring == &rings[0]) {
                min = glm::min(min, p);
                max = glm::max(max, p);
            }
        }
    }
    const double size = std::max(max.x - min.x, max.y - min.y);
    state_.snap = settings.snap.value_or(size / 500);
    state_.weld = settings.weld.value_or(size * 1e-9);
    if (!(state_.weld >= 1e-140 && state_.weld <= 1e150) || !(state_.snap >= 0 && state_.snap <= 1e150))
        refuse(Reason::range, fmt::format("snap {} and weld {}: expected 0 to 1e150, weld at least 1e-140", state_.snap, state_.weld));

    for (const Point2& p : places) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    const Point2 room = Point2(std::max(max.x - min.x, max.y - min.y));
    triangulation_ = Triangulation(min - room, max + room);
    for (Index v = 0; v < 4; ++v) points_.add({});
    for (const Index h : {0u, 4u}) triangulation_.set_inside(h, true); // until the loops are there
    std::vector<Index> vertices;
    std::vector<Triangulation::Split> splits;
    triangulation_.insert_all(places, state_.weld, vertices, splits);
    while (points_.size() < triangulation_.vertex_end()) points_.add({});
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (points_[vertices[i]].id != PointId(none)) refuse(Reason::boundary_touches, fmt::format("two points of the boundary at {}", text(places[i])));
        make_point(vertices[i], PointKind::interior);
    }
    std::size_t first = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const auto ring = std::span(vertices).subspan(first, rings[i].size());
        first += ring.size();
        loops_.add(ring[0]);
        const bool outer = i == 0;
        if (orientation(rings[i]) == (outer ? -1 : 1))
            report_.notes.push_back(outer ? "clockwise: the loop was turned round" : fmt::format("anticlockwise: hole {} was turned round", i - 1));
        for (std::size_t k = 0; k < ring.size(); ++k) {
            make_boundary(ring[k], static_cast<Index>(i));
            pend(ring[k], ring[k + 1 == ring.size() ? 0 : k + 1], Triangulation::loop_bit);
        }
    }
    loops_changed_ = true;
    settle();
}

/// Calls f with each array that edits record, and with what a change keeps of it.
template <class Self, class F>
void Pane::for_arrays(Self& self, F&& f)
{
    f(self.triangulation_, &Change::triangulation);
    f(self.points_, &Change::points);
    f(self.vertex_of_, &Change::vertex_of);
    f(self.loops_, &Change::loops);
    f(self.first_twin_, &Change::first_twin);
    f(self.knots_, &Change::knots);
    f(self.segments_, &Change::segments);
    f(self.twins_, &Change::twins);
}

// --- edits --------------------------------------------------------------------------------------------------------------------------

void Pane::begin()
{
    report_.clear();
    loops_changed_ = false;
    crossings_made_ = 0;
    pending_.clear();
    new_pieces_.clear();
    loose_crossings_.clear();
    before_ = state_;
    for_arrays(*this, [](auto& array, auto) { array.begin(); });
}

/// Makes edges of what is pending, and flags what is inside.
void Pane::settle()
{
    realise();
    while (!loose_crossings_.empty()) {
        tidy_crossings();
        realise();
    }
    if (loops_changed_) flood();
    loops_changed_ = false;
    for (const auto& [u, v] : new_pieces_) {
        const Index h = triangulation_.find_side(u, v);
        if (h != none && (triangulation_.bits(h) & Triangulation::segment_bit) != 0 && !triangulation_.is_inside(h) &&
            !triangulation_.is_inside(triangulation_.twin(h)))
            refuse(Reason::outside, fmt::format("the line from {} to {} leaves the boundary", text(u), text(v)));
    }
    new_pieces_.clear();
}

void Pane::finish()
{
    settle();
    for_arrays(*this, [](auto& array, auto) { array.end(); });
#ifdef DRUSE_FULL_CHECKS
    const PaneCheck found = check(*this);
    if (!found.sound()) throw InternalError("internal error: an edit left a pane that is not sound: " + found.faults.front());
#endif
    if (listener_ == nullptr) return;
    for (const auto& split : report_.splits) listener_->split(split.made, split.from, split.to);
    for (const auto& merge : report_.merged) listener_->merged(merge.gone, merge.into);
    for (const PointId gone : report_.removed) listener_->removed(gone);
}

void Pane::roll_back() noexcept
{
    for_arrays(*this, [](auto& array, auto) { array.roll_back(); });
    state_ = before_;
    report_.clear();
}

std::size_t Pane::Change::bytes() const
{
    return sizeof(Change) + triangulation.bytes() + points.bytes() + vertex_of.bytes() + loops.bytes() + first_twin.bytes() + knots.bytes() +
           segments.bytes() + twins.bytes();
}

std::size_t Pane::bytes() const
{
    std::size_t sum = 0;
    for_arrays(*this, [&](const auto& array, auto) { sum += array.bytes(); });
    return sum;
}

Pane::Change Pane::take_change()
{
    Change change;
    for_arrays(*this, [&](auto& array, auto part) { change.*part = array.take(); });
    change.state = before_;
    return change;
}

void Pane::undo(Change& change)
{
    for_arrays(*this, [&](auto& array, auto part) { array.prepare(change.*part, true); });
    for_arrays(*this, [&](auto& array, auto part) { array.undo(change.*part); });
    std::swap(state_, change.state);
    report_.clear();
}

void Pane::redo(Change& change)
{
    for_arrays(*this, [&](auto& array, auto part) { array.prepare(change.*part, false); });
    for_arrays(*this, [&](auto& array, auto part) { array.redo(change.*part); });
    std::swap(state_, change.state);
    report_.clear();
}

// --- reading ------------------------------------------------------------------------------------------------------------------------

Index Pane::vertex(PointId point) const
{
    ASSERT(exists(point), "a point that is asked for is there");
    return vertex_of_[std::uint32_t(point)];
}

std::vector<PointId> Pane::points() const
{
    std::vector<PointId> found;
    found.reserve(state_.points);
    for (std::uint32_t i = 0; i < vertex_of_.size(); ++i)
        if (vertex_of_[i] != none) found.push_back(PointId(i));
    return found;
}

std::vector<SegmentId> Pane::segments() const
{
    std::vector<SegmentId> found;
    found.reserve(state_.segments);
    for (std::uint32_t i = 0; i < segments_.size(); ++i)
        if (segments_[i].first != none) found.push_back(SegmentId(i));
    return found;
}

std::vector<PointId> Pane::chain(SegmentId segment) const
{
    ASSERT(exists(segment), "a segment that is asked for is there");
    std::vector<PointId> found;
    for (Index k = segments_[std::uint32_t(segment)].first; k != none; k = knots_[k].next) found.push_back(id(knots_[k].vertex));
    return found;
}

std::vector<PointId> Pane::loop(std::size_t i) const
{
    std::vector<PointId> found;
    const Index first = loops_[static_cast<std::uint32_t>(i)];
    Index v = first;
    do {
        found.push_back(id(v));
        v = loop_neighbours(v).second;
    } while (v != first);
    std::rotate(found.begin(), std::min_element(found.begin(), found.end()), found.end());
    return found;
}

std::uint64_t Pane::fingerprint() const
{
    std::uint64_t hash = triangulation_.fingerprint();
    const auto mix = [&](std::uint64_t word) { hash = (hash ^ word) * 1099511628211u; };
    const auto mix_number = [&](double x) {
        std::uint64_t word;
        std::memcpy(&word, &x, sizeof word);
        mix(word);
    };
    for (Index v = 0; v < points_.size(); ++v) {
        const PointData& p = points_[v];
        for (const Index word : {Index(p.id), p.first_knot, p.loop, Index(p.kind), Index(p.locked), Index(p.refined)}) mix(word);
    }
    for (Index i = 0; i < vertex_of_.size(); ++i) mix(vertex_of_[i]);
    for (Index i = 0; i < knots_.size(); ++i)
        for (const Index word : {knots_[i].vertex, knots_[i].segment, knots_[i].next, knots_[i].previous, knots_[i].sibling}) mix(word);
    for (Index i = 0; i < segments_.size(); ++i) {
        mix(segments_[i].first);
        mix(segments_[i].last);
    }
    for (Index i = 0; i < loops_.size(); ++i) mix(loops_[i]);
    for (Index i = 0; i < first_twin_.size(); ++i) mix(first_twin_[i]);
    for (Index i = 0; i < twins_.size(); ++i) {
        for (const Index word : {twins_[i].point, twins_[i].other, twins_[i].next}) mix(word);
        for (const Point2& p : {twins_[i].map.x, twins_[i].map.y, twins_[i].map.shift}) {
            mix_number(p.x);
            mix_number(p.y);
        }
    }
    for (const std::size_t count : {state_.points, state_.boundary_points, state_.segments}) mix(count);
    mix(state_.free_knots);
    mix_number(state_.snap);
    mix_number(state_.weld);
    return hash;
}

// --- refusals -----------------------------------------------------------------------------------------------------------------------

void Pane::refuse(Reason reason, const std::string& what) const { throw PaneRefusal(reason, what); }

std::string Pane::text(const Point2& p) const { return fmt::format("({:.6g}, {:.6g})", p.x, p.y); }

std::string Pane::text(Index v) const { return fmt::format("point {}", Index(points_[v].id)); }

void Pane::require_range(const Point2& p) const
{
    if (!(std::abs(p.x) <= 1e150 && std::abs(p.y) <= 1e150)) refuse(Reason::range, fmt::format("{}: coordinates go to 1e150", text(p)));
}

Index Pane::vertex_asked(PointId point) const
{
    if (!exists(point)) refuse(Reason::no_such_point, fmt::format("there is no point {}", Index(point)));
    return vertex(point);
}

void Pane::require_free(Index v) const
{
    if (points_[v].locked) refuse(Reason::locked, fmt::format("{} is locked", text(v)));
}

} // namespace druse
