#include "ops/select.h"

#include "dlfl/errors.h"
#include "dlfl/measures.h"
#include "geom/sort_unique.h"
#include "ops/direction_grid.h"
#include "ops/group.h"
#include "ops/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace druse {

namespace {

template <class H>
std::uint32_t limit(const Mesh& mesh)
{
    if constexpr (std::is_same_v<H, Face>) return mesh.face_limit();
    else if constexpr (std::is_same_v<H, Edge>) return mesh.edge_limit();
    else return mesh.vertex_limit();
}

template <class H>
std::vector<H> marked(const std::vector<bool>& marks, bool value = true)
{
    std::vector<H> list;
    for (std::uint32_t i = 0; i < marks.size(); ++i)
        if (marks[i] == value) list.push_back(H(i));
    return list;
}

template <class H>
std::vector<bool> marks_of(const Mesh& mesh, const std::vector<H>& list)
{
    std::vector<bool> marks(limit<H>(mesh), false);
    for (const H h : list) marks[h.index] = true;
    return marks;
}

template <class H>
std::vector<H> others_of(const Mesh& mesh, const std::vector<H>& list)
{
    return marked<H>(marks_of(mesh, list), false);
}

/// Runs `reach(h, found)` on what the step before found; reach calls found(g) for each neighbour g.
template <class H, class Reach>
std::vector<H> grow_by(const Mesh& mesh, const std::vector<H>& list, int steps, Progress& progress, Reach&& reach)
{
    std::vector<bool> in = marks_of(mesh, list);
    std::vector<H> front = list, next;
    for (int step = 0; step < steps && !front.empty(); ++step) {
        progress.step(double(step) / steps);
        next.clear();
        for (const H h : front)
            reach(h, [&](H g) {
                if (in[g.index]) return;
                in[g.index] = true;
                next.push_back(g);
            });
        front.swap(next);
    }
    return marked<H>(in);
}

} // namespace

std::vector<Face> grow(const Mesh& mesh, const std::vector<Face>& faces, int steps, Progress& progress)
{
    std::vector<bool> passed(mesh.vertex_limit(), false);
    return grow_by(mesh, faces, steps, progress, [&](Face f, auto&& found) {
        for (const Corner c : mesh.corners(f)) {
            const Vertex v = mesh.vertex(c);
            if (passed[v.index]) continue;
            passed[v.index] = true;
            for (const Corner d : mesh.around(v))
                if (const Face g = mesh.face(d); !g.is_boundary()) found(g);
        }
    });
}

std::vector<Edge> grow(const Mesh& mesh, const std::vector<Edge>& edges, int steps, Progress& progress)
{
    std::vector<bool> passed(mesh.vertex_limit(), false);
    return grow_by(mesh, edges, steps, progress, [&](Edge e, auto&& found) {
        for (const Vertex v : mesh.ends(e)) {
            if (passed[v.index]) continue;
            passed[v.index] = true;
            for (const Corner d : mesh.around(v)) found(mesh.edge(d));
        }
    });
}

std::vector<Vertex> grow(const Mesh& mesh, const std::vector<Vertex>& vertices, int steps, Progress& progress)
{
    return grow_by(mesh, vertices, steps, progress, [&](Vertex v, auto&& found) {
        for (const Corner d : mesh.around(v)) found(mesh.target(d));
    });
}

std::vector<Face> others(const Mesh& mesh, const std::vector<Face>& faces) { return others_of(mesh, faces); }
std::vector<Edge> others(const Mesh& mesh, const std::vector<Edge>& edges) { return others_of(mesh, edges); }
std::vector<Vertex> others(const Mesh& mesh, const std::vector<Vertex>& vertices) { return others_of(mesh, vertices); }

