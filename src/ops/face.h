#pragma once

#include "dlfl/mesh.h"

namespace druse {

/// Lets a face start at its first corner of a vertex, counted from its present start; false if it has none.
bool start_at(Mesh& mesh, Face f, Vertex v);

/// Moves the start so many corners on, counter-clockwise; backward if negative.
void shift_start(Mesh& mesh, Face f, int corners);

/// Lets a face start at the corner farthest in a direction of length 1; of several, at the first one from its present start.
void start_toward(Mesh& mesh, Face f, const Vector& direction);

} // namespace druse
