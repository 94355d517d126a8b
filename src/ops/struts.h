#pragma once

#include "graph/strut_shape.h"
#include "ops/operator.h"

namespace druse {

enum class StrutSource { automatic, edges, lines };

/// What graph.struts takes.
struct Struts : StrutShape {
    StrutSource source = StrutSource::automatic;
    double weld = 0;
    bool keep = false;
};

/// Makes struts of the graph of a document, or of the edges of its mesh, which then become its graph. The mesh gives way to them unless it is
/// kept. Notes say what was mended in the graph, where struts are thinner than asked for, and whether they meet.
/// @throws CommandError where there is no edge, edges overlap or cross, and what was asked for does not fit; Cancelled
void make_struts(Scene& scene, const Struts& p, Context& context);

Operator graph_struts_operator();

} // namespace druse
