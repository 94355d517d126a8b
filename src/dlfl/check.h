#pragma once

#include "dlfl/mesh.h"

#include <string>

namespace druse {

/// The first broken rule of the doubly linked face list as a sentence, or an empty string if the mesh is sound.
///
/// Rules: next and previous are each other's inverse; every corner is in the cycle of one face; an edge has two different
/// corners that run against each other; the corners of a vertex form one rotation; a corner without an edge is a point sphere;
/// start corners and vertex corners point at their own; positions are within largest_coordinate; groups are not negative; what is not alive is a hole.
/// Cost: O(mesh).
std::string check(const Mesh& mesh);

/// The same rules for what a command changed, as far as they can be seen from there. `before` is what Mesh::end_change() gave.
/// Cost: O(change): the pages that were written to are compared, each element that is another one now is looked at, and the rotation of its
/// vertex walked; besides, a pointer for every 4096 corners and vertices. O(mesh) where a whole mesh was put in place of another.
std::string check_change(const Mesh& mesh, const MeshChange& before);

/// The first vertex beyond largest_coordinate, or at no number at all, that a command put there; invalid if there is none. Cost: O(change).
Vertex changed_out_of_reach(const Mesh& mesh, const MeshChange& before);

} // namespace druse
