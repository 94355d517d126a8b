#include "ui/tile_offset.h"

#include "tile/tile_stack.h"

#include <algorithm>
#include <vector>

namespace druse::ui {

namespace {

/// The points of the tile that look for something below them: all of a small one, the corners of a large one.
std::vector<Point2> seekers(const ShownTile& shape)
{
    constexpr std::size_t few = 60;
    std::vector<Point2> list;
    for (const TilePoint& p : shape.points)
        if (shape.points.size() <= few || p.kind == TilePoint::Kind::corner) list.push_back(p.at);
    return list;
}

Point2 nearest_on_piece(const Point2& p, const Point2& a, const Point2& b)
{
    const Point2 along = b - a;
    const double length2 = glm::dot(along, along);
    return a + (length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0) * along;
}

} // namespace

TileOffset attract(const ShownTile& shape, const Point2& wanted, double reach)
{
    const IsohedralOffsets allowed(shape.aspects, shape.lattice, {});
    if (allowed.freedom() == 0) {
        const Point2 nearest = allowed.nearest(wanted);
        return glm::distance(nearest, wanted) <= reach ? TileOffset{nearest, true} : TileOffset{wanted, false};
    }
    // Of the offsets that bring something over something, those that are allowed: to rounding.
    const auto is_allowed = [&](const Point2& d) { return glm::distance(allowed.nearest(d), d) <= 1e-9 * shape.size; };
    const std::vector<Point2> own = seekers(shape);
    for (const bool over_points : {true, false}) {
        std::optional<Point2> best;
        double nearest = reach;
        for (const DrawnCopy& copy : shape.copies)
            for (int i = 0; i < (over_points ? int(shape.points.size()) : shape.outline); ++i) {
                const Point2 a = copy.map(shape.points[std::size_t(i)].at), b = copy.map(shape.points[std::size_t((i + 1) % shape.outline)].at);
                for (const Point2& p : own) {
                    const Point2 d = (over_points ? a : nearest_on_piece(p + wanted, a, b)) - p;
                    if (const double away = glm::distance(d, wanted); away < nearest && is_allowed(d)) nearest = away, best = d;
                }
            }
        if (best) return {*best, true};
    }
    const Point2 near = allowed.nearest(wanted);
    return glm::distance(near, wanted) <= reach ? TileOffset{near, true} : TileOffset{wanted, false};
}

} // namespace druse::ui
