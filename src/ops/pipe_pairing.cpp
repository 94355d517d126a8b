#include "ops/pipe_pairing.h"

#include "dlfl/errors.h"
#include "geom/infinity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace druse {

namespace {

constexpr double tie = 1e-9; // sums that differ relatively by less are the same

double squared(const Vector& v) { return glm::dot(v, v); }

/// Two cycles of points that run side by side: the second one is the boundary of its face backwards.
struct Cycles {
    std::span<const Point> p, q;
    int n = 0, m = 0;

    Cycles(std::span<const Point> first, std::span<const Point> second)
        : p(first), q(second), n(static_cast<int>(first.size())), m(static_cast<int>(second.size()))
    {
    }
    double between(int i, int j) const { return squared(p[std::size_t(i % n)] - q[std::size_t(j % m)]); } // i, j ≥ 0
};

int wrapped(std::int64_t i, int n) { return static_cast<int>(((i % n) + n) % n); }

/// How far to go on in q so that it meets p with the least sum of squares, for as many points.
int least_twist(const Cycles& c, Progress& progress)
{
    const int n = c.n;
    double nearest = infinity;
    int wanted = 0; // the shift that joins the closest pair
    std::vector<double> sums(std::size_t(n), 0.0);
    for (int i = 0; i < n; ++i) {
        if (i % 256 == 0) progress.step(double(i) / n);
        for (int j = 0; j < n; ++j) {
            const double d = c.between(i, j);
            sums[std::size_t(wrapped(j - i, n))] += d;
            if (d < nearest * (1 - tie)) {
                nearest = d;
                wanted = wrapped(j - i, n);
            }
        }
    }
    const double least = *std::ranges::min_element(sums);
    int best = -1, best_distance = n;
    for (int s = 0; s < n; ++s) {
        if (sums[std::size_t(s)] > least * (1 + tie)) continue;
        const int ahead = wrapped(s - wanted, n), distance = std::min(ahead, n - ahead);
        if (distance >= best_distance) continue;
        best = s;
        best_distance = distance;
    }
    return best;
}

/// The bands that begin with one rung, each as the sum of its squares and its rungs: row i holds what the rungs up to p_i add up to.
class Bands {
public:
    Bands(const Cycles& c, Progress& progress)
        : c_(c), progress_(progress), sum_(std::size_t(c.m) + 1), ahead_(std::size_t(c.n) * (std::size_t(c.m) + 1))
    {
    }

    /// The least sum of all bands that begin with the rung between p_i0 and q_j0.
    double least(int i0, int j0)
    {
        const int n = c_.n, m = c_.m;
        std::fill(sum_.begin(), sum_.end(), infinity);
        sum_[0] = c_.between(i0, j0);
        for (int i = 1; i < n; ++i) {
            if (std::int64_t(i) * m % (1 << 18) < m) progress_.step(0.0);
            // From the far end, so that what the row before held is still there. The rungs behind must be able to reach the end.
            const int most = std::min(i, m), needed = std::max(0, m - (n - i));
            for (int j = most; j >= 0; --j) {
                const auto at = std::size_t(j);
                const double stay = sum_[at], step = j > 0 ? sum_[at - 1] : infinity;
                const bool stepped = step <= stay;
                ahead_[std::size_t(i) * (std::size_t(m) + 1) + at] = stepped;
                sum_[at] = j >= needed ? (stepped ? step : stay) + c_.between(i0 + i, j0 + j) : infinity;
            }
        }
        ends_ahead_ = sum_[std::size_t(m)] < sum_[std::size_t(m) - 1];
        return std::min(sum_[std::size_t(m)], sum_[std::size_t(m) - 1]);
    }

