// graph.*: graphs, and what is made from them. Here what all of them share, and graph.wireframe.
#include "ops/graph.h"

#include "graph/edge_graph.h"
#include "ops/registry.h"
#include "ops/struts.h"

namespace druse {

const Graph& graph_of(const Scene& scene)
{
    return held<Graph>(scene.source, "graph", "graph.wireframe makes one of the edges of a mesh");
}

namespace {

struct Wireframe {
    EdgeSelector edges = EdgeSelector::all();
    bool keep = false;
};

void run_wireframe(Scene& scene, const Wireframe& p, Context&)
{
    if (scene.mesh.edge_count() == 0) throw CommandError("there is no mesh to take edges from");
    Graph graph = edge_graph(scene.mesh, p.edges.resolve(scene));
    if (graph.edges.empty()) throw CommandError("there are no edges between two vertices");
    scene.source.replace_with(std::move(graph));
    if (!p.keep) scene.mesh.clear();
}

} // namespace

Operator graph_wireframe_operator()
{
    return define<Wireframe>("graph.wireframe", "Make a graph of the edges of the mesh")
        .param(&Wireframe::edges, "edges", "edges to take")
        .param(&Wireframe::keep, "keep", "keep the mesh beside its graph")
        .example("graph.wireframe keep=true")
        .cites("Hart 2009")
        .run(run_wireframe);
}

void register_graph(Registry& registry)
{
    registry.add(graph_wireframe_operator());
    registry.add(graph_lattice_operator());
    registry.add(graph_tess_operator());
    registry.add(graph_map_operator());
    registry.add(graph_struts_operator());
    registry.add(graph_sculpture_operator());
}

} // namespace druse
