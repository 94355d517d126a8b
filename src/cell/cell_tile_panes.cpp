// Phase I of a CellTile: points and segments of its panes, and points of its edges.
#include "cell/cell_tile.h"
#include "pane/pane_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace druse {

namespace {

PointId pane_id(CellTile::Index point) { return PointId(point); }

} // namespace

void CellTile::require_flat(int pane, const char* what) const
{
    require_pane(pane);
    if (!is_flat(pane)) throw CellRefusal(Reason::phase, fmt::format("{} come before cell.shape: cell.rollback pane={} takes that pane back", what, pane));
}

/// The pane of the design: its points have our numbers, and behind them come those where segments cross without one of the design.
Pane CellTile::make_pane(int p) const
{
    const Index rim = rim_count(p);
    std::vector<Point2> loop;
    for (std::size_t k = 0; k < at_pane(p).sides.size(); ++k) {
        const CellSide& side = at_pane(p).sides[k];
        const Point2 from = at_pane(p).outline[k], along = at_pane(p).outline[(k + 1) % at_pane(p).outline.size()] - from;
        const std::vector<double>& list = edge_points(side.edge.orbit);
        loop.push_back(from);
        for (std::size_t i = 0; i < list.size(); ++i) loop.push_back(from + (side.reversed ? 1 - list[list.size() - 1 - i] : list[i]) * along);
    }
    try {
        Pane pane(loop, {}, {.snap = 0.0, .weld = weld()});
        const std::vector<PointId> ids = pane.add_all(interior(p));
        for (std::size_t i = 0; i < ids.size(); ++i)
            if (ids[i] != pane_id(rim + static_cast<Index>(i)) || pane.kind(ids[i]) != PointKind::interior)
                throw PaneRefusal(PaneRefusal::Reason::coincides, fmt::format("point i{} would be on a side of the pane, or on another point", i));
        for (const auto& chain : at(p).segments) {
            std::vector<PointId> path;
            for (const CellPointName& name : chain) path.push_back(pane_id(find_in_pane(p, name)));
            pane.constrain(path);
        }
        return pane;
    } catch (const PaneRefusal& refusal) {
        throw PaneRefusal(refusal.reason(), fmt::format("pane {}: {}", p, named(p, refusal.what())));
    }
}

/// Points, segments and triangles of a pane whose first ids are our numbers; and splits of its sides once more.
void CellTile::take_pane(int p, const Pane& made)
{
    const Index rim = rim_count(p), known = rim + static_cast<Index>(interior(p).size());
    const auto k = static_cast<std::size_t>(p);
    const auto flat = flat_.find(p);
    const std::vector<bool> were_fresh = flat == flat_.end() ? std::vector<bool>() : flat->second.fresh;
    auto part = std::make_shared<PanePart>();
    auto moved = std::make_shared<std::vector<Vector>>();
    std::vector<bool> fresh;
    std::vector<Index> number(std::size_t(made.next_point()), Pane::none);
    for (const PointId id : made.points()) {
        const auto old = static_cast<Index>(id);
        number[old] = old < rim ? old : rim + static_cast<Index>(part->interior.size());
        if ((made.kind(id) == PointKind::boundary) != (old < rim))
            throw CellRefusal(Reason::fixed, fmt::format("a point inside would be on a side of the pane, at ({:.6g}, {:.6g})", made.position(id).x, made.position(id).y));
        if (old < rim) continue;
        part->interior.push_back(made.position(id));
        moved->push_back(old < known ? moved_in(p)[old - rim] : Vector(0.0));
        fresh.push_back(old < known ? !were_fresh.empty() && were_fresh[old - rim] : true);
    }
    PaneMesh& mesh = part->mesh;
    mesh.own = rim + static_cast<Index>(part->interior.size());
    for (Index i = 0; i < rim; ++i) mesh.rim.push_back(i);
    // In an order that depends on the design only.
    made.for_triangles([&](PointId a, PointId b, PointId c) {
        PaneMesh::Corners t{number[std::size_t(a)], number[std::size_t(b)], number[std::size_t(c)]};
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        mesh.triangles.push_back(t);
    });
    std::ranges::sort(mesh.triangles);
    require_no_slivers(p, mesh);

    panes_[k] = part;
    moved_[k] = std::move(moved);
    if (flat != flat_.end()) flat->second.fresh = std::move(fresh);
    number_points();
    for (const SegmentId segment : made.segments()) {
        auto& chain = part->segments.emplace_back();
        for (const PointId id : made.chain(segment)) chain.push_back(pane_name(p, number[std::size_t(id)]));
    }
    for (int s = 0; s < std::ssize(splits_); ++s)
        if (splits_[static_cast<std::size_t>(s)].edge >= 0) split_side(s, p);
}

