#pragma once

#include "dlfl/mesh_assembler.h"
#include "ops/scene.h"

#include <cstdint>
#include <vector>

namespace druse {

/// A mesh taken apart for MeshAssembler, so that it can be put together with other edges: its corners numbered face after face, each from its
/// start corner, boundary faces last. Borrows the mesh. Precondition: no holes.
class Reassembly {
public:
    explicit Reassembly(const Mesh& mesh);

    std::uint32_t corner_count() const { return static_cast<std::uint32_t>(corners_.size()); }
    std::uint32_t number(Corner c) const { return number_[c.index]; }
    const std::vector<Corner>& corners() const { return corners_; } // by number

    void add_vertices(MeshAssembler& to) const;
    void add_corners(MeshAssembler& to) const;

    /// Assembles, and puts the result in place of the mesh. Precondition: the first corners, faces and vertices added were those of the mesh, in
    /// their order; so they keep their ids, and what is selected stays so.
    void put_in_place(Scene& scene, MeshAssembler& parts, std::span<const std::int32_t> groups) const;

private:
    const Mesh& mesh_;
    std::vector<Corner> corners_;
    std::vector<std::uint32_t> number_; // by corner
};

} // namespace druse
