#pragma once

#include "cell/cell_tile.h"
#include "dlfl/mesh_builder.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace druse {

/// How joints between cells come to be: each vertex goes inside by half their width, or the cell shrinks about its centre of mass, which is uneven.
enum class CellJoint { inset, shrink };

/// A cell tile as a solid, in the world: the triangles of each near pane and then those of its far one, turned round, pane by pane.
struct CellSolid {
    struct Side {
        int pane = 0;
        bool far = false;
        friend auto operator<=>(const Side&, const Side&) = default;
    };

    std::vector<Point> points; // by orbits, each with its members in order
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Side> sides; // of triangles
};

/// V, E, F and genus 0 of a closed surface, whatever is moved; it may pierce itself.
/// With a clearance, joints between cells are at least about that wide, half of it taken from each. `inset`: a vertex goes where the planes of its triangles, moved inside by
/// half the width, meet best, and on until none of them has moved by less, but no farther than four times the width. `shrink`: so that panes that are not deformed are that far apart.
/// Cost: linear, a millisecond for 20 000 triangles.
/// @throws CellRefusal vanishes where that leaves nothing, or the solid would go through itself and come out turned
CellSolid make_solid(const CellTile& tile, double clearance = 0, CellJoint joint = CellJoint::inset);

double volume(const CellSolid& solid);
/// Of its inside; the mean of its points where it has none.
Point centre_of_mass(const CellSolid& solid);

/// Adds the solid to a mesh, scaled about a point and then moved. `groups`: of faces by pane; of one group for all, a single one.
void add_solid(MeshBuilder& builder, const CellSolid& solid, std::span<const int> groups, const Vector& shift = Vector(0.0), double scale = 1, const Point& about = Point(0.0));

/// Pane k is group k + 1.
std::vector<int> pane_groups(const CellTile& tile);

} // namespace druse
