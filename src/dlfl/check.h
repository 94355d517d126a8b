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

/// The same rules for what changed since Mesh::begin_change(), as far as they can be seen from there. Cost: O(change) plus
/// a bit per corner and vertex, except that the rotation of a touched vertex is walked. Precondition: a change is being recorded.
std::string check_change(const Mesh& mesh);

/// The first vertex beyond largest_coordinate, or at no number at all, that changed since Mesh::begin_change(); invalid if there is none.
/// Cost and precondition as check_change().
Vertex changed_out_of_reach(const Mesh& mesh);

} // namespace druse
