#pragma once

#include "geom/do_both.h"
#include "geom/point.h"
#include "geom/progress.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace druse {

/// A tree over boxes, to find those that overlap and those that a ray may meet.
///
/// Built from the top: the boxes of a node are halved at the median of their centres along the longest side of the box around these,
/// so that neither crowds nor far outliers make it deep. It is a complete binary tree without a pointer; what it holds, and the order
/// in which it tells, depend on the boxes only. It remembers them in single precision, scaled into a unit cube: the map is monotone,
/// so boxes that overlap still do, and a few that nearly do are told too.
/// Cost: O(n log n) to build, 40 bytes a box to keep.
class BoxTree {
public:
    BoxTree() = default;
    /// Preconditions: boxes are finite and not empty, fewer than 2^31. Reports its part of the work as `from` to `to`.
    /// @throws Cancelled
    BoxTree(std::span<const Box> boxes, Progress& progress, double from, double to);

    /// Calls f(i, j) for every two boxes that overlap or touch, once for each pair, and possibly for some that nearly do, until it
    /// returns false. Reports its part of the work as `from` to 1. Cost: O(n) and what it tells, for the surfaces of solids. @throws Cancelled
    template <class F>
    void for_each_pair(Progress& progress, double from, F&& f) const
    {
        if (order_.empty()) return;
        PairWalk<F> walk{*this, progress, from, leaves_, f};
        walk.within(1);
    }

    /// The same in two parts, done side by side where the machine can: `first` and `second` hear of different pairs, always of the same ones.
    template <class First, class Second>
    void for_each_pair_apart(Progress& progress, double from, First&& first, Second&& second) const
    {
        if (order_.empty()) return;
        if (leaves_ < 8) {
            for_each_pair(progress, from, first);
            return;
        }
        // Each takes one half of the tree, and one half of what lies between the halves.
        do_both(
            leaves_ > 1000,
            [&] {
                PairWalk<First> walk{*this, progress, from, leaves_ / 2, first};
                if (walk.within(2) && walk.between(4, 6)) walk.between(4, 7);
            },
            [&] {
                PairWalk<Second> walk{*this, progress, unreported, leaves_ / 2, second};
                if (walk.within(3) && walk.between(5, 6)) walk.between(5, 7);
            });
    }

    /// Calls f(i, reach) for boxes that may be met by the ray at a distance from 0 to `reach`, which f lowers as it likes; nearer nodes
    /// come first. `direction` has length 1. Precondition: finite.
    template <class F>
    void for_each_on_ray(const Point& origin, const Vector& direction, double reach, F&& f) const
    {
        if (order_.empty()) return;
        const LocalRay ray(*this, origin, direction);
        std::array<std::pair<std::uint32_t, double>, 64> waiting; // one at each level, and the two of the last
        std::size_t count = 0;
        if (const double at = ray.enter(nodes_[1]); at * unit_ <= reach) waiting[count++] = {1, at};
        while (count > 0) {
            const auto [node, enter] = waiting[--count];
            if (enter * unit_ > reach) continue;
            if (node < leaves_) {
                std::pair<std::uint32_t, double> first{2 * node, ray.enter(nodes_[2 * node])};
                std::pair<std::uint32_t, double> second{2 * node + 1, ray.enter(nodes_[2 * node + 1])};
                if (second.second < first.second) std::swap(first, second);
                for (const auto& child : {second, first})
                    if (child.second * unit_ <= reach) waiting[count++] = child;
            } else {
                for (std::uint32_t k = begin_of(node); k < end_of(node); ++k)
                    if (ray.enter(boxes_[k]) * unit_ <= reach) f(order_[k], reach);
            }
        }
    }

private:
    static constexpr double unreported = -1; // done beside what reports

    struct Small {
        std::array<float, 3> min{2, 2, 2}, max{-1, -1, -1}; // empty
        bool overlaps(const Small& b) const
        {
            return min[0] <= b.max[0] && b.min[0] <= max[0] && min[1] <= b.max[1] && b.min[1] <= max[1] && min[2] <= b.max[2] && b.min[2] <= max[2];
        }
        void add(const Small& b);
    };
    struct Item {
        std::array<float, 3> centre; // twice
        std::uint32_t box;
    };

