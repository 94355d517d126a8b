#include "ops/remesh.h"

#include <fmt/format.h>

namespace druse {

namespace {

__extension__ using Count = unsigned __int128; // at most 2³² · 9²⁰

void refuse_more_than_most(Count edges)
{
    constexpr std::uint64_t millions = 20;
    if (edges > millions * 1'000'000) throw CommandError(fmt::format("would make {} edges, more than {} million", edges, millions));
}

} // namespace

void remesh::refuse_too_large(std::uint64_t edges, std::size_t growth, int iterations)
{
    Count result = edges;
    for (int i = 0; i < iterations; ++i) result *= growth;
    refuse_more_than_most(result);
}

void remesh::refuse_too_large_where(std::uint64_t edges, std::uint32_t n, std::uint64_t found, int iterations)
{
    Count result = edges, now = found;
    for (int i = 0; i < (n == 3 ? iterations : 1); ++i, now *= 3) result += n * now;
    refuse_more_than_most(result);
}

// One function a file.
void add_remesh_checkerboard(Registry& registry);
void add_remesh_catmull_clark(Registry& registry);
void add_remesh_loop(Registry& registry);
void add_remesh_doo_sabin(Registry& registry);
void add_remesh_truncate(Registry& registry);
void add_remesh_dual(Registry& registry);
void add_remesh_root(Registry& registry);
void add_remesh_stellate(Registry& registry);
void add_remesh_pentagonal(Registry& registry);
void add_remesh_inset(Registry& registry);
void add_remesh_triangulate(Registry& registry);
void add_remesh_limit(Registry& registry);
void add_remesh_conway(Registry& registry);

void register_remesh(Registry& registry)
{
    add_remesh_checkerboard(registry);
    add_remesh_catmull_clark(registry);
    add_remesh_loop(registry);
    add_remesh_limit(registry);
    add_remesh_doo_sabin(registry);
    add_remesh_root(registry);
    add_remesh_pentagonal(registry);
    add_remesh_truncate(registry);
    add_remesh_dual(registry);
    add_remesh_stellate(registry);
    add_remesh_triangulate(registry);
    add_remesh_inset(registry);
    add_remesh_conway(registry); // of the others
}

} // namespace druse
