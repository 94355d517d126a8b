#include "ops/extrude.h"
#include "ops/tiered_kernels.h"

namespace druse {

Tiling Rhombicuboctahedral::tiling() const
{
    Tiling tile;
    const auto b = tile.base();
    const auto lower = tile.tier(2), upper = tile.tier(2);
    const auto p = lower[0], q = lower[1], P = upper[0], Q = upper[1];
    const auto t = tile.tier();
    tile.top({t});
    tile.row({b(0), b(1), q(0), p(0)});
    tile.row({b(0), p(0), q(-1)});
    tile.row({q(-1), p(0), P(0), Q(-1)});
    tile.row({p(0), q(0), Q(0), P(0)});
    tile.row({Q(-1), P(0), t(0)});
    tile.row({P(0), Q(0), t(1), t(0)});
    return tile;
}

void Rhombicuboctahedral::place(const BaseFrame& base, Point* tiers, Vector* slide) const
{
    const int n = base.n;
    const double edge = base.edge;
    const Angle& theta = base.angle;
    // Over edge i: p, q above its ends, P, Q above those, then the reach of a third quad, away.
    const auto p = [&](int i) -> Point& { return tiers[2 * i]; };
    const auto q = [&](int i) -> Point& { return tiers[2 * i + 1]; };
    const auto P = [&](int i) -> Point& { return tiers[2 * (n + i)]; };
    const auto Q = [&](int i) -> Point& { return tiers[2 * (n + i) + 1]; };
    const Cycle<Point> t(tiers + 4 * n, n), away(t);

    for (int i = 0; i < n; ++i) {
        p(i) = base.foot[i] + heights[0] * edge * base.climb[i];
        q(i) = base.foot[i + 1] + heights[0] * edge * base.climb[i];
        const Hinge second(q(i), p(i), base.wall[i], theta);
        P(i) = p(i) + heights[1] * edge * second.away;
        Q(i) = q(i) + heights[1] * edge * second.away;
        away[i] = Hinge(Q(i), P(i), second.normal, theta).away; // the memory of t serves until t is known
    }
    // The top's corner: as far out from both edges as their third quads reach (a mitre), at their mean elevation.
    const Vector last_away = away[n - 1];
    Vector before = last_away;
    for (int i = 0; i < n; ++i) {
        const Vector own = away[i];
        const Vector A = P(i) + heights[2] * edge * own - base.foot[i];
        const Vector B = Q(i == 0 ? n - 1 : i - 1) + heights[2] * edge * before - base.foot[i];
        const Vector &o = base.outward[i], &o1 = base.outward[i - 1];
        const double alpha = glm::dot(A, o), beta = glm::dot(B, o1), k = glm::dot(o, o1);
        const double z = 0.5 * (glm::dot(A, base.normal) + glm::dot(B, base.normal));
        const Vector uneven = 1.0 - k < 1e-12 ? Vector(0.0) : (alpha - beta) / (2.0 * (1.0 - k)) * (o - o1);
        t[i] = base.foot[i] + z * base.normal + (alpha + beta) / (2.0 * (1.0 + k)) * (o + o1) + uneven;
        if (slide) slide[i] = base.normal;
        before = own;
    }
}

Operator extrude_rhombicuboctahedral_operator()
{
    return define_extrusion<Rhombicuboctahedral>("extrude.rhombicuboctahedral", "Raise rings of quads with triangles at the corners on each face")
        .alias("extrude.small_rhombicuboctahedral")
        .preset("regular", "angle=135 heights=1,1,1 iterations=1 flat=false")
        .preset("fig24_pagoda", "angle=132 heights=1,1,1 iterations=3")
        .preset("fig24_bulb", "angle=133.5 heights=1,1,1 iterations=3")
        .preset("fig24_beads", "angle=135 heights=1,1,1 iterations=3")
        .preset("fig24_bowl", "angle=138 heights=1,1,1 iterations=3")
        .preset("fig25_terraces", "angle=135 heights=0.2,0.6,0.3 iterations=4")
        .preset("fig25_skyscraper", "angle=135 heights=0.25,3,0.5 iterations=4")
        .preset("fig25_lanterns", "angle=135 heights=1,0.2,1 iterations=4")
        .preset("fig25_overhang", "angle=135 heights=0.6,0.2,0.35 iterations=4")
        .example("extrude.rhombicuboctahedral faces=all heights=0.5,0.7,0.5")
        .cites("Landreneau 2005, III.3.2");
}

} // namespace druse
