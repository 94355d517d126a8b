#include "dlfl/self_intersections.h"

#include "dlfl/triangle_list.h"
#include "geom/box_tree.h"

#include <algorithm>

namespace druse {

SelfIntersections self_intersections(const Mesh& mesh, Progress& progress, std::uint64_t most)
{
    constexpr double gathered = 0.2, built = 0.4; // of the work, about
    const TriangleList triangles(mesh, progress, gathered);
    const BoxTree tree(triangles.boxes(), progress, gathered, built);

    // Two walks side by side, each with a list of its own.
    struct Found {
        std::uint64_t pairs = 0;
        std::vector<bool> faces;
    };
    Found found[2]{{0, std::vector<bool>(mesh.face_limit(), false)}, {0, std::vector<bool>(mesh.face_limit(), false)}};
    const auto into = [&](Found& own) {
        return [&](std::uint32_t i, std::uint32_t j) {
            if (meet_beyond_common(triangles[i], triangles.shadow(i), triangles[j])) {
                ++own.pairs;
                own.faces[triangles.face(i).index] = own.faces[triangles.face(j).index] = true;
            }
            return own.pairs < most;
        };
    };
    tree.for_each_pair_apart(progress, built, into(found[0]), into(found[1]));

    SelfIntersections result;
    result.pairs = std::min(most, found[0].pairs + found[1].pairs);
    if (result.pairs > 0)
        for (const Face f : mesh.faces())
            if (found[0].faces[f.index] || found[1].faces[f.index]) result.faces.push_back(f);
    return result;
}

} // namespace druse
