#pragma once

#include "io/byte_source.h"
#include "io/model.h"
#include "io/output_files.h"

namespace druse {

/// Reads a pane as Druse writes it: JSON, `"format":"druse-pane"`. Its triangles follow from the rest; a note says if the file has others.
/// @throws InputError with line and path of the key, as `points[3][0]`, where a number or list is not what it should be
Model read_pane(ByteSource& source);

/// Writes the pane of a model, a line for each key. Equal panes give equal files.
/// @throws InputError if there is none
void write_pane(const ModelView& model, OutputFiles& out);

} // namespace druse
