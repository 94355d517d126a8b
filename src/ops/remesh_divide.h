#pragma once

#include "dlfl/mesh_assembler.h"
#include "ops/remesh.h"
#include "ops/remesh_old_mesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace druse::remesh {

/// Builds a mesh from an old one of which some faces are divided and the others stay; so do all old vertices and edges.
///
/// For schemes that treat faces differently; where all are treated alike, a Scheme says it shorter. New faces are numbered in the order
/// in which they are given; old faces have to be given by id, each once.
class FaceDivider {
public:
    using Triangle = std::array<std::uint32_t, 3>;

    FaceDivider(const OldMesh& old, RemeshGroups groups);

    void keep(std::uint32_t f, int group);
    /// Puts triangles in place of a face with n corners, by their number from its start corner; n stands for a new vertex at `center`,
    /// if there is one. Precondition: the triangles make a disc whose boundary runs like the face.
    void divide(std::uint32_t f, int group, std::span<const Triangle> triangles, const Point* center = nullptr);

    Mesh build();

private:
    void end_face(std::uint32_t f, int group);
    std::uint32_t add_corner(std::uint32_t vertex);

    struct Inner {
        std::uint32_t low, high, corner; // a side between two local numbers, and where it starts
    };
    const OldMesh& old_;
    RemeshGroups groups_;
    MeshAssembler to_;
    std::vector<std::int32_t> group_of_;
    std::vector<std::uint32_t> side_of_; // new corner of each old side
    std::vector<Inner> inner_;
};

} // namespace druse::remesh
