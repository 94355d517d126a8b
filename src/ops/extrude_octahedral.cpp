#include "ops/extrude.h"
#include "ops/tiered_kernels.h"

namespace druse {

Tiling Octahedral::tiling() const
{
    Tiling tile;
    const auto b = tile.base(), t = tile.tier();
    tile.top({t});
    tile.row({b(0), b(1), t(0)});
    tile.row({b(0), t(0), t(-1)});
    return tile;
}

void Octahedral::place(const BaseFrame& base, Point* t, Vector* slide) const
{
    for (int i = 0; i < base.n; ++i) {
        t[i] = base.middle(i) + heights[0] * base.edge * base.climb[i];
        if (slide) slide[i] = base.climb[i];
    }
}

Operator extrude_octahedral_operator()
{
    return define_extrusion<Octahedral>("extrude.octahedral", "Raise an antiprism on each face")
        .preset("regular", "angle=109.471220634490691 heights=0.866025403784439 iterations=1 flat=false")
        .preset("fig28_arm", "angle=100 heights=0.8 iterations=3")
        .example("extrude.octahedral faces=sides:3 iterations=3")
        .cites("Landreneau 2005, III.2.3");
}

} // namespace druse
