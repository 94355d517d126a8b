// graph.struts: a solid around the edges of a graph.
#include "ops/struts.h"

#include "graph/clean_graph.h"
#include "graph/edge_graph.h"
#include "graph/split_crossings.h"
#include "graph/strut_contacts.h"
#include "graph/strut_surface.h"
#include "graph/strut_thinning.h"
#include "ops/graph.h"
#include "ops/group.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace druse {

namespace {

constexpr std::uint64_t most_strut_edges = 20'000'000;
constexpr double crossing_reach = 1e-9; // of the diagonal
constexpr Colour crossing_colour{230, 30, 30};

[[noreturn]] void refuse_to_thin() { throw CommandError("clearance=thin: struts still meet when they are as thin as can be"); }

/// The graph that the document holds, or one of the edges of its mesh.
Graph graph_to_thicken(const Scene& scene, StrutSource source)
{
    const Graph* graph = std::get_if<Graph>(&*scene.source);
    const bool has_lines = graph && !graph->edges.empty();
    if (source == StrutSource::lines || (source == StrutSource::automatic && has_lines)) return graph_of(scene);
    if (scene.mesh.edge_count() == 0) {
        if (source == StrutSource::edges) throw CommandError("there is no mesh to take edges from");
        throw CommandError(graph ? "the graph has no edges" : "there are no edges: the document holds neither a graph nor a mesh");
    }
    Graph edges = edge_graph(scene.mesh, EdgeSelector::all().resolve(scene));
    if (edges.edges.empty()) throw CommandError("there are no edges between two vertices");
    return edges;
}

/// A clean graph with all that follows from it, which a split begins anew.
struct Work {
    Work(CleanGraph c, const StrutShape& shape)
        : clean(std::move(c)), incidence(clean.graph), placer(clean, incidence, shape), placement(placer.place()), neighbours(clean.graph, incidence)
    {
    }
    Work(const Work&) = delete; // the parts borrow from each other

