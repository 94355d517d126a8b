#pragma once

#include "graph/strut_contacts.h"

#include <span>
#include <vector>

namespace druse {

/// Lowers the factors of vertices, one for each, until no two of the pairs of parts meet any more: balls and struts are made for these alone, and looked at
/// exactly. Ends of struts that meet something, and balls that do, get a fifth thinner round after round. Caps are not looked at.
/// @return false where parts still meet when they are a thousandth as thick: edges that cross. @throws Cancelled
bool thin_out(const Graph& graph, const Incidence& incidence, const StrutPlacer& placer, const StrutShape& shape, const std::vector<PartPair>& pairs,
              std::vector<double>& factors, Progress& progress);

/// Makes all vertices a fifth thinner, once, that belong to a part of a pair: both of a strut, the one of a ball.
void thin(const Graph& graph, std::span<const PartPair> pairs, std::vector<double>& factors);

} // namespace druse
