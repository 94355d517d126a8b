#include "ui/relief_picture.h"

#include "dlfl/errors.h"
#include "tile/tile_stack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace druse::ui {

namespace {

constexpr int neighbour_group = wall_group + 1; // of the first one

Colour face_colour(int group)
{
    if (group >= neighbour_group) { // each its own
        const int number = group - neighbour_group;
        return colour_from_hsv(std::fmod(0.55 + 0.618034 * number, 1.0), 0.28, 0.62);
    }
    constexpr std::array<Colour, 4> colours{{{0xd9, 0x8e, 0x4a}, {0xd9, 0x8e, 0x4a}, {0x6f, 0x5a, 0x49}, {0xb3, 0x79, 0x45}}}; // top, bottom, walls
    return colours[std::size_t(group)];
}

Mesh top_alone(const LayeredTile& tile)
{
    MeshBuilder builder;
    for (const Point& p : tile.surface().points) builder.add_vertex(p);
    for (const auto& t : tile.surface().triangles) builder.add_face(t, top_group);
    Repairs repairs;
    return builder.build(repairs);
}

/// The tiles that touch it: across its edges, and on the layers above and below.
std::vector<std::pair<int, SolidPlace>> places_around(const LayeredTile& tile)
{
    std::vector<std::pair<int, SolidPlace>> places; // with the aspect
    std::vector<TileCopy> known;
    for (int edge = 0; edge < tile.type().corners; ++edge) {
        const TileCopy copy = tile.neighbour({}, edge);
        if (std::ranges::find(known, copy) != known.end()) continue;
        known.push_back(copy);
        places.push_back({copy.aspect, {tile.motion(copy), 0}});
    }
    const Isometry step = stack_motion(tile.design().stack);
    places.push_back({0, {step, tile.thickness()}});
    places.push_back({0, {inverse(step), -tile.thickness()}});
    return places;
}

} // namespace

/// The solid of the tile in an aspect: by the plan that is known, while this fits.
TileSolid ReliefPicture::solid_of(const LayeredTile& tile, int aspect)
{
    auto known = plans_.find(aspect);
    if (known != plans_.end() && !known->second.fits(tile)) known = plans_.end();
    if (known == plans_.end()) known = plans_.insert_or_assign(aspect, SolidPlan(tile, TileBottom::carved, aspect)).first;
    return known->second.solid(tile);
}

/// The tile, its points first, and if `shrink` is above 0 those around it.
Mesh ReliefPicture::mesh_of(const LayeredTile& tile, const TileSolid& solid, double shrink)
{
    MeshBuilder builder;
    add_solid(builder, solid, {});
    struct Part {
        std::uint32_t first, end; // vertices
    };
    std::vector<Part> parts;
    if (shrink > 0) {
        const std::vector<int> members = stack_members(tile.aspects(), tile.lattice(), tile.design().stack);
        std::map<int, TileSolid> others; // of a free stack
        int group = neighbour_group;
        for (const auto& [aspect, place] : places_around(tile)) {
            const int member = members[std::size_t(aspect)];
            if (member != members[0] && !others.contains(member)) others.emplace(member, solid_of(tile, aspect));
            const std::uint32_t first = builder.vertex_count();
            add_solid(builder, member == members[0] ? solid : others.at(member), place, {group, group, group});
            parts.push_back({first, builder.vertex_count()});
            ++group;
        }
    }
    Mesh mesh = builder.build();
    for (const Part& part : parts) {
        Point middle(0.0);
        for (std::uint32_t v = part.first; v < part.end; ++v) middle += mesh.position(Vertex(v)) / double(part.end - part.first);
        for (std::uint32_t v = part.first; v < part.end; ++v) mesh.set_position(Vertex(v), middle + shrink * (mesh.position(Vertex(v)) - middle));
    }
    return mesh;
}

void ReliefPicture::follow(const LayeredTile* tile)
{
    thinnest.reset();
    trouble.clear();
    volume.reset();
    solids = 0;
    if (!tile) {
        plans_.clear();
        lists = DrawLists();
        return;
    }
    if (!tile->is_extruded()) {
        lists.build(top_alone(*tile), face_colour);
        return;
    }
    try {
        const TileSolid solid = solid_of(*tile, 0);
        lists.build(mesh_of(*tile, solid, neighbours), face_colour);
        thinnest = solid.thinnest.thickness;
        volume = druse::volume(solid);
        solids = member_count(*tile);
        thinnest_top = Point(solid.thinnest.at, tile->layer_height(solid.thinnest.at) + tile->thickness());
        thinnest_bottom = thinnest_top - Vector(0, 0, *thinnest);
        if (*thinnest <= 0) trouble = "the top goes under the bottom";
    } catch (const CommandError& e) { // the relief can be edited on
        trouble = e.what();
        lists.build(mesh_of(*tile, make_solid(*tile, TileBottom::column), 0), face_colour);
    }
}

} // namespace druse::ui
