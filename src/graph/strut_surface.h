#pragma once

#include "dlfl/mesh.h"
#include "geom/progress.h"
#include "graph/strut_placement.h"
#include "graph/strut_table.h"

#include <cstdint>

namespace druse {

/// What becomes of the vertices and edges of a graph, in groups.
namespace strut_group {
constexpr int ball = 1, strut = 2, cap = 3;
}

/// Struts as a mesh, and which of its faces is what. The ids in the table are those of the clean graph.
struct StrutSurface {
    Mesh mesh;
    StrutTable table;
};

/// How many edges the surface has before coplanar triangles are merged.
std::uint64_t count_edges(const Graph& graph, const Incidence& incidence, const StrutShape& shape);

/// Builds the surface around a graph: the hull of the polygons at each vertex without what lies in these, a band for each edge, a cap at each end.
///
/// Vertices: corner k of the polygon at end i is vertex i · sides + k; then the apexes, then the corners of caps. Closed and oriented outward;
/// genus E − V + C in C components. With A apexes (each pointed cap counts as one) V is 2 sides E + A, and the triangles of all faces are
/// 4 (sides + 1) E − 4 V + 2 A. Balls and struts of one joint meet in their common polygon only.
/// Corners are rounded to the last digit that the largest coordinate at their vertex has, so that the hulls' signs are those of whole numbers.
/// Cost: linear but for vertices of many edges, there n log n. Two threads share the balls.
/// @throws CommandError where the polygons of a vertex are smaller than the last digits of its coordinates; Cancelled
/// Source: Hart 2009, section 2.
StrutSurface strut_surface(const Graph& graph, const Incidence& incidence, const StrutPlacer& placer, const StrutPlacement& placement,
                           const StrutShape& shape, Progress& progress);

} // namespace druse
