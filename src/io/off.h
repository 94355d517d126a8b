#pragma once

#include "io/byte_source.h"
#include "io/model.h"
#include "io/output_files.h"

namespace druse {

/// Reads OFF in text, with normals, colours and texture coordinates of vertices or without (OFF, NOFF, COFF, STOFF and together).
///
/// Faces, vertices and start corners stay as in the file. Faces of one colour are one group; without colours of faces those of
/// vertices count. A colour is three or four numbers, whole ones of 0 to 255 or others of 0 to 1; the fourth, its opacity, is
/// passed over, and so is a lone number, which stands for a colour in a list of Geomview's. A face of one corner is a point
/// sphere. Throws InputError with the line. Cost: linear, in blocks of a megabyte.
Model read_off(ByteSource& source);

/// Writes OFF in text. A face in a group is followed by the group's colour: ids and names are not saved. Open boundaries are not
/// written; edges that an index list cannot tell apart are split (EdgeSplits).
void write_off(const ModelView& model, OutputFiles& out);

} // namespace druse
