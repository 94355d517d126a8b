#pragma once

#include "geom/colour.h"
#include "geom/point.h"
#include "render/image.h"

#include <span>
#include <vector>

namespace druse {

/// Draws plane shapes into an image, by the part of each pixel that they cover: without a display, and the same everywhere.
///
/// Places are in pixels from the top left corner, y downward; the centre of the first pixel is (0.5, 0.5). What lies outside, or is no number,
/// is left out. Precondition of all: the image is opaque, and stays where it is.
/// Cost: of a fill the pixels of its box inside the image and those along its outline; of a line the pixels along it.
class FlatPainter {
public:
    explicit FlatPainter(Image& image) : image_(image) {}

    void clear(Colour colour);
    /// The inside of a closed polygon, in either sense; where it winds round a place at all, that is inside.
    void fill(std::span<const Point2> polygon, Colour colour, double opacity = 1);
    void line(const Point2& from, const Point2& to, double width, Colour colour, double opacity = 1);
    /// Lines from each point to the next, and from the last to the first where it is `closed`. Points nearer than half a pixel are passed over.
    void lines(std::span<const Point2> points, bool closed, double width, Colour colour, double opacity = 1);
    void disc(const Point2& centre, double radius, Colour colour, double opacity = 1);
    void ring(const Point2& centre, double radius, double width, Colour colour, double opacity = 1);
    /// Another picture: pixel (x, y) of this image shows the place origin + x · across + y · down of the other, in its pixels.
    void picture(const Image& other, const Point2& origin, const Point2& across, const Point2& down, double opacity = 1);

private:
    struct Window {
        int x0, y0, x1, y1; // pixels; the last ones are beyond it
    };

    void blend(int x, int y, Colour colour, double opacity);
    void blend_run(int x0, int x1, int y, Colour colour, double opacity);
    void add_edge(Point2 from, Point2 to, const Window& window);
    void add_inside(Point2 from, Point2 to, const Window& window);
    void add_row(int row, double x0, double x1, double rise, const Window& window);
    template <class Distance>
    void stroke(const Window& window, double radius, Colour colour, double opacity, const Distance& distance);

    Image& image_;
    std::vector<double> cover_; // of a fill: what each pixel adds to those from it to the right
};

} // namespace druse
