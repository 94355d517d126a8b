// Operators on how a tile is drawn: the picture behind it, and the colours of the tiling.
#include "ops/tile.h"
#include "ops/tile_parameters.h"
#include "tile/tile_look.h"

#include <filesystem>
#include <optional>

namespace druse {

namespace {

struct TileTraceParameters {
    bool on = true;
    std::optional<FilePath> image;
    std::optional<std::array<double, 6>> place;
    std::optional<double> opacity;
};

/// As wide as the tile, from its lower left corner on.
std::array<double, 6> place_behind(const LayeredTile& tile)
{
    FlatBox box;
    for (const OutlinePoint& p : tile.outline().points) box.add(p.position);
    const double width = box.max.x - box.min.x;
    return {width, 0, box.min.x, 0, width, box.min.y};
}

/// Runs f(look) on how the tile of a document is drawn.
template <class F>
void edit_look(Scene& scene, Context& context, F&& f)
{
    edit_tile(scene, context, [&](LayeredTile& tile) {
        TileLook changed = look(tile.design());
        f(changed, tile);
        tile = with_look(tile, changed);
    });
}

void run_tile_trace(Scene& scene, const TileTraceParameters& p, Context& context)
{
    edit_look(scene, context, [&](TileLook& look, const LayeredTile& tile) {
        if (!p.on) {
            look.trace.reset();
            return;
        }
        if (!look.trace && !p.image) throw CommandError("image= is needed: the tile has no picture yet");
        if (!look.trace) look.trace.emplace().place = place_behind(tile);
        TileTrace& trace = *look.trace;
        if (p.image) trace.image = std::filesystem::absolute(context.folder / p.image->path).lexically_normal().string();
        trace.place = p.place.value_or(trace.place);
        trace.opacity = p.opacity.value_or(trace.opacity);
    });
}

struct TileColors {
    std::array<Colour, 3> colors = TileLook().colours;
};

} // namespace

Operator tile_trace_operator()
{
    using P = TileTraceParameters;
    return define<P>("tile.trace", "Lay a picture behind the tile, to draw after")
        .param(&P::on, "on", "false takes it away")
        .param(&P::image, "image", "a PNG file; unset: the one that is there")
        .param(&P::place, "place", Unit::length, {}, "a,b,c,d,e,f: (u,v) of the picture, which is one wide, lies at x = a u + b v + c, y = d u + e v + f of the tile frame; unset: where it is, or behind the tile")
        .param(&P::opacity, "opacity", Unit::ratio, {0, 1}, "0 to 1; unset: as it is")
        .keeps_euler()
        .example("tile.trace image=bird.png opacity=0.4")
        .cites("Howison & Séquin 2009, section 2")
        .run(run_tile_trace);
}

Operator tile_colors_operator()
{
    return define<TileColors>("tile.colors", "Choose the colours in which the tiling is drawn")
        .param(&TileColors::colors, "colors", "three of them; tiles that share an edge have different ones")
        .keeps_euler()
        .example("tile.colors colors=#e0b040,#f4f0e8,#406080")
        .cites("Grünbaum & Shephard 1987, ch. 8")
        .run([](Scene& scene, const TileColors& p, Context& context) { edit_look(scene, context, [&](TileLook& look, const LayeredTile&) { look.colours = p.colors; }); });
}

} // namespace druse
