#include "ops/remesh_doo_sabin.h"

#include "ops/remesh.h"
#include "ops/remesh_means.h"

namespace druse {

void DooSabin::place(const remesh::OldMesh& old, const remesh::NewPoints& to, Progress& progress) const
{
    remesh::write_weighted_corners(old, {0.25, 1.25}, to.corner_point, progress, [&old](std::uint32_t c) { return old.position(c); });
}

Operator remesh_doo_sabin_operator()
{
    auto definition = define_remeshing<DooSabin>("remesh.doo_sabin", "Shrink the faces and open a face on every edge and vertex");
    definition.example("remesh.doo_sabin iterations=2").cites("Doo & Sabin 1978");
    return complete(definition);
}

} // namespace druse
