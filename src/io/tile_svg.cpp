#include "io/tile_file.h"

#include "dlfl/errors.h"
#include "geom/colour.h"
#include "tile/tile_look.h"

#include <fmt/format.h>

namespace druse {

namespace {

constexpr double margin = 0.02;     // of the longer side, on all sides
constexpr double line_width = 0.01; // of the square root of a tile's area

std::string path_text(const LayeredTile& tile)
{
    std::string text;
    for (int i = 0; i < tile.outline_count(); ++i) text += fmt::format("{}{:.9g},{:.9g}", i == 0 ? "M" : " L", tile.position(i).x, tile.position(i).y);
    return text + " Z";
}

std::string lines_text(const LayeredTile& tile)
{
    std::string text;
    for (const auto& [a, b] : tile.constrained_edges())
        text += fmt::format("M{:.9g},{:.9g} L{:.9g},{:.9g} ", tile.position(a).x, tile.position(a).y, tile.position(b).x, tile.position(b).y);
    return text;
}

} // namespace

std::vector<TileCopy> drawn_copies(const LayeredTile& tile)
{
    std::vector<TileCopy> copies;
    for (int j = 0; j < tile.design().across[1]; ++j)
        for (int i = 0; i < tile.design().across[0]; ++i)
            for (int a = 0; a < tile.type().aspects(); ++a) copies.push_back({a, {i, j}});
    return copies;
}

DrawnTiling drawn_tiling(const LayeredTile& tile)
{
    const TileLook drawn = look(tile.design());
    const Isometry world = tile.to_world();
    DrawnTiling tiling;
    for (const TileCopy& copy : drawn_copies(tile)) {
        const int colour = tile.type().colours.of(copy.aspect, copy.shift.i, copy.shift.j);
        const Isometry motion = world * tile.motion(copy);
        tiling.copies.push_back({motion, drawn.colours[static_cast<std::size_t>(colour)]});
        for (const OutlinePoint& p : tile.outline().points) tiling.box.add(motion(p.position));
    }
    return tiling;
}

void write_svg(const ModelView& model, OutputFiles& out)
{
    if (!model.tile) throw InputError(out.name(), "the document holds no tile to draw");
    const LayeredTile& tile = *model.tile;
    const auto [copies, tight] = drawn_tiling(tile);
    const FlatBox box = tight.grown(margin * std::max(tight.max.x - tight.min.x, tight.max.y - tight.min.y));
    const Point2 size = box.max - box.min;

    // y is up in the world and down in a drawing.
    ByteSink& sink = out.main();
    sink.put(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.9g}mm\" height=\"{:.9g}mm\" viewBox=\"{:.9g} {:.9g} {:.9g} {:.9g}\">\n", size.x, size.y,
                         box.min.x, -box.max.y, size.x, size.y));
    sink.put(fmt::format("<defs>\n<path id=\"tile\" d=\"{}\"/>\n<path id=\"lines\" fill=\"none\" d=\"{}\"/>\n</defs>\n", path_text(tile), lines_text(tile)));
    sink.put(fmt::format("<g stroke=\"#000000\" stroke-width=\"{:.6g}\" stroke-linejoin=\"round\">\n", line_width * std::sqrt(tile.area())));
    for (const auto& [m, colour] : copies) {
        const std::string place = fmt::format("matrix({:.12g} {:.12g} {:.12g} {:.12g} {:.12g} {:.12g})", m.x.x, -m.x.y, m.y.x, -m.y.y, m.shift.x, -m.shift.y);
        sink.put(fmt::format("<use href=\"#tile\" transform=\"{}\" fill=\"{}\"/>\n", place, to_hex(colour)));
        if (!tile.design().segments.empty()) sink.put(fmt::format("<use href=\"#lines\" transform=\"{}\"/>\n", place));
    }
    sink.put("</g>\n</svg>\n");
}

Model read_svg(ByteSource& source) { throw InputError(source.name(), "drawings of tilings are written, not read; the tile is in the .tile file"); }

} // namespace druse
