#pragma once

#include "geom/colour.h"
#include "geom/point.h"

namespace druse {

/// A line, or where both ends are the same a round dot, with a width in pixels.
struct ThickLine {
    Point from, to;
    Colour colour;
    double width = 3;
    double opacity = 1;
    friend bool operator==(const ThickLine&, const ThickLine&) = default;
};

} // namespace druse
