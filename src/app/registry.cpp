#include "app/registry.h"

namespace druse {

const Registry& all_operators()
{
    static const Registry registry = [] {
        Registry r;
        register_make(r);
        register_face(r);
        register_select(r);
        register_group(r);
        register_extrude(r);
        register_remesh(r);
        register_topology(r);
        register_rind(r);
        register_graph(r);
        register_pane(r);
        register_tile(r);
        register_tile_image(r);
        register_cell(r);
        register_mesh(r);
        register_check(r);
        register_document(r);
        return r;
    }();
    return registry;
}

} // namespace druse
