// A CellTile: making one from a design, and reading it. Edits are in cell_tile_panes.cpp and cell_tile_shape.cpp.
#include "cell/cell_tile.h"

#include "pane/pane_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace druse {

namespace {

constexpr double least_determinant = 1e-6;

/// Cubes of sizes, and of differences that count, are numbers too.
void require_size(double x, const char* what)
{
    if (!(x >= 1e-30 && x <= 1e30)) throw CommandError(fmt::format("{} {}: expected 1e-30 to 1e30", what, x));
}

double determinant_of(const CellMatrix& m)
{
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
}

/// Refuses parameters of points on an edge that are not between its ends, ascending and apart.
void check_edge_points(int edge, const std::vector<double>& list, double weld)
{
    double last = 0;
    for (const double t : list) {
        if (!(t - last > weld && 1 - t > weld))
            throw CommandError(fmt::format("points of edge {}: expected parameters between 0 and 1, ascending and apart, not {} after {}", edge, t, last));
        last = t;
    }
}

} // namespace

CellTile::CellTile(CellDesign design) : height_(design.height), kept_(std::move(design.kept))
{
    require_size(design.size, "size");
    if (height_ && design.cell != CellKind::hexprism) throw CommandError(fmt::format("only a hexprism has a height, not {}", druse::name(design.cell)));
    if (height_) require_size(*height_, "height");
    size_ = design.size;
    cell_ = std::make_shared<const Parallelohedron>(make_parallelohedron(design.cell, size_, height_.value_or(size_)));
    set_matrix(design.matrix);

    const std::size_t panes = cell_->panes.size(), edges = cell_->edges.size();
    if (design.panes.size() != panes) throw CommandError(fmt::format("{} has {} pairs of panes, not {}", druse::name(design.cell), panes, design.panes.size()));
    if (design.edges.size() != edges) throw CommandError(fmt::format("{} has {} orbits of edges, not {}", druse::name(design.cell), edges, design.edges.size()));
    if (design.phase != 1 && design.phase != 2) throw CommandError(fmt::format("phase {}: expected 1 or 2", design.phase));
    if (design.phase == 1 && !(design.moved.empty() && design.details.empty() && design.flat.empty()))
        throw CommandError("nothing is moved or split before phase 2");
    edges_ = std::move(design.edges);
    corner_moved_.assign(cell_->corners.size(), Vector(0.0));
    edge_moved_.resize(edges);
    for (std::size_t e = 0; e < edges; ++e) {
        const Parallelohedron::Edge& edge = cell_->edges[e];
        check_edge_points(static_cast<int>(e), edges_[e], weld() / glm::length(cell_->corner(edge.to) - cell_->corner(edge.from)));
        edge_moved_[e].assign(edges_[e].size(), Vector(0.0));
    }
    phase_ = design.phase;

    for (CellDesign::Pane& pane : design.panes) {
        moved_.push_back(std::make_shared<std::vector<Vector>>(pane.points.size(), Vector(0.0)));
        panes_.push_back(std::make_shared<PanePart>(PanePart{std::move(pane.points), std::move(pane.segments), {}}));
    }
    for (const auto& [pane, flat] : design.flat) {
        require_pane(pane);
        Flat& own = flat_[pane];
        own.keep = flat.keep;
        own.kept = flat.kept;
        own.fresh.assign(interior(pane).size(), false);
        for (const int i : flat.fresh) {
            if (i < 0 || i >= std::ssize(own.fresh)) throw CellRefusal(Reason::no_such_point, fmt::format("pane {} has no point i{}", pane, i));
            own.fresh[static_cast<std::size_t>(i)] = true;
        }
    }
    number_points();
    for (int p = 0; p < pane_count(); ++p) {
        edit_mesh(p).own = rim_count(p) + static_cast<Index>(interior(p).size());
        take_pane(p, make_pane(p));
    }

    const auto is_split = [](const auto& item) { return item.first.kind == CellPointName::Kind::split; };
    for (const auto& item : design.moved) {
        check_moved(item.first, item.second);
        if (is_split(item)) continue;
        const int point = find(item.first);
        if (name(point) != item.first) throw CellRefusal(Reason::no_such_point, fmt::format("{} is moved as {}", item.first.text(), name(point).text()));
        set_moved(point, item.second);
    }
    for (const CellDetail& detail : design.details) {
        const auto found = design.moved.find(CellPointName::split(static_cast<int>(splits_.size())));
        apply(detail, found == design.moved.end() ? Vector(0.0) : found->second);
    }
    for (const auto& item : design.moved)
        if (is_split(item)) find(item.first);
    for (const auto& [pane, flat] : flat_) fill_fresh(pane);
    notes_.clear();
}

