#pragma once

#include "geom/point.h"
#include "tile/point_name.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace druse {

/// How each layer of tiles lies upon the one below it.
struct TileStack {
    enum class Mode { column, shift, mirror, free };

    Mode mode = Mode::column;
    Point2 offset{0.0}; // in the tile frame
    double axis = 0;    // of a mirror: degrees, through the origin of the frame; the offset comes after

    friend bool operator==(const TileStack&, const TileStack&) = default;
};

/// All that a layered tile is made from, as files keep it. Positions are in the tile frame: `size` times those of the type, before the tile is
/// turned and moved to its place.
struct TileDesign {
    int type = 1; // IH number
    double size = 1, rotation = 0; // degrees
    Point2 origin{0.0};
    std::vector<double> parameters;          // of the type, as it names them
    std::vector<std::vector<Point2>> paths;  // inner points, in a frame where the path runs from (0,0) to (1,0); the first half of symmetric ones
    std::vector<Point2> interior;
    std::vector<std::vector<PointName>> segments; // chains of points, straight from each to the next
    std::optional<double> thickness;         // unset: the tile is flat still
    std::map<PointName, double> heights;     // of orbits, by one of their points; 0 where there is none
    TileStack stack;
    std::array<int, 2> across{3, 3};         // how many places of the lattice a drawing of the tiling shows; not in files
    std::string kept;                        // what else its file says, as JSON; written back as it is

    friend bool operator==(const TileDesign&, const TileDesign&) = default;
};

} // namespace druse
