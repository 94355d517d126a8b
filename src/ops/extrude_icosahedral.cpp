#include "ops/extrude.h"
#include "ops/tiered_kernels.h"

namespace druse {

Tiling Icosahedral::tiling() const
{
    Tiling tile;
    const auto b = tile.base(), a = tile.tier(), c = tile.tier(), t = tile.tier();
    tile.top({t});
    tile.row({b(0), b(1), a(0)});
    tile.row({b(0), a(0), c(0)});
    tile.row({b(1), c(1), a(0)});
    tile.row({a(0), t(0), c(0)});
    tile.row({a(0), c(1), t(0)});
    tile.row({c(0), t(0), t(-1)});
    return tile;
}

void Icosahedral::place(const BaseFrame& base, Point* tiers, Vector* slide) const
{
    const int n = base.n;
    const double edge = base.edge;
    const Angle& theta = base.angle;
    const Cycle<Point> a(tiers, n), c(tiers + n, n), t(tiers + 2 * n, n);
    const auto facing = [](const Point& p, const Point& q, const Point& r) { return unit(glm::cross(q - p, r - p)); };

    for (int i = 0; i < n; ++i) a[i] = base.middle(i) + heights[0] * edge * base.climb[i];
    // Tier 2: the two triangles beside corner i are hinged on the sides of the first row.
    for (int i = 0; i < n; ++i) {
        const Vector left = Hinge(base.foot[i], a[i - 1], base.wall[i - 1], theta).normal;
        const Vector right = Hinge(a[i], base.foot[i], base.wall[i], theta).normal;
        c[i] = base.foot[i] + heights[1] * edge * base.meet(left, right);
    }
    // Tier 3: the next two are hinged on the sides of the second row.
    for (int i = 0; i < n; ++i) {
        const Vector right = Hinge(a[i], c[i], facing(base.foot[i], a[i], c[i]), theta).normal;
        const Vector left = Hinge(c[i + 1], a[i], facing(base.foot[i + 1], c[i + 1], a[i]), theta).normal;
        const Vector up = base.meet(left, right);
        t[i] = a[i] + heights[2] * edge * up;
        if (slide) slide[i] = up;
    }
}

Operator extrude_icosahedral_operator()
{
    return define_extrusion<Icosahedral>("extrude.icosahedral", "Raise six rows of triangles on each face")
        .preset("regular", "angle=138.189685104221401 heights=0.866025403784439,1,1 iterations=1 flat=false")
        .preset("fig27_facets", "angle=125 heights=0.6,0.8,0.8")
        .preset("fig28_crown", "angle=112 heights=0.5,0.9,0.9 iterations=2")
        .example("extrude.icosahedral faces=sides:3 iterations=2")
        .cites("Landreneau 2005, III.2.5");
}

} // namespace druse
