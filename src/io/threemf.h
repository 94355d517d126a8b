#pragma once

#include "io/byte_source.h"
#include "io/model.h"
#include "io/output_files.h"

namespace druse {

/// Reads the 3D Manufacturing Format: what its build items and their components place, in millimetres.
///
/// Corners at exactly the same place in single precision become one vertex. If all base materials used are called `group_<id>`, with the name of the
/// group behind a blank, they are the groups; otherwise triangles of one colour are one group, and a triangle of several colours has that of its first
/// corner. Textures, slices and beams are passed over. Cost: linear in the triangles that are placed; the file and what it holds are in memory at once.
/// @throws InputError where the file is none, unpacks to more than 2^30 bytes, or places more than 2^28 corners or 2^20 objects
Model read_3mf(ByteSource& source);

/// Writes one object in millimetres, with a base material `group_<id> NAME` for each group.
///
/// Faces are cut into triangles (Triangulator), and edges upon each other divided. Places are rounded to single precision and to six digits behind the
/// point, so to a nanometre: the same as the slicers that read it work with. The same model gives the same bytes.
/// @throws InputError where nothing has an area after that
void write_3mf(const ModelView& model, OutputFiles& out);

} // namespace druse
