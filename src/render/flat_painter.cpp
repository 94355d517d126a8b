#include "render/flat_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace druse {

namespace {

bool is_number(const Point2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

/// A pixel, kept within what an int holds with room to spare.
int pixel(double x) { return static_cast<int>(std::clamp(std::floor(x), -1e6, 1e6)); }

std::uint8_t mixed(std::uint8_t under, std::uint8_t over, int part) // of 256
{
    return static_cast<std::uint8_t>(under + (((over - under) * part + 128) >> 8));
}

} // namespace

void FlatPainter::clear(Colour colour) { std::ranges::fill(image_.pixels, Pixel{colour.red, colour.green, colour.blue, 255}); }

inline void FlatPainter::blend(int x, int y, Colour colour, double opacity)
{
    Pixel& p = image_.at(x, y);
    if (opacity >= 1) { // nearly all of what is filled
        p = {colour.red, colour.green, colour.blue, p.alpha};
        return;
    }
    const int part = static_cast<int>(256 * opacity + 0.5);
    p = {mixed(p.red, colour.red, part), mixed(p.green, colour.green, part), mixed(p.blue, colour.blue, part), p.alpha};
}

/// Pixels of one row, up to x1.
void FlatPainter::blend_run(int x0, int x1, int y, Colour colour, double opacity)
{
    Pixel* row = &image_.at(x0, y);
    if (opacity >= 1) std::fill(row, row + (x1 - x0), Pixel{colour.red, colour.green, colour.blue, 255});
    else for (int x = x0; x < x1; ++x) blend(x, y, colour, opacity);
}

// --- fills: each edge says by how much it changes the part of a pixel, and of all to the right of it, that is inside -----------------

void FlatPainter::fill(std::span<const Point2> polygon, Colour colour, double opacity)
{
    if (polygon.size() < 3 || !std::ranges::all_of(polygon, is_number)) return;
    Point2 low = polygon[0], high = low;
    for (const Point2& p : polygon) low = glm::min(low, p), high = glm::max(high, p);
    const Window window{std::max(0, pixel(low.x)), std::max(0, pixel(low.y)), std::min(image_.width, pixel(high.x) + 1), std::min(image_.height, pixel(high.y) + 1)};
    if (window.x0 >= window.x1 || window.y0 >= window.y1) return;

    const int pixels = window.x1 - window.x0;
    const std::size_t width = std::size_t(pixels) + 2;
    cover_.assign(width * std::size_t(window.y1 - window.y0), 0);
    for (std::size_t i = 0; i < polygon.size(); ++i) add_edge(polygon[i], polygon[(i + 1) % polygon.size()], window);
    for (int y = window.y0; y < window.y1; ++y) {
        const double* row = &cover_[width * std::size_t(y - window.y0)];
        double inside = 0;
        for (int x = 0; x < pixels;) {
            inside += row[x];
            int end = x + 1;
            while (end < pixels && row[end] == 0) ++end; // as far as no edge comes they are all alike
            // What rounding leaves of a pixel is none of it, or all.
            if (const double part = std::abs(inside); part > 1.0 / 512) blend_run(window.x0 + x, window.x0 + end, y, colour, part < 511.0 / 512 ? opacity * part : opacity);
            x = end;
        }
    }
}

/// Cuts an edge at the upper and lower end of the window, and where it leaves it at a side: what lies to the left counts for the whole row,
/// what lies to the right for none of it.
void FlatPainter::add_edge(Point2 from, Point2 to, const Window& window)
{
    from -= Point2(window.x0, window.y0);
    to -= Point2(window.x0, window.y0);
    const double width = window.x1 - window.x0, height = window.y1 - window.y0;
    const auto cut = [](const Point2& a, const Point2& b, int axis, double at) {
        const double t = (at - a[axis]) / (b[axis] - a[axis]);
        Point2 p = a + t * (b - a);
        p[axis] = at;
        return p;
    };
    if (from.y == to.y || std::max(from.y, to.y) <= 0 || std::min(from.y, to.y) >= height) return;
    for (const double y : {0.0, height}) {
        if ((from.y - y) * (to.y - y) >= 0) continue;
        const Point2 p = cut(from, to, 1, y);
        ((from.y < to.y) == (y == 0) ? from : to) = p;
    }
    std::array<Point2, 4> at{from};
    std::size_t count = 1;
    for (const double x : {0.0, width})
        if ((from.x < x) != (to.x < x)) at[count++] = cut(from, to, 0, x);
    if (count == 3 && from.x > to.x) std::swap(at[1], at[2]); // in the order in which it is met
    at[count++] = to;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        Point2 a = at[i], b = at[i + 1];
        a.x = std::clamp(a.x, 0.0, width);
        b.x = std::clamp(b.x, 0.0, width);
        add_inside(a, b, window);
    }
}

void FlatPainter::add_inside(Point2 from, Point2 to, const Window& window)
{
    const int rows = window.y1 - window.y0;
    const double sign = from.y < to.y ? 1 : -1;
    if (sign < 0) std::swap(from, to);
    const double rise = to.y - from.y;
    if (!(rise > 0)) return;
    for (int row = std::clamp(pixel(from.y), 0, rows - 1); row < rows && row < to.y; ++row) {
        const double top = std::max<double>(row, from.y), bottom = std::min<double>(row + 1, to.y);
        if (bottom <= top) continue;
        const double slope = (to.x - from.x) / rise;
        const double low = std::min(from.x, to.x), high = std::max(from.x, to.x); // a division may lead a little beyond
        add_row(row, std::clamp(from.x + slope * (top - from.y), low, high), std::clamp(from.x + slope * (bottom - from.y), low, high), sign * (bottom - top),
                window);
    }
}

