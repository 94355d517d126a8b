#include "ui/cell_drawing.h"

#include "ui/plane_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace druse::ui {

namespace {

/// Twelve hues, those of numbers that follow each other far apart.
Colour spread_hue(int number, double first, bool dark)
{
    const double hue = first + 5.0 / 12 * (number % 12);
    return colour_from_hsv(hue - std::floor(hue), dark ? 0.6 : 0.85, dark ? 1.0 : 0.72);
}

class PanePicture : private PlanePicture {
public:
    PanePicture(const CellPlane& view, bool dark, double scale, Image& image)
        : PlanePicture(view, dark, scale, image), view_(view), pane_(view.shown_pane()), dark_(dark)
    {
    }

    void draw()
    {
        painter_.clear(colours_.background);
        if (pane_.pane < 0) return;
        if (view_.shown().grid) draw_grid();
        draw_ground();
        if (view_.shown().grid) draw_grid(dark_ ? 0.35 : 1);
        if (view_.shown().triangles) draw_triangles();
        for (const ShownPane::Line& line : pane_.lines) draw_constraint(place(line.ends[0]), place(line.ends[1]), pane_.is_flat ? colours_.segment : colours_.line);
        draw_sides();
        draw_line_under_pointer();
        draw_handles();
        draw_refused();
        draw_gestures();
    }

private:
    const Point2& place(PaneMesh::Index i) const { return pane_.points[i].at; }
    PaneMesh::Index on_rim(std::size_t i) const { return pane_.rim[i % pane_.rim.size()]; }
    int edge_of(std::size_t rim) const { return pane_.sides[std::size_t(pane_.rim_sides[rim])].edge.orbit; }

    void draw_ground()
    {
        std::vector<Point2> outline;
        for (const Point2& p : pane_.outline) outline.push_back(at(p));
        painter_.fill(outline, pane_.is_flat ? colours_.tile : colours_.neighbours[0]);
    }

    /// Each edge inside has two triangles, which run along it both ways; those of the rim are drawn over.
    void draw_triangles()
    {
        for (const PaneMesh::Corners& t : pane_.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                if (const PaneMesh::Index a = t[k], b = t[(k + 1) % 3]; a < b)
                    draw_triangle_edge(place(a), place(b), pane_.is_flat ? colours_.triangle : colours_.neighbour_line);
    }

    Colour side_colour(int edge) const { return view_.shown().orbits ? orbit_colour(edge, dark_) : colours_.line; }

    void draw_sides()
    {
        for (std::size_t i = 0; i < pane_.rim.size(); ++i) {
            const Point2 a = at(place(on_rim(i))), b = at(place(on_rim(i + 1)));
            const bool together = edge_of(i) == view_.hovered_edge();
            if (together) painter_.line(a, b, 9 * scale_, colours_.together, 0.7);
            painter_.line(a, b, 5 * scale_, colours_.handle_line);
            painter_.line(a, b, 3 * scale_, side_colour(edge_of(i)));
        }
        if (const auto& hit = view_.hovered(); hit && hit->rim >= 0) {
            const auto i = std::size_t(hit->rim);
            painter_.line(at(place(on_rim(i))), at(place(on_rim(i + 1))), 3 * scale_, colours_.selected);
        }
    }

    /// All of the line that Delete would take.
    void draw_line_under_pointer()
    {
        const auto& hit = view_.hovered();
        if (!hit || hit->line < 0 || !pane_.is_flat) return;
        for (const ShownPane::Line& line : pane_.lines)
            if (line.chain == pane_.lines[std::size_t(hit->line)].chain) painter_.line(at(place(line.ends[0])), at(place(line.ends[1])), 3.5 * scale_, colours_.selected);
    }

    /// How large the handle of each point may be: 1, or less where others are so near that they would run together.
    std::vector<double> sizes_of_handles() const
    {
        const double roomy = 20 * scale_ / plane_.pixels;
        std::vector<double> nearest(pane_.points.size(), roomy);
        for (const PaneMesh::Corners& t : pane_.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const PaneMesh::Index a = t[k], b = t[(k + 1) % 3];
                const double away = glm::distance(place(a), place(b));
                nearest[a] = std::min(nearest[a], away);
                nearest[b] = std::min(nearest[b], away);
            }
        for (double& size : nearest) size /= roomy;
        return nearest;
    }

    void draw_handles()
    {
        constexpr double least = 0.3, least_marked = 0.6;
        const std::vector<double> sizes = sizes_of_handles();
        for (std::size_t i = 0; i < pane_.points.size(); ++i) {
            const PanePoint& p = pane_.points[i];
            const bool together = p.orbit == view_.hovered_orbit();
            const bool selected = view_.selected().contains(p.name) || view_.is_marked(p.name);
            const HandleMark mark = selected ? HandleMark::selected : together ? HandleMark::together : HandleMark::none;
            if (sizes[i] < least && mark == HandleMark::none && p.kind != PanePoint::Kind::corner) continue;
            const double size = mark == HandleMark::none ? sizes[i] : std::max(sizes[i], least_marked);
            switch (p.kind) {
            case PanePoint::Kind::corner: draw_corner_handle(p.at, mark, view_.shown().orbits ? corner_colour(p.orbit, dark_) : colours_.handle); break;
            case PanePoint::Kind::interior: draw_inner_handle(p.at, mark, size); break;
            case PanePoint::Kind::edge: draw_handle(p.at, 4.5 * size, mark, side_colour(pane_.sides[std::size_t(p.here.line)].edge.orbit)); break;
            case PanePoint::Kind::split: draw_handle(p.at, 3 * size, mark, colours_.handle); break;
            }
        }
        if (const auto& hit = view_.hovered(); hit && hit->point >= 0) draw_ring(pane_.points[std::size_t(hit->point)].at);
    }

    /// The lines that the point would have where it may not go.
    void draw_refused()
    {
        if (!view_.refused()) return;
        const auto& [point, wanted] = *view_.refused();
        for (const ShownPane::Line& line : pane_.lines)
            for (const int k : {0, 1})
                if (int(line.ends[std::size_t(k)]) == point) draw_red_line(wanted, place(line.ends[std::size_t(1 - k)]));
        draw_red_ring(wanted);
    }

    const CellPlane& view_;
    const ShownPane& pane_;
    bool dark_;
};

} // namespace

void draw_pane(const CellPlane& plane, bool dark, double scale, Image& image) { PanePicture(plane, dark, scale, image).draw(); }

Colour orbit_colour(int edge_orbit, bool dark) { return spread_hue(edge_orbit, 0.0, dark); }

Colour corner_colour(int corner_orbit, bool dark) { return spread_hue(corner_orbit, 1.0 / 24, dark); }

} // namespace druse::ui
