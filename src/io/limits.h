#pragma once

#include <cstdint>

namespace druse {

/// The most corners, and so the most of anything, in a mesh.
inline constexpr std::uint64_t most_elements = 0x7fffff00;

} // namespace druse
