#pragma once

#include "dlfl/rind.h"

namespace druse {

/// Takes out the entries that a command has killed, so that none of them comes to life again with a later face of the same id and vertices: a
/// table in memory then says what it would say after going through a file. `before` is the change that the command made, as Mesh::end_change()
/// gives it; the mesh must not have been put in place of another as a whole. Cost: O(what changed).
void drop_dead_pairs(Rind& rind, const Mesh& mesh, const MeshChange& before);

/// Is anything left to be opened? Allocates nothing. Cost: O(corners) at worst.
bool has_live_pair(const Rind& rind, const Mesh& mesh);

} // namespace druse
