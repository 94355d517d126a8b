#pragma once

#include "geom/point.h"
#include "tile/isohedral_type.h"
#include "tile/tile_design.h"
#include "tile/tile_look.h"
#include "tile/tile_motion.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace druse::ui {

/// A point of a tile as the editor shows it.
struct TilePoint {
    enum class Kind { corner, path, middle, interior };

    std::string name; // in commands
    Point2 at{0.0};   // in the tile's frame
    Kind kind = Kind::interior;
    int orbit = -1;   // outline points of one number keep one height; −1: alone
    double height = 0;
};

/// A copy of the tile beside others.
struct DrawnCopy {
    Isometry map; // from the tile to it
    int aspect = 0;
    LatticePlace shift;
    int colour = 0; // in the tiling
};

/// Where the whole tiling turns about a point.
struct RotationCentre {
    Point2 at{0.0};
    int order = 2;
};

/// Everything the editor shows of a layered tile, in a copy of its own: it stays while a command works on the document.
struct ShownTile {
    const IsohedralType* type = nullptr; // none: there is no tile
    double size = 1;
    std::vector<double> parameters;
    std::vector<TilePoint> points; // of the outline, anticlockwise, then those inside
    int outline = 0;               // how many of them are the outline's
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::array<int, 2>> segments; // pieces of constraints
    std::vector<DrawnCopy> copies;             // itself, then those around it, the nearest first
    std::vector<RotationCentre> centres;      // near it
    std::optional<double> thickness;          // set: it has a relief
    std::vector<Isometry> aspects;            // one motion for each linear part of the placement group
    std::array<Point2, 2> lattice{};
    TileStack stack;
    TileLook look;

    std::vector<Point2> outline_points() const;
    Point2 low() const;
    Point2 high() const;
    /// Of a point with that name; −1 if there is none.
    int find(const std::string& name) const;
    /// Is the place inside the outline? In the tile's frame.
    bool holds(const Point2& p) const;
};

/// The tile and the `count` copies of it whose middles are nearest to its own. `corners` are those of the tile.
std::vector<DrawnCopy> copies_around(const IsohedralType& type, const CornerVector& corners, std::size_t count);

/// The centres of rotation of the placement group that are at most as far from the middle of the tile as its farthest corner, and a quarter.
std::vector<RotationCentre> rotation_centres(const IsohedralType& type, const CornerVector& corners);

} // namespace druse::ui