CellTile CellTile::of_kind(CellKind kind, double size, std::optional<double> height)
{
    const Parallelohedron cell = make_parallelohedron(kind, 1, 1);
    CellDesign design;
    design.cell = kind;
    design.size = size;
    design.height = height;
    design.panes.resize(cell.panes.size());
    design.edges.resize(cell.edges.size());
    return CellTile(std::move(design));
}

CellDesign CellTile::design() const
{
    CellDesign design;
    design.cell = cell_->kind;
    design.size = size_;
    design.height = height_;
    design.matrix = matrix_;
    for (int p = 0; p < pane_count(); ++p) design.panes.push_back({at(p).interior, at(p).segments});
    design.edges = edges_;
    design.phase = phase_;
    for (int i = 0; i < point_count(); ++i) {
        const CellPointName its = name(i);
        const auto flat = its.kind == CellPointName::Kind::interior ? flat_.find(its.pane) : flat_.end();
        const bool follows = flat != flat_.end() && flat->second.fresh[static_cast<std::size_t>(its.index)]; // its neighbours tell
        if (const Vector by = moved(i); by != Vector(0.0) && !follows) design.moved.emplace(its, by);
    }
    design.details = details_;
    for (const auto& [pane, flat] : flat_) {
        CellDesign::Flat& its = design.flat[pane];
        its.keep = flat.keep;
        its.kept = flat.kept;
        for (std::size_t i = 0; i < flat.fresh.size(); ++i)
            if (flat.fresh[i]) its.fresh.push_back(static_cast<int>(i));
    }
    design.kept = kept_;
    return design;
}

// --- the frame ----------------------------------------------------------------------------------------------------------------------------

double CellTile::determinant() const { return determinant_of(matrix_); }

Vector CellTile::world(const Vector& v) const
{
    const CellMatrix& m = matrix_;
    return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z, m[6] * v.x + m[7] * v.y + m[8] * v.z};
}

void CellTile::set_matrix(const CellMatrix& matrix)
{
    for (const double x : matrix)
        if (!(std::abs(x) <= 1e100)) throw CommandError(fmt::format("matrix {}: numbers go to 1e100", x));
    if (const double d = determinant_of(matrix); !(d > least_determinant))
        throw CellRefusal(Reason::flat_cell, fmt::format("the matrix has a determinant of {:.6g}, which must be above {:.6g}", d, least_determinant));
    matrix_ = matrix;
    notes_.clear();
}

// --- points by orbit ----------------------------------------------------------------------------------------------------------------------

void CellTile::number_points()
{
    int next = static_cast<int>(cell_->corners.size());
    first_edge_.clear();
    first_inner_.clear();
    for (const auto& list : edges_) {
        first_edge_.push_back(next);
        next += static_cast<int>(list.size());
    }
    first_edge_.push_back(next);
    for (const auto& pane : panes_) {
        first_inner_.push_back(next);
        next += static_cast<int>(pane->interior.size());
    }
    first_inner_.push_back(next);
    first_split_ = next;
}

CellPointName CellTile::name(int point) const
{
    if (point < first_edge_.front()) return CellPointName::corner(point);
    const auto last_not_after = [point](const std::vector<int>& list) { return static_cast<int>(std::ranges::upper_bound(list, point) - list.begin()) - 1; };
    if (point < first_inner_.front()) {
        const int e = last_not_after(first_edge_);
        return CellPointName::edge(e, point - first_edge_[static_cast<std::size_t>(e)]);
    }
    if (point >= first_split_) return CellPointName::split(point - first_split_);
    const int p = last_not_after(first_inner_);
    return CellPointName::interior(p, point - first_inner_[static_cast<std::size_t>(p)]);
}

