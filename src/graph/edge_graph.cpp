#include "graph/edge_graph.h"

#include "dlfl/measures.h"
#include "graph/clean_graph.h"

namespace druse {

Graph edge_graph(const Mesh& mesh, std::span<const Edge> edges)
{
    Graph graph;
    graph.vertices.assign(mesh.positions().begin(), mesh.positions().end());
    graph.edges.reserve(edges.size());
    graph.normals.reserve(edges.size());
    FaceData<Vector> normal(mesh);
    for (const Face f : mesh.faces()) normal[f] = unit_normal(mesh, f);
    const auto normal_of = [&normal](Face f) { return f.is_boundary() ? Vector(0.0) : normal[f]; };
    for (const Edge e : edges) {
        const auto [a, b] = mesh.ends(e);
        if (a == b) continue;
        const auto [f, g] = mesh.faces(e);
        graph.edges.push_back({a.index, b.index});
        graph.normals.push_back(unit(normal_of(f) + normal_of(g), 1e-6));
    }
    drop_isolated(graph);
    return graph;
}

} // namespace druse