/// Refuses a triangle between points of one side, which a line past some of them may leave: the pane beyond may have the same edge.
void CellTile::require_no_slivers(int p, const PaneMesh& mesh) const
{
    const auto corners = static_cast<int>(at_pane(p).corners.size());
    const Index rim = rim_count(p);
    for (const PaneMesh::Corners& t : mesh.triangles) {
        if (std::max({t[0], t[1], t[2]}) >= rim) continue;
        for (int k = 0; k < corners; ++k) {
            const Index from = corner_number(p, k), to = corner_number(p, k + 1);
            if (std::ranges::all_of(t, [&](Index i) { return (i >= from && i <= to) || (i == 0 && to == rim); }))
                throw PaneRefusal(PaneRefusal::Reason::coincides, fmt::format("a line of pane {} runs past points of its side {}, not by them", p, k));
        }
    }
}

/// Edits a pane, and takes over what it became. What `change` returns is a point of it.
template <class F>
CellPointName CellTile::change_pane(int p, F&& change)
{
    Pane pane = make_pane(p);
    pane.set_snap(snap());
    CellTile next = *this;
    next.notes_.clear();
    PointId point;
    try {
        point = change(pane);
    } catch (const PaneRefusal& refusal) {
        throw PaneRefusal(refusal.reason(), named(p, refusal.what()));
    }
    for (const std::string& note : pane.report().notes) next.notes_.push_back(named(p, "note: " + note));
    const std::vector<PointId> points = pane.points();
    const auto place = static_cast<Index>(std::ranges::lower_bound(points, point) - points.begin());
    next.take_pane(p, pane);
    next.fill_fresh(p);
    *this = std::move(next);
    return name(pane_point(p, place).orbit);
}

CellPointName CellTile::add_point(int p, const Point2& at)
{
    require_flat(p, "points of panes");
    // What comes to lie on a side is a point of its edge orbit, so that all panes there get it.
    Pane trial = make_pane(p);
    trial.set_snap(snap());
    PointId id;
    try {
        id = trial.add(at);
    } catch (const PaneRefusal& refusal) {
        throw PaneRefusal(refusal.reason(), named(p, refusal.what()));
    }
    if (static_cast<Index>(id) < mesh(p).own) {
        const OrbitMember there = pane_point(p, static_cast<Index>(id));
        notes_ = {fmt::format("{} is there already", name(there.orbit).text())};
        return name(there.orbit);
    }
    if (trial.kind(id) == PointKind::boundary) {
        const PaneReport::Split& split = trial.report().splits.front();
        const auto k = static_cast<std::size_t>(side_of(p, static_cast<Index>(split.from), static_cast<Index>(split.to)));
        const CellSide& side = at_pane(p).sides[k];
        const Point2 from = at_pane(p).outline[k], along = at_pane(p).outline[(k + 1) % at_pane(p).outline.size()] - from;
        const double u = glm::dot(trial.position(id) - from, along) / glm::dot(along, along);
        return add_edge_point(side.edge.orbit, side.reversed ? 1 - u : u);
    }
    CellTile next = *this;
    next.notes_.clear();
    next.take_pane(p, trial);
    next.fill_fresh(p);
    *this = std::move(next);
    return CellPointName::interior(p, static_cast<int>(interior(p).size()) - 1);
}

/// The number of a point inside a pane that is flat.
CellTile::Index CellTile::interior_number(const CellPointName& point) const
{
    const CellPointName its = name(find(point));
    if (its.kind != CellPointName::Kind::interior)
        throw CellRefusal(Reason::fixed, fmt::format("{} is on the edge of panes: it stays where it is", point.text()));
    require_flat(its.pane, "edits of its points in the plane");
    return rim_count(its.pane) + static_cast<Index>(its.index);
}

void CellTile::move_point(const CellPointName& point, const Point2& to)
{
    const Index i = interior_number(point);
    change_pane(point.pane, [&](Pane& pane) { return pane.move(pane_id(i), to); });
}

