#pragma once

#include "dlfl/mesh.h"

#include <vector>

namespace druse {

/// What of a mesh is no longer as it was drawn. Elements that are gone are listed too, as far as their ids are still below the
/// mesh's limits; those past the limits need not be.
struct MeshDelta {
    bool whole = false;           // everything; the lists are not looked at
    std::vector<Vertex> vertices; // moved, new or gone
    std::vector<Edge> edges;      // new, gone, or with other ends
    std::vector<Face> faces;      // new, gone, or with other corners
    std::vector<Face> regrouped;  // only their group changed
};

/// What differs between a mesh and the state that `other` leads to (as Mesh::end_change or Mesh::exchange left it), exactly:
/// pages that were kept but hold the same values add nothing. Cost: that of the change.
MeshDelta difference(const Mesh& now, const MeshChange& other);

} // namespace druse
