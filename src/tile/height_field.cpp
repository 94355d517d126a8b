#include "tile/height_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace druse {

namespace {

using Corners = std::array<std::uint32_t, 3>;

double area_between(const Point2& a, const Point2& b) { return a.x * b.y - a.y * b.x; }

std::vector<FlatBox> boxes_of(const HeightField& field)
{
    std::vector<FlatBox> boxes;
    boxes.reserve(field.triangles.size());
    for (const Corners& t : field.triangles) {
        FlatBox& box = boxes.emplace_back();
        for (const std::uint32_t v : t) box.add(Point2(field.points[v]));
    }
    return boxes;
}

/// The height of one corner of each triangle: of two, that which `choose` hands back.
template <class F>
std::vector<double> corner_heights(const HeightField& field, F&& choose)
{
    std::vector<double> list;
    list.reserve(field.triangles.size());
    for (const Corners& t : field.triangles) list.push_back(choose(choose(field.points[t[0]].z, field.points[t[1]].z), field.points[t[2]].z));
    return list;
}

double height(const HeightField& field, const Corners& t, const std::array<double, 3>& share)
{
    return share[0] * field.points[t[0]].z + share[1] * field.points[t[1]].z + share[2] * field.points[t[2]].z;
}

/// A convex polygon of at most nine corners, with a height at each.
struct Clipped {
    std::array<Point, 9> corners{};
    int count = 0;

    void add(const Point& p) { corners[static_cast<std::size_t>(count++)] = p; }
};

/// The part of it to the left of a line.
Clipped left_of(const Clipped& whole, const Point2& from, const Point2& to)
{
    Clipped part;
    const auto side = [&](const Point& p) { return area_between(to - from, Point2(p) - from); };
    for (int i = 0; i < whole.count; ++i) {
        const Point &p = whole.corners[static_cast<std::size_t>(i)], &q = whole.corners[static_cast<std::size_t>(i + 1 == whole.count ? 0 : i + 1)];
        const double at_p = side(p), at_q = side(q);
        if (at_p >= 0) part.add(p);
        if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) part.add(p + at_p / (at_p - at_q) * (q - p));
    }
    return part;
}

} // namespace

std::array<double, 3> shares(const Point2& p, const Point2& a, const Point2& b, const Point2& c)
{
    const double whole = area_between(b - a, c - a);
    if (whole > 0) return {area_between(b - p, c - p) / whole, area_between(c - p, a - p) / whole, area_between(a - p, b - p) / whole};
    const std::array<Point2, 3> corners{a, b, c};
    std::size_t from = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (glm::length(corners[(i + 1) % 3] - corners[i]) > glm::length(corners[(from + 1) % 3] - corners[from])) from = i;
    const Point2 along = corners[(from + 1) % 3] - corners[from];
    const double square = glm::dot(along, along);
    const double t = square > 0 ? std::clamp(glm::dot(p - corners[from], along) / square, 0.0, 1.0) : 0.0;
    std::array<double, 3> result{};
    result[from] = 1.0 - t;
    result[(from + 1) % 3] = t;
    return result;
}

HeightFinder::HeightFinder(const HeightField& field) : field_(field), grid_(boxes_of(field)) {}

double HeightFinder::at(const Point2& p) const
{
    // Of the triangles about p that in which it lies deepest: rounding may leave it a little outside of all.
    double best = -std::numeric_limits<double>::infinity(), found = 0;
    const FlatBox& all = grid_.bounds();
    const double reach = std::max(1e-9 * std::max(all.max.x - all.min.x, all.max.y - all.min.y), 1e-300);
    const auto look = [&](std::uint32_t i) {
        const Corners& t = field_.triangles[i];
        std::array<double, 3> share = shares(p, Point2(field_.points[t[0]]), Point2(field_.points[t[1]]), Point2(field_.points[t[2]]));
        const double depth = std::min({share[0], share[1], share[2]});
        if (depth <= best) return;
        best = depth;
        double sum = 0;
        for (double& s : share) sum += s = std::clamp(s, 0.0, 1.0);
        for (double& s : share) s /= sum;
        found = height(field_, t, share);
    };
    for (double wide = reach; best == -std::numeric_limits<double>::infinity(); wide *= 16) grid_.for_each(FlatBox{p, p}.grown(wide), look);
    return found;
}

Thinnest thinnest(const HeightField& top, const HeightField& bottom)
{
    Thinnest result{std::numeric_limits<double>::infinity(), Point2(0.0)};
    if (top.triangles.empty() || bottom.triangles.empty()) return result;
    const std::vector<FlatBox> over = boxes_of(top), beneath = boxes_of(bottom);
    const FlatGrid under(beneath);
    const std::vector<double> low = corner_heights(top, [](double a, double b) { return std::min(a, b); });
    const std::vector<double> high = corner_heights(bottom, [](double a, double b) { return std::max(a, b); });
    const auto look = [&](std::size_t i) {
        const Corners& t = top.triangles[i];
        under.for_each(over[i], [&](std::uint32_t k) {
            if (low[i] - high[k] >= result.thickness) return; // they cannot come nearer
            const Corners& s = bottom.triangles[k];
            const Point2 a(bottom.points[s[0]]), b(bottom.points[s[1]]), c(bottom.points[s[2]]);
            Clipped common;
            for (const std::uint32_t v : t) common.add(top.points[v]);
            common = left_of(left_of(left_of(common, a, b), b, c), c, a);
            for (int n = 0; n < common.count; ++n) {
                const Point& p = common.corners[static_cast<std::size_t>(n)];
                std::array<double, 3> share = shares(Point2(p), a, b, c);
                for (double& x : share) x = std::clamp(x, 0.0, 1.0);
                const double thickness = p.z - height(bottom, s, share) / (share[0] + share[1] + share[2]);
                if (thickness < result.thickness) result = {thickness, Point2(p)};
            }
        });
    };
    // Below where the top is lowest and above where the bottom is highest it is thin already, so that most of the others need no look.
    const auto highest = static_cast<std::size_t>(std::ranges::max_element(high) - high.begin());
    look(static_cast<std::size_t>(std::ranges::min_element(low) - low.begin()));
    for (std::size_t i = 0; i < low.size(); ++i)
        if (over[i].meets(beneath[highest])) look(i);
    for (std::size_t i = 0; i < low.size(); ++i)
        if (low[i] - high[highest] < result.thickness) look(i);
    return result;
}

} // namespace druse