std::vector<Edge> edge_loop(const Mesh& mesh, Edge e)
{
    // The corner of the side that goes straight on where the side of c ends, or an invalid one.
    const auto straight_on = [&mesh](Corner c) {
        const Corner back = mesh.opposite(c);
        Corner d = back;
        for (int i = 0; i < 4; ++i) {
            if (mesh.face(d).is_boundary() || (i > 0 && d == back)) return Corner();
            d = mesh.rotate(d);
        }
        return d == back ? mesh.rotate(mesh.rotate(back)) : Corner();
    };
    std::vector<Edge> loop{e};
    for (const int side : {0, 1}) {
        const Corner first = mesh.corner(e, side);
        Corner c = straight_on(first);
        for (; c.valid() && c != first; c = straight_on(c)) loop.push_back(mesh.edge(c));
        if (c.valid()) break; // it closed: the other way meets the same edges
    }
    sort_unique(loop);
    return loop;
}

Ring edge_ring(const Mesh& mesh, Edge e)
{
    Ring ring{{e}, {}};
    for (const int side : {0, 1}) {
        const Corner first = mesh.corner(e, side);
        Corner c = first;
        do {
            const Face f = mesh.face(c);
            const Corner across = mesh.next(mesh.next(c));
            if (f.is_boundary() || across == c || mesh.next(mesh.next(across)) != c) {
                c = Corner();
                break;
            }
            ring.faces.push_back(f);
            ring.edges.push_back(mesh.edge(across));
            c = mesh.opposite(across);
        } while (c != first);
        if (c.valid()) break;
    }
    sort_unique(ring.edges);
    sort_unique(ring.faces);
    return ring;
}

// --- registration ---------------------------------------------------------------------------------------------------------------

