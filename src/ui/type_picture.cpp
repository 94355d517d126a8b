#include "ui/type_picture.h"

#include "ui/plane_view.h"
#include "ui/shown_tile.h"

#include "render/flat_painter.h"
#include "tile/tile_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace druse::ui {

namespace {

/// Bends of a path that may have that shape, as files keep it: of those that are the same backwards the first half.
std::vector<Point2> sample_path(PathShape shape, double bend)
{
    switch (shape) {
    case PathShape::free: return {{0.22, 0.02 * bend}, {0.36, 0.15 * bend}, {0.52, 0.13 * bend}, {0.60, -0.03 * bend}};
    case PathShape::half_turn: return {{0.25, 0.11 * bend}, {0.40, 0.06 * bend}};
    case PathShape::flip: return {{0.30, 0.0}, {0.36, 0.13 * bend}};
    case PathShape::straight: break;
    }
    return {};
}

} // namespace

int rotations_of(const IsohedralType& type) { return rotation_order(type.placed); }

std::vector<Point2> sample_outline(const IsohedralType& type)
{
    // Where two edges meet in a narrow corner, paths bend less.
    double narrowest = std::numbers::pi;
    for (int k = 0; k < type.corners; ++k) {
        const Point2 at = corner(type.start, k), a = corner(type.start, type.symbol.corner(k + 1)) - at, b = corner(type.start, type.symbol.corner(k - 1)) - at;
        narrowest = std::min(narrowest, std::acos(std::clamp(glm::dot(a, b) / (glm::length(a) * glm::length(b)), -1.0, 1.0)));
    }
    const double bend = std::clamp(narrowest / (std::numbers::pi / 3), 0.35, 1.0);

    std::vector<std::vector<Point2>> paths;
    for (const PathShape shape : type.shapes) paths.push_back(sample_path(shape, bend));
    return make_outline(type, type.start, 1.0, paths).positions();
}

Colour tile_colour(int number)
{
    constexpr std::array<Colour, 3> colours{{{0xd9, 0x8e, 0x4a}, {0xf0, 0xe6, 0xd2}, {0x4f, 0x86, 0xa8}}};
    return colours[std::size_t(number) % colours.size()];
}

Image type_picture(const IsohedralType& type, int size)
{
    constexpr Colour line{0x2a, 0x24, 0x20};
    constexpr double tiles_across = 3.4;
    constexpr std::size_t copies = 60;
    Image image(size, size);
    FlatPainter painter(image);
    painter.clear(tile_colour(1));

    const CornerVector& corners = type.start;
    const Point2 t0 = type.placed.lattice[0].at(corners), t1 = type.placed.lattice[1].at(corners);
    const double area = std::abs(t0.x * t1.y - t0.y * t1.x) / type.aspects();
    PlaneView view{size, size, Point2(0.0), size / (tiles_across * std::sqrt(area))};
    for (int k = 0; k < type.corners; ++k) view.centre += corner(corners, k) / double(type.corners);

    const std::vector<Point2> outline = sample_outline(type);
    for (const DrawnCopy& copy : copies_around(type, corners, copies)) {
        std::vector<Point2> points;
        for (const Point2& p : outline) points.push_back(view.picture(copy.map(p)));
        painter.fill(points, tile_colour(copy.colour));
        painter.lines(points, true, size / 80.0, line);
    }
    return image;
}

} // namespace druse::ui
