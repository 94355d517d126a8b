#pragma once

#include "geom/point.h"

#include <cstdint>
#include <span>
#include <vector>

namespace druse {

/// A box in the plane; empty until something is added.
struct FlatBox {
    Point2 min{1e300}, max{-1e300};

    void add(const Point2& p)
    {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    bool empty() const { return min.x > max.x; }
    FlatBox grown(double by) const { return {min - Point2(by), max + Point2(by)}; }
    bool meets(const FlatBox& b) const { return min.x <= b.max.x && b.min.x <= max.x && min.y <= b.max.y && b.min.y <= max.y; }
};

/// Boxes in a grid of cells, to find those that meet another box. Cells are about as large as the boxes are on the average, at most four for each.
/// Cost: linear to make where boxes are of similar sizes.
class FlatGrid {
public:
    FlatGrid() = default;
    explicit FlatGrid(std::span<const FlatBox> boxes);

    /// Calls f(i) for each box that meets `box`, once; in ascending order within a cell.
    template <class F>
    void for_each(const FlatBox& box, F&& f) const
    {
        if (boxes_.empty() || !box.meets(all_)) return;
        const auto [x0, y0] = cell(box.min);
        const auto [x1, y1] = cell(box.max);
        for (int y = y0; y <= y1; ++y)
            for (int x = x0; x <= x1; ++x)
                for (std::uint32_t k = first_[std::size_t(y * width_ + x)]; k < first_[std::size_t(y * width_ + x) + 1]; ++k) {
                    const FlatBox& b = boxes_[items_[k]];
                    if (!b.meets(box)) continue;
                    const Cell lowest = lowest_[items_[k]]; // told in the first cell that both are in
                    if (x == std::max(lowest.x, x0) && y == std::max(lowest.y, y0)) f(items_[k]);
                }
    }
    const FlatBox& bounds() const { return all_; }

private:
    struct Cell {
        int x, y;
    };
    Cell cell(const Point2& p) const;

    FlatBox all_;
    Point2 scale_{0.0};
    int width_ = 0, height_ = 0;
    std::vector<FlatBox> boxes_;
    std::vector<Cell> lowest_; // of each box
    std::vector<std::uint32_t> first_, items_; // of each cell, one behind the other
};

} // namespace druse
