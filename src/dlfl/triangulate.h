#pragma once

#include "dlfl/mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace druse {

/// Cuts faces into triangles without new vertices, for drawing and for formats that know triangles only.
///
/// Quads are cut along the shorter diagonal, or the only one that lies inside; larger faces go through clip_ears() in the plane
/// of their Newell normal, so that concave faces come out right and warped ones as well as a plane projection allows. A face
/// with n corners gives n − 2 triangles, always, each running like the face. Scratch memory is kept from call to call.
///
/// Which way a face runs does not matter: turned inside out it is cut along the same diagonals, and so is a copy below it with the same start
/// corner and its vertices in the same order. Where the shape leaves a choice, a quad is cut from its start corner, which makes even rows of
/// many; in a larger face the order of the vertex ids decides, so that it may start anywhere, unless its lowest vertex comes twice.
class Triangulator {
public:
    /// The triangles of one face as corners, valid until the next call. Faces with fewer than 3 corners give none.
    const std::vector<std::array<Corner, 3>>& triangles(const Mesh& mesh, Face f);

private:
    void cut_quad(const Mesh& mesh);
    bool order_by_ids(const Mesh& mesh);
    void flatten(const Mesh& mesh);

    std::vector<std::array<Corner, 3>> triangles_;
    std::vector<Corner> corners_;
    std::vector<Point2> flat_;
    std::vector<std::array<std::uint32_t, 3>> cut_;
};

} // namespace druse
