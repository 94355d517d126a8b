#pragma once

#include "dlfl/self_intersections.h"
#include "ops/scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace druse {

/// Where the solid of a scene meets itself: its mesh, or what its tile or cell describes where there is no mesh. None without either. @throws Cancelled
std::optional<SelfIntersections> self_intersections(const Scene& scene, Progress& progress);

/// Everything that `druse info` says of a scene, as one JSON object. `file` is where it came from, `met` where the mesh meets itself, if
/// that was looked for.
///
/// Lengths, areas and volumes are in model units (mm), angles in degrees. Of a graph without faces, what follows from faces is 0 or
/// null. Cost: that of facts(Mesh).
std::string info_json(const Scene& scene, std::string_view file, const std::optional<SelfIntersections>& met = std::nullopt);

/// The same facts as lines of text, aligned, with units.
std::string info_text(const Scene& scene, std::string_view file, const std::optional<SelfIntersections>& met = std::nullopt);

} // namespace druse
