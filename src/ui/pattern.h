#pragma once

#include "dlfl/mesh.h"
#include "ops/operator.h"

#include <optional>
#include <string>

namespace druse::ui {

/// What an extrusion is known by: the solid it makes of the regular polygon that suits it best, by its registered defaults.
///
/// That is the polygon of 3 to 6 sides over which the edges come out most alike, then the faces: the regular solids are found by
/// it from the extrusions alone, and others have a shape as good as they can. Where the solid is a parameter (`solid_parameter`), it is the
/// one named, or that of the operator's example. Nothing for operators that extrude nothing, and for solids in files.
std::optional<Mesh> pattern_of(const Operator& op, const std::string& solid = {});

/// The parameter that names a built-in solid or a file; null if there is none.
const Parameter* solid_parameter(const Operator& op);

} // namespace druse::ui
