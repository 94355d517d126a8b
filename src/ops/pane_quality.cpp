// Operators that make the triangles of a pane better.
#include "ops/pane.h"
#include "ops/parameter.h"

#include <fmt/format.h>

#include <optional>

namespace druse {

/// An angle that refinement can promise; a larger one is refused by the pane's own word.
struct RefinedAngle {
    double degrees = 20;
};

template <>
struct ParameterType<RefinedAngle> {
    static constexpr auto type = Parameter::Type::number;
    static RefinedAngle parse(std::string_view t, const Domain& d)
    {
        const double degrees = ParameterType<double>::parse(t, {d.unit, {}, {}, {}});
        if (degrees > d.range.max) throw CommandError(fmt::format("angle-too-large: expected {} degrees", d.range.text()));
        return {ParameterType<double>::parse(t, d)};
    }
    static std::string text(RefinedAngle x, const Domain&) { return number_text(x.degrees); }
};

namespace {

enum class RefinedBoundary { keep, split };

struct PaneRefine {
    RefinedAngle min_angle;
    std::optional<double> max_area;
    RefinedBoundary boundary = RefinedBoundary::keep;
};

void run_refine(Scene& scene, const PaneRefine& p, Context& context)
{
    Pane::Refined refined;
    const bool split = p.boundary == RefinedBoundary::split;
    edit_pane(scene, context, [&](Pane& pane) { refined = pane.refine({p.min_angle.degrees, p.max_area, split}, &context.progress); });
    tell(refined, context);
}

struct PaneSpread {
    int rounds = 5;
};

} // namespace

void tell(const Pane::Refined& refined, Context& context)
{
    if (!refined.complete) context.note(fmt::format("stopped at {} new points, as many as are allowed", refined.made));
    if (refined.falling_short == 0) return;
    const std::string larger = refined.too_large == 0 ? "" : fmt::format("; {} of them larger", refined.too_large);
    context.note(fmt::format("{} triangle{} still fall{} short of what was asked for{}", refined.falling_short, refined.falling_short == 1 ? "" : "s",
                             refined.falling_short == 1 ? "s" : "", larger));
}

Operator pane_refine_operator()
{
    using P = PaneRefine;
    return define<P>("pane.refine", "Add points to the pane until its triangles have no small angles")
        .param(&P::min_angle, "min_angle", Unit::degrees, {0, 30}, "the least angle; beyond 20.7 it may take too many points, which is said")
        .param(&P::max_area, "max_area", Unit::area, above(0), "the largest area of a triangle, also beside a boundary that is kept")
        .param(&P::boundary, "boundary", words({"keep", "split"}), "whether edges of the boundary may be split; if not, angles beside it may stay small")
        .keeps_euler()
        .example("pane.refine min_angle=25 boundary=split")
        .cites("Ruppert 1995; Shewchuk 2002")
        .run(run_refine);
}

Operator pane_unrefine_operator()
{
    return define<NoParameters>("pane.unrefine", "Remove the points that the last refinement of the pane made")
        .keeps_euler()
        .example("pane.unrefine")
        .cites("Devillers 2002")
        .run([](Scene& scene, const NoParameters&, Context& context) { edit_pane(scene, context, [](Pane& pane) { pane.unrefine(); }); });
}

Operator pane_spread_operator()
{
    using P = PaneSpread;
    return define<P>("pane.spread", "Move free points of the pane apart, each to the middle of what is nearest to it")
        .param(&P::rounds, "rounds", Unit::count, {1, 100}, "how often")
        .keeps_euler()
        .example("pane.spread rounds=10")
        .cites("Lloyd 1982")
        .run([](Scene& scene, const P& p, Context& context) { edit_pane(scene, context, [&](Pane& pane) { pane.spread(p.rounds); }); });
}

} // namespace druse
