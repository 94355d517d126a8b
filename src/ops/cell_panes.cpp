// Operators on points and lines of a cell's panes while they are flat.
#include "ops/cell.h"
#include "ops/cell_parameters.h"
#include "ops/pane.h"

#include <optional>
#include <vector>

namespace druse {

namespace {

struct CellPointAdd {
    int pane = 0;
    Point2 at{0.0};
};

struct CellPointMove {
    CellPointName point;
    Point2 to{0.0};
};

struct CellPointRemove {
    CellPath point;
};

struct CellEdgeAdd {
    int edge = 0;
    double t = 0.5;
};

struct CellSegment {
    int pane = 0;
    std::optional<CellPointName> from, to;
    std::optional<CellPath> path;

    std::vector<CellPointName> points() const
    {
        if (from.has_value() != to.has_value()) throw CommandError("from= and to= are given together");
        return path ? path->points : std::vector{*from, *to};
    }
};

struct CellRefine {
    int pane = 0;
    double min_angle = 20;
    std::optional<double> max_area;
};

void run_cell_refine(Scene& scene, const CellRefine& p, Context& context)
{
    Pane::Refined refined;
    edit_cell(scene, context, [&](CellTile& cell) { refined = cell.refine(p.pane, {p.min_angle, p.max_area, false}, &context.progress); });
    tell(refined, context);
}

Definition<CellSegment> cell_segment_definition(std::string_view name, std::string_view help)
{
    Definition<CellSegment> definition(name, help);
    definition.param(&CellSegment::pane, "pane", Unit::count, {0, 6}, "in which pair of panes")
        .param(&CellSegment::from, "from", "point at which it begins, as v0, e1:2 or i0")
        .param(&CellSegment::to, "to", "point at which it ends")
        .param(&CellSegment::path, "path", Unit::none, {}, at_least(2), "points that it runs along instead")
        .exactly_one({"from", "path"})
        .keeps_euler()
        .cites("Howison & Séquin 2009, section 3.1");
    return definition;
}

} // namespace

Operator cell_point_add_operator()
{
    using P = CellPointAdd;
    return define<P>("cell.point_add", "Add a point to a pair of panes, or find the one that is there; on a side it becomes one of that edge's orbit")
        .param(&P::pane, "pane", Unit::count, {0, 6}, "which pair of panes")
        .param(&P::at, "at", "x,y in the pane, from its centre")
        .required()
        .keeps_euler()
        .example("cell.point_add pane=0 at=0.1,0.05")
        .cites("Howison & Séquin 2009, section 3.1")
        .run([](Scene& scene, const P& p, Context& context) { edit_cell(scene, context, [&](CellTile& cell) { cell.add_point(p.pane, p.at); }); });
}

Operator cell_point_move_operator()
{
    using P = CellPointMove;
    return define<P>("cell.point_move", "Move a point in its flat pane with all its lines; onto another point, the two become one")
        .param(&P::point, "point", "which one, as p0:i1")
        .required()
        .param(&P::to, "to", "x,y in the pane, from its centre")
        .required()
        .keeps_euler()
        .example("cell.point_move point=p1:i0 to=0.1,0.1")
        .cites("Howison & Séquin 2009, section 3.1")
        .run([](Scene& scene, const P& p, Context& context) { edit_cell(scene, context, [&](CellTile& cell) { cell.move_point(p.point, p.to); }); });
}

Operator cell_point_remove_operator()
{
    using P = CellPointRemove;
    return define<P>("cell.point_remove", "Remove points of flat panes; those behind them are numbered anew")
        .param(&P::point, "point", Unit::none, {}, at_least(1), "which ones, as p0:i1; points of edges, as x0:1, may be among them")
        .required()
        .keeps_euler()
        .example("cell.point_remove point=p1:i0")
        .cites("Howison & Séquin 2009, section 3.1")
        .run([](Scene& scene, const P& p, Context& context) { edit_cell(scene, context, [&](CellTile& cell) { cell.remove_points(p.point.points); }); });
}

Operator cell_edge_add_operator()
{
    using P = CellEdgeAdd;
    return define<P>("cell.edge_add", "Add a point to an orbit of edges, on all panes that have one of them")
        .param(&P::edge, "edge", Unit::count, {0, 11}, "which orbit")
        .param(&P::t, "t", Unit::ratio, between(0, 1), "where between its ends")
        .keeps_euler()
        .example("cell.edge_add edge=0 t=0.5")
        .cites("Howison & Séquin 2009, section 3.1")
        .run([](Scene& scene, const P& p, Context& context) { edit_cell(scene, context, [&](CellTile& cell) { cell.add_edge_point(p.edge, p.t); }); });
}

Operator cell_edge_remove_operator()
{
    using P = CellPointRemove;
    return define<P>("cell.edge_remove", "Remove points of orbits of edges")
        .param(&P::point, "point", Unit::none, {}, at_least(1), "which ones, as x0:1")
        .required()
        .keeps_euler()
        .example("cell.edge_remove point=x1:1")
        .cites("Howison & Séquin 2009, section 3.1")
        .run([](Scene& scene, const P& p, Context& context) { edit_cell(scene, context, [&](CellTile& cell) { cell.remove_edge_points(p.point.points); }); });
}

Operator cell_constrain_operator()
{
    return cell_segment_definition("cell.constrain", "Draw a line in a flat pane: straight pieces that are kept as edges")
        .example("cell.constrain pane=1 from=v0 to=i0")
        .run([](Scene& scene, const CellSegment& p, Context& context) { edit_cell(scene, context, [&](CellTile& cell) { cell.constrain(p.pane, p.points()); }); });
}

Operator cell_unconstrain_operator()
{
    return cell_segment_definition("cell.unconstrain", "Remove a line of a flat pane; its points stay")
        .example("cell.unconstrain pane=1 from=v1 to=i0")
        .run([](Scene& scene, const CellSegment& p, Context& context) { edit_cell(scene, context, [&](CellTile& cell) { cell.unconstrain(p.pane, p.points()); }); });
}

Operator cell_refine_operator()
{
    using P = CellRefine;
    return define<P>("cell.refine", "Add points inside a flat pane until its triangles have no small angles")
        .param(&P::pane, "pane", Unit::count, {0, 6}, "which pair of panes")
        .param(&P::min_angle, "min_angle", Unit::degrees, {0, 30}, "the least angle; beyond 20.7 it may take too many points, which is said")
        .param(&P::max_area, "max_area", Unit::area, above(0), "the largest area of a triangle")
        .keeps_euler()
        .example("cell.refine pane=1 min_angle=25")
        .cites("Ruppert 1995; Shewchuk 2002")
        .run(run_cell_refine);
}

} // namespace druse
