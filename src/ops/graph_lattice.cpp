// graph.lattice: pieces of crystal nets.
#include "graph/lattice.h"

#include "ops/graph.h"

namespace druse {

namespace {

struct Lattice : LatticeShape {
    OrWord<double> radius = "auto";
};

void run_lattice(Scene& scene, const Lattice& p, Context& context)
{
    LatticeShape shape = p;
    if (p.radius.word.empty()) shape.size = p.radius.value;
    scene.source.replace_with(lattice(shape, context.progress));
}

} // namespace

Operator graph_lattice_operator()
{
    using P = Lattice;
    return define<P>("graph.lattice", "Make a graph that is a piece of a crystal net")
        .param(&P::kind, "kind", words({"diamond", "srs"}), "diamond, or the net (10,3)-a")
        .param(&P::cells, "cells", Unit::count, {1, 64}, "cubic cells in x, y and z")
        .param(&P::twin, "double", "add the second net in the gaps of the first; it meets it nowhere")
        .param(&P::trim, "trim", words({"cell", "box", "ball"}), "what is kept: whole cells, what lies in the box around them, or in a ball about its centre")
        .param(&P::leaves, "leaves", "keep vertices with one edge")
        .param(&P::bond, "bond", Unit::length, above(0), "length of the edges")
        .param(&P::radius, "size", Unit::ratio, above(0), words({"auto"}), "radius of the ball in cells, which may go beyond them; auto: half the least of cells")
        .only_where("trim", {"ball"})
        .example("graph.lattice kind=srs cells=2,2,1 double=true")
        .cites("Wells 1977; Hyde, O'Keeffe & Proserpio 2008")
        .run(run_lattice);
}

} // namespace druse
