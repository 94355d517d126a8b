// Phase II of a CellTile: moves, splits and flips, and the way back of one pane.
#include "cell/cell_tile.h"
#include "cell/harmonic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse {

void CellTile::require_shaped(const char* what) const
{
    if (phase_ != 2) throw CellRefusal(Reason::phase, fmt::format("{} after cell.shape", what));
}

void CellTile::require_not_flat(int pane) const
{
    if (flat_.contains(pane)) throw CellRefusal(Reason::phase, fmt::format("pane {} is rolled back: cell.shape takes it into space again", pane));
}

void CellTile::shape()
{
    notes_.clear();
    if (phase_ == 2 && flat_.empty()) notes_.emplace_back("the cell is shaped already");
    phase_ = 2;
    flat_.clear();
}

/// New points of a pane that was rolled back take what their neighbours were moved.
void CellTile::fill_fresh(int p)
{
    const auto flat = flat_.find(p);
    if (flat == flat_.end() || !flat->second.keep) return;
    const std::vector<bool>& fresh = flat->second.fresh;
    std::vector<Point2> places;
    std::vector<Vector> values;
    std::vector<Index> unknown;
    const Index rim = rim_count(p);
    for (Index i = 0; i < mesh(p).point_count(); ++i) {
        places.push_back(flat_place(p, i));
        values.push_back(moved(pane_point(p, i).orbit));
        if (i >= rim && i < mesh(p).own && fresh[i - rim]) unknown.push_back(i);
    }
    if (unknown.empty()) return;
    fill_harmonic(places, mesh(p).triangles, unknown, values);
    std::vector<Vector>& list = own(moved_[static_cast<std::size_t>(p)]);
    for (const Index i : unknown) list[i - rim] = values[i];
}

void CellTile::check_moved(const CellPointName& point, const Vector& by)
{
    if (!is_in_reach(by)) throw CommandError(fmt::format("{} would be farther than 1e38", point.text()));
}

void CellTile::move(std::span<const int> points, const Vector& by)
{
    require_shaped("points move in space");
    if (!is_in_reach(by)) throw CommandError("a move goes no farther than 1e38");
    std::vector<int> once(points.begin(), points.end());
    std::ranges::sort(once);
    once.erase(std::unique(once.begin(), once.end()), once.end());
    for (const int point : once) {
        const CellPointName its = name(point);
        if (its.kind == CellPointName::Kind::interior) require_not_flat(its.pane);
        check_moved(its, moved(point) + by);
    }
    for (const int point : once) set_moved(point, moved(point) + by);
    for (const auto& [pane, flat] : flat_) fill_fresh(pane);
    notes_.clear();
}

Vector CellTile::radial(const OrbitMember& point) const
{
    const Vector from_centre = direction(position(point.orbit) + cell_->at(point.shift));
    if (from_centre == Vector(0.0)) throw CommandError(fmt::format("{} is the centre of the cell", name(point.orbit).text()));
    return from_centre;
}

// --- splits and flips ---------------------------------------------------------------------------------------------------------------------

/// Does what a detail says. A new point goes where the surface is there, or is moved as it is told.
void CellTile::apply(const CellDetail& detail, std::optional<Vector> moved)
{
    require_pane(detail.pane);
    require_not_flat(detail.kind == CellDetail::Kind::edge && is_side(detail) ? -1 : detail.pane);
    switch (detail.kind) {
    case CellDetail::Kind::triangle: split_inside(detail, moved); break;
    case CellDetail::Kind::edge: split_at(detail, moved); break;
    case CellDetail::Kind::flip: flip(detail); break;
    }
    details_.push_back(detail);
}

void CellTile::split_inside(const CellDetail& detail, std::optional<Vector> moved)
{
    const std::vector<PaneMesh::Corners>& triangles = mesh(detail.pane).triangles;
    if (detail.triangle < 0 || detail.triangle >= std::ssize(triangles))
        throw CellRefusal(Reason::no_such_triangle, fmt::format("pane {} has {} triangles, from 0 on, and no p{}:{}", detail.pane, triangles.size(), detail.pane, detail.triangle));
    double sum = 0;
    for (const double weight : detail.at) sum += weight;
    if (!(detail.at[0] > 0 && detail.at[1] > 0 && detail.at[2] > 0 && std::abs(sum - 1) <= 1e-9))
        throw CommandError(fmt::format("at={},{},{}: expected three weights above 0 that make 1", detail.at[0], detail.at[1], detail.at[2]));
    Split split{detail.pane, -1, Point(0.0), Vector(0.0), {}};
    for (std::size_t k = 0; k < 3; ++k) {
        const OrbitMember corner = pane_point(detail.pane, triangles[static_cast<std::size_t>(detail.triangle)][k]);
        split.base += detail.at[k] * (base(corner.orbit) + cell_->at(corner.shift));
        split.moved += detail.at[k] * this->moved(corner.orbit);
    }
    split.moved = moved.value_or(split.moved);
    splits_.push_back(split);
    edit_mesh(detail.pane).split_triangle(static_cast<Index>(detail.triangle), static_cast<int>(splits_.size()) - 1);
}

