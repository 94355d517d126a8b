#include "tile/flat_grid.h"

#include <algorithm>
#include <cmath>

namespace druse {

FlatGrid::FlatGrid(std::span<const FlatBox> boxes) : boxes_(boxes.begin(), boxes.end())
{
    Point2 extent(0.0);
    for (const FlatBox& b : boxes_) {
        all_.add(b.min);
        all_.add(b.max);
        extent += b.max - b.min;
    }
    if (boxes_.empty()) return;
    const Point2 whole = all_.max - all_.min;
    const double count = static_cast<double>(boxes_.size());
    // At least a quarter box to a cell, so that the cells are no more than a few for each box.
    const double longer = std::max({whole.x, whole.y, 1e-300});
    const Point2 size = glm::max(extent / count, Point2(longer / std::ceil(2 * std::sqrt(count))));
    const auto cells = [](double length, double of) { return std::max(1, static_cast<int>(length / of)); };
    width_ = cells(whole.x, size.x);
    height_ = cells(whole.y, size.y);
    scale_ = {whole.x > 0 ? width_ / whole.x : 0.0, whole.y > 0 ? height_ / whole.y : 0.0};

    first_.assign(std::size_t(width_) * std::size_t(height_) + 1, 0);
    const auto for_cells = [&](const FlatBox& b, auto&& f) {
        const Cell from = cell(b.min), to = cell(b.max);
        for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x) f(std::size_t(y * width_ + x));
    };
    lowest_.reserve(boxes_.size());
    for (const FlatBox& b : boxes_) lowest_.push_back(cell(b.min));
    for (const FlatBox& b : boxes_) for_cells(b, [&](std::size_t c) { ++first_[c + 1]; });
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    items_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < boxes_.size(); ++i) for_cells(boxes_[i], [&](std::size_t c) { items_[next[c]++] = i; });
}

FlatGrid::Cell FlatGrid::cell(const Point2& p) const
{
    const auto part = [](double x, int count) { return static_cast<int>(std::clamp(x, 0.0, double(count - 1))); };
    return {part((p.x - all_.min.x) * scale_.x, width_), part((p.y - all_.min.y) * scale_.y, height_)};
}

} // namespace druse