int CellTile::find(const CellPointName& name) const
{
    using Kind = CellPointName::Kind;
    const auto within = [](int i, std::size_t count) { return i >= 0 && static_cast<std::size_t>(i) < count; };
    const auto k = static_cast<std::size_t>(name.kind == Kind::interior ? name.pane : name.line);
    switch (name.kind) {
    case Kind::corner:
        if (within(name.index, cell_->corners.size())) return name.index;
        break;
    case Kind::edge:
        if (within(name.line, edges_.size()) && within(name.index, edges_[k].size())) return first_edge_[k] + name.index;
        break;
    case Kind::interior:
        if (name.pane < 0) throw CellRefusal(Reason::no_such_point, fmt::format("{} is in a pane: say which, as p0:{}", name.text(), name.text()));
        if (within(name.pane, panes_.size()) && within(name.index, panes_[k]->interior.size())) return first_inner_[k] + name.index;
        break;
    case Kind::split:
        if (name.pane < 0 && within(name.index, splits_.size())) return first_split_ + name.index;
        [[fallthrough]];
    case Kind::pane_corner:
    case Kind::side:
        if (name.pane < 0 && name.kind != Kind::split)
            throw CellRefusal(Reason::no_such_point, fmt::format("{} is in a pane: say which, as p0:{}", name.text(), name.text()));
        if (within(name.pane, panes_.size())) return pane_point(name.pane, find_in_pane(name.pane, name)).orbit;
        break;
    }
    throw CellRefusal(Reason::no_such_point, fmt::format("the cell has no point {}", name.text()));
}

OrbitMember CellTile::find_member(const CellPointName& name) const
{
    if (const int point = find(name); name.pane < 0) return {point, {}};
    return pane_point(name.pane, find_in_pane(name.pane, name));
}

Point CellTile::base(int point) const
{
    const CellPointName its = name(point);
    switch (its.kind) {
    case CellPointName::Kind::corner: return cell_->corners[static_cast<std::size_t>(its.index)].place;
    case CellPointName::Kind::edge: {
        const Parallelohedron::Edge& edge = cell_->edges[static_cast<std::size_t>(its.line)];
        const Point from = cell_->corner(edge.from);
        return from + edges_[static_cast<std::size_t>(its.line)][static_cast<std::size_t>(its.index)] * (cell_->corner(edge.to) - from);
    }
    case CellPointName::Kind::interior: return at_pane(its.pane).centre + in_plane(its.pane, at(its.pane).interior[static_cast<std::size_t>(its.index)]);
    default: return splits_[static_cast<std::size_t>(its.index)].base;
    }
}

Vector CellTile::moved(int point) const
{
    const CellPointName its = name(point);
    const auto i = static_cast<std::size_t>(its.index);
    switch (its.kind) {
    case CellPointName::Kind::corner: return corner_moved_[i];
    case CellPointName::Kind::edge: return edge_moved_[static_cast<std::size_t>(its.line)][i];
    case CellPointName::Kind::interior: return moved_in(its.pane)[i];
    default: return splits_[i].moved;
    }
}

void CellTile::set_moved(int point, const Vector& to)
{
    const CellPointName its = name(point);
    const auto i = static_cast<std::size_t>(its.index);
    switch (its.kind) {
    case CellPointName::Kind::corner: corner_moved_[i] = to; return;
    case CellPointName::Kind::edge: edge_moved_[static_cast<std::size_t>(its.line)][i] = to; return;
    case CellPointName::Kind::interior: own(moved_[static_cast<std::size_t>(its.pane)])[i] = to; return;
    default: splits_[i].moved = to; return;
    }
}