void CellTile::split_at(const CellDetail& detail, std::optional<Vector> moved)
{
    const int p = detail.pane, number = static_cast<int>(splits_.size());
    if (!(detail.t > 0 && detail.t < 1)) throw CommandError(fmt::format("t={}: expected above 0 and below 1", detail.t));
    const auto [a, b] = edge_between(detail.pane, detail.edge);
    const OrbitMember from = pane_point(p, a), to = pane_point(p, b);
    Split split{p, -1, Point(0.0), Vector(0.0), {}};
    split.base = (1 - detail.t) * (base(from.orbit) + cell_->at(from.shift)) + detail.t * (base(to.orbit) + cell_->at(to.shift));
    split.moved = moved.value_or((1 - detail.t) * this->moved(from.orbit) + detail.t * this->moved(to.orbit));
    if (!is_side(detail)) {
        splits_.push_back(split);
        edit_mesh(p).split_edge(a, b, number, -1);
        return;
    }
    // All that the lattice makes of the edge is split, in all panes.
    const CellSide& side = at_pane(p).sides[static_cast<std::size_t>(side_of(p, a, b))];
    split.pane = -1;
    split.edge = side.edge.orbit;
    split.base -= cell_->at(side.edge.shift);
    split.ends = {name(from.orbit), name(to.orbit)};
    if ((mesh(p).next_on_rim(a) == b) == side.reversed) std::swap(split.ends[0], split.ends[1]);
    splits_.push_back(split);
    split_side(number);
}

/// Where a name of a point is met in a pane: once, or on each side that a split of its edge orbit made it on.
std::vector<CellTile::Index> CellTile::places_in_pane(int pane, const CellPointName& name) const
{
    std::vector<Index> places{find_in_pane(pane, name)};
    if (name.kind == CellPointName::Kind::split && name.side < 0)
        for (Index i = places.front() + 1; i < mesh(pane).point_count(); ++i)
            if (mesh(pane).made[i - mesh(pane).own].split == name.index) places.push_back(i);
    return places;
}

std::array<CellTile::Index, 2> CellTile::edge_between(int pane, const std::array<CellPointName, 2>& ends) const
{
    std::vector<std::array<Index, 2>> found;
    for (const Index a : places_in_pane(pane, ends[0]))
        for (const Index b : places_in_pane(pane, ends[1]))
            if (mesh(pane).find(a, b) || mesh(pane).find(b, a)) found.push_back({a, b});
    if (found.size() == 1) return found.front();
    const std::string between = fmt::format("between {} and {}", ends[0].text(), ends[1].text());
    if (found.empty()) throw CellRefusal(Reason::no_such_edge, fmt::format("pane {} has no edge {}", pane, between));
    throw CellRefusal(Reason::no_such_edge, fmt::format("pane {} has {} edges {}: say on which side, as {} to {}", pane, found.size(), between,
                                                        pane_name(pane, found[0][0]).text(), pane_name(pane, found[0][1]).text()));
}

/// Whether that edge is one of the pane's outline.
bool CellTile::is_side(const CellDetail& detail) const
{
    const auto [a, b] = edge_between(detail.pane, detail.edge);
    return !mesh(detail.pane).find(a, b) || !mesh(detail.pane).find(b, a);
}

/// Splits the sides that have a split of their edge orbit, of all panes or of one.
void CellTile::split_side(int split, std::optional<int> only)
{
    const Split& its = splits_[static_cast<std::size_t>(split)];
    const int first = find(its.ends[0]), last = find(its.ends[1]);
    for (int p = only.value_or(0); p < (only ? *only + 1 : pane_count()); ++p) {
        const CellPane& pane = at_pane(p);
        for (int k = 0; k < std::ssize(pane.sides); ++k) {
            const CellSide& side = pane.sides[static_cast<std::size_t>(k)];
            if (side.edge.orbit != its.edge) continue;
            const Index end = corner_number(p, (k + 1) % static_cast<int>(pane.sides.size()));
            for (Index a = corner_number(p, k); a != end;) {
                const Index b = mesh(p).next_on_rim(a);
                const int from = pane_point(p, a).orbit, to = pane_point(p, b).orbit;
                if (side.reversed ? from == last && to == first : from == first && to == last) {
                    edit_mesh(p).split_edge(a, b, split, k);
                    break;
                }
                a = b;
            }
        }
    }
}