/// Within one row, from x0 to x1: each pixel it passes gets its part of the change, by the mean of how much of it lies to the right.
void FlatPainter::add_row(int row, double x0, double x1, double rise, const Window& window)
{
    const std::size_t width = std::size_t(window.x1 - window.x0) + 2;
    double* cover = &cover_[width * std::size_t(row)];
    if (x0 > x1) std::swap(x0, x1);
    const int first = pixel(x0), last = pixel(x1);
    if (first == last) {
        const double right = rise * (0.5 * (x0 + x1) - first); // what of it falls on the next pixel
        cover[first] += rise - right;
        cover[first + 1] += right;
        return;
    }
    const double per_pixel = rise / (x1 - x0);
    for (int x = first; x <= last; ++x) {
        const double a = std::max<double>(x, x0), b = std::min<double>(x + 1, x1);
        const double part = per_pixel * (b - a), right = part * (0.5 * (a + b) - x);
        cover[x] += part - right;
        cover[x + 1] += right;
    }
}

// --- lines: the distance of the centre of a pixel tells how much of it is covered ----------------------------------------------------

template <class Distance>
void FlatPainter::stroke(const Window& window, double radius, Colour colour, double opacity, const Distance& distance)
{
    const double least = std::min(1.0, 2 * radius); // a line thinner than a pixel is as wide, and fainter
    for (int y = std::max(0, window.y0); y < std::min(image_.height, window.y1); ++y)
        for (int x = std::max(0, window.x0); x < std::min(image_.width, window.x1); ++x) {
            const double part = std::max(radius, 0.5) + 0.5 - distance(Point2(x + 0.5, y + 0.5));
            if (part > 1.0 / 512) blend(x, y, colour, opacity * std::min(part, 1.0) * least);
        }
}

void FlatPainter::line(const Point2& from, const Point2& to, double width, Colour colour, double opacity)
{
    if (!is_number(from) || !is_number(to)) return;
    const double radius = width / 2, reach = std::max(radius, 0.5) + 0.5; // of its middle, to the centres of pixels that it covers in part
    const Point2 along = to - from;
    const double length2 = glm::dot(along, along);
    const double share = length2 > 0 ? 1 / length2 : 0;
    const auto distance = [&](const Point2& p) {
        const Point2 off = p - from;
        const double t = std::clamp((off.x * along.x + off.y * along.y) * share, 0.0, 1.0), x = off.x - t * along.x, y = off.y - t * along.y;
        return std::sqrt(x * x + y * y);
    };
    // Row by row, only what is near it: the box of a slanting line is mostly empty.
    const Point2 low = glm::min(from, to) - reach, high = glm::max(from, to) + reach;
    const bool slants = std::abs(along.y) > 1e-9;
    const double lean = slants ? along.x / along.y : 0, across = slants ? reach * std::sqrt(length2) / std::abs(along.y) : high.x - low.x;
    const int top = std::max(0, pixel(low.y + 0.5)), bottom = std::min(image_.height, pixel(high.y + 0.5));
    for (int y = top; y < bottom; ++y) {
        const double middle = from.x + lean * (y + 0.5 - from.y);
        stroke({pixel(std::max(low.x, middle - across) + 0.5), y, pixel(std::min(high.x, middle + across) + 0.5), y + 1}, radius, colour, opacity, distance);
    }
}

void FlatPainter::lines(std::span<const Point2> points, bool closed, double width, Colour colour, double opacity)
{
    if (points.empty()) return;
    constexpr double near = 0.5;
    Point2 last = points[0];
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (i + 1 < points.size() && glm::distance(last, points[i]) < near) continue;
        line(last, points[i], width, colour, opacity);
        last = points[i];
    }
    if (closed) line(last, points[0], width, colour, opacity);
}

void FlatPainter::disc(const Point2& centre, double radius, Colour colour, double opacity)
{
    if (!is_number(centre)) return;
    stroke({pixel(centre.x - radius - 1), pixel(centre.y - radius - 1), pixel(centre.x + radius + 1) + 1, pixel(centre.y + radius + 1) + 1}, radius, colour,
           opacity, [&](const Point2& p) { return glm::distance(p, centre); });
}

void FlatPainter::ring(const Point2& centre, double radius, double width, Colour colour, double opacity)
{
    if (!is_number(centre)) return;
    const double reach = radius + width / 2 + 1;
    stroke({pixel(centre.x - reach), pixel(centre.y - reach), pixel(centre.x + reach) + 1, pixel(centre.y + reach) + 1}, width / 2, colour, opacity,
           [&](const Point2& p) { return std::abs(glm::distance(p, centre) - radius); });
}

void FlatPainter::picture(const Image& other, const Point2& origin, const Point2& across, const Point2& down, double opacity)
{
    if (!is_number(origin) || !is_number(across) || !is_number(down)) return;
    for (int y = 0; y < image_.height; ++y)
        for (int x = 0; x < image_.width; ++x) {
            const Point2 p = origin + (x + 0.5) * across + (y + 0.5) * down;
            if (p.x < 0 || p.y < 0 || p.x >= other.width || p.y >= other.height) continue;
            const Pixel& q = other.at(static_cast<int>(p.x), static_cast<int>(p.y));
            blend(x, y, {q.red, q.green, q.blue}, opacity * q.alpha / 255.0);
        }
}

} // namespace druse
