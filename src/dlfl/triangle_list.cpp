#include "dlfl/triangle_list.h"

#include "dlfl/triangulate.h"

namespace druse {

TriangleList::TriangleList(const Mesh& mesh, Progress& progress, double share) : mesh_(mesh)
{
    Triangulator triangulator;
    for (const Face f : mesh.faces()) {
        if (f.index % 4096 == 0) progress.step(share * f.index / mesh.face_limit());
        for (const auto& [a, b, c] : triangulator.triangles(mesh, f)) {
            const Shadow shadow = shadow_of({mesh.position(a), mesh.position(b), mesh.position(c)});
            if (shadow.turn == 0) continue;
            corners_.push_back({mesh.vertex(a), mesh.vertex(b), mesh.vertex(c)});
            faces_.push_back(f);
            shadows_.push_back(shadow);
        }
    }
}

std::vector<Box> TriangleList::boxes() const
{
    std::vector<Box> list(size());
    for (std::uint32_t i = 0; i < size(); ++i)
        for (const Vertex v : corners_[i]) list[i].add(mesh_.position(v));
    return list;
}

} // namespace druse
