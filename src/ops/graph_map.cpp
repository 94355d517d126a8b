// graph.map: tessellations of the disk become figures in space.
#include "graph/map.h"

#include "ops/graph.h"
#include "ops/solid.h"

#include <optional>

namespace druse {

namespace {

enum class Platonic { tetrahedron, cube, octahedron, dodecahedron, icosahedron };

struct MapParameters : MapShape {
    OrWord<int> cycles_or_auto = "auto";
    OrWord<double> major_or_auto = "auto", rho_or_auto = "auto";
    Platonic solid = Platonic::icosahedron;
};

/// The edges of a solid whose vertices are at distance 1 from its centre.
Graph unit_graph(Platonic solid)
{
    static constexpr const char* names[] = {"tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron"};
    const Mesh mesh = make_solid(names[static_cast<std::size_t>(solid)], 1);
    Graph graph;
    for (const Vertex v : mesh.vertices()) graph.vertices.push_back(unit(mesh.position(v)));
    for (const Edge e : mesh.edges()) {
        const auto [a, b] = mesh.ends(e);
        graph.edges.push_back({a.index, b.index});
    }
    return graph;
}

template <class T>
std::optional<T> unless_auto(const OrWord<T>& x)
{
    return x.word.empty() ? std::optional<T>(x.value) : std::nullopt;
}

void run_map(Scene& scene, const MapParameters& p, Context& context)
{
    MapShape shape = p;
    shape.cycles = unless_auto(p.cycles_or_auto);
    shape.major = unless_auto(p.major_or_auto);
    shape.rho = unless_auto(p.rho_or_auto);
    const Graph nothing, solid = p.to == MapTo::polyhedron ? unit_graph(p.solid) : Graph();
    const Graph* graph = std::get_if<Graph>(&*scene.source);
    scene.source.replace_with(map_disk(graph ? *graph : nothing, shape, solid, context.notes, context.progress));
}

} // namespace

Operator graph_map_operator()
{
    using P = MapParameters;
    return define<P>("graph.map", "Bend a tessellation of the disk into a figure in space")
        .param(&P::to, "to", words({"disk", "polyp", "helix", "torus", "knot", "polyhedron"}), "what it becomes")
        .required()
        .param(&P::size, "size", Unit::ratio, above(0), "factor on the result")
        .param(&P::rim, "rim", Unit::ratio, above(0), "radius at which a parabola is highest")
        .only_where("to", {"polyp"})
        .param(&P::height, "height", Unit::ratio, {-1e6, 1e6}, "height there")
        .only_where("to", {"polyp"})
        .param(&P::height_expr, "height_expr", "height instead, a formula in x, y, r and t: + - * / ^, pi, sin cos tan sqrt exp log abs min max")
        .instead_of("height")
        .only_where("to", {"polyp"})
        .param(&P::turns, "turns", Unit::count, {1, 64}, "how often it turns up from the middle, and down")
        .only_where("to", {"helix"})
        .param(&P::shape, "shape", words({"sphere", "cylinder"}), "what it is wound in")
        .only_where("to", {"helix"})
        .param(&P::span, "span", Unit::ratio, between(0, 1), "part of a sphere from pole to pole")
        .only_where("to", {"helix"})
        .param(&P::pitch, "pitch", Unit::ratio, above(0), "height of a turn in a cylinder")
        .only_where("to", {"helix"})
        .param(&P::cycles_or_auto, "cycles", Unit::count, {1, 360}, words({"auto"}), "how often the disk turns on its way round; auto: 5 and 9")
        .only_where("to", {"torus", "knot"})
        .param(&P::major_or_auto, "major", Unit::ratio, above(0), words({"auto"}), "radius of the way round; auto: 1.6 and 2")
        .only_where("to", {"torus", "knot"})
        .param(&P::minor, "minor", Unit::ratio, above(0), "how far the knot swings about that way, less than major")
        .only_where("to", {"knot"})
        .param(&P::rho_or_auto, "rho", Unit::ratio, above(0), words({"auto"}), "radius of the disk that is swept; auto: 1 and 0.6")
        .only_where("to", {"torus", "knot"})
        .param(&P::phase, "phase", Unit::degrees, {-360, 360}, "turn of the disk where it begins")
        .only_where("to", {"knot"})
        .param(&P::force, "force", "allow a tube that meets itself")
        .only_where("to", {"knot"})
        .param(&P::solid, "solid", words({"tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron"}), "whose edges become sectors of the disk")
        .only_where("to", {"polyhedron"})
        .example("graph.map to=torus cycles=7")
        .cites("Hart 2009")
        .run(run_map);
}

} // namespace druse