std::span<const LatticeStep> CellTile::members(int point) const
{
    const CellPointName its = name(point);
    int edge = its.line;
    if (its.kind == CellPointName::Kind::corner) return cell_->corners[static_cast<std::size_t>(its.index)].members;
    if (its.kind == CellPointName::Kind::split) edge = splits_[static_cast<std::size_t>(its.index)].edge;
    if (const int pane = pane_of(point); pane >= 0) return at_pane(pane).both;
    return cell_->edges[static_cast<std::size_t>(edge)].members;
}

int CellTile::pane_of(int point) const
{
    const CellPointName its = name(point);
    if (its.kind == CellPointName::Kind::split) return splits_[static_cast<std::size_t>(its.index)].pane;
    return its.kind == CellPointName::Kind::interior ? its.pane : -1;
}

// --- panes --------------------------------------------------------------------------------------------------------------------------------

void CellTile::require_pane(int pane) const
{
    if (pane < 0 || pane >= pane_count())
        throw CellRefusal(Reason::no_such_pane, fmt::format("{} has {} pairs of panes, from 0 on, and no pane {}", druse::name(cell_->kind), pane_count(), pane));
}

CellTile::Index CellTile::rim_count(int pane) const { return corner_number(pane, static_cast<int>(at_pane(pane).corners.size())); }

CellTile::Index CellTile::corner_number(int pane, int corner) const
{
    std::size_t number = static_cast<std::size_t>(corner);
    for (int k = 0; k < corner; ++k) number += edge_points(at_pane(pane).sides[static_cast<std::size_t>(k)].edge.orbit).size();
    return static_cast<Index>(number);
}

CellTile::Index CellTile::side_number(int pane, int side, int index) const { return corner_number(pane, side) + 1 + static_cast<Index>(index); }

OrbitMember CellTile::pane_point(int pane, Index point) const
{
    const CellPane& its = at_pane(pane);
    const PaneMesh& mesh = at(pane).mesh;
    if (point >= mesh.own) {
        const PaneMesh::Made& made = mesh.made[point - mesh.own];
        return {first_split_ + made.split, made.side >= 0 ? its.sides[static_cast<std::size_t>(made.side)].edge.shift : LatticeStep{}};
    }
    Index left = point;
    for (std::size_t k = 0; k < its.sides.size(); ++k) {
        if (left == 0) return its.corners[k];
        const CellSide& side = its.sides[k];
        const auto count = static_cast<Index>(edge_points(side.edge.orbit).size());
        if (left <= count) return {first_edge_[static_cast<std::size_t>(side.edge.orbit)] + static_cast<int>(side.reversed ? count - left : left - 1), side.edge.shift};
        left -= count + 1;
    }
    return {first_inner_[static_cast<std::size_t>(pane)] + static_cast<int>(left), {}};
}

CellPointName CellTile::pane_name(int pane, Index point) const
{
    using Kind = CellPointName::Kind;
    const PaneMesh& mesh = at(pane).mesh;
    if (point >= mesh.own) {
        const PaneMesh::Made& made = mesh.made[point - mesh.own];
        const bool again = std::ranges::count(mesh.made, made.split, &PaneMesh::Made::split) > 1;
        return CellPointName::split(made.split, again ? made.side : -1);
    }
    auto left = static_cast<int>(point);
    const CellPane& its = at_pane(pane);
    for (int k = 0; k < std::ssize(its.sides); ++k) {
        const auto count = static_cast<int>(edge_points(its.sides[static_cast<std::size_t>(k)].edge.orbit).size());
        if (left == 0) return {Kind::pane_corner, -1, 0, k, -1};
        if (left <= count) return {Kind::side, -1, k, left - 1, -1};
        left -= count + 1;
    }
    return CellPointName::interior(-1, left);
}

