// Operators on points and segments inside a tile.
#include "ops/pane.h"
#include "ops/tile.h"
#include "ops/tile_parameters.h"

#include <array>
#include <optional>

namespace druse {

namespace {

struct TilePointAdd {
    Point2 at{0.0};
};

struct TilePointMove {
    PointName point;
    Point2 to{0.0};
};

struct TilePointRemove {
    PointName point;
};

struct TileSegment {
    std::optional<PointName> from, to;
    std::optional<TilePoints> path;

    std::vector<PointName> points() const
    {
        if (from.has_value() != to.has_value()) throw CommandError("from= and to= are given together");
        if (!path) return {*from, *to};
        std::vector<PointName> names;
        for (const std::string& word : path->words) names.push_back(PointName::parse(word));
        return names;
    }
};

struct TileRefine {
    double min_angle = 20;
    std::optional<double> max_area;
};

void run_tile_refine(Scene& scene, const TileRefine& p, Context& context)
{
    Pane::Refined refined;
    edit_tile(scene, context, [&](LayeredTile& tile) { refined = tile.refine({p.min_angle, p.max_area, false}, &context.progress); });
    tell(refined, context);
}

Definition<TileSegment> segment_definition(std::string_view name, std::string_view help)
{
    Definition<TileSegment> definition(name, help);
    definition.param(&TileSegment::from, "from", "point at which it begins, as e0:1 or i0")
        .param(&TileSegment::to, "to", "point at which it ends")
        .param(&TileSegment::path, "path", Unit::none, {}, at_least(2), "points that it runs along instead")
        .exactly_one({"from", "path"})
        .keeps_euler()
        .cites("Howison & Séquin 2009, section 2.1");
    return definition;
}

} // namespace

Operator tile_point_add_operator()
{
    return define<TilePointAdd>("tile.point_add", "Add a point inside the tile, or find the one that is there; on the outline it becomes a point of a path")
        .param(&TilePointAdd::at, "at", "x,y in the tile frame")
        .required()
        .keeps_euler()
        .example("tile.point_add at=0.3,0.6")
        .cites("Howison & Séquin 2009, section 2.1")
        .run([](Scene& scene, const TilePointAdd& p, Context& context) { edit_tile(scene, context, [&](LayeredTile& tile) { tile.add_point(p.at); }); });
}

Operator tile_point_move_operator()
{
    return define<TilePointMove>("tile.point_move", "Move a point inside the tile with all its lines; onto another point, the two become one")
        .param(&TilePointMove::point, "point", "which one, as i0")
        .required()
        .param(&TilePointMove::to, "to", "x,y in the tile frame")
        .required()
        .keeps_euler()
        .example("tile.point_move point=i0 to=0.4,0.5")
        .cites("Howison & Séquin 2009, section 2.1")
        .run([](Scene& scene, const TilePointMove& p, Context& context) { edit_tile(scene, context, [&](LayeredTile& tile) { tile.move_point(p.point, p.to); }); });
}

Operator tile_point_remove_operator()
{
    return define<TilePointRemove>("tile.point_remove", "Remove a point inside the tile; those behind it are numbered anew")
        .param(&TilePointRemove::point, "point", "which one, as i0")
        .required()
        .keeps_euler()
        .example("tile.point_remove point=i0")
        .cites("Howison & Séquin 2009, section 2.1")
        .run([](Scene& scene, const TilePointRemove& p, Context& context) { edit_tile(scene, context, [&](LayeredTile& tile) { tile.remove_point(p.point); }); });
}

Operator tile_constrain_operator()
{
    return segment_definition("tile.constrain", "Draw a line inside the tile: straight pieces that are kept as edges")
        .example("tile.constrain from=v0 to=i0")
        .run([](Scene& scene, const TileSegment& p, Context& context) { edit_tile(scene, context, [&](LayeredTile& tile) { tile.constrain(p.points()); }); });
}

Operator tile_unconstrain_operator()
{
    return segment_definition("tile.unconstrain", "Remove a line inside the tile; its points stay")
        .example("tile.unconstrain from=v1 to=i0")
        .run([](Scene& scene, const TileSegment& p, Context& context) { edit_tile(scene, context, [&](LayeredTile& tile) { tile.unconstrain(p.points()); }); });
}

Operator tile_refine_operator()
{
    return define<TileRefine>("tile.refine", "Add points inside the tile until its triangles have no small angles")
        .param(&TileRefine::min_angle, "min_angle", Unit::degrees, {0, 30}, "the least angle; beyond 20.7 it may take too many points, which is said")
        .param(&TileRefine::max_area, "max_area", Unit::area, above(0), "the largest area of a triangle, also beside the outline, which is kept")
        .keeps_euler()
        .example("tile.refine min_angle=25")
        .cites("Ruppert 1995; Shewchuk 2002")
        .run(run_tile_refine);
}

} // namespace druse
