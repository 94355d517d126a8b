#pragma once

#include "tile/layered_tile.h"
#include "tile/tile_solid.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace druse {

/// A tile with straight edges and one point inside, and what exact arithmetic says of it.
struct Reference {
    std::string name;
    int type;
    double size;
    Point2 inside;
    double height;
    TileStack stack;
    double thickness, area;
    std::array<int, 3> top, bottom; // V, T, and points on the boundary
    std::array<int, 3> solid;       // V, E, F
    double volume, thinnest;
};

inline std::vector<Reference> references()
{
    using enum TileStack::Mode;
    const double root = std::sqrt(3.0);
    return {
        {"IH41Column", 41, 10, {5, 5}, 1, {shift, {0, 0}, 0}, 4, 100, {5, 4, 4}, {5, 4, 4}, {10, 20, 12}, 400, 4},
        {"IH41HalfAndHalf", 41, 10, {5, 5}, 1, {shift, {5, 5}, 0}, 4, 100, {5, 4, 4}, {9, 8, 8}, {14, 28, 16}, 400, 3},
        {"IH41Skew", 41, 10, {5, 5}, 1, {shift, {3, 2}, 0}, 4, 100, {5, 4, 4}, {18, 18, 16}, {23, 47, 26}, 400, 3.4},
        {"IH01", 1, 10, {3, 5}, 1, {shift, {3, 2}, 0}, 4, 50 * root, {7, 6, 6}, {21, 22, 18}, {28, 60, 34}, 200 * root, 3 + 3 / (3 * root + 5)},
        {"IH79WholeLeg", 79, 20, {10, 4}, 2, {shift, {10, 10}, 0}, 5, 100, {5, 4, 4}, {6, 4, 6}, {11, 21, 12}, 500, 3},
        {"IH79Mirror", 79, 20, {10, 4}, 2, {mirror, {0, 0}, 0}, 5, 100, {5, 4, 4}, {5, 4, 4}, {10, 20, 12}, 500, 5},
        {"IH31Column", 31, 20, {12, 2}, 2, {shift, {0, 0}, 0}, 5, 100 * root, {5, 4, 4}, {5, 4, 4}, {10, 20, 12}, 500 * root, 5},
        {"IH31Mirror", 31, 20, {12, 2}, 2, {mirror, {0, 0}, 0}, 5, 100 * root, {5, 4, 4}, {5, 4, 4}, {10, 20, 12}, 500 * root, 3 + 2 * (6 - root) / (6 + root)},
    };
}

inline LayeredTile straight_tile(const Reference& r)
{
    LayeredTile tile = LayeredTile::of_type(r.type, r.size);
    tile.add_point(r.inside);
    tile.set_stack(r.stack);
    tile.extrude(r.thickness);
    tile.set_heights(std::array{tile.find(PointName::interior(0))}, r.height);
    return tile;
}

/// V, T and points on the boundary, of a disk: T = 2 V − B − 2.
inline std::array<int, 3> disk_counts(const HeightField& field)
{
    const int v = static_cast<int>(field.points.size()), t = static_cast<int>(field.triangles.size());
    return {v, t, 2 * v - 2 - t};
}

inline Mesh mesh_of(const TileSolid& solid, const SolidPlace& place = {})
{
    MeshBuilder builder;
    add_solid(builder, solid, place);
    return builder.build();
}

} // namespace druse