/// Points inside a pane, by their numbers.
void CellTile::remove_inside(int p, const std::set<Index>& numbers)
{
    const std::size_t before = interior(p).size();
    const std::string first = pane_name(p, *numbers.begin()).text();
    std::vector<std::string> notes;
    change_pane(p, [&](Pane& pane) {
        for (const Index i : numbers) {
            for (const std::string& note : pane.report().notes) notes.push_back(named(p, "note: " + note));
            pane.remove(pane_id(i));
        }
        return pane_id(0);
    });
    notes_.insert(notes_.begin(), notes.begin(), notes.end());
    const std::size_t stay = interior(p).size() + numbers.size() - before;
    if (stay > 0 && numbers.size() == 1) notes_.push_back(fmt::format("{} stays: lines cross there", first));
    else if (stay > 0) notes_.push_back(fmt::format("pane {}: {} point{} where lines cross", p, stay, stay == 1 ? " stays" : "s stay"));
}

void CellTile::remove_points(std::span<const CellPointName> points)
{
    std::map<int, std::set<Index>> inside; // by pane
    std::map<int, std::set<int>> of_edges; // by orbit of edges, their places in its list
    for (const CellPointName& point : points) {
        const CellPointName its = name(find(point));
        if (its.kind != CellPointName::Kind::edge) {
            inside[its.pane].insert(interior_number(point));
            continue;
        }
        if (phase_ != 1) throw CellRefusal(Reason::phase, "points of edges go before cell.shape");
        of_edges[its.line].insert(its.index);
    }
    CellTile next = *this;
    std::vector<std::string> notes;
    const auto gather = [&] { notes.insert(notes.end(), next.notes_.begin(), next.notes_.end()); };
    for (const auto& [pane, numbers] : inside) {
        next.remove_inside(pane, numbers);
        gather();
    }
    for (const auto& [edge, places] : of_edges) {
        std::vector<double> list = next.edge_points(edge);
        for (auto place = places.rbegin(); place != places.rend(); ++place) list.erase(list.begin() + *place);
        next.set_edge_points(edge, std::move(list));
        gather();
    }
    next.notes_ = std::move(notes);
    *this = std::move(next);
}

/// The points that a line runs along, in the triangulation of its pane.
std::vector<PointId> CellTile::line_points(int p, std::span<const CellPointName> path) const
{
    std::vector<PointId> ids;
    for (const CellPointName& name : path) {
        const Index i = find_in_pane(p, name);
        if (i >= mesh(p).own) throw CellRefusal(Reason::fixed, fmt::format("{} was made by a split in space: no line of the flat pane runs there", name.text()));
        ids.push_back(pane_id(i));
    }
    return ids;
}

void CellTile::constrain(int p, std::span<const CellPointName> path)
{
    require_flat(p, "lines");
    const std::vector<PointId> ids = line_points(p, path);
    change_pane(p, [&](Pane& pane) {
        pane.constrain(ids);
        return pane_id(0);
    });
}

void CellTile::unconstrain(int p, std::span<const CellPointName> path)
{
    require_flat(p, "lines");
    if (path.size() < 2) throw CommandError("a segment runs from one point to another");
    const std::vector<PointId> ids = line_points(p, path);
    change_pane(p, [&](Pane& pane) {
        const auto segment = segment_along(pane, ids);
        if (!segment)
            throw PaneRefusal(PaneRefusal::Reason::no_such_segment, fmt::format("no segment runs from {} to {}", path.front().text(), path.back().text()));
        pane.unconstrain(*segment);
        return pane_id(0);
    });
}

Pane::Refined CellTile::refine(int p, const Pane::Refinement& refinement, Progress* progress)
{
    require_flat(p, "new points of panes");
    Pane::Refined refined;
    change_pane(p, [&](Pane& pane) {
        refined = pane.refine(refinement, progress);
        return pane_id(0);
    });
    return refined;
}

// --- points of edges ----------------------------------------------------------------------------------------------------------------------