    /// The band of the last call: which q each p is joined to, counted from the first rung.
    std::vector<int> trace() const
    {
        std::vector<int> joined(std::size_t(c_.n));
        int j = ends_ahead_ ? c_.m : c_.m - 1;
        for (int i = c_.n - 1; i >= 0; --i) {
            joined[std::size_t(i)] = j;
            if (i > 0 && ahead_[std::size_t(i) * (std::size_t(c_.m) + 1) + std::size_t(j)]) --j;
        }
        return joined;
    }

private:
    const Cycles& c_;
    Progress& progress_;
    std::vector<double> sum_;
    std::vector<bool> ahead_; // row i, place j: whether the step to it went on in q
    bool ends_ahead_ = false;
};

/// Starting rungs to try: p_i with q_0 for all i, or where that is too much the nearest pairs.
std::vector<std::array<int, 2>> starts(const Cycles& c)
{
    std::vector<std::array<int, 2>> list;
    if (double(c.n) * c.n * c.m <= 5e7) {
        for (int i = 0; i < c.n; ++i) list.push_back({i, 0});
        return list;
    }
    constexpr std::size_t most = 16;
    std::vector<std::pair<double, std::array<int, 2>>> nearest; // ascending
    for (int i = 0; i < c.n; ++i)
        for (int j = 0; j < c.m; ++j) {
            const std::pair<double, std::array<int, 2>> pair{c.between(i, j), {i, j}};
            if (nearest.size() == most && !(pair.first < nearest.back().first)) continue;
            nearest.insert(std::ranges::upper_bound(nearest, pair), pair);
            if (nearest.size() > most) nearest.pop_back();
        }
    for (const auto& pair : nearest) list.push_back(pair.second);
    return list;
}

/// Rungs between different numbers of points, the larger number first: places in p and in q.
std::vector<Rung> least_band(const Cycles& c, const std::optional<std::array<int, 2>>& first, Progress& progress)
{
    Bands bands(c, progress);
    std::array<int, 2> start{0, 0};
    if (first) {
        start = *first;
        bands.least(start[0], start[1]);
    } else {
        double least = infinity;
        for (const auto& candidate : starts(c))
            if (const double sum = bands.least(candidate[0], candidate[1]); sum < least * (1 - tie)) {
                least = sum;
                start = candidate;
            }
        bands.least(start[0], start[1]);
    }
    const std::vector<int> joined = bands.trace();
    std::vector<Rung> rungs;
    for (int i = 0; i < c.n; ++i) rungs.push_back({wrapped(std::int64_t(start[0]) + i, c.n), wrapped(std::int64_t(start[1]) + joined[std::size_t(i)], c.m)});
    return rungs;
}

} // namespace

std::vector<Rung> pair_corners(std::span<const Point> from, std::span<const Point> to, const Pairing& pairing, Progress& progress)
{
    const auto n = static_cast<int>(from.size()), m = static_cast<int>(to.size());
    if (std::uint64_t(from.size()) * to.size() > (1u << 30) && !(n == m && pairing.first))
        throw CommandError(fmt::format("faces with {} and {} sides have too many pairings", n, m));
    std::vector<Point> backwards(to.size());
    for (int j = 0; j < m; ++j) backwards[std::size_t(j)] = to[std::size_t(wrapped(-j, m))];

    std::vector<Rung> rungs;
    if (n == m) {
        const Cycles c(from, backwards);
        const std::int64_t s = pairing.first ? -std::int64_t((*pairing.first)[1]) - (*pairing.first)[0] : least_twist(c, progress);
        const int start = pairing.first ? (*pairing.first)[0] : 0;
        for (int k = 0; k < n; ++k) {
            const int i = wrapped(std::int64_t(start) + k, n);
            rungs.push_back({i, wrapped(-(i + s + pairing.shift), m)});
        }
        return rungs;
    }
    std::optional<std::array<int, 2>> first = pairing.first;
    if (first) (*first)[1] = wrapped(-(*first)[1], m);
    if (n > m) {
        rungs = least_band(Cycles(from, backwards), first, progress);
    } else {
        if (first) std::swap((*first)[0], (*first)[1]);
        rungs = least_band(Cycles(backwards, from), first, progress);
        for (Rung& r : rungs) std::swap(r.from, r.to);
    }
    for (Rung& r : rungs) r.to = wrapped(-r.to, m);
    return rungs;
}

} // namespace druse
