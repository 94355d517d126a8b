#include "ops/extrude.h"
#include "ops/tiered_kernels.h"

namespace druse {

Tiling Dodecahedral::tiling() const
{
    Tiling tile;
    const auto b = tile.base(), a = tile.tier(), c = tile.tier(), e = tile.tier();
    tile.top({e});
    tile.row({b(0), b(1), a(1), c(0), a(0)});
    tile.row({a(0), c(0), e(0), e(-1), c(-1)});
    return tile;
}

void Dodecahedral::place(const BaseFrame& base, Point* tiers, Vector* slide) const
{
    const int n = base.n;
    const double edge = base.edge;
    const Cycle<Point> a(tiers, n), c(tiers + n, n), e(tiers + 2 * n, n);

    // Tier 1 climbs where two neighbouring walls meet; tier 2 climbs each wall from the middle of its edge.
    for (int i = 0; i < n; ++i) {
        a[i] = base.foot[i] + heights[0] * edge * base.crest(i);
        c[i] = base.middle(i) + heights[1] * edge * base.climb[i];
    }
    // Tier 3 keeps the second row flat: it leaves tier 2 along the line in which the planes of two of its pentagons meet.
    const auto upper = [&](int i) {
        const Vector across = glm::cross(c[i] - a[i], c[i - 1] - a[i]);
        const Vector between = unit(base.wall[i - 1] + base.wall[i], 0.0, base.normal);
        return unit(across, 1e-9 * edge * edge, between);
    };
    const Vector first = upper(0);
    Vector left = first;
    for (int i = 0; i < n; ++i) {
        const Vector right = i + 1 < n ? upper(i + 1) : first;
        const Vector up = base.meet(left, right);
        e[i] = c[i] + heights[2] * edge * up;
        if (slide) slide[i] = up;
        left = right;
    }
}

Operator extrude_dodecahedral_operator()
{
    return define_extrusion<Dodecahedral>("extrude.dodecahedral", "Raise two rows of pentagons on each face")
        .preset("regular", "angle=116.565051177077989 heights=1,1.538841768587627,1 iterations=1 flat=false")
        .preset("fig27_cluster", "angle=90 heights=0.5,0.9,0.5")
        .preset("fig28_bud", "angle=108 heights=0.8,1.3,0.8")
        .example("extrude.dodecahedral faces=sides:5 angle=110 heights=1,1.6,0.8 iterations=3 flat=true")
        .cites("Landreneau 2005, III.2.4");
}

} // namespace druse
