#include "pane/pane_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace druse {

namespace {

using Index = Pane::Index;
using Number = PaneRecord::Number;
using Reason = PaneRefusal::Reason;

[[noreturn]] void refuse_at(const std::string& path, Reason reason, const std::string& what) { throw PaneRecordRefusal(PaneRefusal(reason, what), path); }

/// Runs f; what it refuses is the fault of the value at a path.
template <class F>
void refused_at(const std::string& path, F&& f)
{
    try {
        f();
    } catch (const PaneRefusal& refusal) {
        throw PaneRecordRefusal(refusal, path);
    }
}

/// Of items that are refused together: the first one without which those before it are not.
template <class F>
std::size_t first_refused(std::size_t count, F&& take)
{
    std::size_t good = 0, bad = count;
    while (good + 1 < bad) {
        const std::size_t middle = good + (bad - good) / 2;
        try {
            take(middle);
            good = middle;
        } catch (const PaneRefusal&) {
            bad = middle;
        }
    }
    return bad - 1;
}

bool is_in_range(double x) { return std::abs(x) <= 1e150; }

/// The pane of the loops alone.
Pane pane_of_loops(const PaneRecord& record, const std::vector<std::vector<Point2>>& loops)
{
    const auto of_first = [&](std::size_t n) { return Pane(loops[0], std::span(loops).subspan(1, n - 1), {record.snap, record.weld}); };
    try {
        return of_first(loops.size());
    } catch (const PaneRefusal& refusal) {
        if (refusal.reason() == Reason::range) throw PaneRecordRefusal(refusal, record.weld >= 1e-140 && is_in_range(record.weld) ? "snap" : "weld");
        throw PaneRecordRefusal(refusal, fmt::format("boundary[{}]", first_refused(loops.size(), of_first)));
    }
}

} // namespace

PaneRecord record(const Pane& pane)
{
    PaneRecord found;
    std::vector<Number> number(std::size_t(pane.next_point()), Pane::none);
    for (const PointId point : pane.points()) {
        number[std::size_t(point)] = static_cast<Number>(found.points.size());
        found.points.push_back(pane.position(point));
        found.ids.push_back(Number(point));
        if (pane.is_locked(point)) found.locked.push_back(number[std::size_t(point)]);
        if (pane.kind(point) == PointKind::crossing) found.crossings.push_back(number[std::size_t(point)]);
        if (pane.is_refined(point)) found.refined.push_back(number[std::size_t(point)]);
    }
    const auto numbers = [&](const std::vector<PointId>& ids) {
        std::vector<Number> list;
        for (const PointId id : ids) list.push_back(number[std::size_t(id)]);
        return list;
    };
    for (std::size_t i = 0; i <= pane.hole_count(); ++i) found.boundary.push_back(numbers(pane.loop(i)));
    for (const SegmentId segment : pane.segments()) {
        const auto& [id, chain] = found.segments.emplace_back(Number(segment), numbers(pane.chain(segment)));
        for (std::size_t i = 1; i < chain.size(); ++i)
            found.constraints.push_back({std::min(chain[i - 1], chain[i]), std::max(chain[i - 1], chain[i])});
    }
    std::sort(found.constraints.begin(), found.constraints.end());
    found.constraints.erase(std::unique(found.constraints.begin(), found.constraints.end()), found.constraints.end());
    pane.for_triangles([&](PointId a, PointId b, PointId c) {
        std::array<Number, 3> t{number[std::size_t(a)], number[std::size_t(b)], number[std::size_t(c)]};
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        found.triangles.push_back(t);
    });
    std::sort(found.triangles.begin(), found.triangles.end());
    found.snap = pane.snap();
    found.weld = pane.weld();
    found.next_point = Number(pane.next_point());
    found.next_segment = Number(pane.next_segment());
    return found;
}

