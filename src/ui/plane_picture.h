#pragma once

#include "ui/plane_editor.h"

#include "geom/colour.h"
#include "render/flat_painter.h"
#include "render/image.h"

#include <array>

namespace druse::ui {

struct PlaneColours {
    Colour background, grid, axis;
    std::array<Colour, 3> neighbours; // by their colour in the tiling
    Colour neighbour_line, tile, line, triangle, segment;
    Colour handle, handle_line, interior, selected, together, centre, arrow, error, ghost;
};

const PlaneColours& plane_colours(bool dark);

/// How a handle is marked: it is selected itself, or something that moves with it.
enum class HandleMark { none, selected, together };

/// What the picture of a plane is drawn with: what those of all planes have.
class PlanePicture {
public:
    /// `scale` is that of the layout. The image has the size of the view.
    PlanePicture(const PlaneEditor& editor, bool dark, double scale, Image& image)
        : editor_(editor), plane_(editor.plane()), colours_(plane_colours(dark)), scale_(scale), painter_(image)
    {
    }

protected:
    Point2 at(const Point2& p) const { return plane_.picture(p); }
    /// `weight`: of its lines, 1 on the empty plane.
    void draw_grid(double weight = 1);
    void draw_constraint(const Point2& a, const Point2& b, Colour colour) { painter_.line(at(a), at(b), 2.2 * scale_, colour); }
    void draw_triangle_edge(const Point2& a, const Point2& b, Colour colour) { painter_.line(at(a), at(b), scale_, colour, 0.65); }
    void draw_handle(const Point2& p, double radius, HandleMark mark, Colour colour);
    /// One of a point inside. `size`: 1 where there is room.
    void draw_inner_handle(const Point2& p, HandleMark mark, double size = 1);
    void draw_corner_handle(const Point2& p, HandleMark mark, Colour colour);
    void draw_ring(const Point2& p) { painter_.ring(at(p), 8 * scale_, 2 * scale_, colours_.selected); }
    void draw_red_line(const Point2& a, const Point2& b) { painter_.line(at(a), at(b), 2.5 * scale_, colours_.error); }
    void draw_red_ring(const Point2& p) { painter_.ring(at(p), 7 * scale_, 2.5 * scale_, colours_.error); }
    /// Lines and boxes that are dragged, or were refused.
    void draw_gestures();

    const PlaneEditor& editor_;
    const PlaneView& plane_;
    const PlaneColours& colours_;
    double scale_;
    FlatPainter painter_;
};

} // namespace druse::ui
