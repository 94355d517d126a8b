// What a CellTool draws over the cell: the pane that is edited, points with their orbits, and the arrow.
#include "ui/cell_drawing.h"
#include "ui/cell_tool.h"
#include "ui/layout.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

namespace druse::ui {

namespace {

constexpr std::size_t most_cell_dots = 1500;       // above that only what is picked has some
constexpr std::size_t most_cell_looks = 200000; // boxes of triangles, to find out what is hidden
constexpr double hidden_opacity = 0.3;
constexpr double least_spacing = 5; // pixels between points that have dots
constexpr Colour point_colour{0xff, 0xff, 0xff}, dot_rim{0x1c, 0x1d, 0x20}, picked_colour{0xff, 0x4d, 0x3d}, partner_colour{0x7d, 0xe0, 0xff}, edited_colour{0xff, 0xff, 0xff};

void add_cell_dot(Overlay& overlay, const Point& at, Colour colour, double pixels, double opacity)
{
    overlay.lines.push_back({at, at, dot_rim, pixels + std::min(3 * layout().scale, 0.5 * pixels), opacity});
    overlay.lines.push_back({at, at, colour, pixels, opacity});
}

} // namespace

void CellTool::add_marks(Overlay& overlay) const
{
    if (!is_drawn()) return;
    add_panes(overlay);
    add_hovered_edge(overlay);
    add_points(overlay);
    add_arrow(overlay);
}

/// The outline of the pane that is edited, and a thinner one of its partner.
void CellTool::add_panes(Overlay& overlay) const
{
    const CellTile& cell = *picture_.cell();
    const int pane = picture_.pane();
    if (pane < 0 || pane >= cell.pane_count()) return;
    const std::vector<bool> facing = picture_.facing(camera_);
    const PaneMesh& mesh = cell.mesh(pane);
    for (const bool far : {false, true}) {
        const LatticeStep back = far ? -cell.cell().panes[static_cast<std::size_t>(pane)].translation : LatticeStep{};
        const auto vertex = [&](std::size_t i) {
            const OrbitMember member = cell.pane_point(pane, mesh.rim[i % mesh.rim.size()]);
            return picture_.vertex_of({member.orbit, member.shift + back});
        };
        for (std::size_t i = 0; i < mesh.rim.size(); ++i) {
            const auto a = vertex(i), b = vertex(i + 1);
            if (!a || !b) continue;
            const bool is_before = facing[a->index] && facing[b->index];
            overlay.lines.push_back({place(*a), place(*b), edited_colour, (far ? 1.5 : 2.5) * layout().scale, is_before ? 1 : hidden_opacity});
        }
    }
}

/// All that the lattice makes of the side that is under the pointer in the flat pane.
void CellTool::add_hovered_edge(Overlay& overlay) const
{
    const CellTile& cell = *picture_.cell();
    const int edge = plane_.hovered_edge();
    if (edge < 0 || edge >= std::ssize(cell.cell().edges)) return;
    const Parallelohedron::Edge& its = cell.cell().edges[static_cast<std::size_t>(edge)];
    for (const LatticeStep& step : its.members) {
        const auto a = picture_.vertex_of({its.from.orbit, its.from.shift + step}), b = picture_.vertex_of({its.to.orbit, its.to.shift + step});
        if (a && b) overlay.lines.push_back({place(*a), place(*b), orbit_colour(edge, true), 4 * layout().scale, 1});
    }
}

/// How far each point of the cell is from the nearest one that it has an edge with, as it is seen, in pixels.
std::vector<double> CellTool::spacing() const
{
    const CellSolid& solid = picture_.solid();
    std::vector<std::optional<Point2>> seen;
    seen.reserve(solid.points.size());
    for (const Point& p : solid.points) seen.push_back(camera_.project(p));
    std::vector<double> spacing(solid.points.size(), std::numeric_limits<double>::infinity());
    for (const auto& triangle : solid.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
            if (!seen[a] || !seen[b]) continue;
            const double away = glm::distance(*seen[a], *seen[b]);
            spacing[a] = std::min(spacing[a], away);
            spacing[b] = std::min(spacing[b], away);
        }
    return spacing;
}

/// Dots are no larger than leaves something to be seen between them, and go where they would only be dust.
void CellTool::add_points(Overlay& overlay) const
{
    const CellTile& cell = *picture_.cell();
    const std::size_t count = picture_.solid().points.size();
    std::vector<bool> marked(static_cast<std::size_t>(cell.point_count()), false); // orbits that are picked here or in the plane, or pointed at
    std::vector<bool> picked(count, false);
    const auto mark = [&](int orbit) {
        if (orbit >= 0 && orbit < cell.point_count()) marked[static_cast<std::size_t>(orbit)] = true;
    };
    for (const CellSelection::Pick& pick : selection_.picks()) {
        mark(pick.at.orbit);
        if (const auto v = picture_.vertex_of(pick.at)) picked[v->index] = true;
    }
    mark(plane_.hovered_orbit());
    if (!plane_.selected().empty())
        for (const PanePoint& point : plane_.shown_pane().points)
            if (plane_.selected().contains(point.name)) mark(point.orbit);

    std::size_t marked_places = 0;
    for (int orbit = 0; orbit < cell.point_count(); ++orbit)
        if (marked[static_cast<std::size_t>(orbit)]) marked_places += cell.members(orbit).size();
    const std::vector<bool> facing = picture_.facing(camera_);
    const auto may_look = [&](std::size_t places) { return places * picture_.lists().pick_boxes().size() * (1 + picture_.lists().copies().size()) < most_cell_looks; };
    const bool looks = may_look(count), looks_at_marked = may_look(marked_places);
    const std::vector<double> spacing = count <= most_cell_dots || marked_places > 0 ? this->spacing() : std::vector<double>();
    // What is behind comes first, so that nothing before it is covered by it.
    for (const bool front : {false, true})
        for (std::uint32_t v = 0; v < count; ++v) {
            const OrbitMember member = picture_.orbit_of(Vertex(v));
            const bool is_marked = marked[static_cast<std::size_t>(member.orbit)];
            if (!is_marked && (!front || count > most_cell_dots || spacing[v] < least_spacing * layout().scale)) continue;
            if (const bool is_before = facing[v] && !((is_marked ? looks_at_marked : looks) && is_hidden(place(Vertex(v)))); is_before != front) continue;
            if (is_marked) {
                add_cell_dot(overlay, place(Vertex(v)), picked[v] ? picked_colour : partner_colour, std::clamp(0.7 * spacing[v], 5 * layout().scale, 11 * layout().scale), front ? 1 : hidden_opacity);
                continue;
            }
            const CellPointName name = cell.name(member.orbit);
            const bool is_corner = name.kind == CellPointName::Kind::corner, is_edge = name.kind == CellPointName::Kind::edge;
            add_cell_dot(overlay, place(Vertex(v)), is_corner ? corner_colour(name.index, true) : is_edge ? orbit_colour(name.line, true) : point_colour,
                         std::min(6 * layout().scale, 0.3 * spacing[v]), 1);
        }
}

void CellTool::add_arrow(Overlay& overlay) const
{
    const auto straight = mode_ == Mode::select ? way() : std::nullopt;
    const auto vertex = straight ? picture_.vertex_of(selection_.last()->at) : std::nullopt;
    const auto ends = vertex ? arrow() : std::nullopt;
    if (!ends) return;
    const double opacity = is_seen(*vertex) ? 1 : hidden_opacity, width = 3.5 * layout().scale;
    const Point2 foot = ends->first, tip = ends->second;
    const auto add = [&](const Point2& a, const Point2& b) { overlay.screen_lines.push_back({Point(a, 0), Point(b, 0), picked_colour, width, opacity}); };
    add(foot, tip);
    if (glm::distance(foot, tip) < 1) return;
    const Point2 back = (foot - tip) / glm::distance(foot, tip), across(-back.y, back.x);
    const double head = std::min(13 * layout().scale, 0.5 * glm::distance(foot, tip));
    add(tip, tip + head * back + 0.55 * head * across);
    add(tip, tip + head * back - 0.55 * head * across);
}

} // namespace druse::ui
