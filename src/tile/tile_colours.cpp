#include "tile/tile_colours.h"

#include "dlfl/errors.h"
#include "tile/isohedral_type.h"

#include <algorithm>

namespace druse {

namespace {

int modulo(int a, int m) { return ((a % m) + m) % m; }

/// Neighbours of each tile of the repeating block.
std::vector<std::vector<int>> neighbours_of(const IsohedralType& type, int period)
{
    std::vector<std::vector<int>> list;
    for (int a = 0; a < type.aspects(); ++a)
        for (int i = 0; i < period; ++i)
            for (int j = 0; j < period; ++j) {
                auto& around = list.emplace_back();
                for (const TileNeighbour& n : type.neighbours[a])
                    around.push_back((n.aspect * period + modulo(i + n.shift.i, period)) * period + modulo(j + n.shift.j, period));
            }
    return list;
}

/// Colours the tiles that have no colour yet (−1), those with the fewest left first: a dead end shows at once.
bool colour_rest(const std::vector<std::vector<int>>& around, int count, std::vector<int>& colour)
{
    int at = -1;
    std::vector<int> choice;
    for (int tile = 0; tile < std::ssize(around); ++tile) {
        if (colour[tile] >= 0) continue;
        std::vector<int> left;
        for (int c = 0; c < count; ++c)
            if (std::ranges::none_of(around[tile], [&](int n) { return n == tile || colour[n] == c; })) left.push_back(c);
        if (at >= 0 && left.size() >= choice.size()) continue;
        at = tile;
        choice = left;
    }
    if (at < 0) return true;
    for (const int c : choice) {
        colour[at] = c;
        if (colour_rest(around, count, colour)) return true;
    }
    colour[at] = -1;
    return false;
}

} // namespace

int TileColours::of(int aspect, int i, int j) const { return colour[(aspect * period + modulo(i, period)) * period + modulo(j, period)]; }

TileColours colour_tiles(const IsohedralType& type)
{
    const auto valences = std::span(type.symbol.valence).first(type.corners);
    TileColours result;
    result.count = std::ranges::find(valences, 3) == valences.end() ? 2 : 3;
    for (; result.period <= 3; ++result.period) {
        const auto around = neighbours_of(type, result.period);
        result.colour.assign(around.size(), -1);
        result.colour[0] = 0;
        if (std::ranges::find(around[0], 0) == around[0].end() && colour_rest(around, result.count, result.colour)) return result;
    }
    ASSERT(false, "a colouring that repeats after three places at most");
    return result;
}

} // namespace druse
