#pragma once

#include "geom/progress.h"
#include "tile/tile_solid.h"

namespace druse {

/// What tells tiles of an assembly apart: their aspect, their layer, or the colouring of the type, in which neighbours differ.
enum class TileColour { aspect, layer, type };

/// A block of a stack: all tiles of nx × ny places of the lattice, layer upon layer.
struct TileAssembly {
    int nx = 3, ny = 3, layers = 2;
    double gap = 0; // by which tiles are moved apart, in the plane on the average
    TileColour color = TileColour::aspect;
    TileBottom bottom = TileBottom::carved;
    double clearance = 0;
};

inline constexpr std::size_t most_assembly_faces = 20'000'000;

/// Adds the block to a mesh, in the world; face groups are colours from 1 on. Each tile is a component of genus 0. Hands back the thinnest place of
/// the solids, in the tile frame.
/// @throws CommandError where there would be more than most_assembly_faces
Thinnest assemble(MeshBuilder& builder, const LayeredTile& tile, const TileAssembly& assembly, Progress& progress);

} // namespace druse
