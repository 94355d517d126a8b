#pragma once

#include "cell/cell_tile.h"
#include "ops/operator.h"

#include <utility>

namespace druse {

/// The cell that a document holds. @throws CommandError if it holds none
const CellTile& cell_of(const Scene& scene);

/// Runs f(cell) on a copy of the cell that a document holds, which then takes its place. @throws what f throws; CommandError if there is none
template <class F>
void edit_cell(Scene& scene, Context& context, F&& f)
{
    CellTile cell = cell_of(scene);
    f(cell);
    for (const std::string& note : cell.notes()) context.note(note);
    scene.source.replace_with(std::move(cell));
}

// The operators, in order; more than one a file.
Operator cell_new_operator();
Operator cell_point_add_operator();
Operator cell_point_move_operator();
Operator cell_point_remove_operator();
Operator cell_edge_add_operator();
Operator cell_edge_remove_operator();
Operator cell_constrain_operator();
Operator cell_unconstrain_operator();
Operator cell_refine_operator();
Operator cell_shape_operator();
Operator cell_move_operator();
Operator cell_split_operator();
Operator cell_split_edge_operator();
Operator cell_flip_operator();
Operator cell_rollback_operator();
Operator cell_skew_operator();
Operator cell_solid_operator();
Operator cell_assemble_operator();
Operator cell_check_operator();

} // namespace druse
