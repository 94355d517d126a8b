#include "graph/weld.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace druse {
namespace {

using Firsts = std::vector<std::uint32_t>;

Firsts weld(const std::vector<Point>& points, double reach)
{
    Progress progress;
    return first_within_reach(points, reach, progress);
}

/// Each point against each.
Firsts weld_slowly(const std::vector<Point>& points, double reach)
{
    Firsts first(points.size());
    std::iota(first.begin(), first.end(), 0u);
    for (bool changed = true; changed;) {
        changed = false;
        for (std::uint32_t i = 0; i < points.size(); ++i)
            for (std::uint32_t j = 0; j < i; ++j)
                if (first[i] != first[j] && glm::distance(points[i], points[j]) <= reach) {
                    first[i] = first[j] = std::min(first[i], first[j]);
                    changed = true;
                }
    }
    return first;
}

TEST(Weld, JoinsWhatComparingAllPointsJoins)
{
    std::mt19937 random(1);
    for (int turn = 0; turn < 60; ++turn) {
        std::vector<Point> points;
        const int dimensions = 1 + turn % 3;
        std::uniform_real_distribution<double> at(-1, 1);
        for (int i = 0; i < 150; ++i) {
            Point p(0.0);
            for (int k = 0; k < dimensions; ++k) p[k] = turn % 2 == 0 ? at(random) : std::round(6 * at(random)) / 6; // on a grid many are equal, and none just as far apart as a reach
            points.push_back(p);
        }
        for (const double reach : {0.0, 0.01, 0.1, 0.17, 0.55}) EXPECT_EQ(weld(points, reach), weld_slowly(points, reach)) << "turn " << turn << " reach " << reach;
    }
}

TEST(Weld, TellsSizesApartWhateverTheyAre)
{
    EXPECT_EQ(weld({}, 0), Firsts{});
    EXPECT_EQ(weld({{0, 0, 0}, {-0.0, 0, 0}, {1e-300, 0, 0}}, 0), (Firsts{0, 0, 2}));
    EXPECT_EQ(weld({{0, 0, 0}, {1e-300, 0, 0}, {3e-300, 0, 0}}, 1e-300), (Firsts{0, 0, 2}));
    EXPECT_EQ(weld({{-1e38, 0, 0}, {1e38, 0, 0}, {0, 0, 0}}, 1e38), (Firsts{0, 0, 0}));
}

TEST(Weld, TakesCrowdsAsQuicklyAsOthers)
{
    // Pairs without number: comparing them would take hours. Two places; a ball within reach; and two beyond it.
    std::mt19937 random(2);
    std::uniform_real_distribution<double> at(0, 1);
    std::vector<Point> places, balls;
    for (int i = 0; i < 300'000; ++i) {
        places.push_back(Point(i % 2));
        balls.push_back(Point(at(random), at(random), at(random) + (i % 2 == 0 ? 0 : 1.2)));
    }
    const Firsts exact = weld(places, 0), wide = weld(balls, 5), apart = weld(balls, 0.19);
    EXPECT_EQ(std::count(exact.begin(), exact.end(), 0u), 150'000);
    EXPECT_EQ(std::count(exact.begin(), exact.end(), 1u), 150'000);
    EXPECT_EQ(std::count(wide.begin(), wide.end(), 0u), 300'000);
    EXPECT_EQ(std::count(apart.begin(), apart.end(), 0u), 150'000);
    EXPECT_EQ(std::count(apart.begin(), apart.end(), 1u), 150'000);
}

TEST(Weld, CanBeCancelled)
{
    Progress progress;
    progress.cancel();
    std::vector<Point> points;
    for (int i = 0; i < 20'000; ++i) points.emplace_back(i, 0, 0);
    EXPECT_THROW(first_within_reach(points, 0.5, progress), Cancelled);
}

} // namespace
} // namespace druse
