// Operators on stack, thickness and heights of a tile, and what is made of it.
#include "ops/tile.h"
#include "ops/tile_parameters.h"
#include "tile/tile_assembly.h"
#include "tile/tile_stack.h"

#include <fmt/format.h>

#include <optional>

namespace druse {

namespace {

struct TileStackParameters {
    TileStack::Mode mode = TileStack::Mode::column;
    Point2 offset{0.0};
    double axis = 0;
    std::optional<double> snap;
};

struct TileExtrude {
    double thickness = 1;
};

struct TileHeight {
    TilePoints points;
    std::optional<double> set, add;
};

void run_tile_height(Scene& scene, const TileHeight& p, Context& context)
{
    const Selection& selection = *scene.selection;
    edit_tile(scene, context, [&](LayeredTile& tile) {
        if (!tile.is_extruded()) throw TileRefusal(TileRefusal::Reason::phase, "heights come after tile.extrude");
        const std::vector<int> points = p.points.resolve(tile, selection);
        if (p.set) tile.set_heights(points, *p.set);
        else tile.add_heights(points, *p.add);
    });
}

/// What tile.solid and tile.assemble have in common.
struct TileBody {
    TileBottom bottom = TileBottom::carved;
    double clearance = 0, min_thickness = 0.4;
};

struct TileSolidParameters : TileBody {
    int aspect = 0, member = 0, layer = 0;
};

struct TileAssemble : TileBody {
    int nx = 3, ny = 3, layers = 2;
    double gap = 0;
    TileColour color = TileColour::aspect;
};

/// Refuses a solid that is pierced, and tells of one that is thin.
void look_at_thickness(const Thinnest& thinnest, double least, Context& context)
{
    const std::string where = fmt::format("{:.6g} thick at {:.6g},{:.6g} of the tile frame", thinnest.thickness, thinnest.at.x, thinnest.at.y);
    if (!(thinnest.thickness > 0)) throw TileRefusal(TileRefusal::Reason::top_under_bottom, "the tile would be " + where);
    if (thinnest.thickness < least) context.note(fmt::format("the tile is only {}", where));
}

void put_mesh(Scene& scene, MeshBuilder& builder)
{
    scene.mesh.replace_with(builder.build());
    scene.selection = Selection();
}

void run_tile_solid(Scene& scene, const TileSolidParameters& p, Context& context)
{
    const LayeredTile& tile = tile_of(scene);
    if (!tile.is_extruded()) throw TileRefusal(TileRefusal::Reason::phase, "a solid comes after tile.extrude");
    const int aspect = p.member > 0 ? aspect_of_member(tile, p.member) : p.aspect;
    const TileSolid solid = make_solid(tile, p.bottom, aspect, p.clearance);
    look_at_thickness(solid.thinnest, p.min_thickness, context);
    if (p.bottom == TileBottom::flat) context.note("a flat bottom fills no space");
    if (solid.steep > 0)
        context.note(fmt::format("{} where the relief is steeper than 75 degrees: joints are narrower than {} there, as tile.check tells",
                                 solid.steep == 1 ? "1 triangle lies" : fmt::format("{} triangles lie", solid.steep), p.clearance));
    if (solid.lost > 0) context.note(fmt::format("the clearance cuts {:.6g} mm² off the outline, which hang on it by less than a joint", solid.lost));
    MeshBuilder builder;
    const Isometry& place = tile.aspects()[aspect];
    add_solid(builder, solid, {tile.to_world() * (p.layer == 0 ? place : stack_motion(tile.design().stack) * place), p.layer * tile.thickness()});
    put_mesh(scene, builder);
}

void run_tile_assemble(Scene& scene, const TileAssemble& p, Context& context)
{
    const LayeredTile& tile = tile_of(scene);
    if (!tile.is_extruded()) throw TileRefusal(TileRefusal::Reason::phase, "an assembly comes after tile.extrude");
    MeshBuilder builder;
    look_at_thickness(assemble(builder, tile, {p.nx, p.ny, p.layers, p.gap, p.color, p.bottom, p.clearance}, context.progress), p.min_thickness, context);
    put_mesh(scene, builder);
    edit_tile(scene, context, [&](LayeredTile& same) { same.set_across(p.nx, p.ny); });
}

template <class P>
void add_body(Definition<P>& definition)
{
    definition.param(&P::bottom, "bottom", words({"carved", "column", "flat"}), "what lies under it: the layer below, its own top, or a plane")
        .param(&P::clearance, "clearance", Unit::length, at_least(0), "width of the joints between tiles")
        .param(&P::min_thickness, "min_thickness", Unit::length, at_least(0), "thinner places are told");
}

} // namespace

Operator tile_stack_operator()
{
    using P = TileStackParameters;
    return define<P>("tile.stack", "Say how each layer of tiles lies upon the one below")
        .param(&P::mode, "mode", words({"column", "shift", "mirror", "free"}), "straight up, moved, mirrored, or moved so that several different solids are needed")
        .param(&P::offset, "offset", "x,y in the tile frame by which the next layer moves; of a mirror, after it")
        .only_where("mode", {"shift", "mirror", "free"})
        .param(&P::axis, "axis", Unit::degrees, {-360, 360}, "direction of the mirror line through the origin of the frame")
        .only_where("mode", {"mirror"})
        .param(&P::snap, "snap", Unit::length, at_least(0), "how near the offset must be to one that makes all tiles alike; unset 1/500 of the size")
        .only_where("mode", {"shift", "mirror"})
        .keeps_euler()
        .example("tile.stack mode=shift offset=1,0")
        .cites("Howison & Séquin 2009, section 2")
        .run([](Scene& scene, const P& p, Context& context) {
            edit_tile(scene, context, [&](LayeredTile& tile) { tile.set_stack({p.mode, p.offset, p.axis}, p.snap); });
        });
}

Operator tile_extrude_operator()
{
    return define<TileExtrude>("tile.extrude", "Give the tile a thickness; heights of its points come after")
        .param(&TileExtrude::thickness, "thickness", Unit::length, above(0), "distance of the layers")
        .required()
        .keeps_euler()
        .example("tile.extrude thickness=0.5")
        .cites("Howison & Séquin 2009, section 2")
        .run([](Scene& scene, const TileExtrude& p, Context& context) { edit_tile(scene, context, [&](LayeredTile& tile) { tile.extrude(p.thickness); }); });
}

Operator tile_height_operator()
{
    return define<TileHeight>("tile.height", "Set or change heights of points of the tile, and of those on the outline that go with them")
        .param(&TileHeight::points, "points", Unit::none, {}, at_least(1), "names as v0, e0:1 or i0, or all, outline, interior, selected, none")
        .required()
        .param(&TileHeight::set, "set", Unit::length, {}, "height over the thickness")
        .param(&TileHeight::add, "add", Unit::length, {}, "or what to add")
        .exactly_one({"set", "add"})
        .keeps_euler()
        .example("tile.height points=i0,v0 set=0.2")
        .cites("Howison & Séquin 2009, section 2")
        .run(run_tile_height);
}

Operator tile_solid_operator()
{
    using P = TileSolidParameters;
    Definition<P> definition("tile.solid", "Make the solid tile: its top, its bottom carved from the layer below, and walls");
    add_body(definition);
    return definition.param(&P::aspect, "aspect", Unit::count, {0, 11}, "which of the tiles of a cell; some are mirror images")
        .param(&P::member, "member", Unit::count, {0, 11}, "which of the different solids of a free stack").instead_of("aspect")
        .param(&P::layer, "layer", Unit::count, {0, 1}, "1: the tile above that one, its mirror image in a stack of mirrors")
        .example("tile.solid")
        .cites("Howison & Séquin 2009, section 2.2")
        .run(run_tile_solid);
}

Operator tile_assemble_operator()
{
    using P = TileAssemble;
    Definition<P> definition("tile.assemble", "Make a block of tiles, layer upon layer");
    definition.param(&P::nx, "nx", Unit::count, {1, 100}, "places of the lattice along its first vector")
        .param(&P::ny, "ny", Unit::count, {1, 100}, "and along its second")
        .param(&P::layers, "layers", Unit::count, {1, 100}, "layers")
        .param(&P::gap, "gap", Unit::length, at_least(0), "by which tiles are moved apart")
        .param(&P::color, "color", words({"aspect", "layer", "type"}), "what groups tell apart: aspects, layers, or the colouring in which neighbours differ");
    add_body(definition);
    return definition.example("tile.assemble nx=2 ny=2 layers=2 gap=0.1").cites("Howison & Séquin 2009, section 2").run(run_tile_assemble);
}

} // namespace druse
