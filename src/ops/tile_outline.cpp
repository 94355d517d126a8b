// Operators on the frame and the outline of a tile.
#include "ops/tile.h"
#include "ops/tile_parameters.h"
#include "tile/tile_look.h"

#include <fmt/format.h>

#include <optional>

namespace druse {

namespace {

constexpr const char* howison = "Howison & Séquin 2009, section 2";

struct TileSwitch {
    TileTypeNumber type;
};

struct TileFrameParameters {
    std::optional<double> size, rotation;
    std::optional<Point2> origin;
};

struct TileParam {
    std::optional<std::vector<double>> values;
    std::optional<int> index;
    std::optional<double> value;
};

void run_tile_param(Scene& scene, const TileParam& p, Context& context)
{
    edit_tile(scene, context, [&](LayeredTile& tile) {
        std::vector<double> values = tile.design().parameters;
        if (p.values) {
            values = *p.values;
        } else {
            if (!p.value) throw CommandError(fmt::format("index={} is given without value=, what that parameter becomes", *p.index));
            if (*p.index >= std::ssize(values)) tile.type().corners_of(std::vector<double>(values.size() + 1)); // which says what there are
            values[static_cast<std::size_t>(*p.index)] = *p.value;
        }
        if (p.values && p.value) throw CommandError("value= goes with index=");
        tile.set_parameters(values);
    });
}

struct TileCorner {
    int corner = 0;
    Point2 to{0.0};
};

struct TileEdgeParameters {
    int path = 0;
    std::vector<Point2> points;
};

struct TilePlace {
    Point2 at{0.0};
};

struct TileEdgeMove {
    PointName point;
    std::optional<Point2> to, uv;
};

struct TilePoint {
    PointName point;
};

} // namespace

Operator tile_type_operator()
{
    return define<TileSwitch>("tile.type", "Make the tile one of another type, with what of its paths and points still fits")
        .param(&TileSwitch::type, "type", "IH01 to IH93")
        .required()
        .keeps_euler()
        .example("tile.type type=IH28")
        .cites("Grünbaum & Shephard 1987, ch. 6")
        .run([](Scene& scene, const TileSwitch& p, Context& context) { edit_tile(scene, context, [&](LayeredTile& tile) { tile.switch_type(p.type.number); }); });
}

Operator tile_frame_operator()
{
    using P = TileFrameParameters;
    return define<P>("tile.frame", "Resize, turn and move the whole tiling")
        .param(&P::size, "size", Unit::length, above(0), "new size; what is inside grows along, heights stay")
        .param(&P::rotation, "rotation", Unit::degrees, {-360, 360}, "new turn")
        .param(&P::origin, "origin", "new x,y of the corner that the type holds")
        .keeps_euler()
        .example("tile.frame size=30")
        .cites(howison)
        .run([](Scene& scene, const P& p, Context& context) {
            edit_tile(scene, context, [&](LayeredTile& tile) {
                const TileDesign& now = tile.design();
                const double size = p.size.value_or(now.size), factor = size / now.size;
                tile.set_frame(size, p.rotation.value_or(now.rotation), p.origin.value_or(now.origin));
                TileLook drawn = look(tile.design());
                if (!drawn.trace || factor == 1) return;
                for (double& x : drawn.trace->place) x *= factor; // the picture stays where it is seen on the tile
                tile = with_look(tile, drawn);
            });
        });
}

Operator tile_param_operator()
{
    return define<TileParam>("tile.param", "Set parameters of the tile: coordinates of corners that its type leaves free, at size 1")
        .param(&TileParam::values, "values", Unit::ratio, {}, at_least(1), "all of them")
        .param(&TileParam::index, "index", Unit::count, at_least(0), "or which one, from 0")
        .param(&TileParam::value, "value", Unit::ratio, {}, "and its value")
        .exactly_one({"values", "index"})
        .keeps_euler()
        .example("tile.param index=0 value=1.1")
        .cites("Grünbaum & Shephard 1987, ch. 6")
        .run(run_tile_param);
}

Operator tile_corner_operator()
{
    return define<TileCorner>("tile.corner", "Move a corner of the tile as near to a place as its type lets it come")
        .param(&TileCorner::corner, "corner", Unit::count, {0, 5}, "which one, from 0")
        .required()
        .param(&TileCorner::to, "to", "x,y in the tile frame")
        .required()
        .keeps_euler()
        .example("tile.corner corner=2 to=1.2,1.1")
        .cites(howison)
        .run([](Scene& scene, const TileCorner& p, Context& context) { edit_tile(scene, context, [&](LayeredTile& tile) { tile.drag_corner(p.corner, p.to); }); });
}

Operator tile_edge_operator()
{
    using P = TileEdgeParameters;
    return define<P>("tile.edge", "Give all edges with one path another path")
        .param(&P::path, "path", Unit::count, at_least(0), "which path")
        .param(&P::points, "points", Unit::ratio, {}, at_least(0), "u,v of its inner points, where it runs from 0,0 to 1,0; the first half of those that are the same backwards")
        .required()
        .keeps_euler()
        .example("tile.edge path=0 points=0.25,0.2,0.75,-0.125")
        .cites(howison)
        .run([](Scene& scene, const P& p, Context& context) { edit_tile(scene, context, [&](LayeredTile& tile) { tile.set_path(p.path, p.points); }); });
}

Operator tile_edge_add_operator()
{
    return define<TilePlace>("tile.edge_add", "Add a point to the outline where it is nearest to a place, and draw it there")
        .param(&TilePlace::at, "at", "x,y in the tile frame")
        .required()
        .keeps_euler()
        .example("tile.edge_add at=0.5,-0.1")
        .cites(howison)
        .run([](Scene& scene, const TilePlace& p, Context& context) {
            edit_tile(scene, context, [&](LayeredTile& tile) { context.note("made " + tile.add_path_point(p.at).text()); });
        });
}

Operator tile_edge_move_operator()
{
    using P = TileEdgeMove;
    return define<P>("tile.edge_move", "Move a point of a path, on all edges that have it")
        .param(&P::point, "point", "which one, as e0:1")
        .required()
        .param(&P::to, "to", "x,y in the tile frame")
        .param(&P::uv, "uv", "or u,v in the frame of the path")
        .exactly_one({"to", "uv"})
        .keeps_euler()
        .example("tile.edge_move point=e0:1 uv=0.3,0.15")
        .cites(howison)
        .run([](Scene& scene, const P& p, Context& context) {
            edit_tile(scene, context, [&](LayeredTile& tile) {
                if (p.to) tile.move_path_point(p.point, *p.to);
                else tile.move_path_point_in_path(p.point, *p.uv);
            });
        });
}

Operator tile_edge_remove_operator()
{
    return define<TilePoint>("tile.edge_remove", "Remove a point of a path, from all edges that have it")
        .param(&TilePoint::point, "point", "which one, as e0:1")
        .required()
        .keeps_euler()
        .example("tile.edge_remove point=e0:1")
        .cites(howison)
        .run([](Scene& scene, const TilePoint& p, Context& context) { edit_tile(scene, context, [&](LayeredTile& tile) { tile.remove_path_point(p.point); }); });
}

} // namespace druse
