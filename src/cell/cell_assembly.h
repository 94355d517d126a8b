#pragma once

#include "cell/cell_solid.h"
#include "geom/progress.h"

#include <array>
#include <vector>

namespace druse {

/// What tells cells of an assembly apart: a colouring by translations in which those that share a pane differ, the height of their centres, or nothing, since all have
/// one aspect.
enum class CellColour { type, layer, aspect };

/// A cell with those around it, shell by shell.
struct CellAssembly {
    int shells = 1;
    double shrink = 1; // of each about its centre of mass
    CellColour color = CellColour::type;
    double clearance = 0;
    CellJoint joint = CellJoint::inset;
};

/// The steps to a cell itself and to those around it: of each shell, those that share a pane with one of the shell before, in order.
std::vector<LatticeStep> cells_around(const Parallelohedron& cell, int shells);

/// A colouring of the cells of a lattice by a number modulo another, with the fewest colours that tell cells apart which share a pane.
struct LatticeColours {
    std::array<int, 3> weights{};
    int count = 1;
    int of(const LatticeStep& step) const;
};
LatticeColours colour_cells(const Parallelohedron& cell);

inline constexpr std::size_t most_cell_faces = 20'000'000;

/// Adds the cells to a mesh; face groups are colours from 1 on. Each is a component of genus 0.
/// @throws CommandError where there would be more than most_cell_faces; CellRefusal as of make_solid
void assemble(MeshBuilder& builder, const CellTile& tile, const CellAssembly& assembly, Progress& progress);

} // namespace druse
