#include "graph/weld.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace druse {

namespace {

constexpr std::uint32_t at_leaf = 8; // points at most, unless all lie at the same place

class Welder {
public:
    Welder(const std::vector<Point>& points, double reach, Progress& progress)
        : points_(points), reach_(reach), progress_(progress), first_(points.size()), order_(points.size())
    {
        std::iota(first_.begin(), first_.end(), 0u);
        order_ = first_;
    }

    std::vector<std::uint32_t> weld()
    {
        if (points_.empty()) return {};
        build(0, static_cast<std::uint32_t>(points_.size()));
        within(0);
        for (std::uint32_t v = 0; v < first_.size(); ++v) first_[v] = root(v);
        return std::move(first_);
    }

private:
    struct Node {
        Box box;
        std::uint32_t begin, end;  // in `order_`
        std::uint32_t second = 0;  // child; the first one follows its parent, 0: it is a leaf
        bool together = false;     // all of its points are known to hang together
    };

    bool is_near(const Vector& d) const
    {
        if (!(std::abs(d.x) <= reach_ && std::abs(d.y) <= reach_ && std::abs(d.z) <= reach_)) return false;
        return std::hypot(d.x, d.y, d.z) <= reach_; // no square is too large or too small
    }
    static Vector gap(const Box& a, const Box& b) { return glm::max(glm::max(a.min - b.max, b.min - a.max), Vector(0.0)); }

    std::uint32_t root(std::uint32_t v)
    {
        while (first_[v] != v) v = first_[v] = first_[first_[v]];
        return v;
    }
    void unite(std::uint32_t v, std::uint32_t w)
    {
        const std::uint32_t a = root(v), b = root(w);
        first_[std::max(a, b)] = std::min(a, b);
    }
    void breathe()
    {
        if ((++turns_ & 0x3ff) == 0) progress_.step(double(done_) / double(points_.size()));
    }

    void build(std::uint32_t begin, std::uint32_t end)
    {
        breathe();
        const auto number = static_cast<std::uint32_t>(nodes_.size());
        Box box;
        for (std::uint32_t i = begin; i < end; ++i) box.add(points_[order_[i]]);
        nodes_.push_back({box, begin, end});
        if (end - begin <= at_leaf || box.min == box.max) return;
        const Vector size = box.size();
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                         [&](std::uint32_t v, std::uint32_t w) { return points_[v][axis] < points_[w][axis]; });
        build(begin, middle);
        nodes_[number].second = static_cast<std::uint32_t>(nodes_.size());
        build(middle, end);
    }

    bool hang_together(const Node& a, const Node& b) { return a.together && b.together && root(order_[a.begin]) == root(order_[b.begin]); }

    void within(std::uint32_t number)
    {
        breathe();
        Node& node = nodes_[number];
        if (is_near(node.box.size())) {
            for (std::uint32_t i = node.begin; i < node.end; ++i) unite(order_[node.begin], order_[i]);
            done_ += node.end - node.begin;
            mark_together(number);
        } else if (node.second == 0) {
            node.together = true;
            for (std::uint32_t i = node.begin; i < node.end; ++i)
                for (std::uint32_t j = i + 1; j < node.end; ++j)
                    if (is_near(points_[order_[i]] - points_[order_[j]])) unite(order_[i], order_[j]);
            for (std::uint32_t i = node.begin; i < node.end; ++i) node.together = node.together && root(order_[i]) == root(order_[node.begin]);
            done_ += node.end - node.begin;
        } else {
            within(number + 1);
            within(node.second);
            between(number + 1, node.second);
            node.together = hang_together(nodes_[number + 1], nodes_[node.second]);
        }
    }

    void mark_together(std::uint32_t number)
    {
        Node& node = nodes_[number];
        node.together = true;
        if (node.second == 0) return;
        mark_together(number + 1);
        mark_together(node.second);
    }

    void between(std::uint32_t a, std::uint32_t b)
    {
        breathe();
        const Node &m = nodes_[a], &n = nodes_[b];
        if (!is_near(gap(m.box, n.box)) || hang_together(m, n)) return;
        if (m.second == 0 && n.second == 0) {
            // Of points at the same place one is enough.
            const std::uint32_t m_end = m.box.min == m.box.max ? m.begin + 1 : m.end, n_end = n.box.min == n.box.max ? n.begin + 1 : n.end;
            for (std::uint32_t i = m.begin; i < m_end; ++i)
                for (std::uint32_t j = n.begin; j < n_end; ++j)
                    if (is_near(points_[order_[i]] - points_[order_[j]])) unite(order_[i], order_[j]);
            return;
        }
        // The larger of both is halved, and what is nearer comes first: once it is joined the rest may be left alone.
        const bool halve_m = n.second == 0 || (m.second != 0 && m.end - m.begin >= n.end - n.begin);
        const std::uint32_t whole = halve_m ? b : a;
        std::uint32_t first = (halve_m ? a : b) + 1, second = (halve_m ? m : n).second;
        const auto distance = [&](std::uint32_t half) { return glm::length(gap(nodes_[half].box, nodes_[whole].box)); };
        if (distance(second) < distance(first)) std::swap(first, second);
        between(first, whole);
        between(second, whole);
    }

    const std::vector<Point>& points_;
    double reach_;
    Progress& progress_;
    std::vector<std::uint32_t> first_, order_;
    std::vector<Node> nodes_; // parents before their children
    std::uint32_t turns_ = 0, done_ = 0;
};

} // namespace

std::vector<std::uint32_t> first_within_reach(const std::vector<Point>& points, double reach, Progress& progress) { return Welder(points, reach, progress).weld(); }

} // namespace druse
