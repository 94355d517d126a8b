#pragma once

#include "dlfl/mesh.h"
#include "geom/progress.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace druse {

class LimitRefinement;

/// A mesh as a preview shows it smooth: Catmull and Clark's limit surface, what remesh.subdivide_limit makes of it, at a level fine enough to
/// look round and coarse enough to be drawn at once: the highest up to 5 that has at most 100 000 faces, or else 1. Where even that has more
/// than `most_faces`, it is the mesh itself with its vertices moved to where the limit surface has them.
class SmoothSurface {
public:
    explicit SmoothSurface(std::size_t most_faces = 1'000'000);
    SmoothSurface(const Mesh& mesh, Progress& progress, std::size_t most_faces = 1'000'000);
    ~SmoothSurface();

    /// Makes it that of a mesh. Where that is the one before with other positions, only points and normals are made anew; what comes of it is
    /// the same. After an error it is that of no mesh, and may follow another one.
    /// @throws CommandError, one line that says why there is none: the model is open, or has more than 2 million edges, or as limit_surface()
    void follow(const Mesh& mesh, Progress& progress);

    const Mesh& mesh() const; // with the groups of the old faces
    /// By face; those of one old face follow each other, in the order of the old faces.
    const std::vector<std::uint32_t>& old_face() const { return old_face_; }
    /// By vertex, and maybe more: of the limit surface, of length 1.
    const std::vector<Vector>& normals() const;

private:
    void prepare(const Mesh& mesh, Progress& progress);

    std::size_t most_faces_;
    Mesh old_; // what was followed last; if own_faces_, with its vertices on the surface
    std::unique_ptr<LimitRefinement> refinement_; // of old_
    bool own_faces_ = false;
    std::vector<std::uint32_t> old_face_;
};

} // namespace druse
