#include "ops/smooth_surface.h"

#include "dlfl/errors.h"
#include "ops/remesh_limit.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace druse {

namespace {

constexpr std::size_t most_edges = 2'000'000;
constexpr std::size_t enough_faces = 100'000;
constexpr int highest_level = 5;

int level_for(std::size_t edges)
{
    int level = 1;
    for (std::size_t faces = 2 * edges; level < highest_level && 4 * faces <= enough_faces; faces *= 4) ++level;
    return level;
}

} // namespace

SmoothSurface smooth_surface(const Mesh& mesh, Progress& progress, std::size_t most_faces)
{
    if (mesh.edge_count() > most_edges) throw CommandError(fmt::format("the model has {} edges, more than {}", mesh.edge_count(), most_edges));
    const int level = level_for(mesh.edge_count());
    SmoothSurface result{limit_surface(mesh, {.level = level}, progress), {}};
    if (result.mesh.face_count() > most_faces) {
        Mesh moved = mesh;
        // What becomes of the old vertices comes first among the new ones.
        std::ranges::copy(result.mesh.positions().first(mesh.vertex_limit()), moved.write_positions().begin());
        result.mesh = std::move(moved);
        result.old_face.resize(mesh.face_limit());
        std::iota(result.old_face.begin(), result.old_face.end(), 0u);
        return result;
    }
    // A quad for each corner of a face, and four for each of these at every further level.
    result.old_face.reserve(result.mesh.face_count());
    for (const Face f : mesh.faces()) result.old_face.insert(result.old_face.end(), std::size_t(mesh.valence(f)) << 2 * (level - 1), f.index);
    ASSERT(result.old_face.size() == result.mesh.face_count(), "faces divide as the scheme says");
    return result;
}

} // namespace druse
