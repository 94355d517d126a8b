#pragma once

#include "pane/pane.h"

#include <string>
#include <vector>

namespace druse {

/// What a whole look at a pane found. Sizes in model units, angles in degrees.
struct PaneCheck {
    std::vector<std::string> faults; // what does not hold of what a pane promises; empty, unless we made a mistake
    std::size_t points = 0, boundary_points = 0, holes = 0, segments = 0, triangles = 0, edges = 0, locked = 0;
    double area = 0;
    double smallest_angle = 180;
    std::size_t thin_triangles = 0; // with an angle below 10 degrees
    std::size_t short_edges = 0;    // shorter than the nozzle of a printer

    bool sound() const { return faults.empty(); }
};

/// Looks at every face, edge, point, segment and loop, by exact signs and without what the edits keep for themselves. Cost: linear but for a sort.
/// Checked: faces turn counter-clockwise and pair up; free edges are Delaunay, ties as promised; pieces of segments and loops are edges, and no other
/// edge carries one; V, E and T are what points, loops and holes say; the area is that of the loops, but for rounding; no two points are nearer than
/// weld; twins are where their maps take their points, but for rounding.
PaneCheck check(const Pane& pane, double nozzle = 0.4);

} // namespace druse
