#pragma once

#include "io/byte_source.h"
#include "io/model.h"
#include "io/output_files.h"

namespace druse {

/// Reads PLY: ASCII, or binary of either byte order.
///
/// Faces, vertices and start corners stay as in the file. Groups are the face property `group`, with the colours of their first
/// faces and the names of `comment group <id> <name>`; without it faces of one colour are one group, and without that the colours
/// of vertices count. Scalars may have any type; other elements and properties are passed over. A face of one corner is a point
/// sphere. Throws InputError with the line, or in binary files the byte, for a file that ends early or says what cannot be. Cost:
/// linear, in blocks of a megabyte.
Model read_ply(ByteSource& source);

/// Writes PLY: binary with the least byte first, or ASCII if wanted; positions in double precision.
///
/// If a face is grouped, faces carry `int group` and `uchar red, green, blue`, and comments give the groups their names. Open
/// boundaries are not written; edges that an index list cannot tell apart are split (EdgeSplits).
void write_ply(const ModelView& model, OutputFiles& out);

} // namespace druse
