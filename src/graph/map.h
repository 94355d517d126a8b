#pragma once

#include "geom/progress.h"
#include "graph/graph.h"

#include <optional>
#include <string>
#include <vector>

namespace druse {

enum class MapTo { disk, polyp, helix, torus, knot, polyhedron };
enum class HelixShape { sphere, cylinder };

/// How a tessellation of the disk becomes a figure in space. Numbers that are unset depend on what it becomes.
struct MapShape {
    MapTo to = MapTo::disk;
    double size = 1;                        // factor on the result

    double rim = 0.6, height = 0.6;         // polyp: the radius of its rim, and the height there
    std::optional<std::string> height_expr{}; // polyp: z in x, y, r, t instead

    int turns = 2;                          // helix: from −turns to turns
    HelixShape shape = HelixShape::sphere;
    double span = 0.9, pitch = 0.3;         // of a sphere the part from pole to pole; of a cylinder the height of a turn

    std::optional<int> cycles{};            // torus, knot: how often the disk is swept
    std::optional<double> major{}, rho{};   // torus, knot: radius of the way round and of the disk that is swept
    double minor = 1;                       // knot: how far it swings about that
    double phase = 0;                       // knot: degrees by which the disk is turned
    bool force = false;                     // knot: also where the tube meets itself
};

/// What a sweep takes where `cycles`, `major` and `rho` are unset. Precondition: torus or knot
struct SweepSize {
    int cycles;
    double major, rho;
};
constexpr SweepSize usual_sweep(MapTo to) { return to == MapTo::torus ? SweepSize{5, 1.6, 1} : SweepSize{9, 2, 0.6}; }

/// Maps a graph that lies in the unit disk; (r, θ) below are its polar coordinates.
///
/// disk: (x, y, 0). polyp: z = height · (1 − ((r − rim)/rim)²), or any expression. Sweeps turn about the centre k times, so that the face there
/// becomes endless: helix, from end to end, what would go beyond left out; torus and knot, closed, one ray of the disk at each place along the way.
/// polyhedron: a sector of the disk between two mirror rays for each edge of a solid, cut off at the rays, which all edges that meet at
/// a vertex share. `solid` is its graph, with vertices at distance 1 from the origin; only polyhedron takes it.
/// V and E become k V and k E for torus and knot, V and E less what is at the ends for the helix, and those of the sector times the
/// solid's edges and of its rays times the solid's vertices for polyhedra.
/// @throws CommandError for a graph that has nothing of that kind at its centre, a formula without a value, tubes that meet themselves
/// Cost: linear; a sort of what lies on the two rays. Source: Hart 2009, 4.1 to 4.6.
Graph map_disk(const Graph& graph, const MapShape& shape, const Graph& solid, std::vector<std::string>& notes, Progress& progress);

} // namespace druse
