#include "ui/shown_pane.h"

#include <algorithm>
#include <utility>

namespace druse::ui {

namespace {

PanePoint::Kind kind_in_pane(const CellPointName& here)
{
    switch (here.kind) {
    case CellPointName::Kind::pane_corner: return PanePoint::Kind::corner;
    case CellPointName::Kind::side: return PanePoint::Kind::edge;
    case CellPointName::Kind::split: return PanePoint::Kind::split;
    default: return PanePoint::Kind::interior;
    }
}

} // namespace

Point2 ShownPane::low() const
{
    Point2 low = outline.front();
    for (const Point2& p : outline) low = glm::min(low, p);
    return low;
}

Point2 ShownPane::high() const
{
    Point2 high = outline.front();
    for (const Point2& p : outline) high = glm::max(high, p);
    return high;
}

/// Panes are convex.
bool ShownPane::holds(const Point2& p) const
{
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Point2 along = outline[(k + 1) % outline.size()] - outline[k], to = p - outline[k];
        if (along.x * to.y - along.y * to.x < 0) return false;
    }
    return !outline.empty();
}

ShownPane shown_pane(const CellTile& cell, int pane)
{
    const CellPane& its = cell.cell().panes[static_cast<std::size_t>(pane)];
    const PaneMesh& mesh = cell.mesh(pane);
    ShownPane shown;
    shown.pane = pane;
    shown.is_flat = cell.is_flat(pane);
    shown.may_edit_sides = cell.phase() == 1;
    shown.outline = its.outline;
    shown.sides = its.sides;
    shown.points.reserve(mesh.point_count());
    for (PaneMesh::Index i = 0; i < mesh.point_count(); ++i) {
        const int orbit = cell.pane_point(pane, i).orbit;
        const CellPointName here = cell.pane_name(pane, i);
        shown.points.push_back({kind_in_pane(here), cell.flat_place(pane, i), orbit, cell.name(orbit).text(), here});
    }
    shown.triangles = mesh.triangles;
    shown.rim = mesh.rim;
    int side = -1;
    for (const PaneMesh::Index i : mesh.rim) {
        if (shown.points[i].kind == PanePoint::Kind::corner) side = shown.points[i].here.index;
        shown.rim_sides.push_back(side);
    }
    if (!shown.is_flat) {
        for (const auto& ends : cell.constrained_edges(pane)) shown.lines.push_back({ends, 0});
        return shown;
    }
    shown.chains = std::move(cell.design().panes[static_cast<std::size_t>(pane)].segments);
    for (std::size_t c = 0; c < shown.chains.size(); ++c)
        for (std::size_t i = 1; i < shown.chains[c].size(); ++i)
            shown.lines.push_back({{cell.find_in_pane(pane, shown.chains[c][i - 1]), cell.find_in_pane(pane, shown.chains[c][i])}, static_cast<int>(c)});
    return shown;
}

} // namespace druse::ui
