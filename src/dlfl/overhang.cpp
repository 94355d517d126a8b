#include "dlfl/overhang.h"

#include "dlfl/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace druse {

Overhang overhang(const Mesh& mesh, double angle)
{
    const Box box = bounds(mesh);
    const double bed = box.min.z + 1e-6 * box.diagonal();
    const double steepest = std::sin(angle) + 1e-9; // faces of just that angle hold, rounding or not
    Overhang result;
    for (const Face f : mesh.faces()) {
        const Vector whole = area_vector(mesh, f);
        const double size = glm::length(whole);
        if (!(-whole.z > steepest * size)) continue;
        double highest = -std::numeric_limits<double>::infinity();
        for (const Corner c : mesh.corners(f)) highest = std::max(highest, mesh.position(c).z);
        if (highest <= bed) continue;
        result.faces.push_back(f);
        result.area += size;
    }
    return result;
}

} // namespace druse
