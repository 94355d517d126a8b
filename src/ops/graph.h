#pragma once

#include "graph/graph.h"
#include "ops/operator.h"

namespace druse {

/// The graph that a document holds. @throws CommandError if it holds none
const Graph& graph_of(const Scene& scene);

// One operator a file; that of struts is in struts.h.
Operator graph_wireframe_operator();
Operator graph_lattice_operator();
Operator graph_tess_operator();
Operator graph_map_operator();
Operator graph_sculpture_operator();

} // namespace druse
