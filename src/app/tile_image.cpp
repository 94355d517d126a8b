// tile.height_image, which needs to read a picture.
#include "app/registry.h"
#include "io/grey_image.h"
#include "ops/tile.h"
#include "ops/tile_parameters.h"
#include "tile/relief_tools.h"

namespace druse {

namespace {

struct TileHeightImage {
    FilePath image;
    double low = 0, high = 1;
    TilePoints points{{"all"}};
};

void run_tile_height_image(Scene& scene, const TileHeightImage& p, Context& context)
{
    if (!tile_of(scene).is_extruded()) throw TileRefusal(TileRefusal::Reason::phase, "heights come after tile.extrude");
    ByteSource source = ByteSource::file(context.folder / p.image.path);
    const GreyImage image = read_grey_png(source);
    const Selection& selection = *scene.selection;
    edit_tile(scene, context, [&](LayeredTile& tile) {
        const std::vector<int> points = p.points.resolve(tile, selection);
        tile.set_heights(points, mapped_heights(tile, points, [&](const Point2& place) { return p.low + (p.high - p.low) * image.at(place); }));
    });
}

} // namespace

void register_tile_image(Registry& registry)
{
    using P = TileHeightImage;
    registry.add(define<P>("tile.height_image", "Take heights from a grey picture, laid over the box of the outline")
                     .param(&P::image, "image", "a PNG picture")
                     .required()
                     .param(&P::low, "low", Unit::length, {}, "height where it is black")
                     .param(&P::high, "high", Unit::length, {}, "and where it is white")
                     .param(&P::points, "points", Unit::none, {}, at_least(1), "which points: names as v0, e0:1 or i0, or all, outline, interior, selected, none")
                     .keeps_euler()
                     .example("tile.height_image image=ripples.png high=0.2")
                     .cites("Howison & Séquin 2009, section 2")
                     .run(run_tile_height_image));
}

} // namespace druse
