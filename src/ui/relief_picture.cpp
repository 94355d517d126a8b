#include "ui/relief_picture.h"

#include "dlfl/errors.h"
#include "tile/tile_solid.h"

#include <array>

namespace druse::ui {

namespace {

Colour face_colour(int group)
{
    constexpr std::array<Colour, 4> colours{{{0xd9, 0x8e, 0x4a}, {0xd9, 0x8e, 0x4a}, {0x6f, 0x5a, 0x49}, {0xb3, 0x79, 0x45}}}; // top, bottom, walls
    return colours[std::size_t(group) % colours.size()];
}

Mesh top_alone(const LayeredTile& tile)
{
    MeshBuilder builder;
    for (const Point& p : tile.surface().points) builder.add_vertex(p);
    for (const auto& t : tile.surface().triangles) builder.add_face(t, top_group);
    Repairs repairs;
    return builder.build(repairs);
}

Mesh mesh_of(const TileSolid& solid)
{
    MeshBuilder builder;
    add_solid(builder, solid, {});
    return builder.build();
}

} // namespace

void ReliefPicture::follow(const LayeredTile* tile)
{
    thinnest.reset();
    trouble.clear();
    if (!tile) {
        lists = DrawLists();
        return;
    }
    if (!tile->is_extruded()) {
        lists.build(top_alone(*tile), face_colour);
        return;
    }
    try {
        const TileSolid solid = make_solid(*tile);
        lists.build(mesh_of(solid), face_colour);
        thinnest = solid.thinnest.thickness;
        thinnest_top = Point(solid.thinnest.at, tile->layer_height(solid.thinnest.at) + tile->thickness());
        thinnest_bottom = thinnest_top - Vector(0, 0, *thinnest);
        if (*thinnest <= 0) trouble = "the top goes under the bottom";
    } catch (const CommandError& e) { // the relief can be edited on
        trouble = e.what();
        lists.build(mesh_of(make_solid(*tile, TileBottom::column)), face_colour);
    }
}

} // namespace druse::ui
