// Operators on the points of a pane.
#include "ops/pane.h"
#include "ops/pane_parameters.h"

#include <fmt/format.h>

#include <optional>

namespace druse {

namespace {

struct PaneAdd {
    Point2 at{0};
    std::optional<PaneEdge> edge;
    bool strict = false;
};

void run_pane_add(Scene& scene, const PaneAdd& p, Context& context)
{
    PointId point{};
    edit_pane(scene, context, [&](Pane& pane) { point = pane.add(p.at, p.edge, p.strict); });
    if (pane_of(scene).report().made.empty()) context.note(fmt::format("coincides: point {} is there already", std::uint32_t(point)));
}

struct PaneAddBoundary {
    Point2 at{0};
    std::optional<PaneEdge> edge;
};

struct PaneMove {
    PointId point{};
    Point2 to{0};
};

struct PaneRemove {
    PointId point{};
    Pane::Through segments = Pane::Through::join;
};

struct PaneLock {
    std::vector<PointId> points;
    bool on = true;
};

} // namespace

Operator pane_add_operator()
{
    return define<PaneAdd>("pane.add", "Add a point to the pane, or find the one that is there; on an edge it splits that edge")
        .param(&PaneAdd::at, "at", "x,y")
        .required()
        .param(&PaneAdd::edge, "edge", "the edge to split, by its ends; unset: the nearest line, if one is within snap")
        .param(&PaneAdd::strict, "strict", "fail where a point is already")
        .keeps_euler()
        .example("pane.add at=1,1")
        .cites("Lawson 1977; Devillers, Pion & Teillaud 2002")
        .run(run_pane_add);
}

Operator pane_add_boundary_operator()
{
    using P = PaneAddBoundary;
    return define<P>("pane.add_boundary", "Split an edge of the pane's boundary, and take the new point to a place")
        .param(&P::at, "at", "x,y, also outside")
        .required()
        .param(&P::edge, "edge", "the edge to split, by its ends; unset: the nearest")
        .keeps_euler()
        .example("pane.add_boundary at=5,-1")
        .cites("Howison & Séquin 2009")
        .run([](Scene& scene, const P& p, Context& context) { edit_pane(scene, context, [&](Pane& pane) { pane.add_boundary(p.at, p.edge); }); });
}

Operator pane_move_operator()
{
    return define<PaneMove>("pane.move", "Move a point of the pane with all its lines; onto another point, the two become one")
        .param(&PaneMove::point, "point", "which one")
        .required()
        .param(&PaneMove::to, "to", "x,y")
        .required()
        .keeps_euler()
        .example("pane.move point=1 to=11,-1")
        .cites("Howison & Séquin 2009")
        .run([](Scene& scene, const PaneMove& p, Context& context) { edit_pane(scene, context, [&](Pane& pane) { pane.move(p.point, p.to); }); });
}

Operator pane_remove_operator()
{
    return define<PaneRemove>("pane.remove", "Remove a point of the pane; at the boundary two edges become one")
        .param(&PaneRemove::point, "point", "which one")
        .required()
        .param(&PaneRemove::segments, "segments", words({"join", "cut"}), "what becomes of segments through it: they run on straight, or end before it")
        .keeps_euler()
        .example("pane.remove point=7")
        .cites("Devillers 2002")
        .run([](Scene& scene, const PaneRemove& p, Context& context) { edit_pane(scene, context, [&](Pane& pane) { pane.remove(p.point, p.segments); }); });
}

Operator pane_lock_operator()
{
    return define<PaneLock>("pane.lock", "Lock points of the pane: they may not be moved or removed")
        .param(&PaneLock::points, "points", Unit::id, at_least(0), at_least(1), "which ones")
        .required()
        .param(&PaneLock::on, "on", "false frees them")
        .keeps_euler()
        .example("pane.lock points=0,2")
        .cites("Howison & Séquin 2009")
        .run([](Scene& scene, const PaneLock& p, Context& context) { edit_pane(scene, context, [&](Pane& pane) { pane.lock(p.points, p.on); }); });
}

} // namespace druse
