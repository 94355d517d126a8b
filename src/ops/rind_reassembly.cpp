#include "ops/rind_reassembly.h"

#include "dlfl/errors.h"

#include <algorithm>

namespace druse {

Reassembly::Reassembly(const Mesh& mesh) : mesh_(mesh), number_(mesh.corner_limit())
{
    ASSERT(!mesh.has_holes(), "no holes in a mesh to take apart");
    const auto add = [this](Face f) {
        for (const Corner c : mesh_.corners(f)) {
            number_[c.index] = corner_count();
            corners_.push_back(c);
        }
    };
    for (const Face f : mesh.faces()) add(f);
    for (const Face f : mesh.boundary_faces()) add(f);
}

void Reassembly::add_vertices(MeshAssembler& to) const
{
    for (const Point& p : mesh_.positions()) to.add_vertex(p);
}

void Reassembly::add_corners(MeshAssembler& to) const
{
    for (const Corner c : corners_) to.add_corner(mesh_.vertex(c).index);
}

void Reassembly::put_in_place(Scene& scene, MeshAssembler& parts, std::span<const std::int32_t> groups) const
{
    Repairs repairs;
    Mesh made = parts.assemble(groups, repairs);
    Selection selection = *scene.selection;
    for (Edge& e : selection.edges) e = made.edge(Corner(number(mesh_.corner(e, 0))));
    std::ranges::sort(selection.edges);
    selection.edges.erase(std::unique(selection.edges.begin(), selection.edges.end()), selection.edges.end());
    scene.mesh.replace_with(std::move(made));
    scene.selection = std::move(selection);
}

} // namespace druse
