#pragma once

#include "dlfl/mesh.h"
#include "geom/progress.h"
#include "ops/remesh.h"

#include <vector>

namespace druse {

enum class LimitScheme { catmull_clark, loop };

struct LimitSurface {
    LimitScheme scheme = LimitScheme::catmull_clark;
    int level = 2;
    std::vector<Edge> creases = {}; // edges of the old mesh
    double sharpness = 10;     // of the creases: 0 smooth, 10 never smoothed; between, smooth after as many levels
    bool to_limit = true;      // otherwise the points stay those of the last level
    RemeshGroups groups = RemeshGroups::keep;
};

/// Subdivides a closed mesh `level` times and moves the points to where they would go in infinitely many levels.
///
/// Connectivity and numbering are those of remesh.catmull_clark, or remesh.loop, with as many iterations; without creases so are the points,
/// if they do not go to the limit. OpenSubdiv does it. The old mesh does not change, so this serves previews too.
/// @throws CommandError as remeshed(); for Loop's scheme also where a face is no triangle; where a face has more than 65535 sides or a vertex
/// more edges
/// Source: Catmull & Clark 1978; Loop 1987; DeRose, Kass & Truong, *Subdivision surfaces in character animation* (1998), for the creases.
Mesh limit_surface(const Mesh& mesh, const LimitSurface& surface, Progress& progress);

} // namespace druse
