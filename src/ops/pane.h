#pragma once

#include "ops/operator.h"
#include "pane/pane.h"

#include <utility>

namespace druse {

/// The pane that a document holds. @throws CommandError if it holds none
const Pane& pane_of(const Scene& scene);

/// Says what an edit did that a caller could not know: points that became one, crossings, what was there already.
void tell(const Pane& pane, Context& context);
/// Says what a refinement could not do.
void tell(const Pane::Refined& refined, Context& context);

/// Runs f(pane) as one edit of the pane that a document holds. @throws PaneRefusal; CommandError if it holds none
template <class F>
void edit_pane(Scene& scene, Context& context, F&& f)
{
    pane_of(scene);
    scene.source.edit_pane(std::forward<F>(f));
    tell(pane_of(scene), context);
}

// The operators, in order; more than one a file.
Operator pane_new_operator();
Operator pane_add_operator();
Operator pane_add_boundary_operator();
Operator pane_move_operator();
Operator pane_remove_operator();
Operator pane_constrain_operator();
Operator pane_unconstrain_operator();
Operator pane_lock_operator();
Operator pane_refine_operator();
Operator pane_unrefine_operator();
Operator pane_spread_operator();
Operator pane_check_operator();

} // namespace druse
