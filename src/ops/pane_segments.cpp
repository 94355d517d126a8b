// Operators on the segments of a pane.
#include "ops/pane.h"
#include "ops/pane_parameters.h"

#include <array>
#include <optional>

namespace druse {

namespace {

struct PaneConstrain {
    std::optional<PointId> from, to;
    std::optional<std::vector<PointId>> path;
    std::optional<std::vector<Point2>> line;
};

struct PaneUnconstrain {
    std::optional<SegmentId> segment;
    std::optional<PointId> from, to;
};

void require_both(const std::optional<PointId>& from, const std::optional<PointId>& to)
{
    if (from.has_value() != to.has_value()) throw CommandError("from= and to= are given together");
}

void run_constrain(Scene& scene, const PaneConstrain& p, Context& context)
{
    require_both(p.from, p.to);
    edit_pane(scene, context, [&](Pane& pane) {
        if (p.path) pane.constrain(*p.path);
        else if (p.line) pane.constrain_line(*p.line);
        else pane.constrain(*p.from, *p.to);
    });
}

void run_unconstrain(Scene& scene, const PaneUnconstrain& p, Context& context)
{
    require_both(p.from, p.to);
    edit_pane(scene, context, [&](Pane& pane) {
        if (p.segment) pane.unconstrain(*p.segment);
        else pane.unconstrain(*p.from, *p.to);
    });
}

} // namespace

Operator pane_constrain_operator()
{
    using P = PaneConstrain;
    return define<P>("pane.constrain", "Draw a segment in the pane: straight pieces that are kept as edges")
        .param(&P::from, "from", "point at which it begins")
        .param(&P::to, "to", "point at which it ends")
        .param(&P::path, "path", Unit::id, at_least(0), at_least(2), "points that it runs along instead")
        .param(&P::line, "line", Unit::length, {-1e150, 1e150}, at_least(4), "x,y of places that it runs along instead; points are made as needed")
        .exactly_one({"from", "path", "line"})
        .keeps_euler()
        .example("pane.constrain line=1,1,9,2,9,8")
        .cites("Anglada 1997")
        .run(run_constrain);
}

Operator pane_unconstrain_operator()
{
    using P = PaneUnconstrain;
    return define<P>("pane.unconstrain", "Remove a segment from the pane, and crossings that only it made")
        .param(&P::segment, "segment", "which one")
        .param(&P::from, "from", "or a point at which it ends")
        .param(&P::to, "to", "and the other")
        .exactly_one({"segment", "from"})
        .keeps_euler()
        .example("pane.unconstrain segment=0")
        .cites("Howison & Séquin 2009")
        .run(run_unconstrain);
}

} // namespace druse
