#pragma once

#include "dlfl/handle.h"
#include "dlfl/measures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace druse {

/// Finds the point near a place, in a time that does not depend on how many there are. The points stay the caller's.
class PointFinder {
public:
    /// Cells are a little larger than what is looked for, so that a search meets few cells and few points in them.
    PointFinder(const std::vector<Point>& points, double largest_reach) : points_(points), cell_(std::max(4.0 * largest_reach, least_cell(points)))
    {
        for (std::uint32_t i = 0; i < points.size(); ++i) cells_.emplace(key(cell_of(points[i])), i);
    }
    /// The lowest-numbered point within reach, or Vertex::none.
    std::uint32_t find(const Point& p, double reach) const
    {
        std::uint32_t best = Vertex::none;
        if (!std::isfinite(p.x + p.y + p.z)) return best;
        const glm::i64vec3 low = cell_of(p - Vector(reach)), high = cell_of(p + Vector(reach));
        for (auto x = low.x; x <= high.x; ++x)
            for (auto y = low.y; y <= high.y; ++y)
                for (auto z = low.z; z <= high.z; ++z) {
                    const auto [begin, end] = cells_.equal_range(key({x, y, z}));
                    for (auto it = begin; it != end; ++it)
                        if (glm::distance(points_[it->second], p) <= reach) best = std::min(best, it->second);
                }
        return best;
    }

private:
    /// What keeps the numbers of cells within 64 bits.
    static double least_cell(const std::vector<Point>& points)
    {
        Box box;
        for (const Point& p : points) box.add(p);
        const double least = 1e-15 * (box.diagonal() + glm::length(box.center()));
        return least > 0.0 ? least : 1.0;
    }
    glm::i64vec3 cell_of(const Point& p) const { return glm::i64vec3(glm::floor(p / cell_)); }
    static std::uint64_t key(const glm::i64vec3& c)
    {
        return std::uint64_t(c.x) * 0x9e3779b97f4a7c15ull ^ std::uint64_t(c.y) * 0xc2b2ae3d27d4eb4full ^ std::uint64_t(c.z) * 0x165667b19e3779f9ull;
    }
    const std::vector<Point>& points_;
    double cell_;
    std::unordered_multimap<std::uint64_t, std::uint32_t> cells_;
};

} // namespace druse