CellTile::Index CellTile::find_in_pane(int pane, const CellPointName& name) const
{
    using Kind = CellPointName::Kind;
    require_pane(pane);
    const CellPane& its = at_pane(pane);
    const bool here = name.pane < 0 || name.pane == pane;
    const auto within = [](int i, std::size_t count) { return i >= 0 && static_cast<std::size_t>(i) < count; };
    if (here && name.kind == Kind::interior && within(name.index, interior(pane).size())) return rim_count(pane) + static_cast<Index>(name.index);
    if (here && name.kind == Kind::pane_corner && within(name.index, its.corners.size())) return corner_number(pane, name.index);
    if (here && name.kind == Kind::side && within(name.line, its.sides.size()) &&
        within(name.index, edge_points(its.sides[static_cast<std::size_t>(name.line)].edge.orbit).size()))
        return side_number(pane, name.line, name.index);
    if (here && name.kind == Kind::split)
        for (std::size_t i = 0; i < mesh(pane).made.size(); ++i)
            if (const auto& made = mesh(pane).made[i]; made.split == name.index && (name.side < 0 || made.side == name.side)) return mesh(pane).own + static_cast<Index>(i);
    throw CellRefusal(Reason::no_such_point, fmt::format("pane {} has no point {}", pane, name.text()));
}

Point2 CellTile::flat_place(int pane, Index point) const
{
    const CellPane& its = at_pane(pane);
    const Index rim = rim_count(pane);
    if (point >= mesh(pane).own) {
        const OrbitMember member = pane_point(pane, point);
        const Vector v = base(member.orbit) + cell_->at(member.shift) - its.centre;
        return {glm::dot(v, its.right), glm::dot(v, its.up)};
    }
    if (point >= rim) return interior(pane)[point - rim];
    Index left = point;
    for (std::size_t k = 0;; ++k) {
        const std::vector<double>& list = edge_points(its.sides[k].edge.orbit);
        const Point2 from = its.outline[k];
        if (left == 0) return from;
        if (left <= list.size()) {
            const double u = its.sides[k].reversed ? 1 - list[list.size() - left] : list[left - 1];
            return from + u * (its.outline[(k + 1) % its.outline.size()] - from);
        }
        left -= static_cast<Index>(list.size()) + 1;
    }
}

int CellTile::side_of(int pane, Index a, Index b) const
{
    const PaneMesh& its = at(pane).mesh;
    const auto corners = static_cast<int>(at_pane(pane).corners.size());
    const auto lies_on = [&](Index point, int k) {
        if (point >= its.own) return its.made[point - its.own].side == k;
        const Index from = corner_number(pane, k), to = corner_number(pane, k + 1);
        return k + 1 == corners ? point == 0 || (point >= from && point < to) : point >= from && point <= to;
    };
    for (int k = 0; k < corners; ++k)
        if (lies_on(a, k) && lies_on(b, k)) return k;
    return -1;
}

std::vector<std::array<CellTile::Index, 2>> CellTile::constrained_edges(int pane) const
{
    std::vector<std::array<Index, 2>> edges;
    for (const auto& chain : at(pane).segments)
        for (std::size_t i = 1; i < chain.size(); ++i) edges.push_back({find_in_pane(pane, chain[i - 1]), find_in_pane(pane, chain[i])});
    return edges;
}

std::size_t CellTile::bytes() const
{
    std::size_t sum = details_.size() * sizeof(CellDetail) + splits_.size() * sizeof(Split) + kept_.size();
    for (const CellDetail& detail : details_) sum += detail.kept.size();
    for (std::size_t e = 0; e < edges_.size(); ++e) sum += edges_[e].size() * (sizeof(double) + sizeof(Vector));
    for (const auto& list : moved_)
        if (list.use_count() == 1) sum += list->size() * sizeof(Vector);
    for (const auto& pane : panes_) {
        if (pane.use_count() > 1) continue;
        sum += pane->interior.size() * sizeof(Point2) + pane->mesh.triangles.size() * sizeof(PaneMesh::Corners) +
               (pane->mesh.rim.size() + 2 * pane->mesh.made.size()) * sizeof(Index);
        for (const auto& chain : pane->segments) sum += sizeof(chain) + chain.size() * sizeof(CellPointName);
    }
    return sum;
}

/// A message of a pane, with our names of its points.
std::string CellTile::named(int pane, const std::string& text) const
{
    const auto known = rim_count(pane) + interior(pane).size();
    return with_names(text, [&](std::uint32_t number) { return number < known ? pane_name(pane, number).text() : std::string(); });
}

} // namespace druse
