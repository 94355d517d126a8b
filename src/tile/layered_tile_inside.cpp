// Edits of points and segments inside a LayeredTile: those of its pane.
#include "pane/pane_names.h"
#include "tile/layered_tile.h"

#include <fmt/format.h>

#include <algorithm>

namespace druse {

namespace {

PointId id_of(int point) { return PointId(static_cast<std::uint32_t>(point)); }

} // namespace

/// Edits a pane that has our points by our numbers, and takes over what it became. What `change` returns is a point of the pane.
template <class F>
PointName LayeredTile::change_inside(F&& change, Progress* progress)
{
    Pane pane = make_pane();
    pane.set_snap(snap());
    LayeredTile next = *this;
    next.notes_.clear();
    PointId point;
    try {
        point = change(pane);
    } catch (const PaneRefusal& refusal) {
        throw PaneRefusal(refusal.reason(), named(refusal.what()));
    }
    for (const std::string& note : pane.report().notes) next.notes_.push_back(named("note: " + note));
    const std::vector<PointId> points = pane.points();
    const auto place = static_cast<int>(std::ranges::lower_bound(points, point) - points.begin());
    next.take_inside(pane, this, progress);
    *this = std::move(next);
    return place < point_count() ? name(place) : PointName::corner(0);
}

PointName LayeredTile::add_point(const Point2& at)
{
    // What comes to lie on the outline is a point of a path, so that all edges with that path get it.
    Pane trial = make_pane();
    trial.set_snap(snap());
    const PointId id = [&] {
        try {
            return trial.add(at);
        } catch (const PaneRefusal& refusal) {
            throw PaneRefusal(refusal.reason(), named(refusal.what()));
        }
    }();
    const int number = static_cast<int>(id);
    if (number < point_count()) {
        notes_ = {fmt::format("{} is there already", name(number).text())};
        return name(number);
    }
    if (trial.kind(id) == PointKind::boundary) return add_path_point(trial.position(id));
    LayeredTile next = *this;
    next.notes_.clear();
    next.take_inside(trial, this);
    *this = std::move(next);
    return name(point_count() - 1);
}

void LayeredTile::move_point(const PointName& point, const Point2& to)
{
    const int i = inner_point(point);
    change_inside([&](Pane& pane) { return pane.move(id_of(i), to); });
}

void LayeredTile::remove_point(const PointName& point)
{
    const int i = inner_point(point);
    change_inside([&](Pane& pane) {
        pane.remove(id_of(i));
        return id_of(0);
    });
}

/// The number of a point inside.
int LayeredTile::inner_point(const PointName& point) const
{
    const int i = find(point);
    if (point.kind != PointName::Kind::interior) throw TileRefusal(TileRefusal::Reason::no_such_point, fmt::format("{} is not inside: points of the outline move with their paths", point.text()));
    return i;
}

void LayeredTile::constrain(std::span<const PointName> path)
{
    std::vector<PointId> ids;
    for (const PointName& name : path) ids.push_back(id_of(find(name)));
    change_inside([&](Pane& pane) {
        pane.constrain(ids);
        return id_of(0);
    });
}

void LayeredTile::unconstrain(std::span<const PointName> path)
{
    if (path.size() < 2) throw CommandError("a segment runs from one point to another");
    std::vector<PointId> all;
    for (const PointName& name : path) all.push_back(id_of(find(name)));
    change_inside([&](Pane& pane) {
        const auto segment = segment_along(pane, all);
        if (!segment)
            throw PaneRefusal(PaneRefusal::Reason::no_such_segment, fmt::format("no segment runs from {} to {}", path.front().text(), path.back().text()));
        pane.unconstrain(*segment);
        return id_of(0);
    });
}

Pane::Refined LayeredTile::refine(const Pane::Refinement& refinement, Progress* progress)
{
    Pane::Refined refined;
    const auto change = [&](Pane& pane) {
        refined = pane.refine(refinement, progress);
        return id_of(0);
    };
    change_inside(change, progress);
    return refined;
}

} // namespace druse
