#pragma once

#include "cell/cell_check.h"
#include "cell/cell_solid.h"
#include "cell/cell_tile.h"
#include "dlfl/measures.h"

#include <array>
#include <random>
#include <vector>

namespace druse {

inline constexpr std::array every_cell{CellKind::bcc, CellKind::fcc, CellKind::cube, CellKind::hexprism, CellKind::elongated};

/// Of size 4, or 1 for those that have their corners at that: shortest edges √2, √3, 1, 1/√3 and √3.
inline double table_size(CellKind kind) { return kind == CellKind::cube || kind == CellKind::hexprism ? 1 : 4; }
inline double shortest_edge(CellKind kind)
{
    switch (kind) {
    case CellKind::bcc: return std::sqrt(2.0);
    case CellKind::cube: return 1;
    case CellKind::hexprism: return 1 / std::sqrt(3.0);
    default: return std::sqrt(3.0);
    }
}

/// Each edge in four parts, each pane with a point in the middle and one on the way to each corner and to the middle of each side: T of a fan over halved edges, each
/// triangle in four.
inline CellTile subdivided(CellKind kind)
{
    CellTile tile = CellTile::of_kind(kind, table_size(kind));
    CellDesign design = tile.design();
    for (auto& edge : design.edges) edge = {0.25, 0.5, 0.75};
    for (std::size_t p = 0; p < design.panes.size(); ++p) {
        const std::vector<Point2>& outline = tile.cell().panes[p].outline;
        auto& points = design.panes[p].points;
        points.emplace_back(0.0);
        for (std::size_t k = 0; k < outline.size(); ++k) {
            points.push_back(0.5 * outline[k]);
            points.push_back(0.25 * (outline[k] + outline[(k + 1) % outline.size()]));
        }
    }
    CellTile shaped(design);
    shaped.shape();
    return shaped;
}

/// Makes room for small triangles: points on all sides of a pane.
inline void divide_sides(CellTile& tile, int pane, int parts)
{
    for (const CellSide& side : tile.cell().panes[std::size_t(pane)].sides)
        for (int i = 1; i < parts; ++i) tile.add_edge_point(side.edge.orbit, double(i) / parts);
}

inline double uniform(std::mt19937& random, double from, double to) { return from + (to - from) * (double(random()) / 4294967296.0); }

/// Every orbit moved by up to `most` along each axis.
inline CellTile shaken(CellTile tile, double most, std::mt19937& random)
{
    for (int i = 0; i < tile.point_count(); ++i)
        tile.move(std::array{i}, Vector(uniform(random, -most, most), uniform(random, -most, most), uniform(random, -most, most)));
    return tile;
}

inline Mesh mesh_of(const CellTile& tile)
{
    MeshBuilder builder;
    add_solid(builder, make_solid(tile), pane_groups(tile));
    return builder.build();
}

} // namespace druse
