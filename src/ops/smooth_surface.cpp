#include "ops/smooth_surface.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_tables.h"
#include "ops/remesh_limit.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

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

/// Two closed meshes without holes.
bool differ_in_positions_only(const Mesh& a, const Mesh& b)
{
    const MeshTables::View x = MeshTables::view(a), y = MeshTables::view(b);
    return a.boundary_count() == 0 && b.boundary_count() == 0 && a.vertex_limit() == b.vertex_limit() && std::ranges::equal(x.vertex, y.vertex) &&
           std::ranges::equal(x.next, y.next) && std::ranges::equal(x.edge_corners, y.edge_corners) && std::ranges::equal(x.start, y.start) &&
           std::ranges::equal(a.groups(), b.groups());
}

} // namespace

SmoothSurface::SmoothSurface(std::size_t most_faces) : most_faces_(most_faces) {}
SmoothSurface::SmoothSurface(const Mesh& mesh, Progress& progress, std::size_t most_faces) : most_faces_(most_faces) { follow(mesh, progress); }
SmoothSurface::~SmoothSurface() = default;

const Mesh& SmoothSurface::mesh() const { return own_faces_ ? old_ : refinement_->mesh(); }
const std::vector<Vector>& SmoothSurface::normals() const { return refinement_->normals(); }

void SmoothSurface::follow(const Mesh& mesh, Progress& progress)
{
    if (!refinement_ || !differ_in_positions_only(old_, mesh)) prepare(mesh, progress);
    refinement_->place_with_normals(mesh.positions());
    // What becomes of the old vertices comes first among the new ones.
    if (own_faces_) std::ranges::copy(refinement_->mesh().positions().first(old_.vertex_limit()), old_.write_positions().begin());
}

void SmoothSurface::prepare(const Mesh& mesh, Progress& progress)
{
    refinement_.reset();
    if (mesh.edge_count() > most_edges) throw CommandError(fmt::format("the model has {} edges, more than {}", mesh.edge_count(), most_edges));
    const int level = level_for(mesh.edge_count());
    old_ = mesh;
    auto refinement = std::make_unique<LimitRefinement>(mesh, LimitSurface{.level = level}, progress);
    const std::size_t faces = refinement->mesh().face_count();
    own_faces_ = faces > most_faces_;
    if (own_faces_) {
        old_face_.resize(mesh.face_limit());
        std::iota(old_face_.begin(), old_face_.end(), 0u);
    } else {
        // A quad for each corner of a face, and four for each of these at every further level.
        old_face_.clear();
        old_face_.reserve(faces);
        for (const Face f : mesh.faces()) old_face_.insert(old_face_.end(), std::size_t(mesh.valence(f)) << 2 * (level - 1), f.index);
        ASSERT(old_face_.size() == faces, "faces divide as the scheme says");
    }
    refinement_ = std::move(refinement);
}

} // namespace druse
