#pragma once

#include "cell/cell_tile.h"
#include "dlfl/group_table.h"
#include "dlfl/mesh.h"
#include "dlfl/rind.h"
#include "graph/graph.h"
#include "pane/pane.h"
#include "tile/layered_tile.h"

#include <optional>
#include <string>
#include <vector>

namespace druse {

/// What a file holds: a mesh with its groups and the table of its rind, and a source: a graph, a pane, a tile or a cell.
struct Model {
    Mesh mesh;
    Rind rind{};
    GroupTable groups;
    std::optional<Graph> graph;
    std::optional<Pane> pane;
    std::optional<LayeredTile> tile;
    std::optional<CellTile> cell;
    std::vector<std::string> notes; // what the reader mended or left out, one line each
};

/// What a writer takes: the parts of a model or of a document, borrowed. Precondition: the mesh has no holes.
struct ModelView {
    const Mesh& mesh;
    const GroupTable& groups;
    const Graph* graph = nullptr;
    const Rind* rind = nullptr;
    const Pane* pane = nullptr;
    const LayeredTile* tile = nullptr;
    const CellTile* cell = nullptr;

    /// The graph beside the mesh, if it is more than what struts in the mesh were made of.
    const Graph* lines() const { return has_edges() && graph->struts.edge_ids.empty() ? graph : nullptr; }
    /// True if the graph was given as lines, and struts were made of it.
    bool has_become_struts() const { return has_edges() && !lines() && graph->normals.empty(); }
    bool has_edges() const { return graph && !graph->edges.empty(); }
};

} // namespace druse
