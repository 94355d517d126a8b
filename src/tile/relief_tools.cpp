#include "tile/relief_tools.h"

#include "geom/segments.h"

#include <algorithm>
#include <cmath>

namespace druse {

namespace {

/// From 0 at the foot to 1 at the crest, for how far in between.
double risen(double t, ReliefProfile profile)
{
    t = std::clamp(t, 0.0, 1.0);
    return profile == ReliefProfile::straight ? t : std::sqrt(t * (2.0 - t)); // a quarter of an ellipse
}

/// Points of the outline have the places of their whole orbit: those are one place of the layer, seen from several tiles.
class Places {
public:
    explicit Places(const LayeredTile& tile) : tile_(tile), members_(static_cast<std::size_t>(tile.outline().orbits))
    {
        for (int i = 0; i < tile.outline_count(); ++i) members_[orbit(i)].push_back(tile.position(i));
    }

    template <class F>
    void for_each(int point, F&& f) const
    {
        if (point >= tile_.outline_count()) f(tile_.position(point));
        else
            for (const Point2& p : members_[orbit(point)]) f(p);
    }

private:
    std::size_t orbit(int i) const { return static_cast<std::size_t>(tile_.outline().points[static_cast<std::size_t>(i)].orbit); }

    const LayeredTile& tile_;
    std::vector<std::vector<Point2>> members_;
};

} // namespace

std::vector<double> smoothed_heights(const LayeredTile& tile, std::span<const int> points, double amount, int times)
{
    // Of each orbit and of each point inside: one height, and what is around it on all tiles.
    const std::size_t orbits = static_cast<std::size_t>(tile.outline().orbits);
    const auto place = [&](std::size_t point) {
        const std::size_t rim = static_cast<std::size_t>(tile.outline_count());
        return point < rim ? static_cast<std::size_t>(tile.outline().points[point].orbit) : orbits + point - rim;
    };
    const std::size_t count = orbits + static_cast<std::size_t>(tile.point_count() - tile.outline_count());
    std::vector<double> height(count), sum(count), weight(count);
    std::vector<bool> moves(count);
    for (int i = 0; i < tile.point_count(); ++i) height[place(static_cast<std::size_t>(i))] = tile.height(i);
    for (const int i : points) moves[place(static_cast<std::size_t>(i))] = true;
    for (int round = 0; round < times; ++round) {
        std::ranges::fill(sum, 0.0);
        std::ranges::fill(weight, 0.0);
        for (const auto& t : tile.surface().triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t at = place(t[k]);
                sum[at] += height[place(t[(k + 1) % 3])] + height[place(t[(k + 2) % 3])];
                weight[at] += 2;
            }
        for (std::size_t i = 0; i < count; ++i)
            if (moves[i]) height[i] += amount * (sum[i] / weight[i] - height[i]);
    }
    std::vector<double> result;
    for (const int i : points) result.push_back(height[place(static_cast<std::size_t>(i))]);
    return result;
}

std::vector<double> ridged_heights(const LayeredTile& tile, std::span<const int> points, std::span<const Point2> chain, double height, double width, ReliefProfile profile)
{
    const Places places(tile);
    std::vector<double> result;
    for (const int i : points) {
        double nearest = width;
        places.for_each(i, [&](const Point2& p) {
            for (std::size_t k = 1; k < chain.size(); ++k)
                nearest = std::min(nearest, distance_to_segment(Point(p, 0.0), Point(chain[k - 1], 0.0), Point(chain[k], 0.0)));
        });
        result.push_back(tile.height(i) + height * risen(1.0 - nearest / width, profile));
    }
    return result;
}

std::vector<double> domed_heights(const LayeredTile& tile, std::span<const int> points, double height, std::optional<double> width, ReliefProfile profile)
{
    const std::vector<Point2> outline = tile.outline().positions();
    std::vector<double> inside;
    for (const int i : points) inside.push_back(i < tile.outline_count() ? 0.0 : nearest_side(outline, tile.position(i)).distance);
    const double reach = width ? *width : inside.empty() ? 0.0 : std::ranges::max(inside);
    std::vector<double> result;
    for (std::size_t k = 0; k < points.size(); ++k)
        result.push_back(tile.height(points[k]) + (reach > 0 ? height * risen(inside[k] / reach, profile) : 0.0));
    return result;
}

std::vector<double> mapped_heights(const LayeredTile& tile, std::span<const int> points, const std::function<double(const Point2&)>& height_at)
{
    FlatBox box;
    for (const OutlinePoint& p : tile.outline().points) box.add(p.position);
    const Places places(tile);
    std::vector<double> result;
    for (const int i : points) {
        double sum = 0, count = 0;
        places.for_each(i, [&](const Point2& p) {
            sum += height_at((p - box.min) / (box.max - box.min));
            ++count;
        });
        result.push_back(sum / count);
    }
    return result;
}

} // namespace druse
