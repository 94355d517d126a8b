#include "geom/ear_clipping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace druse {

namespace {

using Ear = std::array<std::uint32_t, 3>;

constexpr double sliver = 1e-10; // quality of a triangle that has an area from rounding only

/// Qualities that differ by rounding only shall be no choice, so they are compared as multiples of 2⁻³⁰.
double coarse(double quality)
{
    constexpr double unit = 0x1.8p22; // numbers of this size have no finer digits
    return (quality + unit) - unit;
}

/// Twice the signed area of a triangle: positive if it runs counter-clockwise.
double cross(const Point2& a, const Point2& b, const Point2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double squared(const Point2& v)
{
    return v.x * v.x + v.y * v.y;
}

double signed_area(std::span<const Point2> polygon)
{
    double twice = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) twice += cross(polygon[0], polygon[i - 1], polygon[i]);
    return 0.5 * twice;
}

/// True if every corner turns the same way by more than rounding, and all of them together turn once.
bool is_strictly_convex(std::span<const Point2> polygon, double turn)
{
    constexpr double least_sine = 1e-9;
    const std::size_t n = polygon.size();
    int reversals = 0; // of the direction along x; a polygon that winds once has two
    Point2 in = polygon[0] - polygon[n - 1];
    for (std::size_t i = 0; i < n; ++i) {
        const Point2 out = polygon[i + 1 == n ? 0 : i + 1] - polygon[i];
        const double sine = turn * (in.x * out.y - in.y * out.x);
        if (!(sine > 0 && sine * sine > least_sine * least_sine * squared(in) * squared(out))) return false;
        const bool forward = in.x > 0 || (in.x == 0 && in.y > 0), still_forward = out.x > 0 || (out.x == 0 && out.y > 0);
        if (forward != still_forward) ++reversals;
        in = out;
    }
    return reversals == 2;
}

/// Cuts off every other corner until three are left.
void cut_in_rings(std::uint32_t n, std::vector<Ear>& triangles)
{
    for (std::uint32_t step = 1; step < n; step *= 2) // the ring of this round is 0, step, 2 · step, … below n
        for (std::uint32_t i = 0; i + step < n; i += 2 * step) {
            const std::uint32_t last = i + 2 * step < n ? i + 2 * step : 0;
            if (last != i) triangles.push_back({i, i + step, last});
        }
}

class EarClipper {
public:
    EarClipper(std::span<const Point2> polygon, double turn, std::vector<Ear>& triangles);
    void clip();

private:
    static constexpr std::uint32_t none = 0xffffffffu;

    // What is clipped first. Within a kind, the best shaped triangle goes first.
    enum class Kind : std::uint8_t {
        spike,    // stands still or turns straight back: the polygon is the same without it
        convex,   // an ear, if nothing lies in it
        touched,  // something lies on the side it would be cut along, or on the others
        straight, // has no area
        blocked,  // something lies in it
        reflex
    };
    struct Node {
        Point2 at;
        std::uint32_t previous, next;
        std::uint32_t in_cell = none; // the next corner in the same cell of the grid
        std::uint32_t waiting = none; // ears that this corner blocks: first in `waiting_`
        std::uint32_t version = 0;    // entries of the queue that were made before count no more
        bool clipped = false, can_block = false, in_grid = false;
    };
    struct Entry {
        Kind kind;
        double quality;
        std::uint32_t corner, version;
        // The heap hands out its greatest.
        friend bool operator<(const Entry& a, const Entry& b)
        {
            if (a.kind != b.kind) return a.kind > b.kind;
            if (a.quality != b.quality) return a.quality < b.quality;
            return a.corner > b.corner;
        }
    };
    struct Waiting {
        std::uint32_t corner, version, next;
    };

    Entry entry(std::uint32_t i);
    void push(const Entry& e);
    void look_again(std::uint32_t i);
    void release(std::uint32_t blocker);
    std::pair<Kind, std::uint32_t> find_blocker(std::uint32_t ear);

    void make_grid();
    void put_in_grid(std::uint32_t i);
    std::uint32_t column(double x) const { return cell(x - origin_.x, columns_); }
    std::uint32_t row(double y) const { return cell(y - origin_.y, rows_); }
    std::uint32_t cell(double offset, std::uint32_t count) const
    {
        return static_cast<std::uint32_t>(std::clamp(offset * cells_per_unit_, 0.0, double(count - 1)));
    }

