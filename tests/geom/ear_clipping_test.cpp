#include "geom/ear_clipping.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>

namespace druse {
namespace {

using Polygon = std::vector<Point2>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Triangles cut(const Polygon& polygon)
{
    Triangles triangles;
    clip_ears(polygon, triangles);
    return triangles;
}

double twice_area(const Point2& a, const Point2& b, const Point2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double area(const Polygon& p)
{
    double twice = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Point2 &a = p[i] - p[0], &b = p[(i + 1) % p.size()] - p[0];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

/// n − 2 triangles whose sides, but for pairs that run against each other, are the polygon's own.
void expect_same_boundary(const Polygon& polygon, const Triangles& triangles)
{
    ASSERT_EQ(triangles.size() + 2, polygon.size());
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    for (const auto& t : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t a = t[i], b = t[(i + 1) % 3];
            ASSERT_LT(a, polygon.size());
            ++sides[{a, b}];
            --sides[{b, a}];
        }
    const auto n = static_cast<std::uint32_t>(polygon.size());
    for (std::uint32_t i = 0; i < n; ++i) {
        --sides[{i, (i + 1) % n}];
        ++sides[{(i + 1) % n, i}];
    }
    for (const auto& [side, count] : sides) ASSERT_EQ(count, 0) << side.first << " to " << side.second;
}

/// Triangles of positive area that add up to the polygon's lie in it and not upon each other.
void expect_tiling(const Polygon& polygon, const Triangles& triangles)
{
    expect_same_boundary(polygon, triangles);
    double sum = 0;
    for (const auto& t : triangles) {
        const double twice = twice_area(polygon[t[0]], polygon[t[1]], polygon[t[2]]);
        ASSERT_GT(twice, 0) << t[0] << ' ' << t[1] << ' ' << t[2];
        sum += 0.5 * twice;
    }
    EXPECT_NEAR(sum / area(polygon), 1.0, 1e-9);
}

Polygon square_border(int side)
{
    Polygon p;
    for (int i = 0; i < side; ++i) p.emplace_back(i, 0);
    for (int i = 0; i < side; ++i) p.emplace_back(side, i);
    for (int i = 0; i < side; ++i) p.emplace_back(side - i, side);
    for (int i = 0; i < side; ++i) p.emplace_back(0, side - i);
    return p;
}

Polygon regular(int n)
{
    Polygon p;
    for (int i = 0; i < n; ++i) p.emplace_back(std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n));
    return p;
}

/// A ribbon that winds inward: `turns` times, `steps` corners a turn on either side.
Polygon spiral(int turns, int steps)
{
    Polygon p;
    const int n = turns * steps;
    const auto at = [&](double t, double offset) {
        const double r = 1.0 + t / steps + offset, a = 2 * M_PI * t / steps;
        return Point2(r * std::cos(a), r * std::sin(a));
    };
    for (int i = 0; i <= n; ++i) p.push_back(at(i, 0.5));
    for (int i = n; i >= 0; --i) p.push_back(at(i, 0.0));
    return p;
}

Polygon comb(int teeth)
{
    Polygon p{{0, 0}, {2.0 * teeth, 0}};
    for (int i = teeth - 1; i >= 0; --i) {
        p.emplace_back(2 * i + 2, 100);
        p.emplace_back(2 * i + 1, 100);
        p.emplace_back(2 * i + 1, 1);
        p.emplace_back(2 * i, 1);
    }
    p.pop_back();
    p.back() = {0, 1};
    p.insert(p.end() - 1, {1, 1});
    return p;
}

Polygon random_star(int n, unsigned seed)
{
    std::mt19937 random(seed);
    Polygon p;
    for (int i = 0; i < n; ++i) {
        const double r = 0.05 + double(random()) / 4294967296.0, a = 2 * M_PI * i / n;
        p.emplace_back(r * std::cos(a), r * std::sin(a));
    }
    return p;
}

TEST(EarClipping, GivesNothingForFewerThanThreeCorners)
{
    EXPECT_TRUE(cut({}).empty());
    EXPECT_TRUE(cut({{0, 0}, {1, 0}}).empty());
}

TEST(EarClipping, CutsConvexPolygonsOfEverySize)
{
    for (int n = 3; n <= 70; ++n) expect_tiling(regular(n), cut(regular(n)));
    expect_tiling(regular(4097), cut(regular(4097)));
}

TEST(EarClipping, CutsAnLShapeWithoutLeavingIt)
{
    const Polygon l{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    for (std::size_t start = 0; start < l.size(); ++start) {
        Polygon turned = l;
        std::rotate(turned.begin(), turned.begin() + std::ptrdiff_t(start), turned.end());
        expect_tiling(turned, cut(turned));
    }
}

TEST(EarClipping, PutsNoTriangleAlongAStraightSide)
{
    const Polygon triangle{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {2, 3}};
    expect_tiling(triangle, cut(triangle));
    for (const int side : {1, 2, 3, 10, 100}) expect_tiling(square_border(side), cut(square_border(side)));
}

TEST(EarClipping, CutsTheBorderOfALargeGrid)
{
    const Polygon border = square_border(4096); // 16384 corners, all but four of them straight
    expect_tiling(border, cut(border));
}

TEST(EarClipping, CutsCombsAndSpirals)
{
    for (const int teeth : {2, 3, 50, 5000}) expect_tiling(comb(teeth), cut(comb(teeth)));
    expect_tiling(spiral(2, 12), cut(spiral(2, 12)));
    expect_tiling(spiral(50, 400), cut(spiral(50, 400)));
}

TEST(EarClipping, CutsRandomSimplePolygons)
{
    for (unsigned seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Polygon star = random_star(5 + int(seed), seed);
        expect_tiling(star, cut(star));
    }
}

TEST(EarClipping, CutsAHundredThousandCorners)
{
    const Polygon star = random_star(100000, 1);
    expect_tiling(star, cut(star));
    expect_tiling(spiral(100, 500), cut(spiral(100, 500)));
}

TEST(EarClipping, RunsLikeAClockwisePolygon)
{
    Polygon l{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    std::reverse(l.begin(), l.end());
    double sum = 0;
    for (const auto& t : cut(l)) {
        EXPECT_LT(twice_area(l[t[0]], l[t[1]], l[t[2]]), 0);
        sum += 0.5 * twice_area(l[t[0]], l[t[1]], l[t[2]]);
    }
    EXPECT_DOUBLE_EQ(sum, -3);
}

TEST(EarClipping, GoesRoundAHoleReachedOverABridge)
{
    // A square frame: the outer ring, the bridge from its first corner, the hole clockwise, and the bridge back.
    const Polygon frame{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}};
    ASSERT_DOUBLE_EQ(area(frame), 8);
    expect_tiling(frame, cut(frame));
}

TEST(EarClipping, CutsTwoSquaresThatMeetInAPoint)
{
    const Polygon squares{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}};
    const Triangles triangles = cut(squares);
    expect_same_boundary(squares, triangles);
    int halves = 0;
    for (const auto& t : triangles) {
        const double twice = twice_area(squares[t[0]], squares[t[1]], squares[t[2]]);
        EXPECT_TRUE(twice == 0 || twice == 1) << twice; // half a square, or what joins the two in the point
        halves += twice == 1;
    }
    EXPECT_EQ(halves, 4);
}

TEST(EarClipping, KeepsTheBoundaryOfPolygonsThatAreNotSimple)
{
    const std::vector<Polygon> odd{
        {{0, 0}, {1, 1}, {1, 0}, {0, 1}},                          // crosses itself
        {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1.5, 0}},                // on a line
        {{1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}, {1, 1}},          // a point
        {{0, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 1}},  // corners twice
        {{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 9}, {2, 4}, {0, 4}},  // a spike
        {{0, 1e-300}, {1e-300, 0}, {2e-300, 1e-300}, {0, 2e-300}}, // areas below the least number
    };
    for (const Polygon& p : odd) expect_same_boundary(p, cut(p));

    for (unsigned seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        Polygon tangle;
        for (unsigned i = 0; i < 4 + seed; ++i) tangle.emplace_back(random() % 7, random() % 7);
        expect_same_boundary(tangle, cut(tangle));
    }
    std::mt19937 random(7);
    Polygon large;
    for (int i = 0; i < 20000; ++i) large.emplace_back(random() % 1000, random() % 1000);
    expect_same_boundary(large, cut(large));
}

TEST(EarClipping, GivesTheSameTrianglesEveryTime)
{
    const Polygon star = random_star(500, 3);
    EXPECT_EQ(cut(star), cut(star));
}

TEST(EarClipping, StaysExactFarFromTheOrigin)
{
    Polygon l{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    for (Point2& p : l) p += Point2(1e9, -1e9);
    expect_tiling(l, cut(l));
}

TEST(ClipEars, CutsNoSliverOffAtCornersThatAreStraightButForRounding)
{
    // Inner corners of the longest side are moved by some units in the last place, to either side.
    std::mt19937 random(3);
    for (int trial = 0; trial < 200; ++trial) {
        Polygon polygon;
        const int n = 3 + trial % 7;
        for (int i = 0; i <= n; ++i)
            polygon.emplace_back(i, 0.25 * i + (i > 0 && i < n ? (double(random() % 9) - 4) * 0x1p-52 : 0.0));
        polygon.emplace_back(n - 0.3, 5 + trial % 3);
        polygon.emplace_back(0.4, 5);
        const Triangles triangles = cut(polygon);
        expect_same_boundary(polygon, triangles);
        for (const auto& [a, b, c] : triangles) EXPECT_GT(twice_area(polygon[a], polygon[b], polygon[c]), 0.1) << trial;
    }
}

} // namespace
} // namespace druse
