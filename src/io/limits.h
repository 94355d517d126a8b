#pragma once

#include <cstdint>

namespace druse {

/// The largest coordinate a reader takes, in size: what single precision holds, and products of six of them stay finite.
inline constexpr double largest_coordinate = 1e38;

/// The most corners, and so the most of anything, in a mesh.
inline constexpr std::uint64_t most_elements = 0x7fffff00;

} // namespace druse