namespace {

enum class Mode { set, add, remove };
enum class Part { faces, edges, vertices };
const Words mode_words = words({"set", "add", "remove"});
const Words part_words = words({"faces", "edges", "vertices"});
constexpr const char* mode_help = "replace the selection, add to it, or take from it";

template <class H, class S>
auto& list_of(S& selection)
{
    if constexpr (std::is_same_v<H, Face>) return selection.faces;
    else if constexpr (std::is_same_v<H, Edge>) return selection.edges;
    else return selection.vertices;
}

template <class H>
void select(Scene& scene, std::vector<H> given, Mode mode)
{
    std::vector<H>& list = list_of<H>(scene.selection.edit());
    if (mode == Mode::set) {
        list = std::move(given);
        return;
    }
    std::vector<H> result;
    if (mode == Mode::add) std::ranges::set_union(list, given, std::back_inserter(result));
    else std::ranges::set_difference(list, given, std::back_inserter(result));
    list = std::move(result);
}

/// What is selected. @throws CommandError if nothing is
template <class H>
const std::vector<H>& selected(const Scene& scene, const char* many)
{
    const std::vector<H>& list = list_of<H>(*scene.selection);
    if (list.empty()) throw CommandError(fmt::format("no {} are selected", many));
    return list;
}

template <class H>
struct SelectElements {
    Selector<H> elements;
    Mode mode = Mode::set;
};

template <class H>
void add_select(Registry& registry, const std::string& many, const char* example)
{
    using P = SelectElements<H>;
    registry.add(define<P>("select." + many, "Select " + many)
                     .param(&P::elements, many, many + " to select")
                     .required()
                     .param(&P::mode, "mode", mode_words, mode_help)
                     .example(example)
                     .cites("Druse")
                     .keeps_euler()
                     .run([](Scene& scene, const P& p, Context&) { select(scene, p.elements.resolve(scene), p.mode); }));
}

struct GrowSelection {
    Part of = Part::faces;
    int steps = 1;
};

/// Calls f with a null pointer of the handle type and the word for it.
template <class F>
void with_part(Part part, F&& f)
{
    if (part == Part::faces) f(static_cast<Face*>(nullptr), "faces");
    else if (part == Part::edges) f(static_cast<Edge*>(nullptr), "edges");
    else f(static_cast<Vertex*>(nullptr), "vertices");
}

void grow_selection(Scene& scene, const GrowSelection& p, Context& context)
{
    with_part(p.of, [&]<class H>(H*, const char* many) {
        select(scene, grow(scene.mesh, selected<H>(scene, many), p.steps, context.progress), Mode::set);
    });
}

void shrink_selection(Scene& scene, const GrowSelection& p, Context& context)
{
    // What is not selected grows.
    with_part(p.of, [&]<class H>(H*, const char* many) {
        const std::vector<H> outside = others(scene.mesh, selected<H>(scene, many));
        select(scene, others(scene.mesh, grow(scene.mesh, outside, p.steps, context.progress)), Mode::set);
    });
}

struct InvertSelection {
    Part of = Part::faces;
};

struct SelectLoop {
    EdgeId edge;
    enum class Kind { edges, ring, faces } kind = Kind::edges;
    Mode mode = Mode::set;
};

void select_loop(Scene& scene, const SelectLoop& p, Context&)
{
    const Edge e = p.edge.resolve(scene.mesh);
    if (p.kind == SelectLoop::Kind::edges) select(scene, edge_loop(scene.mesh, e), p.mode);
    else if (p.kind == SelectLoop::Kind::ring) select(scene, edge_ring(scene.mesh, e).edges, p.mode);
    else select(scene, edge_ring(scene.mesh, e).faces, p.mode);
}

struct SelectSimilar {
    enum class By { sides, area, normal, group, length, valence } by = By::sides;
    double tolerance = 1e-6;
};

/// The elements whose measure differs from that of a selected one by at most a fraction.
template <class H, class Measure>
void select_near(Scene& scene, const std::vector<H>& list, double tolerance, Measure&& measure)
{
    std::vector<double> known;
    for (const H h : list) known.push_back(measure(h));
    std::ranges::sort(known);
    const auto near = [tolerance](double x, double y) { return std::abs(x - y) <= tolerance * std::max(std::abs(x), std::abs(y)); };
    std::vector<H> result;
    for (std::uint32_t i = 0; i < limit<H>(scene.mesh); ++i) {
        const double x = measure(H(i));
        const auto above = std::ranges::lower_bound(known, x);
        if ((above != known.end() && near(x, *above)) || (above != known.begin() && near(x, *std::prev(above)))) result.push_back(H(i));
    }
    select(scene, std::move(result), Mode::set);
}

void select_similar(Scene& scene, const SelectSimilar& p, Context& context)
{
    const Mesh& mesh = scene.mesh;
    using By = SelectSimilar::By;
    switch (p.by) {
    case By::sides: return select_near(scene, selected<Face>(scene, "faces"), 0.0, [&](Face f) { return double(mesh.valence(f)); });
    case By::group: return select_near(scene, selected<Face>(scene, "faces"), 0.0, [&](Face f) { return double(mesh.group(f)); });
    case By::area: return select_near(scene, selected<Face>(scene, "faces"), p.tolerance, [&](Face f) { return area(mesh, f); });
    case By::length: return select_near(scene, selected<Edge>(scene, "edges"), p.tolerance, [&](Edge e) { return length(mesh, e); });
    case By::valence:
        return select_near(scene, selected<Vertex>(scene, "vertices"), 0.0, [&](Vertex v) { return double(mesh.valence(v)); });
    case By::normal: break;
    }
    const double angle = std::min(p.tolerance, 180.0);
    DirectionGrid known(angle), distinct(0.0);
    for (const Face f : selected<Face>(scene, "faces")) {
        const Vector n = unit_normal(mesh, f);
        if (distinct.find(n) != DirectionGrid::none) continue;
        distinct.add(n, f.index);
        known.add(n, f.index);
    }
    std::vector<Face> result;
    for (const Face f : mesh.faces()) {
        if (f.index % 4096 == 0) context.progress.step(double(f.index) / mesh.face_limit());
        if (known.find(unit_normal(mesh, f)) != DirectionGrid::none) result.push_back(f);
    }
    select(scene, std::move(result), Mode::set);
}

struct SelectGroup {
    OrWord<std::vector<int>> ids;
    Mode mode = Mode::set;
};

} // namespace

