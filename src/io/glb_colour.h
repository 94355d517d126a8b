#pragma once

#include "geom/colour.h"

#include <cmath>

namespace druse {

// Base colours of glTF are linear, ours are sRGB (IEC 61966-2-1). All 256 values of a channel come back from there.

inline double linear_from_srgb(double c)
{
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

inline double srgb_from_linear(double c)
{
    return c <= 0.0031308 ? c * 12.92 : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

} // namespace druse
