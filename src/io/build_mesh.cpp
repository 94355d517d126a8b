#include "io/build_mesh.h"

#include "dlfl/errors.h"

#include <algorithm>

namespace druse {

void build_mesh(MeshBuilder& builder, const ByteSource& source, Model& model, std::uint32_t used_elsewhere)
{
    Repairs repairs;
    try {
        model.mesh = builder.build(repairs);
    } catch (const CommandError& error) {
        throw InputError(source.name(), error.what());
    }
    if (model.mesh.face_count() == 0 && !model.graph) throw InputError(source.name(), "holds no faces with three different corners");
    repairs.loose_vertices -= std::min(used_elsewhere, repairs.loose_vertices);
    for (std::string& note : repairs.notes()) model.notes.push_back(std::move(note));
}

} // namespace druse
