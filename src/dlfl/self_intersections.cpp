#include "dlfl/self_intersections.h"

#include "dlfl/triangle_list.h"
#include "geom/box_tree.h"

namespace druse {

SelfIntersections self_intersections(const Mesh& mesh, Progress& progress, std::uint64_t most)
{
    constexpr double gathered = 0.2, built = 0.4; // of the work, about
    const TriangleList triangles(mesh, progress, gathered);
    const BoxTree tree(triangles.boxes(), progress, gathered, built);

    SelfIntersections result;
    FaceData<bool> meets(mesh, false);
    tree.for_each_pair(progress, built, [&](std::uint32_t i, std::uint32_t j) {
        if (meet_beyond_common(triangles[i], triangles.shadow(i), triangles[j])) {
            ++result.pairs;
            meets[triangles.face(i)] = meets[triangles.face(j)] = true;
        }
        return result.pairs < most;
    });
    for (const Face f : mesh.faces())
        if (meets[f]) result.faces.push_back(f);
    return result;
}

} // namespace druse
