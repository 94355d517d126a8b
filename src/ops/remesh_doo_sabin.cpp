#include "ops/remesh_doo_sabin.h"

#include "geom/cut_corners.h"
#include "ops/remesh.h"

namespace druse {

void DooSabin::place(const remesh::OldMesh& old, const remesh::NewPoints& to, Progress& progress) const
{
    CornerCutter cutter;
    for (std::uint32_t f = 0; f < old.faces(); ++f) {
        if (f % 16384 == 0) progress.step(0.5 + 0.5 * f / old.faces());
        const std::uint32_t begin = old.begin(f);
        const int n = static_cast<int>(old.end(f) - begin);
        const auto corner = [&](int i) { return old.position(begin + static_cast<std::uint32_t>(i)); };
        cutter.cut(n, CornerCutter::doo_sabin(n), corner, [&](int i, const Point& p) { to.corner_point[begin + static_cast<std::uint32_t>(i)] = p; });
    }
}

Operator remesh_doo_sabin_operator()
{
    auto definition = define_remeshing<DooSabin>("remesh.doo_sabin", "Shrink the faces and open a face on every edge and vertex");
    definition.example("remesh.doo_sabin iterations=2").cites("Doo & Sabin 1978");
    return complete(definition);
}

} // namespace druse
