#pragma once

#include "ops/operator.h"
#include "tile/layered_tile.h"

#include <utility>

namespace druse {

/// The tile that a document holds. @throws CommandError if it holds none
const LayeredTile& tile_of(const Scene& scene);

/// Runs f(tile) on a copy of the tile that a document holds, which then takes its place. @throws what f throws; CommandError if there is none
template <class F>
void edit_tile(Scene& scene, Context& context, F&& f)
{
    LayeredTile tile = tile_of(scene);
    f(tile);
    for (const std::string& note : tile.notes()) context.note(note);
    scene.source.replace_with(std::move(tile));
}

// The operators, in order; more than one a file.
Operator tile_new_operator();
Operator tile_type_operator();
Operator tile_frame_operator();
Operator tile_param_operator();
Operator tile_corner_operator();
Operator tile_edge_operator();
Operator tile_edge_add_operator();
Operator tile_edge_move_operator();
Operator tile_edge_remove_operator();
Operator tile_point_add_operator();
Operator tile_point_move_operator();
Operator tile_point_remove_operator();
Operator tile_constrain_operator();
Operator tile_unconstrain_operator();
Operator tile_refine_operator();
Operator tile_stack_operator();
Operator tile_extrude_operator();
Operator tile_height_operator();
Operator tile_height_smooth_operator();
Operator tile_height_ridge_operator();
Operator tile_height_dome_operator();
Operator tile_solid_operator();
Operator tile_assemble_operator();
Operator tile_trace_operator();
Operator tile_colors_operator();
Operator tile_check_operator();

} // namespace druse
