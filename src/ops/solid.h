#pragma once

#include "dlfl/mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace druse {

/// A convex solid with regular faces and edges of length `size`, its vertex mean at the origin.
///
/// The Platonic and Archimedean solids by name; `prism:N`, `antiprism:N` (3 to 100), `pyramid:N`, `cupola:N`, `rotunda`,
/// `bipyramid:N`, `elongated_pyramid:N`, `gyroelongated_pyramid:N` (4 or 5), `elongated_cupola:N`, `gyroelongated_cupola:N`,
/// `orthobicupola:N`, `gyrobicupola:N` (3 to 5). Coordinates are the usual closed forms; the snub dodecahedron's are solved for.
///
/// Vertices, and faces by their centres, are numbered from the bottom up, then counter-clockwise seen from above, from +x on;
/// faces start at their lowest-numbered vertex.
/// @throws CommandError for an unknown name, with the nearest one
/// Sources: Coxeter, *Regular polytopes* (1973); Johnson, *Convex polyhedra with regular faces* (1966).
Mesh make_solid(std::string_view name, double size);

/// @throws CommandError for an unknown name, without repeating it: `there is no such solid; did you mean 'cube'?`
void check_solid_name(std::string_view name);

/// The names above, those of a family with `:N`.
const std::vector<std::string>& solid_names();

} // namespace druse
