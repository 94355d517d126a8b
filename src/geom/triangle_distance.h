#pragma once

#include "geom/triangle_contact.h"

namespace druse {

/// The least distance between two triangles that do not cross; either may be without area.
double triangle_distance(const Triangle& a, const Triangle& b);

} // namespace druse
