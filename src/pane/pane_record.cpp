#include "pane/pane_record.h"

#include <fmt/format.h>

#include <algorithm>

namespace druse {

namespace {

using Index = Pane::Index;
using Number = PaneRecord::Number;
using Reason = PaneRefusal::Reason;

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
    const auto fail = [](Reason reason, const std::string& what) { throw PaneRefusal(reason, what); };
    const auto count = static_cast<Number>(record.points.size());
    if (record.ids.size() != count || !std::is_sorted(record.ids.begin(), record.ids.end()) ||
        std::adjacent_find(record.ids.begin(), record.ids.end()) != record.ids.end() || (count > 0 && record.ids.back() >= record.next_point))
        fail(Reason::no_such_point, fmt::format("{} points, and ids that are not theirs", count));
    const auto checked = [&](Number i) {
        if (i >= count) fail(Reason::no_such_point, fmt::format("there is no point number {}", i));
        return i;
    };
    if (record.boundary.empty()) fail(Reason::too_few_points, "a pane has a boundary");

    std::vector<std::vector<Point2>> loops;
    std::vector<Number> order; // of the record's points, as the new pane numbers them
    std::vector<bool> bounds(count);
    for (const auto& loop : record.boundary) {
        loops.emplace_back();
        for (const Number i : loop) {
            loops.back().push_back(record.points[checked(i)]);
            order.push_back(i);
            bounds[i] = true;
        }
    }
    Pane pane(loops[0], std::span(loops).subspan(1), {record.snap, record.weld});
    std::vector<Point2> inner;
    for (Number i = 0; i < count; ++i)
        if (!bounds[i]) {
            inner.push_back(record.points[i]);
            order.push_back(i);
        }
    pane.add_all(inner);
    if (pane.point_count() != count || pane.boundary_count() != std::size_t(std::count(bounds.begin(), bounds.end(), true)))
        fail(Reason::coincides, "points of the record are nearer than weld, or on the boundary without being of it");

    std::vector<Number> new_of(count);
    for (Number i = 0; i < count; ++i) new_of[order[i]] = i;
    pane.take_ids(record.ids, new_of, record.next_point);
    for (const auto& [id, chain] : record.segments) {
        if (id < Number(pane.next_segment()) || id >= record.next_segment || chain.size() < 2)
            fail(Reason::no_such_segment, fmt::format("segment {} is out of order, or has no length", id));
        std::vector<PointId> path;
        for (const Number i : chain) path.push_back(PointId(record.ids[checked(i)]));
        pane.take_segment(id, path);
        if (pane.point_count() != count) fail(Reason::unresolvable, fmt::format("segment {} crosses another where the record has no point", id));
    }
    pane.skip_segments(record.next_segment);
    for (const auto& [id, chain] : record.segments) {
        const auto equal = [&](PointId point, Number i) { return Number(point) == record.ids[i]; };
        if (!std::ranges::equal(pane.chain(SegmentId(id)), chain, equal))
            fail(Reason::unresolvable, fmt::format("segment {} meets more than its points", id));
    }
    const auto ids = [&](const std::vector<Number>& numbers) {
        std::vector<PointId> points;
        for (const Number i : numbers) points.push_back(PointId(record.ids[checked(i)]));
        return points;
    };
    for (const Number i : record.crossings)
        if (bounds[checked(i)]) fail(Reason::boundary_touches, fmt::format("point number {} is of the boundary, not a crossing", i));
    pane.take_marks(ids(record.crossings), ids(record.refined));
    pane.lock(ids(record.locked));
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
