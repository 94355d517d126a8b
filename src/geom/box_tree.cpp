#include "geom/box_tree.h"

#include <algorithm>
#include <bit>

namespace druse {

namespace {

constexpr std::uint32_t leaf_size = 4;           // the most boxes of a leaf
constexpr std::uint32_t worth_a_thread = 10'000; // boxes

} // namespace

void BoxTree::Small::add(const Small& b)
{
    for (std::size_t k = 0; k < 3; ++k) {
        min[k] = std::min(min[k], b.min[k]);
        max[k] = std::max(max[k], b.max[k]);
    }
}

BoxTree::LocalRay::LocalRay(const BoxTree& tree, const Point& from, const Vector& direction)
    : origin((from - tree.corner_) / tree.unit_), inverse(1.0 / direction)
{
}

struct BoxTree::Building {
    std::span<const Box> boxes;
    std::span<Item> items;
    Progress& progress;
    double from, to;
    bool reports = true; // else what is done beside it does
};

BoxTree::BoxTree(std::span<const Box> boxes, Progress& progress, double from, double to)
{
    if (boxes.empty()) return;
    Box all;
    for (const Box& b : boxes) {
        all.add(b.min);
        all.add(b.max);
    }
    corner_ = all.min;
    const Vector size = 0.5 * all.max - 0.5 * all.min; // half: the whole might overflow
    const double most = std::max({size.x, size.y, size.z});
    unit_ = most > 1e-300 && most < 1e300 ? 2 * most : most >= 1e300 ? 1e308 : 1.0;

    const auto n = static_cast<std::uint32_t>(boxes.size());
    leaves_ = std::bit_ceil((n + leaf_size - 1) / leaf_size);
    order_.resize(n);
    boxes_.resize(n);
    nodes_.resize(2 * std::size_t(leaves_));
    std::vector<Item> items(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const Small s = small(boxes[i]);
        for (std::size_t k = 0; k < 3; ++k) items[i].centre[k] = s.min[k] + s.max[k];
        items[i].box = i;
    }
    build({boxes, items, progress, from, to}, 1, 0);
}

BoxTree::Small BoxTree::small(const Box& box) const
{
    Small s;
    for (int k = 0; k < 3; ++k) {
        s.min[std::size_t(k)] = static_cast<float>(box.min[k] / unit_ - corner_[k] / unit_);
        s.max[std::size_t(k)] = static_cast<float>(box.max[k] / unit_ - corner_[k] / unit_);
    }
    return s;
}

void BoxTree::build(const Building& b, std::uint32_t node, std::uint32_t depth)
{
    const std::uint32_t at = node - (1u << depth); // among the nodes of its level
    const std::uint32_t begin = place(at, 1u << depth), end = place(at + 1, 1u << depth);
    const std::span<Item> items = b.items.subspan(begin, end - begin);
    if (items.size() > 1000) {
        if (b.reports) b.progress.step(b.from + (b.to - b.from) * begin / double(order_.size()));
        else if (b.progress.cancelled()) throw Cancelled();
    }
    if (node >= leaves_) {
        for (std::uint32_t k = begin; k < end; ++k) {
            order_[k] = b.items[k].box;
            boxes_[k] = small(b.boxes[order_[k]]);
            nodes_[node].add(boxes_[k]);
        }
        return;
    }
    std::array<float, 3> least = items[0].centre, most = least;
    for (const Item& item : items)
        for (std::size_t k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], item.centre[k]);
            most[k] = std::max(most[k], item.centre[k]);
        }
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (most[k] - least[k] > most[axis] - least[axis]) axis = k;
    const std::uint32_t middle = place(2 * at + 1, 2u << depth);
    std::nth_element(items.begin(), items.begin() + (middle - begin), items.end(), [axis](const Item& i, const Item& j) {
        return i.centre[axis] != j.centre[axis] ? i.centre[axis] < j.centre[axis] : i.box < j.box;
    });
    const auto half = [&](const Building& how, std::uint32_t child) { build(how, child, depth + 1); };
    if (depth == 0 && items.size() > worth_a_thread) {
        Building beside = b;
        beside.reports = false;
        do_both(true, [&] { half(b, 2 * node); }, [&] { half(beside, 2 * node + 1); });
    } else {
        half(b, 2 * node);
        half(b, 2 * node + 1);
    }
    nodes_[node] = nodes_[2 * node];
    nodes_[node].add(nodes_[2 * node + 1]);
}

} // namespace druse
