#include "geom/least_squares.h"

#include <algorithm>
#include <cmath>

namespace druse {

Vector least_squares(const Symmetric3& a, const Vector& b, double least)
{
    // Jacobi's rotations: each makes one element off the diagonal zero, and a few rounds make all of them as good as that.
    double m[3][3]{{a.xx, a.xy, a.zx}, {a.xy, a.yy, a.yz}, {a.zx, a.yz, a.zz}};
    Vector axis[3]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    constexpr int most_rounds = 12; // each squares what is left; five are enough
    for (int round = 0; round < most_rounds; ++round) {
        const double off = std::abs(m[0][1]) + std::abs(m[1][2]) + std::abs(m[0][2]);
        if (!(off > 1e-16 * (std::abs(m[0][0]) + std::abs(m[1][1]) + std::abs(m[2][2])))) break;
        for (const auto& [p, q] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)}) {
            if (m[p][q] == 0) continue;
            const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
            const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1));
            const double c = 1 / std::sqrt(t * t + 1), s = t * c;
            for (int k = 0; k < 3; ++k) {
                const double kp = m[k][p], kq = m[k][q];
                m[k][p] = c * kp - s * kq;
                m[k][q] = s * kp + c * kq;
            }
            for (int k = 0; k < 3; ++k) {
                const double pk = m[p][k], qk = m[q][k];
                m[p][k] = c * pk - s * qk;
                m[q][k] = s * pk + c * qk;
            }
            m[p][q] = m[q][p] = 0;
            const Vector ap = axis[p], aq = axis[q];
            axis[p] = c * ap - s * aq;
            axis[q] = s * ap + c * aq;
        }
    }
    const double largest = std::max({m[0][0], m[1][1], m[2][2]});
    Vector x(0.0);
    for (int k = 0; k < 3; ++k)
        if (m[k][k] > least * largest) x += glm::dot(axis[k], b) / m[k][k] * axis[k];
    return x;
}

} // namespace druse
