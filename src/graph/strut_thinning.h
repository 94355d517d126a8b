#pragma once

#include "graph/strut_contacts.h"

#include <vector>

namespace druse {

/// Lowers the factors of vertices, one for each, until no two of the pairs of parts meet any more: balls and struts are made for these alone, and looked at
/// exactly. Ends of struts that meet something, and balls that do, get a fifth thinner again and again. Caps are not looked at.
/// @return false where parts still meet when they are a thousandth as thick: edges that cross. @throws Cancelled
bool thin_out(const Graph& graph, const Incidence& incidence, const StrutPlacer& placer, const StrutShape& shape, const std::vector<PartPair>& pairs,
              std::vector<double>& factors, Progress& progress);

/// Makes both vertices of a strut, or the vertex of a ball, a fifth thinner, of each part of a pair.
void thin(const Graph& graph, const PartPair& pair, std::vector<double>& factors);

} // namespace druse
