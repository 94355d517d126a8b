#pragma once

#include "tile/isohedral_type.h"
#include "tile/point_name.h"

#include <span>
#include <vector>

namespace druse {

/// A point of the outline of a tile.
struct OutlinePoint {
    PointName name;
    Point2 position{0.0}; // in the tile frame
    int edge = 0;         // of the type
    int place = 0;        // on that edge, from its start; 0: the corner itself
    int orbit = 0;        // points with the same number are carried into one another by the placement group
};

/// The outline of a tile, derived from its paths: so it has the symmetry that copies need to fit, whatever the paths are.
struct TileOutline {
    std::vector<OutlinePoint> points; // anticlockwise from corner 0
    std::vector<int> corner;          // where each corner is among them; then, once more, how many they are
    int orbits = 0;

    int size() const { return static_cast<int>(points.size()); }
    int next(int i) const { return i + 1 == size() ? 0 : i + 1; }
    std::vector<Point2> positions() const;
    /// Where that point is, or −1.
    int find(const IsohedralType& type, const PointName& name) const;
};

/// Whether a preparation runs a path from its end to its start.
inline bool runs_backwards(Preparation p) { return p == Preparation::half_turn || p == Preparation::flip; }

/// What is stored of a path, point by point, and what it means on an edge.
struct PathPoint {
    PointName::Kind kind = PointName::Kind::path;
    int index = 0; // in the stored path
    Point2 at{0.0};
};

/// Whether a path must be the same backwards, so that its first half is stored: S and U always, I where edges ask for it.
bool is_half_stored(const IsohedralType& type, int path);

/// @throws TileRefusal half_path where points are not in the first half, or not on a straight path; CommandError where they are no numbers
void check_path(const IsohedralType& type, int path, std::span<const Point2> stored);

/// All inner points of a path, from (0,0) to (1,0). Precondition: check_path().
std::vector<PathPoint> whole_path(const IsohedralType& type, int path, std::span<const Point2> stored);

TileOutline make_outline(const IsohedralType& type, const CornerVector& corners, double size, std::span<const std::vector<Point2>> paths);

/// A place in the frame of a path, as a preparation moves it; doing that twice changes nothing.
Point2 prepared_point(const Point2& p, Preparation preparation);

/// Where a place is in the frame in which `from`-`to` is (0,0)-(1,0).
Point2 off_edge(const Point2& p, const Point2& from, const Point2& to);

/// Whether p is inside a polygon; on its boundary, either.
bool contains(std::span<const Point2> polygon, const Point2& p);

/// The side of a polygon that is nearest to p, from its corner with that number.
struct NearestSide {
    int side = 0;
    double distance = 0;
};
NearestSide nearest_side(std::span<const Point2> polygon, const Point2& p);

/// Twice the area, positive if they run anticlockwise.
double twice_area(std::span<const Point2> polygon);

} // namespace druse
