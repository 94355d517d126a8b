// rind.*: crusts, and what is done to them.
#include "ops/rind.h"

#include "ops/registry.h"

namespace druse {

void register_rind(Registry& registry)
{
    registry.add(rind_crust_operator());
    registry.add(rind_punch_operator());
    registry.add(rind_peel_operator());
    registry.add(rind_nest_operator());
}

} // namespace druse
