#pragma once

#include "io/byte_source.h"
#include "io/model.h"
#include "io/output_files.h"

namespace druse {

/// Reads glTF 2.0, binary or in text, with its data inside or beside it.
///
/// Triangles, strips and fans of all meshes of the scene stand where their nodes put them, and corners at exactly the same place
/// become one vertex. If all materials used are called `group_<id>` they are the groups, with the `name` of their extras;
/// otherwise triangles of one base colour are one group. Points, lines, skins, morph targets, textures and animations are passed
/// over. The y axis of glTF, which looks up, becomes our z. Throws InputError for whatever points outside of the file. Cost:
/// linear in the size of the file and in the triangles, the data in memory once.
Model read_gltf(ByteSource& source);

/// Writes binary glTF 2.0: a mesh with one primitive and material `group_<id>` for each group, its name in the material's extras.
///
/// Faces are cut into triangles (Triangulator) and positions rounded to single precision. Our z, which looks up, becomes the y of
/// glTF, our y its −z; a unit stays a unit. There are no normals, so viewers show flat faces. Open boundaries are not written,
/// nor what has no area to show: point spheres and 2-gons.
void write_glb(const ModelView& model, OutputFiles& out);
/// The same in text, with the data inside.
void write_gltf(const ModelView& model, OutputFiles& out);

} // namespace druse
