#pragma once

#include "geom/colour.h"
#include "render/image.h"
#include "tile/isohedral_type.h"

#include <vector>

namespace druse::ui {

/// How many times round the tiles of a type meet about one point: 6, 4, 3, 2, or 1 where nothing rotates.
int rotations_of(const IsohedralType& type);

/// A tile of the type by default, with paths that show what shape each may have. Anticlockwise.
std::vector<Point2> sample_outline(const IsohedralType& type);

/// Colours of tiles that differ from their neighbours, and the line between them, by number from 0 to 2.
Colour tile_colour(int number);

/// A piece of the tiling by sample tiles, in its two or three colours.
Image type_picture(const IsohedralType& type, int size);

} // namespace druse::ui
