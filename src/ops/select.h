#pragma once

#include "geom/progress.h"
#include "ops/scene.h"

#include <vector>

namespace druse {

// Lists of elements are ascending and without repeats, as in Selection.

/// The elements, and those that can be reached from them in so many steps: faces and edges step across a shared vertex, vertices
/// along an edge. Cost: O(mesh) for the marks, then what is reached.
std::vector<Face> grow(const Mesh& mesh, const std::vector<Face>& faces, int steps, Progress& progress);
std::vector<Edge> grow(const Mesh& mesh, const std::vector<Edge>& edges, int steps, Progress& progress);
std::vector<Vertex> grow(const Mesh& mesh, const std::vector<Vertex>& vertices, int steps, Progress& progress);

/// All that are not in the list.
std::vector<Face> others(const Mesh& mesh, const std::vector<Face>& faces);
std::vector<Edge> others(const Mesh& mesh, const std::vector<Edge>& edges);
std::vector<Vertex> others(const Mesh& mesh, const std::vector<Vertex>& vertices);

/// The edges met by going straight on from an edge, both ways, over vertices with four edges, as far as there are such.
std::vector<Edge> edge_loop(const Mesh& mesh, Edge e);

/// The edges met by crossing quads from side to opposite side, both ways, as far as there are quads; and those quads.
struct Ring {
    std::vector<Edge> edges;
    std::vector<Face> faces;
};
Ring edge_ring(const Mesh& mesh, Edge e);

} // namespace druse
