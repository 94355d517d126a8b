#pragma once

#include "geom/point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>
#include <utility>
#include <vector>

namespace druse {

/// Numbered directions, and the first of them within an angle of a given one. A cost per question that does not grow with the
/// number of directions, as long as they lie at least that angle apart.
class DirectionGrid {
public:
    static constexpr std::uint32_t none = 0xffffffffu;

    /// The angle in degrees, 0 to 180; a 10⁹th of a degree more is let pass.
    explicit DirectionGrid(double angle)
        : reach_(2.0 * std::sin(angle * (std::numbers::pi / 360.0)) + 1.75e-11), cell_(2.0 * reach_ * (1.0 + 1e-9))
    {
    }

    /// `d` has length 1, or is zero: then it is near other zeros only.
    void add(const Vector& d, std::uint32_t number) { cells_[cell(d)].emplace_back(d, number); }

    /// The lowest number of a direction within the angle, or none.
    std::uint32_t find(const Vector& d) const
    {
        // A cell is twice as wide as the reach, so only its neighbours on the nearer side matter.
        const Cell home = cell(d);
        Cell side{};
        for (std::size_t k = 0; k < 3; ++k) side[k] = d[int(k)] / cell_ - double(home[k]) < 0.5 ? -1 : 1;
        std::uint32_t best = none;
        for (int i = 0; i < 8; ++i) {
            Cell c = home;
            for (std::size_t k = 0; k < 3; ++k)
                if (i >> k & 1) c[k] += side[k];
            const auto at = cells_.find(c);
            if (at == cells_.end()) continue;
            for (const auto& [other, number] : at->second)
                if (number < best && near(d, other)) best = number;
        }
        return best;
    }

private:
    using Cell = std::array<std::int64_t, 3>;
    struct Hash {
        std::size_t operator()(const Cell& c) const noexcept
        {
            std::uint64_t h = 0;
            for (const std::int64_t x : c) h = (h ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15ull, h ^= h >> 29;
            return h;
        }
    };

    Cell cell(const Vector& d) const
    {
        Cell c;
        for (std::size_t k = 0; k < 3; ++k) c[k] = static_cast<std::int64_t>(std::floor(d[int(k)] / cell_));
        return c;
    }
    bool near(const Vector& a, const Vector& b) const
    {
        const bool zero_a = a == Vector(0.0), zero_b = b == Vector(0.0);
        return zero_a || zero_b ? zero_a == zero_b : glm::distance(a, b) <= reach_;
    }

    double reach_, cell_; // the chord of the angle
    std::unordered_map<Cell, std::vector<std::pair<Vector, std::uint32_t>>, Hash> cells_;
};

} // namespace druse
