// topology.*: the minimal operators by hand.
#include "dlfl/errors.h"
#include "ops/handle.h"
#include "ops/registry.h"

#include <fmt/format.h>

#include <vector>

namespace druse {

namespace {

struct InsertEdge {
    CornerId c1, c2;
};

void insert_edge(Scene& scene, const InsertEdge& p, Context&)
{
    const Corner c1 = p.c1.resolve(scene.mesh), c2 = p.c2.resolve(scene.mesh);
    if (c1 == c2) throw CommandError(fmt::format("c1 and c2 are the same corner {}:{}", p.c1.face, p.c1.place));
    scene.mesh.insert_edge(c1, c2);
}

struct DeleteEdges {
    EdgeSelector edges;
    bool cleanup = true;
};

void delete_edges(Scene& scene, const DeleteEdges& p, Context& context)
{
    Mesh& mesh = scene.mesh;
    const std::vector<Edge> edges = p.edges.resolve(scene);
    for (const Edge e : edges)
        if (mesh.is_on_boundary(e)) throw CommandError(fmt::format("edge {} lies on an open boundary", e.index));

    // A face that falls apart may take the id of one that was merged before, or a new one, so what goes leaves the selection at once.
    std::vector<bool> selected(mesh.face_limit(), false);
    for (const Face f : scene.selection->faces) selected[f.index] = true;
    bool lost = false;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        context.progress.step(double(i) / double(edges.size())); // one deletion may walk a face of any size
        if (!mesh.is_alive(edges[i])) continue;
        const auto beside = mesh.faces(edges[i]);
        mesh.delete_edge(edges[i], p.cleanup);
        for (const Face f : beside)
            if (!mesh.is_alive(f) && f.index < selected.size() && selected[f.index]) {
                selected[f.index] = false;
                lost = true;
            }
    }
    if (lost) std::erase_if(scene.selection.edit().faces, [&](Face f) { return !selected[f.index]; });
}

struct CreateVertex {
    Point at{0.0};
};

void create_vertex(Scene& scene, const CreateVertex& p, Context&)
{
    if (!is_in_reach(p.at)) throw CommandError(fmt::format("at: expected coordinates of at most {} in size", largest_coordinate));
    scene.mesh.create_vertex(p.at);
}

struct DeleteVertices {
    VertexSelector vertices;
};

void delete_vertices(Scene& scene, const DeleteVertices& p, Context&)
{
    const std::vector<Vertex> vertices = p.vertices.resolve(scene);
    for (const Vertex v : vertices)
        if (const int n = scene.mesh.valence(v); n > 0)
            throw CommandError(fmt::format("vertex {} is no point sphere: it has {} edge{}", v.index, n, n == 1 ? "" : "s"));
    for (const Vertex v : vertices) scene.mesh.delete_vertex(v);
}

constexpr const char* source = "Akleman, Chen & Srinivasan 2003";

} // namespace

void register_topology(Registry& registry)
{
    registry.add(define<InsertEdge>("topology.insert_edge", "Join two corners by an edge: it splits a face, adds a handle or joins components")
                     .param(&InsertEdge::c1, "c1", "the corner where the edge starts, FACE:K")
                     .required()
                     .param(&InsertEdge::c2, "c2", "the corner where it ends, FACE:K")
                     .required()
                     .example("topology.insert_edge c1=0:0 c2=0:2")
                     .cites(source)
                     .run(insert_edge));
    registry.add(define<DeleteEdges>("topology.delete_edge", "Take edges away: faces are merged, or one falls apart")
                     .param(&DeleteEdges::edges, "edges", "edges to delete")
                     .param(&DeleteEdges::cleanup, "cleanup", "delete vertices that lose their last edge, too")
                     .example("topology.delete_edge edges=4~9")
                     .cites(source)
                     .run(delete_edges));
    registry.add(define<CreateVertex>("topology.create_vertex", "Add a point sphere: a vertex alone on a face without edges")
                     .param(&CreateVertex::at, "at", "its position")
                     .required()
                     .example("topology.create_vertex at=0,0,2")
                     .cites(source)
                     .run(create_vertex));
    registry.add(define<DeleteVertices>("topology.delete_vertex", "Delete point spheres")
                     .param(&DeleteVertices::vertices, "vertices", "vertices without edges")
                     .example("topology.delete_vertex vertices=valence:0")
                     .cites(source)
                     .run(delete_vertices));
    registry.add(pipe_operator());
    registry.add(handle_operator());
}

} // namespace druse
