#pragma once

#include "dlfl/mesh.h"

#include <vector>

namespace druse {

/// Scale, then turn about x, y and z (degrees), then move; all but the move about a fixed point.
struct Transform {
    Vector scale{1.0}, rotate{0.0}, move{0.0};
    Point about{0.0};

    Vector linear(const Vector& d) const; // without the moves
    bool mirrors() const { return (scale.x < 0) != ((scale.y < 0) != (scale.z < 0)); }
};

/// Transforms vertices. Components that are mirrored as a whole are turned inside out, so that their outside stays out.
/// @throws CommandError if a coordinate does not stay finite
void transform(Mesh& mesh, const std::vector<Vertex>& vertices, const Transform& t);

} // namespace druse
