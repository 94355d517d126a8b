#include "app/registry.h"

namespace druse {

const Registry& all_operators()
{
    static const Registry registry = [] {
        Registry r;
        register_extrude(r);
        register_document(r);
        return r;
    }();
    return registry;
}

} // namespace druse
