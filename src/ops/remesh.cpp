#include "ops/remesh.h"

#include <fmt/format.h>

namespace druse {

void remesh::refuse_too_large(std::uint32_t edges, std::size_t growth, int iterations)
{
    constexpr std::uint64_t most = 20'000'000;
    __extension__ unsigned __int128 result = edges; // at most 2³² · 9²⁰
    for (int i = 0; i < iterations; ++i) result *= growth;
    if (result > most) throw CommandError(fmt::format("would make {} edges", result));
}

// One operator a file.
Operator remesh_checkerboard_operator();
Operator remesh_catmull_clark_operator();
Operator remesh_doo_sabin_operator();

void register_remesh(Registry& registry)
{
    registry.add(remesh_checkerboard_operator());
    registry.add(remesh_catmull_clark_operator());
    registry.add(remesh_doo_sabin_operator());
}

} // namespace druse
