#include "dlfl/rind_upkeep.h"

#include "dlfl/changed_elements.h"
#include "geom/sort_unique.h"

#include <algorithm>
#include <vector>

namespace druse {

void drop_dead_pairs(Rind& rind, const Mesh& mesh, const MeshChange& before)
{
    if (rind.empty()) return;
    std::vector<Face> changed; // each once: to look at one costs its sides
    const auto look_at = [&](Face f) {
        if (!f.is_boundary() && (changed.empty() || changed.back() != f)) changed.push_back(f);
    };
    // A face whose cycle changed begins elsewhere, is gone, or has a corner with another vertex or follower.
    for_each_changed(before.corner_vertex, [&](std::uint32_t i) { return mesh.vertex(Corner(i)); }, [&](std::uint32_t i, Vertex) { look_at(mesh.face(Corner(i))); });
    for_each_changed(before.corner_next, [&](std::uint32_t i) { return mesh.next(Corner(i)); }, [&](std::uint32_t i, Corner) { look_at(mesh.face(Corner(i))); });
    for_each_changed(before.face_corner, [&](std::uint32_t i) { return mesh.corner(Face(i)); }, [&](std::uint32_t i, Corner) { look_at(Face(i)); });
    sort_unique(changed);
    for (const Face f : changed)
        if (!rind.find(mesh, f)) rind.remove(f);
    for (std::uint32_t i = mesh.face_limit(); i < before.face_corner.size; ++i) rind.remove(Face(i));
}

bool has_live_pair(const Rind& rind, const Mesh& mesh)
{
    return !rind.empty() && std::ranges::any_of(mesh.faces(), [&](Face f) { return rind.find(mesh, f).has_value(); });
}

} // namespace druse
