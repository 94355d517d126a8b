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

/// The nearest place of the layer below where a point or an edge of its triangles lies, within `reach`; for each copy that is near enough, `take` is called with it.
template <class F>
void for_features(const ShownTile& shape, const Point2& at, double reach, bool points, F&& take)
{
    const Point2 low = shape.low() - reach, high = shape.high() + reach;
    for (const DrawnCopy& copy : shape.copies) {
        const Point2 p = inverse(copy.map)(at);
        if (p.x < low.x || p.y < low.y || p.x > high.x || p.y > high.y) continue;
        if (points) {
            for (const TilePoint& q : shape.points)
                if (glm::distance(q.at, p) < reach) take(copy.map(q.at));
        } else {
            for (const auto& t : shape.triangles)
                for (std::size_t k = 0; k < 3; ++k) {
                    const Point2 q = nearest_on_piece(p, shape.points[std::size_t(t[k])].at, shape.points[std::size_t(t[(k + 1) % 3])].at);
                    if (glm::distance(q, p) < reach) take(copy.map(q));
                }
        }
    }
}

} // namespace

TileOffset attract(const ShownTile& shape, const Point2& wanted, double reach)
{
    TileStack stack = shape.stack;
    if (stack.mode == TileStack::Mode::column) stack = {TileStack::Mode::shift, Point2(0.0), 0};
    stack.offset = Point2(0.0);
    const Isometry turn = stack_motion(stack);
    const bool free = stack.mode == TileStack::Mode::free;
    const IsohedralOffsets allowed(shape.aspects, shape.lattice, turn);
    if (!free && !allowed.any()) return {wanted, false};
    if (!free && allowed.freedom() == 0) {
        const Point2 nearest = allowed.nearest(wanted);
        return glm::distance(nearest, wanted) <= reach ? TileOffset{nearest, true} : TileOffset{wanted, false};
    }
    // Of the offsets that bring something over something, those that are allowed: to rounding.
    const auto is_allowed = [&](const Point2& d) { return free || glm::distance(allowed.nearest(d), d) <= 1e-9 * shape.size; };
    const std::vector<Point2> own = seekers(shape);
    for (const bool over_points : {true, false}) {
        std::optional<Point2> best;
        double nearest = reach;
        for (const Point2& p : own)
            for_features(shape, turn(p) + wanted, reach, over_points, [&](const Point2& place) {
                const Point2 d = place - turn(p);
                if (const double away = glm::distance(d, wanted); away < nearest && is_allowed(d)) nearest = away, best = d;
            });
        if (best) return {*best, true};
    }
    if (free || allowed.freedom() == 2) return {wanted, true};
    const Point2 near = allowed.nearest(wanted);
    return glm::distance(near, wanted) <= reach ? TileOffset{near, true} : TileOffset{wanted, false};
}

} // namespace druse::ui