CellPointName CellTile::add_edge_point(int edge, double t)
{
    if (edge < 0 || edge >= std::ssize(edges_))
        throw CellRefusal(Reason::no_such_edge, fmt::format("{} has {} orbits of edges, from 0 on, and no edge {}", druse::name(cell_->kind), edges_.size(), edge));
    if (phase_ != 1) throw CellRefusal(Reason::phase, "points of edges come before cell.shape");
    if (!(t > 0 && t < 1)) throw CommandError(fmt::format("t={}: expected above 0 and below 1", t));
    const Parallelohedron::Edge& its = cell_->edges[static_cast<std::size_t>(edge)];
    const double near = weld() / glm::length(cell_->corner(its.to) - cell_->corner(its.from));
    std::vector<double> list = edge_points(edge);
    const auto after = std::ranges::upper_bound(list, t);
    const auto place = static_cast<int>(after - list.begin());
    std::optional<CellPointName> there;
    if (t - (place > 0 ? list[static_cast<std::size_t>(place) - 1] : 0.0) <= near) there = place > 0 ? CellPointName::edge(edge, place - 1) : CellPointName::corner(its.from.orbit);
    else if ((after != list.end() ? *after : 1.0) - t <= near) there = after != list.end() ? CellPointName::edge(edge, place) : CellPointName::corner(its.to.orbit);
    if (there) {
        notes_ = {fmt::format("{} is there already", there->text())};
        return *there;
    }
    list.insert(after, t);
    set_edge_points(edge, std::move(list));
    return CellPointName::edge(edge, place);
}

void CellTile::remove_edge_points(std::span<const CellPointName> points)
{
    for (const CellPointName& point : points)
        if (name(find(point)).kind != CellPointName::Kind::edge) throw CellRefusal(Reason::no_such_point, fmt::format("{} is no point of an edge, as x0:1", point.text()));
    remove_points(points);
}

void CellTile::set_edge_points(int edge, std::vector<double> t)
{
    CellTile next = *this;
    next.notes_.clear();
    const auto e = static_cast<std::size_t>(edge);
    next.edge_moved_[e].assign(t.size(), Vector(0.0));
    next.edges_[e] = std::move(t);
    next.number_points();
    for (int p = 0; p < pane_count(); ++p) {
        if (std::ranges::none_of(at_pane(p).sides, [edge](const CellSide& side) { return side.edge.orbit == edge; })) continue;
        PaneMesh& mesh = next.edit_mesh(p);
        mesh = {};
        mesh.own = next.rim_count(p) + static_cast<Index>(interior(p).size());
        own(next.panes_[static_cast<std::size_t>(p)]).segments = next.chains_after(*this, p);
        next.take_pane(p, next.make_pane(p));
    }
    *this = std::move(next);
}

/// The segments of a pane as they were before points came to its sides or went: one along a side passes the new points, and one by a point that is gone runs
/// straight on.
CellTile::Chains CellTile::chains_after(const CellTile& before, int p) const
{
    const CellPane& its = at_pane(p);
    const Index rim = before.rim_count(p);
    // By old numbers of points on the outline, the new ones.
    std::vector<Index> number(rim, Pane::none);
    for (std::size_t k = 0; k < its.sides.size(); ++k) {
        const auto side = static_cast<int>(k);
        const std::vector<double>&old = before.edge_points(its.sides[k].edge.orbit), &now = edge_points(its.sides[k].edge.orbit);
        number[before.corner_number(p, side)] = corner_number(p, side);
        for (std::size_t i = 0; i < old.size(); ++i) {
            const auto found = std::ranges::find(now, old[i]);
            if (found == now.end()) continue;
            const auto j = static_cast<int>(found - now.begin()), last_old = static_cast<int>(old.size()) - 1, last = static_cast<int>(now.size()) - 1;
            const int a = its.sides[k].reversed ? last_old - static_cast<int>(i) : static_cast<int>(i), b = its.sides[k].reversed ? last - j : j;
            number[before.side_number(p, side, a)] = side_number(p, side, b);
        }
    }
    Chains chains;
    for (const auto& chain : before.at(p).segments) {
        std::vector<CellPointName> names;
        Index last = Pane::none; // of the chain, by its old number
        for (const CellPointName& old_name : chain) {
            const Index old = before.find_in_pane(p, old_name);
            if (old < rim && number[old] == Pane::none) continue;
            if (last < rim && old < rim && !names.empty()) {
                const bool forward = (last + 1) % rim == old, backward = (old + 1) % rim == last;
                const Index end = rim_count(p), from = number[last], to = number[old];
                if (forward)
                    for (Index i = (from + 1) % end; i != to; i = (i + 1) % end) names.push_back(pane_name(p, i));
                else if (backward)
                    for (Index i = (from + end - 1) % end; i != to; i = (i + end - 1) % end) names.push_back(pane_name(p, i));
            }
            names.push_back(old < rim ? pane_name(p, number[old]) : old_name);
            last = old;
        }
        if (names.size() > 1) chains.push_back(std::move(names));
    }
    return chains;
}

} // namespace druse
