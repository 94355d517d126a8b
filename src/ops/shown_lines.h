#pragma once

#include "graph/graph.h"
#include "ops/scene.h"

namespace druse {

/// The edges of a pane in z = 0; vertex k is the k-th of its points by id. Cost: linear.
Graph pane_edges(const Pane& pane);

/// Whether the source is what one sees of a scene: it is while there are no faces.
bool shows_source(const Scene& scene);

/// The lines that are drawn of a scene without faces: its graph, or the edges of its pane. The scene must outlive it.
class ShownLines {
public:
    explicit ShownLines(const Scene& scene);
    ShownLines(const ShownLines&) = delete;
    ShownLines& operator=(const ShownLines&) = delete;

    /// Null where faces are drawn, or nothing.
    const Graph* graph() const { return graph_; }

private:
    Graph of_pane_;
    const Graph* graph_ = nullptr;
};

} // namespace druse
