#pragma once

#include "dlfl/mesh.h"
#include "graph/graph.h"

#include <span>

namespace druse {

/// Edges of a mesh as a graph, in the order given, each from its first to its second end, with the mean normal of its faces. Vertices keep their
/// order; those that none of the edges has are left out, and so are edges from a vertex to itself. Cost: O(mesh).
Graph edge_graph(const Mesh& mesh, std::span<const Edge> edges);

} // namespace druse
