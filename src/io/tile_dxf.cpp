#include "io/tile_file.h"

#include "dlfl/errors.h"
#include "tile/layered_tile.h"

#include <fmt/format.h>

#include <cstddef>
#include <span>
#include <string_view>

namespace druse {

namespace {

// DXF of Release 12, which cutters and all drawing programs read: pairs of lines, a code and a value.
constexpr std::string_view dxf_head = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"; // 4: millimetres
constexpr std::string_view dxf_end = "0\nENDSEC\n0\nEOF\n";

void put_polyline(ByteSink& sink, std::string_view layer, std::span<const Point2> points)
{
    sink.put(fmt::format("0\nPOLYLINE\n8\n{}\n66\n1\n70\n0\n10\n0\n20\n0\n30\n0\n", layer));
    for (const Point2& p : points) sink.put(fmt::format("0\nVERTEX\n8\n{}\n10\n{:.9g}\n20\n{:.9g}\n30\n0\n", layer, p.x, p.y));
    sink.put(fmt::format("0\nSEQEND\n8\n{}\n", layer));
}

} // namespace

void write_dxf(const ModelView& model, OutputFiles& out)
{
    if (!model.tile) throw InputError(out.name(), "the document holds no tile to draw");
    const LayeredTile& tile = *model.tile;
    const TileOutline& outline = tile.outline();
    const std::vector<TileCopy> copies = drawn_copies(tile);
    const auto [nx, ny] = tile.design().across;
    const auto is_earlier = [&](const TileCopy& copy, std::size_t than) {
        const auto [i, j] = copy.shift;
        if (i < 0 || i >= nx || j < 0 || j >= ny) return false;
        return (std::size_t(j) * std::size_t(nx) + std::size_t(i)) * tile.aspects().size() + std::size_t(copy.aspect) < than;
    };
    ByteSink& sink = out.main();
    sink.put(dxf_head);
    std::vector<Point2> line;
    for (std::size_t c = 0; c < copies.size(); ++c) {
        const Isometry there = tile.to_world() * tile.motion(copies[c]);
        for (int k = 0; k < tile.type().corners; ++k) {
            // What two copies have in common is cut once.
            if (is_earlier(tile.neighbour(copies[c], k), c)) continue;
            line.clear();
            for (int i = outline.corner[k]; i <= outline.corner[k + 1]; ++i) line.push_back(there(outline.points[i % outline.size()].position));
            put_polyline(sink, "CUT", line);
        }
        for (const auto& chain : tile.design().segments) {
            line.clear();
            for (const PointName& name : chain) line.push_back(there(tile.position(tile.find(name))));
            put_polyline(sink, "ENGRAVE", line);
        }
    }
    sink.put(dxf_end);
}

Model read_dxf(ByteSource& source) { throw InputError(source.name(), "drawings of tilings are written, not read; the tile is in the .tile file"); }

} // namespace druse
