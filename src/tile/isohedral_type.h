#pragma once

#include "tile/corner_motion.h"
#include "tile/corner_space.h"
#include "tile/incidence_symbol.h"
#include "tile/isohedral_table.h"
#include "tile/plane_group.h"
#include "tile/tile_colours.h"
#include "tile/tile_path.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace druse {

/// Which path an edge has, and how it is put there.
struct TileEdge {
    int path = 0;
    Preparation preparation = Preparation::none;
};

/// Where a tile lies: its corner `held` at `origin`, everything else turned anticlockwise and `size` times as large as in the frame of the type.
struct TileFrame {
    Point2 origin{0.0};
    double size = 1.0, rotation = 0.0; // radians

    Point2 world(const Point2& canonical) const;
    Point2 canonical(const Point2& world) const;
};

/// The tile beyond an edge of a tile: the copy `aspect`, moved by a place of the lattice.
struct TileNeighbour {
    int aspect = 0;
    LatticePlace shift;
    int partner = 0; // its edge that lies there
};

/// One of the 81 types of isohedral tilings by tiles without marks: which corners a tile may have, which of its edges have the same path, and
/// where the copies lie. Corners may move freely as long as they are admissible: all else follows linearly.
struct IsohedralType {
    int number = 0;
    const TileNet* net = nullptr;
    IncidenceSymbol symbol;
    int corners = 0, held = 0;
    CornerVector start{}; // the corners by default

    std::vector<OwnSymmetry> own; // symmetries of every tile of this type
    std::vector<TileEdge> edges;
    std::vector<PathShape> shapes; // of the paths, by letter

    CornerSpace admissible; // all movements of the corners, with size, direction and place of the tile
    CornerSpace inside;     // those that leave the held corner and the held translation as they are
    std::vector<int> parameters;             // coordinates of the corners, as indices of a CornerVector
    std::vector<CornerVector> movements;     // what each of them does to all corners
    std::optional<CornerShift> held_translation; // of types with parameters: it keeps its value at the default corners

    PlaneGroup full;   // all motions that carry the tiling to itself
    PlaneGroup placed; // a subgroup that carries one tile to each tile once: its representatives are the aspects
    std::vector<TileCrossing> placing; // the partner of each edge in it
    std::vector<std::vector<TileNeighbour>> neighbours; // of each aspect, edge by edge
    std::vector<int> corner_orbit; // corners with the same number are carried into one another by `placed`
    TileColours colours;

    std::string name() const;                     // `IH07`
    std::string own_name() const;                 // `C1`, `D3`
    std::string parameter_name(int p) const;      // `x5`
    std::string edge_text() const;                // `a+ b+ ar br`
    std::string shape_text() const;               // `JS`
    bool has_mirrored_aspects() const;
    int aspects() const { return static_cast<int>(placed.representatives.size()); }
    std::vector<double> default_parameters() const;

    /// The corners for these parameters. @throws CommandError for another number of them than the type has, naming them.
    CornerVector corners_of(std::span<const double> values) const;
};

/// What moving a corner made of a tile.
struct MovedTile {
    TileFrame frame;
    std::vector<double> parameters;
};

/// Moves corner k as near as it can come to `target`, a place in the frame of the type, while all corners together move least. Where the frame holds
/// the corner, the frame moves. @throws CommandError where the type is fixed.
MovedTile drag_corner(const IsohedralType& type, std::span<const double> parameters, int k, const Point2& target);

/// Frame and parameters of the tile of this type nearest to `corners`, which may come from another type of the same net.
MovedTile nearest_tile(const IsohedralType& type, const CornerVector& corners);

/// All of them by number, derived on the first call.
const std::vector<IsohedralType>& isohedral_types();

/// @throws CommandError where there is no such type, or tiles of that type need marks.
const IsohedralType& isohedral_type(int number);

} // namespace druse
