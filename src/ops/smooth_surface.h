#pragma once

#include "dlfl/mesh.h"
#include "geom/progress.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace druse {

/// A mesh as a preview shows it smooth, and where each of its faces comes from.
struct SmoothSurface {
    Mesh mesh;                           // with the groups of the old faces
    std::vector<std::uint32_t> old_face; // by face; those of one old face follow each other, in the order of the old faces
};

/// Catmull and Clark's limit surface of a closed mesh: what remesh.subdivide_limit makes of it, at a level fine enough to look round and
/// coarse enough to be drawn at once: the highest up to 5 that has at most 100 000 faces, or else 1. Where even that has more than
/// `most_faces`, it is the mesh itself with its vertices moved to where the limit surface has them.
/// @throws CommandError, one line that says why there is none: the model is open, or has more than 2 million edges, or as limit_surface()
SmoothSurface smooth_surface(const Mesh& mesh, Progress& progress, std::size_t most_faces = 1'000'000);

} // namespace druse
