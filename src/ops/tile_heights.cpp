// Operators that shape the relief of a tile: many heights at once.
#include "ops/tile.h"
#include "ops/tile_parameters.h"
#include "tile/relief_tools.h"

#include <optional>

namespace druse {

namespace {

constexpr const char* howison_relief = "Howison & Séquin 2009, section 2";

struct TileHeightSmooth {
    TilePoints points{{"all"}};
    double amount = 0.5;
    int times = 1;
};

struct TileHeightRidge {
    std::optional<TilePoints> path;
    std::optional<std::vector<Point2>> line;
    double height = 1;
    std::optional<double> width;
    ReliefProfile profile = ReliefProfile::round;
    TilePoints points{{"all"}};
};

struct TileHeightDome {
    double height = 1;
    std::optional<double> width;
    ReliefProfile profile = ReliefProfile::round;
    TilePoints points{{"all"}};
};

/// Shapes the heights of the points that are asked for. `heights(tile, points)` says what they are to be.
template <class F>
void shape_relief(Scene& scene, Context& context, const TilePoints& asked, F&& heights)
{
    const Selection& selection = *scene.selection;
    edit_tile(scene, context, [&](LayeredTile& tile) {
        if (!tile.is_extruded()) throw TileRefusal(TileRefusal::Reason::phase, "heights come after tile.extrude");
        const std::vector<int> points = asked.resolve(tile, selection);
        if (points.empty()) return;
        tile.set_heights(points, heights(tile, points));
    });
}

void run_tile_height_ridge(Scene& scene, const TileHeightRidge& p, Context& context)
{
    shape_relief(scene, context, p.points, [&](const LayeredTile& tile, const std::vector<int>& points) {
        std::vector<Point2> chain;
        if (p.line) chain = *p.line;
        else
            for (const std::string& word : p.path->words) chain.push_back(tile.position(tile.find(PointName::parse(word))));
        if (chain.size() == 1) chain.push_back(chain.front()); // a hill
        std::vector<double> heights = ridged_heights(tile, points, chain, p.height, p.width.value_or(0.1 * tile.size()), p.profile);
        bool any = false;
        for (std::size_t i = 0; i < points.size(); ++i) any = any || heights[i] != tile.height(points[i]);
        if (!any) context.note("no point lies within the width of the ridge: tile.point_add and tile.refine make more");
        return heights;
    });
}

constexpr const char* points_help = "which may move: names as v0, e0:1 or i0, or all, outline, interior, selected, none";

} // namespace

Operator tile_height_smooth_operator()
{
    using P = TileHeightSmooth;
    return define<P>("tile.height_smooth", "Smooth the relief: heights go towards the mean of those around them")
        .param(&P::points, "points", Unit::none, {}, at_least(1), points_help)
        .param(&P::amount, "amount", Unit::ratio, {0, 1}, "how far, each time: 0 not at all, 1 all the way")
        .param(&P::times, "times", Unit::count, {1, 1000}, "how often")
        .keeps_euler()
        .example("tile.height_smooth times=2")
        .cites(howison_relief)
        .run([](Scene& scene, const P& p, Context& context) {
            shape_relief(scene, context, p.points, [&](const LayeredTile& tile, const std::vector<int>& points) { return smoothed_heights(tile, points, p.amount, p.times); });
        });
}

Operator tile_height_ridge_operator()
{
    using P = TileHeightRidge;
    return define<P>("tile.height_ridge", "Raise a ridge along a line, or sink a valley")
        .param(&P::path, "path", Unit::none, {}, at_least(1), "points that it runs along; of one, a hill")
        .param(&P::line, "line", Unit::length, {}, at_least(1), "or x,y of places, in the tile frame")
        .exactly_one({"path", "line"})
        .param(&P::height, "height", Unit::length, {}, "what is added along the line; below 0, a valley")
        .param(&P::width, "width", Unit::length, above(0), "to both sides; unset 1/10 of the size")
        .param(&P::profile, "profile", words({"round", "straight"}), "how it falls off")
        .param(&P::points, "points", Unit::none, {}, at_least(1), points_help)
        .keeps_euler()
        .example("tile.height_ridge path=v1,i0 height=0.1 width=0.3")
        .cites(howison_relief)
        .run(run_tile_height_ridge);
}

Operator tile_height_dome_operator()
{
    using P = TileHeightDome;
    return define<P>("tile.height_dome", "Vault the tile: heights grow with the distance from the outline")
        .param(&P::height, "height", Unit::length, {}, "what is added inside; below 0, a bowl")
        .param(&P::width, "width", Unit::length, above(0), "how far inside that is reached; unset: where the tile is widest")
        .param(&P::profile, "profile", words({"round", "straight"}), "how it rises")
        .param(&P::points, "points", Unit::none, {}, at_least(1), points_help)
        .keeps_euler()
        .example("tile.height_dome height=0.2")
        .cites(howison_relief)
        .run([](Scene& scene, const P& p, Context& context) {
            shape_relief(scene, context, p.points,
                         [&](const LayeredTile& tile, const std::vector<int>& points) { return domed_heights(tile, points, p.height, p.width, p.profile); });
        });
}

} // namespace druse
