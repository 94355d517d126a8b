#pragma once

#include "io/byte_source.h"
#include "io/model.h"
#include "io/output_files.h"

#include <cstddef>

namespace druse {

/// Reads STL, binary or ASCII, whatever its header claims to be. Corners at exactly the same place become one vertex; facets that
/// have fewer than three places are left out; normals and attribute bytes are passed over. ASCII loops may have any number of
/// corners. Throws InputError for a file that ends early, or a coordinate that is no number, with the line or the triangle. Cost:
/// linear, in blocks of a megabyte.
Model read_stl(ByteSource& source);

/// Of binary STL, in bytes: text and the number of triangles before them; twelve numbers and two attribute bytes for each.
inline constexpr std::size_t stl_header_size = 84, stl_record_size = 50;

/// Writes STL: binary, or ASCII if wanted. Faces are cut into triangles (Triangulator), positions rounded to single precision,
/// normals those of the triangles. Open boundaries are not written, nor what has no area to show: point spheres and 2-gons.
void write_stl(const ModelView& model, OutputFiles& out);

} // namespace druse
