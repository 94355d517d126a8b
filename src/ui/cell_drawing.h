#pragma once

#include "ui/cell_plane.h"

#include "geom/colour.h"
#include "render/image.h"

namespace druse::ui {

/// Draws the flat pane that a plane shows, with its sides and corners in the colours of their orbits. `scale` is that of the layout; the image has the size of the view.
void draw_pane(const CellPlane& plane, bool dark, double scale, Image& image);

/// Colours that tell the orbits of edges, or of corners, of one cell apart.
Colour orbit_colour(int edge_orbit, bool dark);
Colour corner_colour(int corner_orbit, bool dark);

} // namespace druse::ui
