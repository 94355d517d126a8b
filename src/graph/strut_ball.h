#pragma once

#include "geom/convex_hull.h"
#include "geom/progress.h"
#include "graph/strut_placement.h"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace druse {

/// Rounds coordinates to multiples of a power of two, fine as the last digits of the largest coordinate near a point.
class CoordinateGrid {
public:
    /// For coordinates of points within `reach` of p.
    CoordinateGrid(const Point& p, double reach);
    Point operator()(const Point& p) const { return (p + shift_) - shift_; }
    /// What coordinates are multiples of.
    double step() const { return std::ldexp(shift_.x / 1.5, -52); }

private:
    Vector shift_;
};

/// Faces of balls, one after the other.
struct BallFaces {
    static constexpr std::uint32_t apex = 1u << 31; // in a corner: number of an apex instead of a polygon's corner

    std::vector<std::uint32_t> corners;            // vertices
    std::vector<std::uint32_t> ends;               // of faces, in `corners`
    std::vector<std::uint32_t> ball_ends;          // of balls, in `ends`
    std::vector<Point> apexes;
};

/// Makes the surface around vertices, one after the other, in memory that it keeps.
class BallMaker {
public:
    /// `rims` has corner k of the polygon at end i at i · sides + k, counter-clockwise around the direction of the edge. Borrows all of it.
    BallMaker(const Graph& graph, const Incidence& incidence, const StrutPlacer& placer, const StrutPlacement& placement, const StrutShape& shape,
              std::span<const Point> rims, Progress& progress)
        : graph_(graph), incidence_(incidence), placer_(placer), placement_(placement), shape_(shape), rims_(rims), sides_(static_cast<std::uint32_t>(shape.sides)), progress_(progress)
    {
    }

    /// Adds the faces of a ball: the hull of the polygons at a vertex, without these; and of the vertex where the hull leaves it outside.
    /// Precondition: two edges at least.
    /// @throws CommandError where the hull does not have the sides of the polygons: these are smaller than coordinates tell apart; Cancelled
    void make(std::uint32_t v, BallFaces& out);

private:
    Point pole(std::uint32_t end, const CoordinateGrid& grid) const;
    void gather(std::uint32_t v, const CoordinateGrid& grid);
    bool has_all_sides() const;
    bool is_lid(const ConvexHull::Facet& f) const;
    std::uint32_t pole_of(const ConvexHull::Facet& f) const;
    bool leaves_out(const Point& p, double least) const;
    void put_triangles(BallFaces& out);
    void put_merged(BallFaces& out);
    bool put_polygon(BallFaces& out);
    std::uint32_t vertex(std::uint32_t point, const BallFaces& out) const;

    const Graph& graph_;
    const Incidence& incidence_;
    const StrutPlacer& placer_;
    const StrutPlacement& placement_;
    const StrutShape& shape_;
    std::span<const Point> rims_;
    std::uint32_t sides_;
    Progress& progress_;

    std::uint32_t v_ = 0;
    std::span<const std::uint32_t> star_; // the ends at v
    ConvexHull hull_;
    std::vector<Point> points_;
    std::vector<std::uint32_t> names_; // of points: vertices, or poles
    // While merging: by facet, by point, and of the region at hand.
    std::vector<Vector> normals_;
    std::vector<std::uint32_t> region_of_, next_, region_;
    std::uint32_t stamp_ = 0;
    std::vector<std::uint32_t> stamps_;
};

} // namespace druse
