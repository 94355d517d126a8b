#include "geom/convex_hull.h"

#include "geom/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace druse {
namespace {

using Facet = ConvexHull::Facet;

std::vector<Facet> live(const ConvexHull& hull)
{
    std::vector<Facet> list;
    for (const Facet& f : hull.facets())
        if (f.corner[0] != ConvexHull::none) list.push_back(f);
    return list;
}

/// Closed, with the neighbours that it says, Euler's formula, no facet without area, and no point above any facet: by exact signs.
void expect_hull(const ConvexHull& hull, std::span<const Point> points)
{
    const std::vector<Facet> facets = live(hull);
    std::set<std::uint32_t> corners;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const Facet& f : facets) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = f.corner[k], b = f.corner[(k + 1) % 3];
            corners.insert(a);
            ++sides[{a, b}];
            const Facet& other = hull.facets()[f.neighbour[k]];
            bool back = false;
            for (std::size_t j = 0; j < 3; ++j) back = back || (other.corner[j] == b && other.corner[(j + 1) % 3] == a);
            EXPECT_TRUE(back);
        }
        bool solid = false;
        for (const Point& p : points) {
            const int side = orient(hull.point(f.corner[0]), hull.point(f.corner[1]), hull.point(f.corner[2]), p);
            EXPECT_LE(side, 0);
            solid = solid || side < 0;
        }
        EXPECT_TRUE(solid);
    }
    for (const auto& [side, count] : sides) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(sides.count({side.second, side.first}), 1u);
    }
    EXPECT_EQ(facets.size(), 2 * corners.size() - 4);
}

double volume(const ConvexHull& hull)
{
    double six = 0;
    for (const Facet& f : live(hull)) six += glm::dot(hull.point(f.corner[0]), glm::cross(hull.point(f.corner[1]), hull.point(f.corner[2])));
    return six / 6;
}

TEST(ConvexHull, OfACubeWithPointsInItsFacesAndInsideIsTheCube)
{
    std::vector<Point> points;
    for (int x = 0; x <= 4; ++x)
        for (int y = 0; y <= 4; ++y)
            for (int z = 0; z <= 4; ++z) points.emplace_back(x, y, z);
    std::mt19937 random(1);
    ConvexHull hull;
    for (int i = 0; i < 20; ++i) {
        std::shuffle(points.begin(), points.end(), random);
        ASSERT_TRUE(hull.build(points));
        expect_hull(hull, points);
        EXPECT_DOUBLE_EQ(volume(hull), 64);
    }
}

TEST(ConvexHull, HoldsAllPointsOfASphereAndNoneFromWithin)
{
    std::mt19937 random(2);
    std::normal_distribution<double> at;
    std::vector<Point> points;
    for (int i = 0; i < 300; ++i) {
        const Vector d = unit(Vector(at(random), at(random), at(random)));
        points.push_back(d);
        points.push_back(0.5 * d);
    }
    ConvexHull hull;
    ASSERT_TRUE(hull.build(points));
    expect_hull(hull, points);
    EXPECT_EQ(live(hull).size(), 2u * 300 - 4);
}

TEST(ConvexHull, IsExactWherePointsAreInAPlaneButForRounding)
{
    // Rings of corners on a prism, turned so that none of its planes survives in doubles.
    std::mt19937 random(3);
    std::uniform_real_distribution<double> angle(0, 6);
    ConvexHull hull;
    for (int i = 0; i < 50; ++i) {
        const Vector z = unit(Vector(std::cos(angle(random)), std::sin(angle(random)), 0.3)), x = unit(glm::cross(z, Vector(0, 0, 1))), y = glm::cross(z, x);
        std::vector<Point> points;
        for (int k = 0; k < 12; ++k)
            for (const double height : {-1.0, 0.0, 1.0}) points.push_back(1000.0 * x + std::cos(k * 0.5235987755982988) * x + std::sin(k * 0.5235987755982988) * y + height * z);
        ASSERT_TRUE(hull.build(points));
        expect_hull(hull, points);
        EXPECT_NEAR(volume(hull), 2 * 3, 1e-6); // 12 triangles of area 1/4, 2 high
    }
}

TEST(ConvexHull, TakesOnePointMoreIfItLiesOutside)
{
    const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    ConvexHull hull;
    ASSERT_TRUE(hull.build(points));
    EXPECT_FALSE(hull.add({0.1, 0.1, 0.1}));
    EXPECT_FALSE(hull.add({0.25, 0.25, 0}));
    EXPECT_EQ(live(hull).size(), 4u);
    ASSERT_TRUE(hull.add({1, 1, 1}));
    EXPECT_NEAR(volume(hull), 0.5, 1e-15); // 1/6 below the plane x + y + z = 1, and twice as much above
    EXPECT_EQ(live(hull).size(), 6u);
}

TEST(ConvexHull, NeedsPointsThatSpanASolid)
{
    ConvexHull hull;
    EXPECT_FALSE(hull.build({}));
    EXPECT_FALSE(hull.build(std::vector<Point>(9, Point(1, 2, 3))));
    EXPECT_FALSE(hull.build(std::vector<Point>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}, {3, 3, 3}}));
    EXPECT_FALSE(hull.build(std::vector<Point>{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {1, 1, 1}, {2, 2, -1}}));
    EXPECT_TRUE(hull.build(std::vector<Point>{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}, {1, 1, 1}, {1, 1, std::nextafter(1, 2)}}));
}

} // namespace
} // namespace druse
