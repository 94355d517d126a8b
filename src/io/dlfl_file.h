#pragma once

#include "io/byte_source.h"
#include "io/model.h"
#include "io/output_files.h"

namespace druse {

/// Reads TopMod's `.dlfl`: vertices, corners, edges as pairs of corners, and faces as cycles of corners, so that parallel edges,
/// 2-gons and point spheres come back as they were. Faces and vertices stay in file order. Colours of materials become groups
/// as in OBJ, unless group ids follow after TopMod's part. Throws InputError where the lists contradict each other.
Model read_dlfl(ByteSource& source);

/// Writes `.dlfl` so that TopMod reads it, followed by what is ours: `druse 1`, `g` with the group id of each face, and `open`
/// with the faces that stand for an open boundary.
void write_dlfl(const ModelView& model, OutputFiles& out);

} // namespace druse
