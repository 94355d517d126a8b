// Many vertices at once, along a Hilbert curve.
#include "pane/triangulation.h"

#include <algorithm>
#include <numeric>

namespace druse {

using Index = Triangulation::Index;

namespace {

/// Four levels of the curve at once: 4 bits of x and of y, and how the square lies, give 8 bits of the way along it and how the next square lies.
struct HilbertTable {
    std::array<std::array<std::uint16_t, 256>, 4> step{};

    constexpr HilbertTable()
    {
        for (unsigned start = 0; start < 4; ++start)
            for (unsigned xy = 0; xy < 256; ++xy) {
                unsigned swapped = start & 1, turned = start >> 1, along = 0;
                for (int bit = 3; bit >= 0; --bit) {
                    unsigned x = ((xy >> (4 + bit)) & 1) ^ turned, y = ((xy >> bit) & 1) ^ turned;
                    if (swapped != 0) {
                        const unsigned x_before = x;
                        x = y;
                        y = x_before;
                    }
                    along = along * 4 + ((3 * x) ^ y);
                    if (y == 0) {
                        turned ^= x;
                        swapped ^= 1;
                    }
                }
                step[start][xy] = static_cast<std::uint16_t>(along | (swapped | turned << 1) << 8);
            }
    }
};
constexpr HilbertTable table;

std::uint32_t along_curve(std::uint32_t x, std::uint32_t y)
{
    std::uint32_t along = 0, lie = 0;
    for (int shift = 12; shift >= 0; shift -= 4) {
        const std::uint16_t step = table.step[lie][((x >> shift) & 15) << 4 | ((y >> shift) & 15)];
        along = along << 8 | (step & 0xff);
        lie = step >> 8;
    }
    return along;
}

} // namespace

std::vector<std::uint32_t> hilbert_order(std::span<const Point2> points)
{
    Point2 min(1e300), max(-1e300);
    for (const Point2& p : points) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    const Point2 size = max - min;
    const double longer = std::max(size.x, size.y), scale = longer > 0 ? 65535 / longer : 0;
    struct Entry {
        std::uint32_t key, index;
    };
    std::vector<Entry> entries(points.size()), sorted(points.size());
    std::array<std::array<std::uint32_t, 2049>, 3> start{};
    constexpr std::array<unsigned, 3> shift{0, 11, 22};
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const Point2 at = (points[i] - min) * scale;
        const std::uint32_t key = along_curve(static_cast<std::uint32_t>(at.x), static_cast<std::uint32_t>(at.y));
        entries[i] = {key, i};
        for (std::size_t digit = 0; digit < 3; ++digit) ++start[digit][((key >> shift[digit]) & 2047) + 1];
    }
    for (std::size_t digit = 0; digit < 3; ++digit) {
        std::partial_sum(start[digit].begin(), start[digit].end(), start[digit].begin());
        for (const Entry& entry : entries) sorted[start[digit][(entry.key >> shift[digit]) & 2047]++] = entry;
        std::swap(entries, sorted);
    }
    std::vector<std::uint32_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = entries[i].index;
    return order;
}

/// Vertices are numbered along the curve. They are put in on several rounds along it, every 512th, 64th and 8th first: points that come in order alone
/// would make and break long thin faces over what is still empty. Each walk starts at the point before on the curve.
Index Triangulation::insert_all(std::span<const Point2> points, double weld, std::vector<Index>& made, std::vector<Split>& splits)
{
    const std::vector<std::uint32_t> order = hilbert_order(points);
    const auto count = static_cast<Index>(points.size());
    made.resize(count);
    const Index first = vertices_.size();
    vertices_.reserve(first + count);
    sides_.reserve(sides_.size() + std::size_t(count) * 8);
    for (const std::uint32_t i : order) vertices_.add({points[i], none});
    state_.vertices += count;
    Index refused = none;
    std::vector<Index> double_points;
    constexpr Index least_step = 512;
    for (Index step = least_step; step >= 1 && refused == none; step /= 8)
        for (Index i = 0; i < count; i += step) {
            if (step != least_step && i % (step * 8) == 0) continue;
            const Index v = first + i;
            const Point2& p = position(v);
            const Index start = i >= step ? out(made[order[i - step]]) : state_.corners[0] < first ? out(state_.corners[0]) : last_;
            const Place at = locate(p, start);
            if (!is_inside(at.side) && !(at.kind == Place::Kind::side && is_inside(twin(at.side)))) {
                refused = order[i];
                break;
            }
            if (const Index there = look_around(p, at, weld).vertex; there != none) {
                made[order[i]] = there;
                double_points.push_back(v);
                continue;
            }
            if (at.kind == Place::Kind::side && is_fixed(at.side)) splits.push_back({v, origin(at.side), target(at.side), bits(at.side)});
            join(v, at);
            made[order[i]] = v;
        }
    if (refused != none) return refused;
    for (const Index v : double_points) free_vertex(v);
    return none;
}

} // namespace druse
