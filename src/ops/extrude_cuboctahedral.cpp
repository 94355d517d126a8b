#include "ops/extrude.h"
#include "ops/tiered_kernels.h"

namespace druse {

Tiling Cuboctahedral::tiling() const
{
    Tiling tile;
    const auto b = tile.base(), a = tile.tier(), c = tile.tier();
    tile.top({c});
    tile.row({b(0), b(1), a(0)});
    tile.row({b(0), a(0), c(0), a(-1)});
    tile.row({a(0), c(1), c(0)});
    return tile;
}

void Cuboctahedral::place(const BaseFrame& base, Point* tiers, Vector* slide) const
{
    const int n = base.n;
    const Cycle<Point> a(tiers, n), c(tiers + n, n);
    for (int i = 0; i < n; ++i) a[i] = base.middle(i) + heights[0] * base.edge * base.climb[i];
    // Tier 2 leaves the corner towards the middle of its two neighbours, so that the quads are flat on every base.
    for (int i = 0; i < n; ++i) {
        const Vector up = unit(0.5 * (a[i - 1] + a[i]) - base.foot[i], 1e-9 * base.edge, base.normal);
        c[i] = base.foot[i] + heights[1] * base.edge * up;
        if (slide) slide[i] = up;
    }
}

Operator extrude_cuboctahedral_operator()
{
    return define_extrusion<Cuboctahedral>("extrude.cuboctahedral", "Raise triangles and quads on each face, as in the cuboctahedron")
        .preset("regular", "angle=125.264389682754654 heights=0.866025403784439,1.414213562373095 iterations=1 flat=false")
        .preset("fig24_spire", "angle=85 heights=0.866025403784439,1.414213562373095 iterations=3")
        .preset("fig24_column", "angle=105 heights=0.866025403784439,1.414213562373095 iterations=3")
        .preset("fig24_vase", "angle=115 heights=0.866025403784439,1.414213562373095 iterations=3")
        .preset("fig24_bowl", "angle=125.264389682754654 heights=0.866025403784439,1.414213562373095 iterations=3")
        .example("extrude.cuboctahedral faces=sides:4 heights=0.9,1.3")
        .cites("Landreneau 2005, III.3.1");
}

} // namespace druse