    CleanGraph clean;
    Incidence incidence;
    StrutPlacer placer;
    StrutPlacement placement;
    StrutNeighbours neighbours;
    NearParts near;
    std::optional<Crossing> meeting; // where edges meet that crossings=ignore leaves alone
    std::vector<double> factors;     // of the radii at vertices, if some were lowered
};

std::string names(const CleanGraph& clean, const Crossing& c) { return fmt::format("edges {} and {}", clean.edge_name(c.first), clean.edge_name(c.second)); }
std::string place_text(const Point& p) { return fmt::format("{:.6g},{:.6g},{:.6g}", p.x, p.y, p.z); }

/// The first thing that makes crossings an error, if there is one.
std::optional<std::string> complaint(const CleanGraph& clean, const std::vector<Crossing>& found, Crossings what)
{
    for (const Crossing& c : found)
        if (c.along) return names(clean, c) + " run along each other";
    if (found.empty() || what != Crossings::error) return std::nullopt;
    return fmt::format("{} cross at {}; crossings=split joins them", names(clean, found.front()), place_text(found.front().place));
}

/// Looks for parts that come near each other, and has an edge end where it crosses another one, if that is what was asked for.
void join_crossings(std::optional<Work>& work, const Struts& p, Context& context)
{
    if (p.crossings == Crossings::ignore && p.clearance == Clearance::off) return;
    Box box;
    for (const Point& v : work->clean.graph.vertices) box.add(v);
    const double reach = crossing_reach * box.diagonal();
    const auto look = [&] {
        work->near = work->neighbours.near(work->placement, reach, context.progress);
        return crossings(work->clean.graph, work->near.meeting, reach);
    };
    std::vector<Crossing> found = look();
    if (p.crossings == Crossings::ignore) {
        if (!found.empty()) work->meeting = found.front();
        return;
    }
    if (const auto text = complaint(work->clean, found, p.crossings)) throw CommandError(*text);
    if (found.empty()) return;
    if (found.size() >= NearParts::most) throw CommandError(fmt::format("{} crossings or more: too many to split", NearParts::most));
    CleanGraph pieces = split(work->clean, found, reach, context.progress);
    work.emplace(std::move(pieces), p);
    context.note(found.size() == 1 ? "1 crossing: split" : fmt::format("{} crossings: split", found.size()));
    found = look();
    if (const auto text = complaint(work->clean, found, Crossings::error)) throw CommandError(*text);
}

void place_thinner(Work& work, Context& context)
{
    work.placement = work.placer.place(1, work.factors);
    work.near = work.neighbours.near(work.placement, 0, context.progress);
}

/// Lowers radii as far as that can be told before anything is made.
void keep_apart(Work& work, const Struts& p, Context& context)
{
    if (p.clearance == Clearance::off) work.near = {};
    if ((work.near.pairs.empty() && work.near.complete) || (p.clearance != Clearance::shrink && p.clearance != Clearance::thin)) return;
    if (const auto& c = work.meeting)
        throw CommandError(fmt::format("clearance={}: {} meet at {}, so no radius keeps their struts apart; crossings=split joins them",
                                       p.clearance == Clearance::thin ? "thin" : "shrink", names(work.clean, *c), place_text(c->place)));
    const auto for_each_list = [&](auto&& f) { work.neighbours.for_each_list(work.near, work.placement, context.progress, f); };
    if (p.clearance == Clearance::shrink) {
        double factor = 1;
        for_each_list([&](const std::vector<PartPair>& pairs) {
            factor = work.neighbours.clearing_factor(work.placer, pairs, factor);
            return true;
        });
        context.note(fmt::format("radius lowered to {:.6g}, so that nothing meets", p.radius * factor));
        work.placement = work.placer.place(factor);
        work.near = {};
    } else {
        work.factors.assign(work.clean.graph.vertices.size(), 1.0);
        for_each_list([&](const std::vector<PartPair>& pairs) {
            if (!thin_out(work.clean.graph, work.incidence, work.placer, p, pairs, work.factors, context.progress)) refuse_to_thin();
            return true;
        });
        place_thinner(work, context);
    }
}

/// The largest radius that fits everywhere, in six digits that do.
double largest_radius(const Work& work, double radius)
{
    const double fits = radius * work.placer.fitting_factor(), digit = std::pow(10.0, std::floor(std::log10(fits)) - 5);
    const double rounded = std::round(fits / digit) * digit;
    return work.placer.place(rounded / radius).thinned == 0 ? rounded : std::floor(fits / digit) * digit;
}

void check_fit(const Work& work, const Struts& p, Context& context)
{
    const StrutPlacement& placement = work.placement;
    if (placement.thinned == 0) return;
    if (p.fit == StrutFit::error)
        throw CommandError(fmt::format("radius={}: does not fit at {}; the largest that fits everywhere is {:.6g}", number_text(p.radius),
                                       work.clean.vertex_name(placement.least_at), largest_radius(work, p.radius)));
    context.note(fmt::format("{} thinned, least to {:.2g}", placement.thinned == 1 ? "1 end" : fmt::format("{} ends", placement.thinned), placement.least));
}

StrutSurface make_surface(const Work& work, const Struts& p, Context& context)
{
    return strut_surface(work.clean.graph, work.incidence, work.placer, work.placement, p, context.progress);
}

StrutContacts find_contacts(const Work& work, const StrutSurface& made, Context& context)
{
    StrutContacts met;
    work.neighbours.for_each_list(work.near, work.placement, context.progress, [&](const std::vector<PartPair>& pairs) {
        return work.neighbours.add_contacts(made, pairs, met, context.progress);
    });
    return met;
}

/// Says what was thinned, and what crosses all the same.
void tell_contacts(const Work& work, const StrutContacts& met, const Struts& p, Context& context)
{
    if (const auto thinner = std::count_if(work.factors.begin(), work.factors.end(), [](double factor) { return factor < 1; }); thinner > 0)
        context.note(fmt::format("{} thinned, so that nothing meets, least to {:.2g}", thinner == 1 ? "1 vertex" : fmt::format("{} vertices", thinner),
                                 *std::min_element(work.factors.begin(), work.factors.end())));
    if (met.pairs == 0) return;
    const std::string text = met.pairs == 1 ? "1 pair of triangles crosses"
                                            : fmt::format("{} pairs of triangles{} cross", met.pairs, met.pairs < StrutContacts::most ? "" : " or more");
    const bool edges_meet = work.meeting.has_value();
    if (p.clearance == Clearance::error) throw CommandError(text + (edges_meet ? "; crossings=split joins edges that meet" : "; a smaller radius or clearance=thin keeps struts apart"));
    context.note(text + (edges_meet ? " where edges meet or struts come too near each other; crossings=split joins those edges"
                                    : " where struts come too near each other; clearance=thin keeps them apart"));
}

/// Struts in place of the mesh or after it, with groups of their own, and red where they cross.
void put_in_place(Scene& scene, Mesh&& struts, bool keep, const StrutContacts& met)
{
    constexpr int crossing = strut_group::cap + 1;
    int before = 0;
    for (const Face f : met.faces) struts.set_group(f, crossing);
    if (!keep) {
        scene.mesh.replace_with(std::move(struts));
    } else {
        before = first_new_group(scene.mesh, crossing) - 1;
        for (std::int32_t& group : struts.write_groups()) group += before;
        scene.mesh.append(struts);
    }
    GroupTable& groups = scene.groups.edit();
    const auto name = [&groups, before](int group, const char* text) {
        groups.forget(before + group);
        groups.set_name(before + group, text);
    };
    name(strut_group::ball, "ball");
    name(strut_group::strut, "strut");
    name(strut_group::cap, "cap");
    if (met.faces.empty()) return;
    name(crossing, "crossing");
    groups.set_colour(before + crossing, crossing_colour);
}

} // namespace

