#pragma once

#include "dlfl/errors.h"
#include "io/model.h"
#include "io/output_files.h"

#include <string>
#include <string_view>

namespace druse {

/// For writers of formats that hold faces only: notes what else there is. Throws InputError if there are no faces.
inline void require_faces(const ModelView& model, OutputFiles& out, std::string_view format)
{
    if (model.mesh.face_count() > 0) {
        if (model.lines()) out.note("the graph is not saved in " + std::string(format));
        return;
    }
    throw InputError(out.name(), model.graph && !model.graph->edges.empty()
                                     ? "the document holds a graph and no faces; " + std::string(format) + " holds only faces"
                                     : "the document holds no faces");
}

} // namespace druse
