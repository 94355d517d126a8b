#pragma once

#include "dlfl/mesh.h"
#include "geom/progress.h"
#include "ops/remesh.h"

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace druse {

enum class LimitScheme { catmull_clark, loop };

struct LimitSurface {
    LimitScheme scheme = LimitScheme::catmull_clark;
    int level = 2;
    std::vector<Edge> creases = {}; // edges of the old mesh
    double sharpness = 10;     // of the creases: 0 smooth, 10 never smoothed; between, smooth after as many levels
    bool to_limit = true;      // otherwise the points stay those of the last level
    RemeshGroups groups = RemeshGroups::keep;
};

/// Subdivides a closed mesh `level` times and moves the points to where they would go in infinitely many levels.
///
/// Connectivity and numbering are those of remesh.catmull_clark, or remesh.loop, with as many iterations; without creases so are the points,
/// if they do not go to the limit. OpenSubdiv does it. The old mesh does not change, so this serves previews too.
/// @throws CommandError as remeshed(); for Loop's scheme also where a face is no triangle; where a face has more than 65535 sides or a vertex
/// more edges
/// Source: Catmull & Clark 1978; Loop 1987; DeRose, Kass & Truong, *Subdivision surfaces in character animation* (1998), for the creases.
Mesh limit_surface(const Mesh& mesh, const LimitSurface& surface, Progress& progress);

/// The same for one mesh whose vertices move: what does not depend on where they are is made once.
class LimitRefinement {
public:
    /// Reads all of the old mesh but its positions. @throws as limit_surface()
    LimitRefinement(const Mesh& mesh, const LimitSurface& surface, Progress& progress);
    LimitRefinement(LimitRefinement&&) noexcept;
    LimitRefinement& operator=(LimitRefinement&&) noexcept;
    ~LimitRefinement();

    /// Where the new vertices are if the old ones are here, exactly as limit_surface() has them. Cost: linear in the new ones; nothing is searched.
    void place(std::span<const Point> old);
    /// The same with normals. Precondition: the surface goes to the limit.
    void place_with_normals(std::span<const Point> old);

    /// The subdivided mesh. Its points are those of the last call of either function; before that they are anywhere.
    const Mesh& mesh() const { return mesh_; }
    Mesh take() && { return std::move(mesh_); }
    /// The normals of the limit surface at the vertices of mesh(), of length 1: outward, square to both limit tangents.
    ///
    /// At a crease, which has a tangent plane on each side, and where the tangents are parallel, it is the mean of the faces around the
    /// vertex, weighted by their angles there; zero if they have no area.
    const std::vector<Vector>& normals() const { return normals_; }

private:
    struct Refined;
    void find_places(std::span<const Point> old, bool with_normals);

    std::unique_ptr<Refined> refined_; // null: there is nothing to refine
    Mesh mesh_;
    std::vector<Vector> normals_;
};

} // namespace druse
