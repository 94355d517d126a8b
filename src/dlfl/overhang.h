#pragma once

#include "dlfl/mesh.h"

#include <vector>

namespace druse {

/// What a printer would lay upon air, were the model printed as it stands, z up.
struct Overhang {
    std::vector<Face> faces; // ascending
    double area = 0;
};

/// Faces that lean out by more than `angle` (radians): 0 is a wall, π/2 a ceiling. Faces that lie on the bed, all their corners lowest
/// but for a millionth of the model's size, lean on it. Faces look outward. Cost: O(mesh).
Overhang overhang(const Mesh& mesh, double angle);

} // namespace druse
