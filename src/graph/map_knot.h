#pragma once

#include "geom/point.h"

#include <algorithm>

namespace druse {

/// The trefoil C(t) = ((R + a cos 3t) cos 2t, (R + a cos 3t) sin 2t, a sin 3t), a curve on a torus, closed after t = 2π.
class Trefoil {
public:
    Trefoil(double major, double minor) : major_(major), minor_(minor) {}

    struct Frame {
        Point place;
        Vector normal, binormal;
    };
    /// Frenet's frame. Precondition: is_bent()
    Frame frame(double t) const;

    /// Whether the curvature is nowhere near 0, where the frame would turn over.
    bool is_bent() const;

    double least_radius_of_curvature() const;
    /// The least length of a chord that is square to the curve at both ends. Both are found among 720 places and then by steps, to 1e-9 of them.
    double least_strand_distance() const;
    /// The radius up to which a tube about it stays clear of itself. Cost: 5 ms.
    double thickness() const { return std::min(least_radius_of_curvature(), 0.5 * least_strand_distance()); }

private:
    struct Derivatives {
        Vector c, c1, c2, c3; // the curve and its derivatives by t
    };
    Derivatives derivatives(double t) const;
    double curvature(double t) const;

    double major_, minor_;
};

} // namespace druse
