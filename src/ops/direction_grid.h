#pragma once

#include "geom/point.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace druse {

/// Numbered directions, and the first of them within an angle of a given one. A question costs the same whatever the number of
/// directions, as long as they lie at least that angle apart.
class DirectionGrid {
public:
    static constexpr std::uint32_t none = 0xffffffffu;

    /// The angle in degrees, 0 to 180; a 10⁹th of a degree more is let pass.
    explicit DirectionGrid(double angle)
        : reach_(2.0 * std::sin(angle * (std::numbers::pi / 360.0)) + 1.75e-11), cell_(2.0 * reach_ * (1.0 + 1e-9)), first_(16, none)
    {
    }

    /// `d` has length 1, or is zero: then it is near other zeros only.
    void add(const Vector& d, std::uint32_t number)
    {
        if (entries_.size() >= first_.size()) {
            first_.assign(2 * first_.size(), none);
            for (std::uint32_t i = 0; i < entries_.size(); ++i) hang(i);
        }
        entries_.push_back({d, number, none});
        hang(static_cast<std::uint32_t>(entries_.size() - 1));
    }

    /// The lowest number of a direction within the angle, or none.
    std::uint32_t find(const Vector& d) const
    {
        // A cell is twice as wide as the reach, so only its neighbours on the nearer side matter.
        const Cell home = cell(d);
        Cell beside = home;
        for (std::size_t k = 0; k < 3; ++k) beside[k] += d[int(k)] / cell_ - double(home[k]) < 0.5 ? -1 : 1;
        std::uint32_t best = none;
        for (unsigned i = 0; i < 8; ++i) {
            const Cell c{(i & 1 ? beside : home)[0], (i & 2 ? beside : home)[1], (i & 4 ? beside : home)[2]};
            for (std::uint32_t at = first_[slot(c)]; at != none; at = entries_[at].next)
                if (entries_[at].number < best && near(d, entries_[at].direction)) best = entries_[at].number;
        }
        return best;
    }

private:
    // Cells that fall on one slot share a chain: the distance tells them apart.
    using Cell = std::array<std::int64_t, 3>;
    struct Entry {
        Vector direction;
        std::uint32_t number, next;
    };

    Cell cell(const Vector& d) const
    {
        Cell c;
        for (std::size_t k = 0; k < 3; ++k) c[k] = static_cast<std::int64_t>(std::floor(d[int(k)] / cell_));
        return c;
    }
    std::size_t slot(const Cell& c) const
    {
        std::uint64_t h = 0;
        for (const std::int64_t x : c) h = (std::rotl(h, 23) ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15ull;
        return (h ^ h >> 32) & (first_.size() - 1);
    }
    void hang(std::uint32_t entry)
    {
        std::uint32_t& first = first_[slot(cell(entries_[entry].direction))];
        entries_[entry].next = first;
        first = entry;
    }
    bool near(const Vector& a, const Vector& b) const
    {
        const bool zero_a = a == Vector(0.0), zero_b = b == Vector(0.0);
        return zero_a || zero_b ? zero_a == zero_b : glm::distance(a, b) <= reach_;
    }

    double reach_, cell_; // the chord of the angle
    std::vector<std::uint32_t> first_; // by slot; their number is a power of two
    std::vector<Entry> entries_;
};

} // namespace druse
