#pragma once

#include <limits>

namespace druse {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace druse
