#pragma once

#include "graph/strut_contacts.h"

#include <span>
#include <vector>

namespace druse {

/// Rounds of thinning after which edges meet if struts still do: a fifth each at first, then a half, to far below the distance at which edges count as
/// meeting.
inline constexpr int most_thinnings = 96;

/// Lowers the factors of vertices, one for each, until no two of the pairs of parts meet any more: balls and struts are made for these alone, and looked at
/// exactly. Ends of struts that meet something, and balls that do, get thinner round after round. Caps are not looked at.
/// @return false where parts still meet at last: edges that meet. @throws CommandError where a ball gets too small for its coordinates, Cancelled
bool thin_out(const Graph& graph, const Incidence& incidence, const StrutPlacer& placer, const StrutShape& shape, const std::vector<PartPair>& pairs,
              std::vector<double>& factors, Progress& progress);

/// Makes all vertices thinner, once, that belong to a part of a pair: both of a strut, the one of a ball. They are thinner than they were: not than was asked for.
void thin(const Graph& graph, const Incidence& incidence, const StrutPlacement& placement, std::span<const PartPair> pairs, int round,
          std::vector<double>& factors);

} // namespace druse
