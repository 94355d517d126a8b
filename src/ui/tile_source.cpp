#include "ui/tile_source.h"

#include "tile/tile_solid.h"

#include <fmt/format.h>

#include <utility>
#include <variant>

namespace druse::ui {

namespace {

constexpr std::size_t copies_drawn = 100; // beside the tile: around it, up to the corners of a window

TilePoint::Kind point_kind(const PointName& name)
{
    switch (name.kind) {
    case PointName::Kind::corner: return TilePoint::Kind::corner;
    case PointName::Kind::middle: return TilePoint::Kind::middle;
    case PointName::Kind::interior: return TilePoint::Kind::interior;
    case PointName::Kind::path:
    case PointName::Kind::mirrored: break;
    }
    return TilePoint::Kind::path;
}

} // namespace

const LayeredTile* layered_tile(const Scene& scene) { return std::get_if<LayeredTile>(&*scene.source); }

ShownTile shown_tile(const LayeredTile* tile)
{
    ShownTile shown;
    if (!tile) return shown;
    shown.type = &tile->type();
    shown.size = tile->size();
    shown.parameters = tile->design().parameters;
    shown.outline = tile->outline_count();
    shown.points.reserve(static_cast<std::size_t>(tile->point_count()));
    for (int i = 0; i < tile->point_count(); ++i) {
        const PointName name = tile->name(i);
        const int orbit = i < shown.outline ? tile->outline().points[std::size_t(i)].orbit : -1;
        shown.points.push_back({name.text(), tile->position(i), point_kind(name), orbit, tile->height(i)});
    }
    shown.triangles.reserve(tile->surface().triangles.size());
    for (const auto& t : tile->surface().triangles) shown.triangles.push_back({int(t[0]), int(t[1]), int(t[2])});
    shown.segments = tile->constrained_edges();
    const CornerVector corners = plus(CornerVector{}, tile->corners(), tile->size());
    shown.copies = copies_around(*shown.type, corners, copies_drawn);
    shown.centres = rotation_centres(*shown.type, corners);
    shown.aspects = tile->aspects();
    shown.lattice = tile->lattice();
    shown.stack = tile->design().stack;
    shown.look = look(tile->design());
    if (tile->is_extruded()) shown.thickness = tile->thickness();
    return shown;
}

std::vector<SolidFile> solid_files(const LayeredTile& tile, const std::string& command, const std::filesystem::path& file)
{
    std::vector<SolidFile> files;
    for (const TilePart& part : tile_parts(tile)) {
        SolidFile next{command, file};
        if (part.aspect > 0) next.command += fmt::format(" aspect={}", part.aspect);
        if (part.layer > 0) next.command += fmt::format(" layer={}", part.layer);
        if (!files.empty()) next.file.replace_filename(fmt::format("{}-{}{}", file.stem().string(), files.size() + 1, file.extension().string()));
        files.push_back(std::move(next));
    }
    return files;
}

} // namespace druse::ui
