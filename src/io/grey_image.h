#pragma once

#include "geom/point.h"
#include "io/byte_source.h"

#include <cstddef>
#include <vector>

namespace druse {

/// A picture as shades: 0 is black and 1 white.
struct GreyImage {
    std::size_t width = 0, height = 0;
    std::vector<float> shades; // row by row from the top

    /// Between the middles of pixels, linearly; x to the right and y upwards, both from 0 to 1 over the picture. Beyond, the rim goes on.
    double at(const Point2& place) const;
};

/// Reads a PNG of any kind; of colours, their brightness, and what is transparent is black. Those with 16 bits keep them. @throws InputError
GreyImage read_grey_png(ByteSource& source);

} // namespace druse
