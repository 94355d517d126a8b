// pane.*: flat outlines with points and lines in them. Here what all of them share, pane.new and pane.check.
#include "ops/pane.h"

#include "ops/pane_parameters.h"
#include "ops/registry.h"
#include "pane/pane_check.h"
#include "pane/pane_record.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <optional>

namespace druse {

const Pane& pane_of(const Scene& scene) { return held<Pane>(scene.source, "pane", "pane.new makes one"); }

void tell(const Pane& pane, Context& context)
{
    constexpr std::size_t most_named = 20;
    const PaneReport& report = pane.report();
    for (const std::string& note : report.notes) context.note(note);
    for (const auto& [gone, into] : report.merged) context.note(fmt::format("merged: point {} is now point {}", std::uint32_t(gone), std::uint32_t(into)));
    std::string crossings;
    std::size_t count = 0;
    for (const PointId made : report.made)
        if (pane.exists(made) && pane.kind(made) == PointKind::crossing && ++count <= most_named)
            crossings.append(crossings.empty() ? "" : ",").append(std::to_string(std::uint32_t(made)));
    if (count > most_named) context.note(fmt::format("crossing: {} points", count));
    else if (count > 0) context.note(fmt::format("crossing: point{} {}", count == 1 ? "" : "s", crossings));
}

namespace {

constexpr double largest_place = 1e150;

struct PaneNew {
    std::vector<Point2> loop;
    std::optional<std::vector<std::vector<Point2>>> holes;
    std::optional<double> snap, weld;
};

void run_pane_new(Scene& scene, const PaneNew& p, Context& context)
{
    Pane pane(p.loop, p.holes.value_or(std::vector<std::vector<Point2>>()), {p.snap, p.weld});
    tell(pane, context);
    scene.source.replace_with(std::move(pane));
}

struct PaneCheckParameters {
    bool strict = false;
    double nozzle = 0.4;
};

void run_pane_check(Scene& scene, const PaneCheckParameters& p, Context& context)
{
    const Pane& pane = pane_of(scene);
    PaneCheck found = check(pane, p.nozzle);
    if (found.sound()) { // the triangles of a pane that is not are no guide to anything
        try {
            if (record(restore(record(pane))).triangles != record(pane).triangles) found.faults.push_back("made anew, it has other triangles");
        } catch (const PaneRefusal& refusal) {
            found.faults.push_back(fmt::format("cannot be made anew: {}", refusal.what()));
        }
    }
    nlohmann::ordered_json json;
    json["sound"] = found.sound();
    json["faults"] = found.faults;
    json["points"] = found.points;
    json["boundary_points"] = found.boundary_points;
    json["holes"] = found.holes;
    json["segments"] = found.segments;
    json["triangles"] = found.triangles;
    json["edges"] = found.edges;
    json["locked"] = found.locked;
    json["area"] = found.area;
    json["smallest_angle"] = found.smallest_angle;
    json["thin_triangles"] = found.thin_triangles;
    json["short_edges"] = found.short_edges;
    context.output = json.dump();
    context.failed = p.strict && !found.sound();
}

} // namespace

Operator pane_new_operator()
{
    const Range places{-largest_place, largest_place};
    return define<PaneNew>("pane.new", "Make a pane: a flat region with an outline, and holes, to draw points and lines in")
        .param(&PaneNew::loop, "loop", Unit::length, places, at_least(6), "x,y of the points of the outline, which become points 0, 1, …")
        .required()
        .param(&PaneNew::holes, "hole", Unit::length, places, at_least(6), "the same of a hole, numbered on from there")
        .param(&PaneNew::snap, "snap", Unit::length, at_least(0), "how near a new place means what is there; 0 is never, unset 1/500 of the longer side")
        .param(&PaneNew::weld, "weld", Unit::length, above(0), "the least distance of two points; unset a billionth of the longer side")
        .keeps_euler()
        .example("pane.new loop=0,0,10,0,10,10,0,10 hole=4,4,4,6,6,4")
        .cites("Howison & Séquin 2009")
        .run(run_pane_new);
}

Operator pane_check_operator()
{
    using P = PaneCheckParameters;
    return define<P>("pane.check", "Say whether the pane is all that it should be, and how good its triangles are")
        .param(&P::strict, "strict", "fail where anything is wrong; thin triangles and short edges are not")
        .param(&P::nozzle, "nozzle", Unit::length, above(0), "length below which an edge is too short to be printed")
        .keeps_euler()
        .example("pane.check strict=true")
        .cites("Lawson 1977; Shewchuk 1997")
        .query()
        .run(run_pane_check);
}

void register_pane(Registry& registry)
{
    registry.add(pane_new_operator());
    registry.add(pane_add_operator());
    registry.add(pane_add_boundary_operator());
    registry.add(pane_move_operator());
    registry.add(pane_remove_operator());
    registry.add(pane_constrain_operator());
    registry.add(pane_unconstrain_operator());
    registry.add(pane_lock_operator());
    registry.add(pane_refine_operator());
    registry.add(pane_unrefine_operator());
    registry.add(pane_spread_operator());
    registry.add(pane_check_operator());
}

} // namespace druse