void CellTile::flip(const CellDetail& detail)
{
    const auto [a, b] = edge_between(detail.pane, detail.edge);
    const auto one = mesh(detail.pane).find(a, b), other = mesh(detail.pane).find(b, a);
    if (!one || !other)
        throw CellRefusal(Reason::fixed, fmt::format("{} to {} is a side of pane {}, which other panes have too", detail.edge[0].text(), detail.edge[1].text(), detail.pane));
    const OrbitMember c = pane_point(detail.pane, mesh(detail.pane).opposite(*one)), d = pane_point(detail.pane, mesh(detail.pane).opposite(*other));
    if (has_edge(c, d))
        throw CellRefusal(Reason::duplicate, fmt::format("there is an edge between {} and {} already", name(c.orbit).text(), name(d.orbit).text()));
    edit_mesh(detail.pane).flip(a, b);
}

/// Whether any pane has an edge that the lattice makes of the one between two points; a point has one with itself.
bool CellTile::has_edge(const OrbitMember& a, const OrbitMember& b) const
{
    if (a == b) return true;
    const LatticeStep wanted = b.shift - a.shift;
    for (int p = 0; p < pane_count(); ++p) {
        std::vector<OrbitMember> points(mesh(p).point_count());
        for (Index i = 0; i < points.size(); ++i) points[i] = pane_point(p, i);
        for (const PaneMesh::Corners& t : mesh(p).triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const OrbitMember &c = points[t[k]], &d = points[t[(k + 1) % 3]];
                if (c.orbit == a.orbit && d.orbit == b.orbit && d.shift - c.shift == wanted) return true;
                if (c.orbit == b.orbit && d.orbit == a.orbit && c.shift - d.shift == wanted) return true;
            }
    }
    return false;
}

CellPointName CellTile::add_detail(const CellDetail& detail)
{
    require_shaped("triangles are split and turned");
    CellTile next = *this;
    next.notes_.clear();
    next.apply(detail, {});
    *this = std::move(next);
    return CellPointName::split(static_cast<int>(splits_.size()) - 1);
}

CellPointName CellTile::split_triangle(int pane, int triangle, const std::array<double, 3>& at)
{
    CellDetail detail;
    detail.pane = pane;
    detail.triangle = triangle;
    detail.at = at;
    return add_detail(detail);
}

CellPointName CellTile::split_edge(int pane, const CellPointName& from, const CellPointName& to, double t)
{
    CellDetail detail;
    detail.kind = CellDetail::Kind::edge;
    detail.pane = pane;
    detail.edge = ends_in_pane(pane, from, to);
    detail.t = t;
    return add_detail(detail);
}

void CellTile::flip(int pane, const CellPointName& from, const CellPointName& to)
{
    CellDetail detail;
    detail.kind = CellDetail::Kind::flip;
    detail.pane = pane;
    detail.edge = ends_in_pane(pane, from, to);
    add_detail(detail);
}

/// The ends of an edge as a design names them.
std::array<CellPointName, 2> CellTile::ends_in_pane(int pane, const CellPointName& from, const CellPointName& to) const
{
    const auto [a, b] = edge_between(pane, {from, to});
    return {pane_name(pane, a), pane_name(pane, b)};
}

// --- rolling back -------------------------------------------------------------------------------------------------------------------------

void CellTile::roll_back(int p, bool keep)
{
    require_pane(p);
    require_shaped("a pane goes back to phase I");
    require_not_flat(p);
    CellTile next = *this;
    next.notes_.clear();
    // Of its details those on sides stay: other panes have them too.
    next.details_.clear();
    next.splits_.clear();
    std::vector<int> number; // of splits that stay
    const auto renamed = [&](CellPointName& name) {
        if (name.kind == CellPointName::Kind::split) name.index = number[static_cast<std::size_t>(name.index)];
    };
    for (CellDetail detail : details_) {
        const bool goes = detail.pane == p && (!detail.makes_point() || splits_[number.size()].pane == p);
        if (!goes)
            for (CellPointName& end : detail.edge) renamed(end);
        if (detail.makes_point()) {
            number.push_back(goes ? -1 : static_cast<int>(next.splits_.size()));
            if (!goes) {
                Split& split = next.splits_.emplace_back(splits_[number.size() - 1]);
                for (CellPointName& end : split.ends) renamed(end);
            }
        }
        if (!goes) next.details_.push_back(detail);
    }
    if (next.splits_.size() < splits_.size())
        for (int q = 0; q < pane_count(); ++q)
            if (q != p && !mesh(q).made.empty())
                for (PaneMesh::Made& made : next.edit_mesh(q).made) made.split = number[static_cast<std::size_t>(made.split)];
    next.flat_[p] = {keep, std::vector<bool>(interior(p).size(), false), {}};
    if (!keep) next.moved_[static_cast<std::size_t>(p)] = std::make_shared<std::vector<Vector>>(interior(p).size(), Vector(0.0));
    next.take_pane(p, next.make_pane(p));
    *this = std::move(next);
}

} // namespace druse
