#include "tile/tile_path.h"

#include <algorithm>

namespace druse {

char letter(Preparation preparation) { return "+rfg"[static_cast<int>(preparation)]; }
char letter(PathShape shape) { return "JSUI"[static_cast<int>(shape)]; }

// How they combine is the exclusive or of their numbers.
static_assert((static_cast<int>(Preparation::half_turn) ^ static_cast<int>(Preparation::flip)) == static_cast<int>(Preparation::mirror));

std::vector<Point2> prepared(std::span<const Point2> inner, Preparation preparation)
{
    const bool turns_over = preparation == Preparation::half_turn || preparation == Preparation::mirror;
    const bool backwards = preparation == Preparation::half_turn || preparation == Preparation::flip;
    std::vector<Point2> points(inner.begin(), inner.end());
    for (Point2& p : points) p = {backwards ? 1.0 - p.x : p.x, turns_over ? -p.y : p.y};
    if (backwards) std::ranges::reverse(points);
    return points;
}

} // namespace druse
