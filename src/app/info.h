#pragma once

#include "ops/scene.h"

#include <string>
#include <string_view>

namespace druse {

/// Everything that `druse info` says of a scene, as one JSON object. `file` is where it came from.
///
/// Lengths, areas and volumes are in model units (mm), angles in degrees. Of a graph without faces, what follows from faces is 0 or
/// null. Cost: that of facts(Mesh).
std::string info_json(const Scene& scene, std::string_view file);

/// The same facts as lines of text, aligned, with units.
std::string info_text(const Scene& scene, std::string_view file);

} // namespace druse
