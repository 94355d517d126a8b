#include "graph/map_knot.h"

#include "geom/angle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace druse {

namespace {

constexpr int knot_samples = 720; // of the whole curve; a third of it is all there is to see

} // namespace

Trefoil::Derivatives Trefoil::derivatives(double t) const
{
    // The distance from the axis and its derivatives, times (cos 2t, sin 2t) and its derivatives.
    const double c3 = std::cos(3 * t), s3 = std::sin(3 * t), c2 = std::cos(2 * t), s2 = std::sin(2 * t);
    const double q = major_ + minor_ * c3, q1 = -3 * minor_ * s3, q2 = -9 * minor_ * c3, q3 = 27 * minor_ * s3;
    Derivatives d;
    d.c = {q * c2, q * s2, minor_ * s3};
    d.c1 = {q1 * c2 - 2 * q * s2, q1 * s2 + 2 * q * c2, 3 * minor_ * c3};
    d.c2 = {q2 * c2 - 4 * q1 * s2 - 4 * q * c2, q2 * s2 + 4 * q1 * c2 - 4 * q * s2, -9 * minor_ * s3};
    d.c3 = {q3 * c2 - 6 * q2 * s2 - 12 * q1 * c2 + 8 * q * s2, q3 * s2 + 6 * q2 * c2 - 12 * q1 * s2 - 8 * q * c2, -27 * minor_ * c3};
    return d;
}

Trefoil::Frame Trefoil::frame(double t) const
{
    const Derivatives d = derivatives(t);
    const Vector binormal = unit(glm::cross(d.c1, d.c2));
    return {d.c, glm::cross(binormal, unit(d.c1)), binormal};
}

double Trefoil::curvature(double t) const
{
    const Derivatives d = derivatives(t);
    const double speed = glm::length(d.c1);
    return glm::length(glm::cross(d.c1, d.c2)) / (speed * speed * speed);
}

bool Trefoil::is_bent() const
{
    for (int i = 0; i < knot_samples; ++i)
        if (!(curvature(2 * pi / 3 * i / knot_samples) * major_ > 1e-3)) return false;
    return true;
}

double Trefoil::least_radius_of_curvature() const
{
    const double step = 2 * pi / 3 / knot_samples;
    int best = 0;
    for (int i = 1; i < knot_samples; ++i)
        if (curvature(i * step) > curvature(best * step)) best = i;
    // The greatest curvature lies beside the greatest sample: by thirds.
    double low = (best - 1) * step, high = (best + 1) * step;
    for (int i = 0; i < 80; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        (curvature(a) < curvature(b) ? low : high) = curvature(a) < curvature(b) ? a : b;
    }
    return 1 / curvature(0.5 * (low + high));
}

double Trefoil::least_strand_distance() const
{
    const double step = 2 * pi / knot_samples;
    std::vector<Point> points;
    for (int i = 0; i < knot_samples; ++i) points.push_back(derivatives(i * step).c);
    const auto square = [&](int i, int j) {
        const Vector d = points[std::size_t((i + knot_samples) % knot_samples)] - points[std::size_t((j + knot_samples) % knot_samples)];
        return glm::dot(d, d);
    };
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < knot_samples / 3; ++i)
        for (int j = i + 2; j < i + knot_samples - 1; ++j) {
            // Pairs that are nearer than all around them; then down to where the chord is square to both strands, by Newton's steps.
            const double here = square(i, j);
            bool lowest = true;
            for (int a = -1; a <= 1 && lowest; ++a)
                for (int b = -1; b <= 1 && lowest; ++b) lowest = (a == 0 && b == 0) || here <= square(i + a, j + b);
            if (!lowest) continue;
            double s = i * step, t = j * step;
            for (int n = 0; n < 20; ++n) {
                const Derivatives p = derivatives(s), q = derivatives(t);
                const Vector d = p.c - q.c;
                const double fs = glm::dot(d, p.c1), ft = -glm::dot(d, q.c1);
                const double fss = glm::dot(p.c1, p.c1) + glm::dot(d, p.c2), ftt = glm::dot(q.c1, q.c1) - glm::dot(d, q.c2), fst = -glm::dot(p.c1, q.c1);
                const double det = fss * ftt - fst * fst;
                if (!(det > 0)) break;
                const double ds = std::clamp((fs * ftt - ft * fst) / det, -step, step), dt = std::clamp((ft * fss - fs * fst) / det, -step, step);
                s -= ds;
                t -= dt;
            }
            least = std::min(least, here);
            if (std::max(std::abs(s - i * step), std::abs(t - j * step)) > 2 * step) continue; // it went elsewhere
            const Vector d = derivatives(s).c - derivatives(t).c;
            least = std::min(least, glm::dot(d, d));
        }
    return std::sqrt(least);
}

} // namespace druse
