#include "ops/scene.h"

#include <algorithm>

namespace druse {

namespace {

template <class H>
bool ends_below(const std::vector<H>& list, std::uint32_t limit)
{
    return list.empty() || list.back().index < limit;
}

/// Takes dead elements out of a selected list.
template <class H>
void drop_dead(const Mesh& mesh, std::vector<H>& list)
{
    std::erase_if(list, [&mesh](H h) { return !mesh.is_alive(h); });
}

/// Gives selected elements their new ids; `to` is empty where none changed.
template <class H>
void follow(std::vector<H>& list, const std::vector<std::uint32_t>& to)
{
    if (to.empty()) return;
    for (H& h : list) h = H(to[h.index]);
}

} // namespace

void settle(Scene& scene)
{
    Mesh& mesh = scene.mesh;
    const Selection& selection = *scene.selection;
    if (!mesh.has_holes() && ends_below(selection.faces, mesh.face_limit()) && ends_below(selection.edges, mesh.edge_limit()) &&
        ends_below(selection.vertices, mesh.vertex_limit()))
        return;
    Selection kept = selection;
    drop_dead(mesh, kept.faces);
    drop_dead(mesh, kept.edges);
    drop_dead(mesh, kept.vertices);
    const Renumbering to = close_holes(mesh, scene.rind);
    follow(kept.faces, to.faces);
    follow(kept.edges, to.edges);
    follow(kept.vertices, to.vertices);
    if (!(kept == selection)) scene.selection = std::move(kept);
}

} // namespace druse
