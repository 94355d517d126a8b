#include "ops/extrude.h"
#include "ops/tiered_kernels.h"

namespace druse {

Tiling Tetrahedral::tiling() const
{
    Tiling tile;
    const auto b = tile.base(), apex = tile.apex();
    tile.row({b(0), b(1), apex(0)});
    return tile;
}

void Tetrahedral::place(const BaseFrame& base, Point* tiers, Vector*) const
{
    Vector sum(0.0);
    for (int i = 0; i < base.n; ++i) sum += base.middle(i) + heights[0] * base.edge * base.climb[i];
    tiers[0] = sum / double(base.n);
}

Operator extrude_tetrahedral_operator()
{
    return define_extrusion<Tetrahedral>("extrude.tetrahedral", "Raise a pyramid on each face")
        .preset("regular", "angle=70.528779365509308 heights=0.866025403784439")
        .preset("fig26_sierpinski", "angle=70.528779365509308 heights=-0.42 groups=keep")
        .preset("fig28_spikes", "angle=78 heights=1.8")
        .example("extrude.tetrahedral faces=0 heights=1.2")
        .cites("Landreneau 2005, III.2.1");
}

} // namespace druse
