#include "ops/shown_lines.h"

#include "cell/cell_solid.h"

#include <algorithm>

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

Graph tile_edges(const LayeredTile& tile)
{
    Graph graph;
    const Isometry world = tile.to_world();
    for (const Point& p : tile.surface().points) graph.vertices.emplace_back(Point(world(Point2(p)), p.z + tile.thickness()));
    for (const auto& t : tile.surface().triangles)
        for (std::size_t i = 0; i < 3; ++i) graph.edges.push_back({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
    std::sort(graph.edges.begin(), graph.edges.end());
    graph.edges.erase(std::unique(graph.edges.begin(), graph.edges.end()), graph.edges.end());
    return graph;
}

Graph cell_edges(const CellTile& cell)
{
    CellSolid solid = make_solid(cell);
    Graph graph;
    graph.vertices = std::move(solid.points);
    for (const auto& t : solid.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            if (t[i] < t[(i + 1) % 3]) graph.edges.push_back({t[i], t[(i + 1) % 3]}); // a closed surface has each edge both ways
    std::ranges::sort(graph.edges);
    return graph;
}

bool shows_source(const Scene& scene) { return scene.mesh.face_count() == 0 && !std::holds_alternative<std::monostate>(*scene.source); }

ShownLines::ShownLines(const Scene& scene)
{
    if (!shows_source(scene)) return;
    graph_ = std::get_if<Graph>(&*scene.source);
    if (const Pane* pane = std::get_if<Pane>(&*scene.source)) {
        made_ = pane_edges(*pane);
        graph_ = &made_;
    }
    if (const LayeredTile* tile = std::get_if<LayeredTile>(&*scene.source)) {
        made_ = tile_edges(*tile);
        graph_ = &made_;
    }
    if (const CellTile* cell = std::get_if<CellTile>(&*scene.source)) {
        made_ = cell_edges(*cell);
        graph_ = &made_;
    }
}

} // namespace druse
