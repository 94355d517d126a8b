#include "graph/nearest_directions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace druse {

namespace {

constexpr std::uint32_t few = 24; // that are compared each with each

} // namespace

void NearestDirections::find(std::span<const Vector> directions)
{
    const auto n = static_cast<std::uint32_t>(directions.size());
    order_.resize(n);
    nearest_.resize(n);
    std::iota(order_.begin(), order_.end(), 0u);
    place_.assign(n, 0.0);
    if (n > few) {
        // A line that no figure is likely to be square to.
        const Vector line = unit(Vector(1.0, std::numbers::sqrt2, std::numbers::e));
        for (std::uint32_t i = 0; i < n; ++i) place_[i] = glm::dot(directions[i], line);
        std::sort(order_.begin(), order_.end(), [this](std::uint32_t i, std::uint32_t j) { return place_[i] < place_[j] || (place_[i] == place_[j] && i < j); });
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t me = order_[i];
        double least = std::numeric_limits<double>::infinity();
        const auto look = [&](std::uint32_t other) {
            const Vector d = directions[other] - directions[me];
            if (const double square = glm::dot(d, d); square < least) {
                least = square;
                nearest_[me] = other;
            }
            const double gap = place_[other] - place_[me];
            return gap * gap <= least && least > 0;
        };
        for (std::uint32_t j = i + 1; j < n && look(order_[j]);) ++j;
        for (std::uint32_t j = i; j-- > 0 && look(order_[j]);) {}
    }
}

double angle_between(const Vector& u, const Vector& w) { return std::atan2(glm::length(glm::cross(u, w)), glm::dot(u, w)); }

} // namespace druse