void make_struts(Scene& scene, const Struts& p, Context& context)
{
    Graph graph = graph_to_thicken(scene, p.source);
    graph.struts = {};
    if (p.frame == StrutFrame::normal && graph.normals.empty()) throw CommandError("frame=normal: the graph came from no mesh that has normals");
    GraphRepairs repairs;
    std::optional<Work> work;
    work.emplace(cleaned(graph, p.weld, repairs, context.progress), p);
    for (std::string& note : repairs.notes()) context.note(std::move(note));
    if (const std::uint64_t edges = count_edges(work->clean.graph, work->incidence, p); edges > most_strut_edges)
        throw CommandError(fmt::format("would make {} million edges, more than {} million", edges / 1'000'000, most_strut_edges / 1'000'000));
    join_crossings(work, p, context);
    keep_apart(*work, p, context);
    check_fit(*work, p, context);

    StrutSurface made = make_surface(*work, p, context);
    StrutContacts met = find_contacts(*work, made, context);
    for (int round = 0; p.clearance == Clearance::thin && met.pairs > 0; ++round) { // caps, and struts that widen beside thinner balls
        if (round == most_thinnings) refuse_to_thin();
        thin(work->clean.graph, work->incidence, work->placement, met.parts, round, work->factors);
        place_thinner(*work, context);
        made = make_surface(*work, p, context);
        met = find_contacts(*work, made, context);
    }
    tell_contacts(*work, met, p, context);

    graph.struts = std::move(made.table);
    graph.struts.vertex_ids = std::move(work->clean.vertex_ids);
    graph.struts.edge_ids = std::move(work->clean.edge_ids);
    graph.struts.first_face = p.keep ? scene.mesh.face_limit() : 0;
    put_in_place(scene, std::move(made.mesh), p.keep, met);
    if (p.keep) graph.struts.hold(scene.mesh);
    scene.source.replace_with(std::move(graph));
}

Operator graph_struts_operator()
{
    using P = Struts;
    return define<P>("graph.struts", "Make a solid around the edges of a graph: struts, and balls that join them")
        .param(&P::radius, "radius", Unit::ratio, above(0), "of the polygons around the edges, in what scale says")
        .param(&P::scale, "scale", words({"length", "absolute"}), "radius in mean lengths of the edges at each vertex, so that struts taper, or in model units")
        .param(&P::sides, "sides", Unit::count, {3, 64}, "corners of the polygons")
        .param(&P::phase, "phase", Unit::degrees, {-360, 360}, "turns every polygon about its edge")
        .param(&P::twist, "twist", Unit::degrees, {-360, 360}, "turns the polygon at the second end further")
        .param(&P::frame, "frame", words({"auto", "normal", "axis"}), "what corner 0 looks to: the faces' normal where the graph came from a mesh, or the z axis")
        .param(&P::ball, "ball", Unit::ratio, {1, 10}, "size of the balls, in what they need; never more than fits")
        .param(&P::gap, "gap", Unit::ratio, {0.1, 0.99}, "how much of half the angle to the nearest edge a polygon may fill")
        .param(&P::spread, "spread", Unit::degrees, {5, 80}, "largest half angle of a polygon, seen from its vertex")
        .param(&P::cap, "cap", words({"flat", "round", "point"}), "how struts end at vertices with one edge")
        .param(&P::fit, "fit", words({"shrink", "error"}), "where a polygon has to be smaller than asked for: make it so, or refuse")
        .param(&P::crossings, "crossings", words({"error", "split", "ignore"}), "edges that meet away from vertices: refuse, put a vertex there, or do not look")
        .param(&P::clearance, "clearance", words({"warn", "thin", "shrink", "error", "off"}), "struts that cross: say so and colour them, thin those, thin all, refuse, or do not look")
        .param(&P::merge, "merge", "join coplanar triangles of the balls into polygons")
        .param(&P::triangulate, "triangulate", "make triangles only")
        .param(&P::keep, "keep", "keep the mesh too")
        .param(&P::source, "source", words({"auto", "edges", "lines"}), "edges of the mesh, or lines of the graph; auto: lines if there are any")
        .param(&P::weld, "weld", Unit::length, at_least(0), "vertices that near become one; 0: at exactly the same place")
        .example("graph.struts radius=0.08 sides=4")
        .cites("Hart 2009")
        .run(make_struts);
}

} // namespace druse
