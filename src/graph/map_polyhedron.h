#pragma once

#include "graph/graph.h"

namespace druse {

/// Puts a sector of the disk, between two neighbouring mirror rays through vertices of the face at its centre, in place of every edge of a polyhedron.
///
/// The edge a b sees the centre under the angle β; a point at radius r and at part τ of the sector goes to r (cos βτ a + sin βτ b'), b' square to a.
/// What lies on a ray belongs to a vertex of the polyhedron and is shared by all its edges, found by its rank along the ray and not by its place.
/// Edges that cross a ray, which they do at right angles, are cut there. Preconditions: a face is at the centre; `solid` has vertices at distance 1.
/// @throws CommandError if the rays are no mirrors (a chiral tessellation, or a face that is not so symmetric)
/// Cost: linear in the sector times the solid's edges; a sort of what lies on the rays. Source: Hart 2009, 4.6.
Graph map_to_polyhedron(const Graph& graph, const Graph& solid);

} // namespace druse
