#pragma once

#include "dlfl/mesh_builder.h"
#include "io/byte_source.h"
#include "io/model.h"

#include <cstdint>

namespace druse {

/// Builds the mesh of the polygons that a reader gathered, and notes what was mended. Of vertices in no face, so many are not
/// left out but belong to something else.
/// @throws InputError if the surface is one-sided, or no polygon is a face and the model holds nothing else
void build_mesh(MeshBuilder& builder, const ByteSource& source, Model& model, std::uint32_t used_elsewhere = 0);

} // namespace druse
