#pragma once

#include "graph/graph.h"
#include "ops/scene.h"

namespace druse {

/// The edges of a pane in z = 0; vertex k is the k-th of its points by id. Cost: linear.
Graph pane_edges(const Pane& pane);

/// The edges of the triangles of a tile in the world, at their heights; vertex k is its point k. Cost: linear, but for a sort.
Graph tile_edges(const LayeredTile& tile);

/// The edges of a cell in the world, those that panes share once; vertex k is that of cell.solid. Cost: linear, but for a sort.
Graph cell_edges(const CellTile& cell);

/// Whether the source is what one sees of a scene: it is while there are no faces.
bool shows_source(const Scene& scene);

/// The lines that are drawn of a scene without faces: its graph, or the edges of its pane, tile or cell. The scene must outlive it.
class ShownLines {
public:
    explicit ShownLines(const Scene& scene);
    ShownLines(const ShownLines&) = delete;
    ShownLines& operator=(const ShownLines&) = delete;

    /// Null where faces are drawn, or nothing.
    const Graph* graph() const { return graph_; }

private:
    Graph made_;
    const Graph* graph_ = nullptr;
};

} // namespace druse
