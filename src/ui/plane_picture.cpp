#include "ui/plane_picture.h"

#include <cmath>

namespace druse::ui {

namespace {

constexpr PlaneColours dark_plane{.background = {0x20, 0x22, 0x26},
                                  .grid = {0x2b, 0x2e, 0x33},
                                  .axis = {0x3c, 0x40, 0x47},
                                  .neighbours = {{{0x3f, 0x43, 0x4a}, {0x4a, 0x4f, 0x57}, {0x35, 0x39, 0x3f}}},
                                  .neighbour_line = {0x6c, 0x72, 0x7c},
                                  .tile = {0xd9, 0x8e, 0x4a},
                                  .line = {0xf4, 0xee, 0xe6},
                                  .triangle = {0x6e, 0x42, 0x1a},
                                  .segment = {0x2a, 0x17, 0x06},
                                  .handle = {0xff, 0xff, 0xff},
                                  .handle_line = {0x1c, 0x1d, 0x20},
                                  .interior = {0x2a, 0x17, 0x06},
                                  .selected = {0x2b, 0x73, 0xff},
                                  .together = {0x7d, 0xe0, 0xff},
                                  .centre = {0xff, 0xe0, 0x66},
                                  .arrow = {0x8f, 0xc7, 0xff},
                                  .error = {0xff, 0x3b, 0x41},
                                  .ghost = {0x5c, 0xc8, 0xff}};

constexpr PlaneColours light_plane{.background = {0xf4, 0xf5, 0xf7},
                                   .grid = {0xe4, 0xe7, 0xea},
                                   .axis = {0xc9, 0xce, 0xd4},
                                   .neighbours = {{{0xd6, 0xda, 0xdf}, {0xe3, 0xe6, 0xea}, {0xc8, 0xcd, 0xd4}}},
                                   .neighbour_line = {0x74, 0x7b, 0x85},
                                   .tile = {0xe2, 0xa2, 0x67},
                                   .line = {0x2a, 0x24, 0x20},
                                   .triangle = {0x9c, 0x68, 0x38},
                                   .segment = {0x2a, 0x17, 0x06},
                                   .handle = {0xff, 0xff, 0xff},
                                   .handle_line = {0x1c, 0x1d, 0x20},
                                   .interior = {0x2a, 0x17, 0x06},
                                   .selected = {0x2b, 0x73, 0xff},
                                   .together = {0x00, 0x8a, 0xb8},
                                   .centre = {0xb8, 0x86, 0x00},
                                   .arrow = {0x1f, 0x62, 0xa8},
                                   .error = {0xd0, 0x1f, 0x26},
                                   .ghost = {0x00, 0x7a, 0xb8}};

} // namespace

const PlaneColours& plane_colours(bool dark) { return dark ? dark_plane : light_plane; }

void PlanePicture::draw_grid(double weight)
{
    const double step = editor_.grid();
    const Point2 low = plane_.plane(Point2(0, plane_.height)), high = plane_.plane(Point2(plane_.width, 0));
    for (const int axis : {0, 1})
        for (double k = std::ceil(low[axis] / step); k * step <= high[axis]; ++k) {
            Point2 a = low, b = high;
            a[axis] = b[axis] = k * step;
            painter_.line(at(a), at(b), 1, k == 0 ? colours_.axis : colours_.grid, weight * (k == 0 ? 0.8 : 0.45));
        }
}

void PlanePicture::draw_handle(const Point2& p, double radius, HandleMark mark, Colour colour)
{
    const Point2 c = at(p);
    const double r = radius * scale_;
    if (mark != HandleMark::none) painter_.disc(c, r + 3.5 * scale_, mark == HandleMark::selected ? colours_.selected : colours_.together);
    painter_.disc(c, r + 1.2 * scale_, colours_.handle_line);
    painter_.disc(c, r, colour);
}

void PlanePicture::draw_inner_handle(const Point2& p, HandleMark mark, double size)
{
    draw_handle(p, 4 * size, mark, colours_.interior);
    painter_.ring(at(p), 3.5 * size * scale_, 1.4 * size * scale_, colours_.handle);
}

void PlanePicture::draw_corner_handle(const Point2& p, HandleMark mark, Colour colour)
{
    draw_handle(p, 5, mark, colour);
    painter_.disc(at(p), 3 * scale_, colours_.handle_line);
}

void PlanePicture::draw_gestures()
{
    if (const auto line = editor_.rubber()) painter_.line(at(line->first), at(line->second), 2 * scale_, colours_.ghost);
    if (const auto& line = editor_.refused_line()) draw_red_line(line->first, line->second);
    if (const auto box = editor_.box()) {
        const auto& [a, c] = *box;
        const std::array corners{a, Point2(c.x, a.y), c, Point2(a.x, c.y)};
        painter_.fill(corners, colours_.selected, 0.15);
        painter_.lines(corners, true, 1.5 * scale_, colours_.selected);
    }
}

} // namespace druse::ui