    std::vector<Node> nodes_;
    std::vector<Entry> queue_;
    std::vector<Waiting> waiting_;
    std::vector<std::uint32_t> cells_; // first corner of each cell
    std::uint32_t columns_ = 1, rows_ = 1;
    Point2 origin_{0.0};
    double cells_per_unit_ = 0;
    std::vector<Ear>& triangles_;
};

EarClipper::EarClipper(std::span<const Point2> polygon, double turn, std::vector<Ear>& triangles) : triangles_(triangles)
{
    const auto n = static_cast<std::uint32_t>(polygon.size());
    nodes_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) {
        nodes_[i].at = Point2(polygon[i].x, turn * polygon[i].y); // a clockwise polygon is looked at from behind
        nodes_[i].previous = i == 0 ? n - 1 : i - 1;
        nodes_[i].next = i + 1 == n ? 0 : i + 1;
    }
    queue_.reserve(2 * std::size_t(n));
    for (std::uint32_t i = 0; i < n; ++i) queue_.push_back(entry(i));
    std::make_heap(queue_.begin(), queue_.end());
    make_grid();
}

EarClipper::Entry EarClipper::entry(std::uint32_t i)
{
    Node& b = nodes_[i];
    const Point2 &p = nodes_[b.previous].at, &q = nodes_[b.next].at;
    const double area = cross(p, b.at, q);
    const double longest = std::max({squared(b.at - p), squared(q - b.at), squared(p - q)});
    const double quality = longest > 0 ? area / longest : 0.0;
    b.can_block = !(quality > sliver);
    const Kind kind = quality > sliver                   ? Kind::convex
                      : quality < -sliver                ? Kind::reflex
                      : glm::dot(b.at - p, q - b.at) > 0 ? Kind::straight
                                                         : Kind::spike;
    return {kind, coarse(quality), i, b.version};
}

void EarClipper::push(const Entry& e)
{
    queue_.push_back(e);
    std::push_heap(queue_.begin(), queue_.end());
}

/// The neighbours of a corner have changed.
void EarClipper::look_again(std::uint32_t i)
{
    Node& node = nodes_[i];
    ++node.version;
    const bool could_block = node.can_block;
    push(entry(i));
    if (could_block && !node.can_block) release(i);
    if (node.can_block && !node.in_grid) put_in_grid(i); // only where the polygon crosses itself
}

/// A corner blocks no more: the ears that waited for it are tried again.
void EarClipper::release(std::uint32_t blocker)
{
    std::uint32_t w = std::exchange(nodes_[blocker].waiting, none);
    for (; w != none; w = waiting_[w].next) {
        const std::uint32_t i = waiting_[w].corner;
        Node& node = nodes_[i];
        if (node.clipped || node.version != waiting_[w].version) continue;
        ++node.version;
        push(entry(i));
    }
}

void EarClipper::make_grid()
{
    Point2 low(std::numeric_limits<double>::infinity()), high = -low;
    std::uint32_t blockers = 0;
    for (const Node& node : nodes_)
        if (node.can_block) {
            low = glm::min(low, node.at);
            high = glm::max(high, node.at);
            ++blockers;
        }
    if (blockers > 8) {
        // About as many cells as corners that can block, square ones; a thin polygon gets a row of them.
        const Point2 size = high - low;
        const double longer = std::max(size.x, size.y), shorter = std::min(size.x, size.y);
        if (longer > 0) {
            const double ratio = std::max(shorter / longer, 1.0 / blockers);
            const double along = std::clamp(std::sqrt(blockers / ratio), 1.0, double(blockers));
            cells_per_unit_ = along / longer;
            origin_ = low;
            columns_ = static_cast<std::uint32_t>(size.x * cells_per_unit_) + 1;
            rows_ = static_cast<std::uint32_t>(size.y * cells_per_unit_) + 1;
        }
    }
    cells_.assign(std::size_t(columns_) * rows_, none);
    for (std::uint32_t i = 0; i < nodes_.size(); ++i)
        if (nodes_[i].can_block) put_in_grid(i);
}

void EarClipper::put_in_grid(std::uint32_t i)
{
    Node& node = nodes_[i];
    std::uint32_t& first = cells_[std::size_t(row(node.at.y)) * columns_ + column(node.at.x)];
    node.in_cell = first;
    node.in_grid = true;
    first = i;
}

