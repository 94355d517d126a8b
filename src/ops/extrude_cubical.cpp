#include "ops/extrude.h"
#include "ops/tiered_kernels.h"

namespace druse {

Tiling Cubical::tiling() const
{
    Tiling tile;
    const auto b = tile.base(), t = tile.tier();
    tile.top({t});
    tile.row({b(0), b(1), t(1), t(0)});
    return tile;
}

void Cubical::place(const BaseFrame& base, Point* t, Vector* slide) const
{
    for (int i = 0; i < base.n; ++i) {
        const Vector up = base.crest(i);
        t[i] = base.foot[i] + heights[0] * base.edge * up;
        if (slide) slide[i] = up;
    }
}

Operator extrude_cubical_operator()
{
    return define_extrusion<Cubical>("extrude.cubical", "Raise a prism with leaning walls on each face")
        .preset("regular", "angle=90 heights=1 iterations=1 flat=false")
        .preset("fig26_menger", "angle=90 heights=-1 groups=keep")
        .preset("fig26_cubes", "angle=90 heights=1 groups=keep")
        .preset("fig28_spine", "angle=85 heights=3")
        .example("extrude.cubical faces=all angle=80 heights=0.5 iterations=2")
        .cites("Landreneau 2005, III.2.2");
}

} // namespace druse