void register_select(Registry& registry)
{
    add_select<Face>(registry, "faces", "select.faces faces=group:3+sides:5 mode=add");
    add_select<Edge>(registry, "edges", "select.edges edges=0~1,1~2");
    add_select<Vertex>(registry, "vertices", "select.vertices vertices=valence:3");
    registry.add(define<GrowSelection>("select.grow", "Add the neighbours of what is selected")
                     .param(&GrowSelection::of, "of", part_words, "the part of the selection that grows")
                     .param(&GrowSelection::steps, "steps", Unit::count, {1, 1000}, "how often")
                     .example("select.grow of=faces steps=2")
                     .cites("Druse")
                     .keeps_euler()
                     .run(grow_selection));
    registry.add(define<GrowSelection>("select.shrink", "Take away what has a neighbour that is not selected")
                     .param(&GrowSelection::of, "of", part_words, "the part of the selection that shrinks")
                     .param(&GrowSelection::steps, "steps", Unit::count, {1, 1000}, "how often")
                     .example("select.shrink of=vertices")
                     .cites("Druse")
                     .keeps_euler()
                     .run(shrink_selection));
    registry.add(define<SelectLoop>("select.loop", "Select the loop or ring through an edge")
                     .param(&SelectLoop::edge, "edge", "an edge of the loop")
                     .required()
                     .param(&SelectLoop::kind, "kind", words({"edges", "ring", "faces"}),
                            "edges: straight on over vertices with four edges; ring: opposite sides of quads; faces: the quads of the ring")
                     .param(&SelectLoop::mode, "mode", mode_words, mode_help)
                     .example("select.loop edge=4~9 kind=ring")
                     .cites("Druse")
                     .keeps_euler()
                     .run(select_loop));
    registry.add(define<SelectSimilar>("select.similar", "Select what is like the selected faces, edges or vertices")
                     .param(&SelectSimilar::by, "by", words({"sides", "area", "normal", "group", "length", "valence"}),
                            "what is compared: sides, area, normal and group of faces, length of edges, valence of vertices")
                     .param(&SelectSimilar::tolerance, "tolerance", Unit::ratio, at_least(0),
                            "largest difference: a fraction of area or length, degrees between normals")
                     .example("select.similar by=area tolerance=0.01")
                     .cites("Druse")
                     .keeps_euler()
                     .run(select_similar));
    registry.add(define<InvertSelection>("select.invert", "Select what is not selected")
                     .param(&InvertSelection::of, "of", part_words, "the part of the selection to invert")
                     .example("select.invert of=edges")
                     .cites("Druse")
                     .keeps_euler()
                     .run([](Scene& scene, const InvertSelection& p, Context&) {
                         with_part(p.of, [&]<class H>(H*, const char*) {
                             select(scene, others(scene.mesh, list_of<H>(*scene.selection)), Mode::set);
                         });
                     }));
    registry.add(define<SelectGroup>("select.group", "Select all faces of groups")
                     .param(&SelectGroup::ids, "ids", Unit::id, {0, 2147483647}, words({"all"}), "group ids; all: every face that has a group")
                     .required()
                     .param(&SelectGroup::mode, "mode", mode_words, mode_help)
                     .example("select.group ids=1,2 mode=add")
                     .cites("Landreneau 2005, III.5")
                     .keeps_euler()
                     .run([](Scene& scene, const SelectGroup& p, Context&) {
                         const std::vector<int> ids = resolve_groups(scene.mesh, p.ids);
                         std::vector<Face> faces;
                         for (const Face f : scene.mesh.faces())
                             if (std::ranges::binary_search(ids, scene.mesh.group(f))) faces.push_back(f);
                         select(scene, std::move(faces), p.mode);
                     }));
}

} // namespace druse
