#include "cli/flat_tiling.h"

#include "io/tile_file.h"
#include "render/flat_painter.h"
#include "tile/tile_look.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace druse {

namespace {

constexpr double margin = 0.02;     // of the shorter side of the picture, on all sides
constexpr double line_width = 0.01; // of the square root of a tile's area

} // namespace

Image flat_tiling(const LayeredTile& tile, const StillOptions& options)
{
    const TileLook drawn = look(tile.design());
    const Isometry world = tile.to_world();
    std::vector<std::pair<TileCopy, Isometry>> copies;
    FlatBox box;
    for (const TileCopy& copy : drawn_copies(tile)) {
        copies.emplace_back(copy, world * tile.motion(copy));
        for (const OutlinePoint& p : tile.outline().points) box.add(copies.back().second(p.position));
    }
    const Point2 picture(options.width, options.height), size = box.max - box.min;
    const double room = 1 - 2 * margin, pixels = room * std::min(picture.x / size.x, picture.y / size.y);
    const auto place = [&](const Point2& p) {
        const Point2 from_middle = pixels * (p - 0.5 * (box.min + box.max));
        return Point2(0.5 * picture.x + from_middle.x, 0.5 * picture.y - from_middle.y);
    };

    Image image(options.width, options.height);
    FlatPainter painter(image);
    painter.clear(options.background.value_or(Colour{255, 255, 255}));
    const Colour ink{0, 0, 0};
    const double width = std::max(1.0, line_width * std::sqrt(tile.area()) * pixels);
    std::vector<Point2> outline;
    for (const auto& [copy, motion] : copies) {
        outline.clear();
        for (int i = 0; i < tile.outline_count(); ++i) outline.push_back(place(motion(tile.position(i))));
        const int colour = tile.type().colours.of(copy.aspect, copy.shift.i, copy.shift.j);
        painter.fill(outline, drawn.colours[static_cast<std::size_t>(colour)]);
        painter.lines(outline, true, width, ink);
        for (const auto& [a, b] : tile.constrained_edges()) painter.line(place(motion(tile.position(a))), place(motion(tile.position(b))), width, ink);
    }
    return image;
}

} // namespace druse