/// A corner that lies inside an ear, or else one upon its sides; `none` if the ear may be clipped. Corners that share their place
/// with one of the ear's own do not count: there the polygon touches itself, or leads in to a hole and out again.
std::pair<EarClipper::Kind, std::uint32_t> EarClipper::find_blocker(std::uint32_t ear)
{
    const Node& node = nodes_[ear];
    const Point2 a = nodes_[node.previous].at, b = node.at, c = nodes_[node.next].at;
    const double slack = sliver * std::max({squared(b - a), squared(c - b), squared(a - c)});
    std::uint32_t upon_side = none;

    const auto look_at_cell = [&](std::uint32_t& first) {
        for (std::uint32_t* link = &first; *link != none;) {
            Node& other = nodes_[*link];
            if (other.clipped || !other.can_block) { // has left the grid
                other.in_grid = false;
                *link = other.in_cell;
                continue;
            }
            const Point2& q = other.at;
            const double ab = cross(a, b, q), bc = cross(b, c, q), ca = cross(c, a, q);
            // A straight corner that rounding put beside the side to be cut along still lies upon it.
            if (ab >= 0 && bc >= 0 && ca >= -slack && q != a && q != b && q != c) {
                if (ab > 0 && bc > 0 && ca > slack) return *link;
                if (upon_side == none) upon_side = *link;
            }
            link = &other.in_cell;
        }
        return none;
    };

    // Row by row, the cells that the triangle meets. Rounding must not lose one, so each strip is taken a little wider.
    const std::array<Point2, 3> corner{a, b, c};
    const std::uint32_t first_row = row(std::min({a.y, b.y, c.y})), last_row = row(std::max({a.y, b.y, c.y}));
    for (std::uint32_t r = first_row; r <= last_row; ++r) {
        double left = std::numeric_limits<double>::infinity(), right = -left;
        if (first_row == last_row) {
            left = std::min({a.x, b.x, c.x}), right = std::max({a.x, b.x, c.x});
        } else {
            constexpr double margin = 1e-6;
            const double low =
                r == first_row ? -std::numeric_limits<double>::infinity() : origin_.y + (r - margin) / cells_per_unit_;
            const double high =
                r == last_row ? std::numeric_limits<double>::infinity() : origin_.y + (r + 1 + margin) / cells_per_unit_;
            for (std::size_t i = 0; i < 3; ++i) {
                const Point2 &p = corner[i], &q = corner[(i + 1) % 3];
                if (std::max(p.y, q.y) < low || std::min(p.y, q.y) > high) continue;
                const double from = std::clamp(low, std::min(p.y, q.y), std::max(p.y, q.y));
                const double to = std::clamp(high, std::min(p.y, q.y), std::max(p.y, q.y));
                for (const double y : {from, to}) {
                    const double x = p.y == q.y ? p.x : p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y));
                    left = std::min(left, x), right = std::max(right, x);
                }
                if (p.y == q.y) left = std::min(left, q.x), right = std::max(right, q.x);
            }
            left -= margin / cells_per_unit_, right += margin / cells_per_unit_;
        }
        if (left > right) continue;
        const std::uint32_t last_column = column(right);
        for (std::uint32_t k = column(left); k <= last_column; ++k)
            if (const std::uint32_t found = look_at_cell(cells_[std::size_t(r) * columns_ + k]); found != none)
                return {Kind::blocked, found};
    }
    return {Kind::touched, upon_side};
}

void EarClipper::clip()
{
    std::size_t left = nodes_.size();
    while (left > 3) {
        std::pop_heap(queue_.begin(), queue_.end());
        Entry e = queue_.back();
        queue_.pop_back();
        const std::uint32_t i = e.corner;
        if (nodes_[i].clipped || nodes_[i].version != e.version) continue;
        if (e.kind == Kind::convex) {
            const auto [kind, blocker] = find_blocker(i);
            if (blocker != none) {
                waiting_.push_back({i, e.version, nodes_[blocker].waiting});
                nodes_[blocker].waiting = static_cast<std::uint32_t>(waiting_.size() - 1);
                e.kind = kind;
                push(e);
                continue;
            }
        }
        Node& node = nodes_[i];
        triangles_.push_back({node.previous, i, node.next});
        node.clipped = true;
        nodes_[node.previous].next = node.next;
        nodes_[node.next].previous = node.previous;
        --left;
        release(i);
        look_again(node.previous);
        look_again(node.next);
    }
    std::uint32_t i = 0;
    while (nodes_[i].clipped) ++i;
    triangles_.push_back({i, nodes_[i].next, nodes_[i].previous});
}

} // namespace

void clip_ears(std::span<const Point2> polygon, std::vector<Ear>& triangles)
{
    triangles.clear();
    if (polygon.size() < 3) return;
    triangles.reserve(polygon.size() - 2);
    const double turn = signed_area(polygon) < 0 ? -1.0 : 1.0;
    if (is_strictly_convex(polygon, turn))
        cut_in_rings(static_cast<std::uint32_t>(polygon.size()), triangles);
    else
        EarClipper(polygon, turn, triangles).clip();
}

} // namespace druse
