#pragma once

#include "dlfl/mesh.h"
#include "geom/progress.h"
#include "geom/triangle_contact.h"

#include <array>
#include <cstdint>
#include <vector>

namespace druse {

/// The triangles of a mesh that have an area, as Triangulator cuts them: an array for each thing to know about them. What lies on a
/// triangle without area lies on its neighbours too. Borrows the mesh, which must not change.
class TriangleList {
public:
    /// Reports its part of the work as 0 to `share`. @throws Cancelled
    TriangleList(const Mesh& mesh, Progress& progress, double share);

    std::uint32_t size() const { return static_cast<std::uint32_t>(corners_.size()); }
    Face face(std::uint32_t i) const { return faces_[i]; }
    Shadow shadow(std::uint32_t i) const { return shadows_[i]; }
    Triangle operator[](std::uint32_t i) const
    {
        const auto& [a, b, c] = corners_[i];
        return {mesh_.position(a), mesh_.position(b), mesh_.position(c)};
    }
    std::vector<Box> boxes() const;

private:
    const Mesh& mesh_;
    std::vector<std::array<Vertex, 3>> corners_;
    std::vector<Face> faces_;
    std::vector<Shadow> shadows_;
};

} // namespace druse
