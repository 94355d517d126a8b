// tile.*: layered Escher tiles. Here what all of them share, tile.new, and the questions.
#include "ops/tile.h"

#include "ops/registry.h"
#include "ops/tile_parameters.h"
#include "tile/tile_check.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <optional>

namespace druse {

const LayeredTile& tile_of(const Scene& scene) { return held<LayeredTile>(scene.source, "tile", "tile.new makes one"); }

namespace {

struct TileNew {
    TileTypeNumber type;
    double size = 1, rotation = 0;
    Point2 origin{0.0};
    std::optional<std::vector<double>> params;
};

void run_tile_new(Scene& scene, const TileNew& p, Context&)
{
    const IsohedralType& type = isohedral_type(p.type.number);
    TileDesign design;
    design.type = p.type.number;
    design.size = p.size;
    design.rotation = p.rotation;
    design.origin = p.origin;
    design.parameters = p.params ? *p.params : type.default_parameters();
    design.paths.resize(type.shapes.size());
    scene.source.replace_with(LayeredTile(std::move(design)));
}

struct TileCheckParameters {
    bool strict = false;
    double clearance = 0, min_thickness = 0.4;
};

void run_tile_check(Scene& scene, const TileCheckParameters& p, Context& context)
{
    const LayeredTile& tile = tile_of(scene);
    const TileCheck found = check(tile, p.clearance);
    nlohmann::ordered_json json;
    json["sound"] = found.sound();
    json["faults"] = found.faults;
    json["type"] = tile.type().name();
    json["aspects"] = found.aspects;
    json["orbits"] = found.orbits;
    json["area"] = found.area;
    json["cell"] = found.cell;
    json["edge_mismatch"] = found.edge_mismatch;
    json["solids"] = nlohmann::ordered_json::array();
    for (const TilePart& part : found.parts) json["solids"].push_back({{"aspect", part.aspect}, {"member", part.member}, {"layer", part.layer}, {"mirrored", part.mirrored}});
    if (const auto& solid = found.solid) {
        json["volume"] = solid->volume;
        json["volume_expected"] = solid->volume_expected;
        json["carved_area"] = solid->carved_area;
        json["bottom_mismatch"] = solid->bottom_mismatch;
        json["aspect_mismatch"] = solid->aspect_mismatch;
        json["members"] = solid->members;
        json["min_thickness"] = solid->thinnest.thickness;
        json["thinnest_at"] = {solid->thinnest.at.x, solid->thinnest.at.y};
        json["thick_enough"] = solid->thinnest.thickness >= p.min_thickness;
        json["leaves"] = solid->leaves;
        if (solid->leaves.empty()) context.note("tiles are locked: none leaves the stack");
        if (p.clearance > 0) {
            json["clearance"] = solid->clearance;
            json["volume_left"] = solid->volume_left;
            json["area_lost"] = solid->lost;
        }
    }
    context.output = json.dump();
    context.failed = p.strict && !found.sound();
}

} // namespace

Operator tile_new_operator()
{
    return define<TileNew>("tile.new", "Make a tile of one of the 81 isohedral types, with straight edges")
        .param(&TileNew::type, "type", "IH01 to IH93")
        .required()
        .param(&TileNew::size, "size", Unit::length, above(0), "how large: edges are about that long")
        .param(&TileNew::params, "params", Unit::ratio, {}, at_least(0), "coordinates of corners that the type leaves free, at size 1; unset: those of the regular net")
        .param(&TileNew::rotation, "rotation", Unit::degrees, {-360, 360}, "turn of the whole tiling")
        .param(&TileNew::origin, "origin", "x,y of the corner that the type holds")
        .keeps_euler()
        .example("tile.new type=IH79 size=20")
        .cites("Grünbaum & Shephard 1987, ch. 6")
        .run(run_tile_new);
}

Operator tile_check_operator()
{
    using P = TileCheckParameters;
    return define<P>("tile.check", "Say whether copies of the tile fill plane and space, and how thick it is")
        .param(&P::strict, "strict", "fail where anything is wrong")
        .param(&P::clearance, "clearance", Unit::length, at_least(0), "width of the joints to look at too; 0: none")
        .param(&P::min_thickness, "min_thickness", Unit::length, at_least(0), "what is thick enough")
        .keeps_euler()
        .example("tile.check strict=true")
        .cites("Howison & Séquin 2009, section 2")
        .query()
        .run(run_tile_check);
}

void register_tile(Registry& registry)
{
    for (const auto& make :
         {tile_new_operator, tile_type_operator, tile_frame_operator, tile_param_operator, tile_corner_operator, tile_edge_operator, tile_edge_add_operator,
          tile_edge_move_operator, tile_edge_remove_operator, tile_point_add_operator, tile_point_move_operator, tile_point_remove_operator,
          tile_constrain_operator, tile_unconstrain_operator, tile_refine_operator, tile_stack_operator, tile_extrude_operator, tile_height_operator,
          tile_height_smooth_operator, tile_height_ridge_operator, tile_height_dome_operator, tile_solid_operator, tile_assemble_operator, tile_trace_operator,
          tile_colors_operator, tile_check_operator})
        registry.add(make());
}

} // namespace druse
