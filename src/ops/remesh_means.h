#pragma once

#include "geom/progress.h"
#include "ops/remesh_old_mesh.h"

namespace druse::remesh {

/// The mean of the corners of each face.
void write_face_means(const OldMesh& old, Point* to, Progress& progress);

} // namespace druse::remesh