    /// A ray in the unit cube.
    struct LocalRay {
        LocalRay(const BoxTree& tree, const Point& from, const Vector& direction);
        /// Where it enters a box, at least 0; infinite if it does not.
        double enter(const Small& box) const
        {
            constexpr double slack = 1e-6; // more than single precision loses
            double enter = 0, leave = std::numeric_limits<double>::infinity();
            for (std::size_t k = 0; k < 3; ++k) {
                double in = (double(box.min[k]) - slack - origin[int(k)]) * inverse[int(k)];
                double out = (double(box.max[k]) + slack - origin[int(k)]) * inverse[int(k)];
                if (in > out) std::swap(in, out);
                if (in > enter) enter = in; // 0 · ∞, for a ray along a side of the box, changes nothing
                if (out < leave) leave = out;
            }
            return enter <= leave ? enter : std::numeric_limits<double>::infinity();
        }
        Point origin;
        Vector inverse;
    };

    template <class F>
    struct PairWalk {
        const BoxTree& tree;
        Progress& progress;
        double from;
        std::uint32_t leaves; // that it is going to see
        F& f;
        std::uint32_t turns = 0, done = 0;

        void breathe()
        {
            if ((++turns & 0xff) != 0) return;
            if (from != unreported) progress.step(from + (1 - from) * done / leaves);
            else if (progress.cancelled()) throw Cancelled();
        }
        bool within(std::uint32_t node)
        {
            if (node < tree.leaves_) return within(2 * node) && within(2 * node + 1) && between(2 * node, 2 * node + 1);
            ++done;
            breathe();
            for (std::uint32_t i = tree.begin_of(node); i < tree.end_of(node); ++i)
                for (std::uint32_t j = i + 1; j < tree.end_of(node); ++j)
                    if (tree.boxes_[i].overlaps(tree.boxes_[j]) && !f(tree.order_[i], tree.order_[j])) return false;
            return true;
        }
        bool between(std::uint32_t a, std::uint32_t b) // of one level
        {
            if (!tree.nodes_[a].overlaps(tree.nodes_[b])) return true;
            breathe();
            if (a < tree.leaves_)
                return between(2 * a, 2 * b) && between(2 * a, 2 * b + 1) && between(2 * a + 1, 2 * b) && between(2 * a + 1, 2 * b + 1);
            for (std::uint32_t i = tree.begin_of(a); i < tree.end_of(a); ++i) {
                if (!tree.boxes_[i].overlaps(tree.nodes_[b])) continue;
                for (std::uint32_t j = tree.begin_of(b); j < tree.end_of(b); ++j)
                    if (tree.boxes_[i].overlaps(tree.boxes_[j]) && !f(tree.order_[i], tree.order_[j])) return false;
            }
            return true;
        }
    };

    Small small(const Box& box) const;
    struct Building;
    void build(const Building& b, std::uint32_t node, std::uint32_t depth);

    /// The boxes of leaf k are those from k n / leaves to (k + 1) n / leaves, in the order of the tree.
    std::uint32_t begin_of(std::uint32_t leaf) const { return place(leaf - leaves_, leaves_); }
    std::uint32_t end_of(std::uint32_t leaf) const { return place(leaf - leaves_ + 1, leaves_); }
    std::uint32_t place(std::uint32_t k, std::uint32_t parts) const { return static_cast<std::uint32_t>(std::uint64_t(k) * order_.size() / parts); }

    std::uint32_t leaves_ = 0;         // a power of two
    std::vector<Small> nodes_;         // the root is 1, the children of k are 2 k and 2 k + 1
    std::vector<Small> boxes_;         // in the order of the tree
    std::vector<std::uint32_t> order_; // their numbers
    Point corner_{0.0};                // of the unit cube
    double unit_ = 1;                  // and its side
};

} // namespace druse
