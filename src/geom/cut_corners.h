#pragma once

#include "geom/point.h"
#include "geom/turn.h"

#include <vector>

namespace druse {

/// Replaces the corners of polygons by weighted means of all their corners.
///
/// Corner i of n becomes Σ_j W(n, i, j; α) p_j, with weight α for j = i and (1 − α)(3 + 2 cos(2π(i − j)/n))/(3n − 5) for the
/// others; they sum to 1. As the cosine of a difference is a sum of products, a polygon costs as much as it has corners.
/// Source: Doo & Sabin, *Behaviour of recursive division surfaces near extraordinary points* (1978), where α = 1/4 + 5/(4n).
class CornerCutter {
public:
    static double doo_sabin(int n) { return 0.25 + 1.25 / n; }

    /// `at(i)` is corner i, `write(i, p)` takes its replacement; every corner is read before the first is written.
    template <class At, class Write>
    void cut(int n, double alpha, At&& at, Write&& write)
    {
        if (n == 4) return cut_quad(alpha, at, write);
        if (directions_.size() != std::size_t(n)) {
            directions_.resize(std::size_t(n));
            for (int i = 0; i < n; ++i) directions_[std::size_t(i)] = turn(i, n);
        }
        // Relative to the first one, so that a polygon far from the origin loses no digits.
        const Point origin = at(0);
        relative_.resize(std::size_t(n));
        Vector sum(0.0), cosines(0.0), sines(0.0);
        for (int i = 0; i < n; ++i) {
            const Vector p = relative_[std::size_t(i)] = at(i) - origin;
            sum += p;
            cosines += directions_[std::size_t(i)].x * p;
            sines += directions_[std::size_t(i)].y * p;
        }
        const double w = (1.0 - alpha) / (3.0 * n - 5.0);
        for (int i = 0; i < n; ++i) {
            const Point2& d = directions_[std::size_t(i)];
            write(i, origin + w * (3.0 * sum + 2.0 * (d.x * cosines + d.y * sines)) + (alpha - 5.0 * w) * relative_[std::size_t(i)]);
        }
    }

private:
    /// Most faces of most meshes: 3 + 2 cos is 3 for the two neighbours and 1 for the corner opposite.
    template <class At, class Write>
    static void cut_quad(double alpha, At&& at, Write&& write)
    {
        const Point p = at(0);
        const Vector a = at(1) - p, b = at(2) - p, c = at(3) - p;
        const double w = (1.0 - alpha) / 7.0;
        write(0, p + (3.0 * w * (a + c) + w * b));
        write(1, p + (alpha * a + 3.0 * w * b + w * c));
        write(2, p + (alpha * b + 3.0 * w * (a + c)));
        write(3, p + (alpha * c + 3.0 * w * b + w * a));
    }

    std::vector<Point2> directions_; // of n corners, evenly around
    std::vector<Vector> relative_;
};

} // namespace druse
