// Operators on the shape of a cell in space.
#include "ops/cell.h"
#include "ops/cell_parameters.h"

#include <fmt/format.h>

#include <optional>

namespace druse {

namespace {

struct CellShape {};

struct CellMove {
    CellPoints points;
    std::optional<SpaceVector> by;
    std::optional<OrWord<SpaceVector>> along;
    std::optional<double> amount;
    std::optional<int> pane;
    std::optional<Point2> plane;
};

Vector direction_along(const CellTile& cell, const CellMove& p, const OrbitMember& last)
{
    const std::string& word = p.along->word;
    if (word == "x") return {1, 0, 0};
    if (word == "y") return {0, 1, 0};
    if (word == "z") return {0, 0, 1};
    if (word == "radial") return cell.radial(last);
    if (word == "normal") {
        const int pane = p.pane.value_or(cell.pane_of(last.orbit));
        if (pane < 0) throw CommandError(fmt::format("along=normal: {} is in several panes: say which, by pane=", cell.name(last.orbit).text()));
        if (pane >= cell.pane_count()) throw CellRefusal(CellRefusal::Reason::no_such_pane, fmt::format("the cell has {} pairs of panes, from 0 on", cell.pane_count()));
        return cell.normal(pane);
    }
    const Vector v = direction(p.along->value.v);
    if (v == Vector(0.0)) throw CommandError("along=0,0,0 is no direction");
    return v;
}

void run_cell_move(Scene& scene, const CellMove& p, Context& context)
{
    if (p.along.has_value() != p.amount.has_value()) throw CommandError("along= and amount= are given together");
    if (p.pane && !p.plane && !(p.along && p.along->word == "normal")) throw CommandError("pane= says whose plane or normal is meant: it goes with plane= or along=normal");
    if (p.plane && !p.pane) throw CommandError("plane= is of a pane: say which, by pane=");
    edit_cell(scene, context, [&](CellTile& cell) {
        if (cell.phase() != 2) throw CellRefusal(CellRefusal::Reason::phase, "points move in space after cell.shape");
        const std::vector<OrbitMember> members = p.points.resolve(cell, scene.mesh, *scene.selection);
        if (members.empty()) return;
        std::vector<int> points;
        for (const OrbitMember& member : members) points.push_back(member.orbit);
        if (p.plane && *p.pane >= cell.pane_count())
            throw CellRefusal(CellRefusal::Reason::no_such_pane, fmt::format("the cell has {} pairs of panes, from 0 on", cell.pane_count()));
        cell.move(points, p.by ? p.by->v : p.plane ? cell.in_plane(*p.pane, *p.plane) : *p.amount * direction_along(cell, p, members.back()));
    });
}

struct CellSplit {
    CellTriangle face;
    std::array<double, 3> at{};
};

struct CellSplitEdge {
    int pane = 0;
    CellPath edge;
    double t = 0.5;
};

struct CellFlip {
    int pane = 0;
    CellPath edge;
};

struct CellRollback {
    int pane = 0;
    bool keep = true;
};

} // namespace

Operator cell_shape_operator()
{
    return define<CellShape>("cell.shape", "Let the points of the cell move in space; panes that were rolled back come along")
        .keeps_euler()
        .example("cell.shape")
        .cites("Howison & Séquin 2009, section 3.1")
        .run([](Scene& scene, const CellShape&, Context& context) { edit_cell(scene, context, [](CellTile& cell) { cell.shape(); }); });
}

Operator cell_move_operator()
{
    using P = CellMove;
    return define<P>("cell.move", "Move points of the cell in space, with all that the lattice makes of them; before its skew")
        .param(&P::points, "points", Unit::none, {}, at_least(1), "names as c0, x0:1, p0:i0 or s0, or all, outline, interior, selected, none")
        .required()
        .param(&P::by, "by", Unit::length, {}, "dx,dy,dz")
        .param(&P::along, "along", Unit::ratio, {}, words({"radial", "normal", "x", "y", "z"}),
               "or a direction: from the centre through the last point, the normal of its pane, an axis, or dx,dy,dz of any length")
        .param(&P::amount, "amount", Unit::length, {}, "how far along that")
        .param(&P::pane, "pane", Unit::count, {0, 6}, "whose normal or plane is meant")
        .param(&P::plane, "plane", "or dx,dy in the plane of that pane")
        .exactly_one({"by", "along", "plane"})
        .keeps_euler()
        .example("cell.move points=c0,p0:i0 along=radial amount=0.05")
        .cites("Howison & Séquin 2009, section 3.1")
        .run(run_cell_move);
}

Operator cell_split_operator()
{
    using P = CellSplit;
    return define<P>("cell.split", "Split a triangle of a pane in three, and that of the far pane")
        .param(&P::face, "face", "pane and number of the triangle, as p0:1")
        .required()
        .param(&P::at, "at", Unit::ratio, between(0, 1), "where: the weights of its corners, 1 together")
        .required()
        .keeps_euler()
        .example("cell.split face=p0:0 at=0.25,0.25,0.5")
        .cites("Howison & Séquin 2009, section 3.1")
        .run([](Scene& scene, const P& p, Context& context) {
            edit_cell(scene, context, [&](CellTile& cell) { cell.split_triangle(p.face.pane, p.face.triangle, p.at); });
        });
}

Operator cell_split_edge_operator()
{
    using P = CellSplitEdge;
    return define<P>("cell.split_edge", "Split an edge of a pane, and all triangles that it is a side of")
        .param(&P::pane, "pane", Unit::count, {0, 6}, "in which pair of panes")
        .param(&P::edge, "edge", Unit::none, {}, Range{2, 2}, "its two ends, as v0,i0; a split on two sides of the pane is s0@2 on side 2")
        .required()
        .param(&P::t, "t", Unit::ratio, between(0, 1), "where, from the first to the second")
        .keeps_euler()
        .example("cell.split_edge pane=0 edge=v0,v1 t=0.4")
        .cites("Howison & Séquin 2009, section 3.1")
        .run([](Scene& scene, const P& p, Context& context) {
            edit_cell(scene, context, [&](CellTile& cell) { cell.split_edge(p.pane, p.edge.points[0], p.edge.points[1], p.t); });
        });
}

Operator cell_flip_operator()
{
    using P = CellFlip;
    return define<P>("cell.flip", "Turn an edge between two triangles of a pane into the other diagonal")
        .param(&P::pane, "pane", Unit::count, {0, 6}, "in which pair of panes")
        .param(&P::edge, "edge", Unit::none, {}, Range{2, 2}, "its two ends, as v0,i0; a split on two sides of the pane is s0@2 on side 2")
        .required()
        .keeps_euler()
        .example("cell.flip pane=1 edge=v1,i0")
        .cites("Howison & Séquin 2009, section 3.1")
        .run([](Scene& scene, const P& p, Context& context) {
            edit_cell(scene, context, [&](CellTile& cell) { cell.flip(p.pane, p.edge.points[0], p.edge.points[1]); });
        });
}

Operator cell_rollback_operator()
{
    using P = CellRollback;
    return define<P>("cell.rollback", "Make one pair of panes flat again, to edit its points and lines; cell.shape takes it back into space")
        .param(&P::pane, "pane", Unit::count, {0, 6}, "which pair of panes")
        .param(&P::keep, "keep", "its points stay moved, and new ones go with them; else they begin anew")
        .keeps_euler()
        .example("cell.rollback pane=0")
        .cites("Howison & Séquin 2009, section 3.1")
        .run([](Scene& scene, const P& p, Context& context) { edit_cell(scene, context, [&](CellTile& cell) { cell.roll_back(p.pane, p.keep); }); });
}

} // namespace druse