/// Loops and inner points are put in as for a new pane, and then take the ids of the record.
Pane restore(const PaneRecord& record)
{
    const auto count = static_cast<Number>(record.points.size());
    if (record.ids.size() != count) refuse_at("ids", Reason::no_such_point, fmt::format("{} ids of {} points", record.ids.size(), count));
    for (Number i = 1; i < count; ++i)
        if (record.ids[i - 1] >= record.ids[i]) refuse_at(fmt::format("ids[{}]", i), Reason::no_such_point, "ids ascend");
    if (count > 0 && record.ids.back() >= record.next_point) refuse_at("next", Reason::no_such_point, fmt::format("point {} is there already", record.ids.back()));
    for (Number i = 0; i < count; ++i)
        if (!is_in_range(record.points[i].x) || !is_in_range(record.points[i].y)) refuse_at(fmt::format("points[{}]", i), Reason::range, "coordinates go to 1e150");
    const auto checked = [&](Number i, const char* path) {
        if (i >= count) refuse_at(path, Reason::no_such_point, fmt::format("there is no point number {}", i));
        return i;
    };
    if (record.boundary.empty()) refuse_at("boundary", Reason::too_few_points, "a pane has a boundary");

    std::vector<std::vector<Point2>> loops;
    std::vector<Number> order; // of the record's points, as the new pane numbers them
    std::vector<bool> bounds(count);
    for (const auto& loop : record.boundary) {
        loops.emplace_back();
        for (const Number i : loop) {
            loops.back().push_back(record.points[checked(i, "boundary")]);
            order.push_back(i);
            bounds[i] = true;
        }
    }
    Pane pane = pane_of_loops(record, loops);
    const std::size_t rim = order.size();
    std::vector<Point2> inner;
    for (Number i = 0; i < count; ++i)
        if (!bounds[i]) {
            inner.push_back(record.points[i]);
            order.push_back(i);
        }
    const auto point_path = [&](std::size_t i) { return fmt::format("points[{}]", order[rim + i]); };
    const auto of_first = [&](std::size_t n) {
        Pane trial = pane;
        trial.add_all(std::span(inner).first(n));
    };
    std::vector<PointId> added;
    try {
        added = pane.add_all(inner);
    } catch (const PaneRefusal& refusal) {
        throw PaneRecordRefusal(refusal, point_path(first_refused(inner.size(), of_first)));
    }
    for (std::size_t i = 0; i < added.size(); ++i)
        if (std::size_t(added[i]) != rim + i || pane.kind(added[i]) == PointKind::boundary)
            refuse_at(point_path(i), Reason::coincides, "another point is nearer than weld, or it is on the boundary without being of it");

    std::vector<Number> new_of(count);
    for (Number i = 0; i < count; ++i) new_of[order[i]] = i;
    pane.take_ids(record.ids, new_of, record.next_point);
    for (std::size_t k = 0; k < record.segments.size(); ++k) {
        const auto& [id, chain] = record.segments[k];
        const std::string place = fmt::format("segments[{}]", k);
        if (id < Number(pane.next_segment()) || id >= record.next_segment || chain.size() < 2)
            refuse_at(place, Reason::no_such_segment, fmt::format("segment {} is out of order, or has no length", id));
        std::vector<PointId> path;
        for (const Number i : chain) path.push_back(PointId(record.ids[checked(i, place.c_str())]));
        refused_at(place, [&] { pane.take_segment(id, path); });
        if (pane.point_count() != count) refuse_at(place, Reason::unresolvable, fmt::format("segment {} crosses another where the record has no point", id));
    }
    pane.skip_segments(record.next_segment);
    for (std::size_t k = 0; k < record.segments.size(); ++k) {
        const auto& [id, chain] = record.segments[k];
        const auto equal = [&](PointId point, Number i) { return Number(point) == record.ids[i]; };
        if (!std::ranges::equal(pane.chain(SegmentId(id)), chain, equal))
            refuse_at(fmt::format("segments[{}]", k), Reason::unresolvable, fmt::format("segment {} meets more than its points", id));
    }
    const auto ids = [&](const std::vector<Number>& numbers, const char* path) {
        std::vector<PointId> points;
        for (const Number i : numbers) points.push_back(PointId(record.ids[checked(i, path)]));
        return points;
    };
    for (std::size_t k = 0; k < record.crossings.size(); ++k)
        if (const Number i = checked(record.crossings[k], "crossings"); bounds[i])
            refuse_at(fmt::format("crossings[{}]", k), Reason::boundary_touches, fmt::format("point number {} is of the boundary, not a crossing", i));
    pane.take_marks(ids(record.crossings, "crossings"), ids(record.refined, "refined"));
    pane.lock(ids(record.locked, "locked"));
    return pane;
}

bool operator==(const Pane& a, const Pane& b)
{
    if (record(a) != record(b) || a.twins_.size() != b.twins_.size()) return false;
    for (Index i = 0; i < a.twins_.size(); ++i) {
        const Pane::Twin &s = a.twins_[i], &t = b.twins_[i];
        if (s.point != t.point || s.other != t.other || s.map.x != t.map.x || s.map.y != t.map.y || s.map.shift != t.map.shift) return false;
    }
    return true;
}

/// The points take other ids: ids[k] is that of the point new_of[k].
void Pane::take_ids(std::span<const std::uint32_t> ids, std::span<const std::uint32_t> new_of, std::uint32_t next)
{
    edit([&] {
        std::vector<Index> vertices(ids.size());
        for (std::size_t k = 0; k < ids.size(); ++k) vertices[k] = vertex_of_[new_of[k]];
        for (std::uint32_t i = 0; i < vertex_of_.size(); ++i) vertex_of_.change(i) = none;
        while (vertex_of_.size() < next) {
            vertex_of_.add(none);
            first_twin_.add(none);
        }
        for (std::size_t k = 0; k < ids.size(); ++k) {
            vertex_of_.change(ids[k]) = vertices[k];
            points_.change(vertices[k]).id = PointId(ids[k]);
        }
        return 0;
    });
}

/// A segment with a given id, not below the next.
void Pane::take_segment(std::uint32_t id, std::span<const PointId> path)
{
    skip_segments(id);
    edit([&] {
        const Index segment = new_segment();
        Index last = none;
        for (const PointId point : path) {
            const Index v = vertex_asked(point);
            if (last != none && knots_[last].vertex == v) refuse(Reason::same_point, fmt::format("segment {} has a piece without length", id));
            if (last != none) pend(knots_[last].vertex, v, Triangulation::segment_bit);
            last = add_knot(v, segment, last);
        }
        return 0;
    });
}

void Pane::take_marks(std::span<const PointId> crossings, std::span<const PointId> refined)
{
    edit([&] {
        for (const PointId point : crossings) points_.change(vertex(point)).kind = PointKind::crossing;
        for (const PointId point : refined) points_.change(vertex(point)).refined = true;
        return 0;
    });
}

void Pane::skip_segments(std::uint32_t next)
{
    edit([&] {
        while (segments_.size() < next) segments_.add({});
        return 0;
    });
}

} // namespace druse
