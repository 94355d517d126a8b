#pragma once

#include "io/byte_source.h"
#include "io/model.h"
#include "io/output_files.h"

namespace druse {

/// Reads Wavefront OBJ: polygons of any size, polylines (`l`, kept as a graph) and points (`p`, point spheres).
///
/// Faces, vertices and start corners stay as in the file. Colours of materials, TopMod's `c r g b` records, or else those of
/// vertices become face groups (FacePaints). Texture coordinates, normals and everything else is passed over. What is no closed,
/// oriented 2-manifold is mended as MeshBuilder says; the notes tell what was done. Throws InputError, with the line where there
/// is one. Cost: linear, in blocks of a megabyte.
Model read_obj(ByteSource& source);

/// Writes Wavefront OBJ and, if a face is grouped, the .mtl file with the groups' colours and names beside it.
///
/// Faces begin at their start corner, numbers are the shortest that read back the same, open boundaries are not written. Index
/// lists cannot tell parallel edges apart: all but one of them get a vertex in the middle, and loops two, in the file only. The
/// graph is written as lines between vertices of its own; beside a mesh not if struts in it were made of that. Throws InputError if there is neither.
void write_obj(const ModelView& model, OutputFiles& out);

} // namespace druse
