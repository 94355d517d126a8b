#include "cli/flat_tiling.h"

#include "io/tile_file.h"
#include "render/flat_painter.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace druse {

namespace {

constexpr double margin = 0.02;     // of the shorter side of the picture, on all sides
constexpr double line_width = 0.01; // of the square root of a tile's area

} // namespace

Image flat_tiling(const LayeredTile& tile, const StillOptions& options)
{
    const auto [copies, box] = drawn_tiling(tile);
    const Point2 picture(options.width, options.height), size = box.max - box.min, middle = 0.5 * (box.min + box.max);
    const double room = 1 - 2 * margin, pixels = room * std::min(picture.x / size.x, picture.y / size.y);
    const auto place = [&](const Point2& p) {
        const Point2 from_middle = pixels * (p - middle);
        return Point2(0.5 * picture.x + from_middle.x, 0.5 * picture.y - from_middle.y);
    };

    Image image(options.width, options.height);
    FlatPainter painter(image);
    painter.clear(options.background.value_or(Colour{255, 255, 255}));
    const Colour ink{0, 0, 0};
    const double width = std::max(1.0, line_width * std::sqrt(tile.area()) * pixels);
    std::vector<Point2> outline;
    for (const DrawnTiling::Copy& copy : copies) {
        const Isometry& motion = copy.motion;
        outline.clear();
        for (int i = 0; i < tile.outline_count(); ++i) outline.push_back(place(motion(tile.position(i))));
        painter.fill(outline, copy.colour);
        painter.lines(outline, true, width, ink);
        for (const auto& [a, b] : tile.constrained_edges()) painter.line(place(motion(tile.position(a))), place(motion(tile.position(b))), width, ink);
    }
    return image;
}

} // namespace druse
