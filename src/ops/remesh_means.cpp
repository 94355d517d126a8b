#include "ops/remesh_means.h"

namespace druse::remesh {

void write_face_means(const OldMesh& old, Point* to, Progress& progress)
{
    for (std::uint32_t f = 0; f < old.faces(); ++f) {
        if (f % 65536 == 0) progress.step(0.5 + 0.5 * f / old.faces());
        Vector sum(0.0);
        for (std::uint32_t c = old.begin(f); c < old.end(f); ++c) sum += old.position(c);
        to[f] = sum / double(old.end(f) - old.begin(f));
    }
}

} // namespace druse::remesh
