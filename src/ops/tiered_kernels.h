#pragma once

#include "ops/extrude_frame.h"
#include "ops/tiling.h"

#include <array>

namespace druse {

// The seven tiered extrusions of Landreneau's *Crystal-like geometric modeling* (2005), chapters III.2 and III.3, as kernels for extrude_faces().
//
// With its default angle and heights each of them turns a regular triangle, square or pentagon into the regular solid it is named
// after. On any other face the connectivity is the same; angle and heights keep their meaning edge by edge. n is the number of
// sides of the base; V − E + F never changes. `place` writes the new vertices in the order of the tiling; heights are multiples of
// the mean length of the base edges, along directions given at each kernel. `mitred` kernels raise vertices over the corners along
// the line shared by two walls, and refuse a base that folds back on itself.

/// A pyramid: every edge proposes a tip up its wall, the apex is their mean. n triangles, no top: V + 1, E + n, F + n − 1.
struct Tetrahedral {
    static constexpr bool mitred = false, has_top = false;
    double angle = 70.528779365509308; // acos(1/3)
    std::array<double, 1> heights{0.866025403784439}; // sqrt(3)/2

    Tiling tiling() const;
    void place(const BaseFrame& base, Point* tiers, Vector* slide) const;
};

/// A prism whose walls lean at the angle: V + n, E + 2n, F + n.
struct Cubical {
    static constexpr bool mitred = true, has_top = true;
    double angle = 90;
    std::array<double, 1> heights{1.0};

    Tiling tiling() const;
    void place(const BaseFrame& base, Point* tiers, Vector* slide) const;
};

/// An antiprism: the top's corners stand over the middles of the base edges. V + n, E + 3n, F + 2n.
struct Octahedral {
    static constexpr bool mitred = false, has_top = true;
    double angle = 109.471220634490691; // 180° − acos(1/3)
    std::array<double, 1> heights{0.866025403784439};

    Tiling tiling() const;
    void place(const BaseFrame& base, Point* tiers, Vector* slide) const;
};

/// Two rows of pentagons, the lower one on the base edges. V + 3n, E + 5n, F + 2n.
struct Dodecahedral {
    static constexpr bool mitred = true, has_top = true;
    double angle = 116.565051177077989; // acos(−1/sqrt 5)
    std::array<double, 3> heights{1.0, 1.538841768587627, 1.0}; // the second is sqrt(5 + 2 sqrt 5)/2

    Tiling tiling() const;
    void place(const BaseFrame& base, Point* tiers, Vector* slide) const;
};

/// Six rows of triangles; the angle bends every one of them. V + 3n, E + 9n, F + 6n.
struct Icosahedral {
    static constexpr bool mitred = false, has_top = true;
    double angle = 138.189685104221401; // acos(−sqrt(5)/3)
    std::array<double, 3> heights{0.866025403784439, 1.0, 1.0};

    Tiling tiling() const;
    void place(const BaseFrame& base, Point* tiers, Vector* slide) const;
};

/// Triangles on the base edges, quads between them, triangles up to the top. V + 2n, E + 5n, F + 3n.
struct Cuboctahedral {
    static constexpr bool mitred = false, has_top = true;
    double angle = 125.264389682754654; // acos(−1/sqrt 3)
    std::array<double, 2> heights{0.866025403784439, 1.414213562373095};

    Tiling tiling() const;
    void place(const BaseFrame& base, Point* tiers, Vector* slide) const;
};

/// Quads up every edge with triangles at the corners, bent by the angle three times. V + 5n, E + 11n, F + 6n.
struct Rhombicuboctahedral {
    static constexpr bool mitred = true, has_top = true;
    double angle = 135;
    std::array<double, 3> heights{1.0, 1.0, 1.0};

    Tiling tiling() const;
    void place(const BaseFrame& base, Point* tiers, Vector* slide) const;
};

} // namespace druse
