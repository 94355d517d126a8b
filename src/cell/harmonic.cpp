#include "cell/harmonic.h"

#include <algorithm>
#include <cmath>

namespace druse {

namespace {

/// The stiffness matrix of linear elements on the unknown points: an entry for each pair of corners of a triangle.
class Stiffness {
public:
    Stiffness(std::span<const Point2> points, std::span<const std::array<std::uint32_t, 3>> triangles, std::span<const std::uint32_t> unknown)
        : slot_(points.size(), none), diagonal_(unknown.size(), 0.0)
    {
        for (std::uint32_t i = 0; i < unknown.size(); ++i) slot_[unknown[i]] = i;
        for (const auto& t : triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                // Half the cotangent of the angle opposite a side is what its ends have to do with each other.
                const std::uint32_t a = t[k], b = t[(k + 1) % 3];
                const Point2 u = points[a] - points[t[(k + 2) % 3]], v = points[b] - points[t[(k + 2) % 3]];
                const double twice_area = u.x * v.y - u.y * v.x;
                if (!(twice_area > 0)) continue;
                const double weight = 0.5 * glm::dot(u, v) / twice_area;
                if (slot_[a] == none && slot_[b] == none) continue;
                links_.push_back({a, b, weight});
                for (const std::uint32_t end : {a, b})
                    if (slot_[end] != none) diagonal_[slot_[end]] += weight;
            }
        for (double& d : diagonal_) d = d > 0 ? d : 1;
    }

    /// What the known points pull.
    std::vector<Vector> pull(const std::vector<Vector>& values) const
    {
        std::vector<Vector> sum(diagonal_.size(), Vector(0.0));
        for (const Link& l : links_) {
            if (slot_[l.b] == none) sum[slot_[l.a]] += l.weight * values[l.b];
            if (slot_[l.a] == none) sum[slot_[l.b]] += l.weight * values[l.a];
        }
        return sum;
    }

    std::vector<Vector> times(const std::vector<Vector>& x) const
    {
        std::vector<Vector> y(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) y[i] = diagonal_[i] * x[i];
        for (const Link& l : links_) {
            const std::uint32_t a = slot_[l.a], b = slot_[l.b];
            if (a == none || b == none) continue;
            y[a] -= l.weight * x[b];
            y[b] -= l.weight * x[a];
        }
        return y;
    }

    double diagonal(std::size_t i) const { return diagonal_[i]; }

private:
    static constexpr std::uint32_t none = 0xffffffffu;
    struct Link {
        std::uint32_t a, b;
        double weight;
    };
    std::vector<std::uint32_t> slot_;
    std::vector<double> diagonal_;
    std::vector<Link> links_;
};

double product(const std::vector<Vector>& a, const std::vector<Vector>& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i], b[i]);
    return sum;
}

} // namespace

void fill_harmonic(std::span<const Point2> points, std::span<const std::array<std::uint32_t, 3>> triangles, std::span<const std::uint32_t> unknown,
                   std::vector<Vector>& values)
{
    if (unknown.empty()) return;
    const Stiffness matrix(points, triangles, unknown);
    const std::size_t n = unknown.size();
    std::vector<Vector> x(n, Vector(0.0)), rest = matrix.pull(values), step(n), scaled(n);
    const auto precondition = [&] {
        for (std::size_t i = 0; i < n; ++i) scaled[i] = rest[i] / matrix.diagonal(i);
    };
    precondition();
    step = scaled;
    double size = product(rest, scaled);
    const double enough = 1e-26 * size;
    for (std::size_t round = 0; round < 4 * n + 50 && size > enough; ++round) {
        const std::vector<Vector> image = matrix.times(step);
        const double curvature = product(step, image);
        if (!(curvature > 0)) break;
        const double length = size / curvature;
        for (std::size_t i = 0; i < n; ++i) {
            x[i] += length * step[i];
            rest[i] -= length * image[i];
        }
        precondition();
        const double next = product(rest, scaled);
        for (std::size_t i = 0; i < n; ++i) step[i] = scaled[i] + next / size * step[i];
        size = next;
    }
    for (std::size_t i = 0; i < n; ++i) values[unknown[i]] = x[i];
}

} // namespace druse
