#pragma once

#include "geom/point.h"

#include <array>

namespace druse {

/// A symmetric 3 × 3 matrix.
struct Symmetric3 {
    double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;

    /// Adds n nᵀ.
    void add_square(const Vector& n)
    {
        xx += n.x * n.x;
        yy += n.y * n.y;
        zz += n.z * n.z;
        xy += n.x * n.y;
        yz += n.y * n.z;
        zx += n.z * n.x;
    }
};

/// The shortest x that comes nearest to A x = b. Precondition: A is a sum of squares n nᵀ, and b a sum of the n with factors. Eigenvalues below `least`
/// times the largest count as 0: in these directions x does not go.
Vector least_squares(const Symmetric3& a, const Vector& b, double least);

} // namespace druse
