#include "ops/shown_lines.h"

namespace druse {

Graph pane_edges(const Pane& pane)
{
    using Index = Pane::Index;
    const Triangulation& t = pane.triangulation();
    Graph graph;
    std::vector<std::uint32_t> number(t.vertex_end());
    for (const PointId point : pane.points()) {
        const Index v = pane.vertex(point);
        number[v] = static_cast<std::uint32_t>(graph.vertices.size());
        graph.vertices.emplace_back(t.position(v).x, t.position(v).y, 0.0);
    }
    for (Index face = 0; face < t.side_end(); face += 4)
        for (Index h = face; h < face + 3 && t.is_face(face) && t.is_inside(face); ++h)
            if (h < t.twin(h) || !t.is_inside(t.twin(h))) graph.edges.push_back({number[t.origin(h)], number[t.target(h)]});
    return graph;
}

bool shows_source(const Scene& scene) { return scene.mesh.face_count() == 0 && !std::holds_alternative<std::monostate>(*scene.source); }

ShownLines::ShownLines(const Scene& scene)
{
    if (!shows_source(scene)) return;
    graph_ = std::get_if<Graph>(&*scene.source);
    if (const Pane* pane = std::get_if<Pane>(&*scene.source)) {
        of_pane_ = pane_edges(*pane);
        graph_ = &of_pane_;
    }
}

} // namespace druse
