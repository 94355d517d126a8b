// Refinement and spreading: angles, what is kept, and the way back.
#include "pane_support.h"

#include <cmath>
#include <numbers>

namespace druse {
namespace {

Pane with_points(std::size_t count)
{
    Pane pane(std::vector<Point2>{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}, {0.0, {}});
    std::mt19937 random(12);
    for (std::size_t i = 0; i < count; ++i) pane.add({0.5 + double(random() % 9000) / 1000, 0.5 + double(random() % 9000) / 1000});
    return pane;
}

double largest_area(const Pane& pane)
{
    double most = 0;
    pane.for_triangles([&](PointId a, PointId b, PointId c) {
        const Point2 u = pane.position(b) - pane.position(a), w = pane.position(c) - pane.position(a);
        most = std::max(most, (u.x * w.y - u.y * w.x) / 2);
    });
    return most;
}

TEST(PaneRefine, MakesEveryAngleLargeWhereLinesMeetSquarely)
{
    for (const double angle : {15.0, 20.0, 25.0}) {
        Pane pane = with_points(30);
        pane.constrain_line(std::array{Point2(2, 2), Point2(8, 2), Point2(8, 8)});
        const auto before = triangles(pane);
        const auto ids = pane.points();
        const auto refined = pane.refine({angle, {}, true});
        EXPECT_TRUE(refined.complete);
        EXPECT_EQ(refined.falling_short, 0u);
        EXPECT_GT(refined.made, 0u);
        EXPECT_GE(check(pane).smallest_angle, angle - 1e-9);
        EXPECT_EQ(pane.point_count(), ids.size() + refined.made);
        expect_sound(pane);
        pane.unrefine();
        EXPECT_EQ(pane.points(), ids);
        EXPECT_EQ(triangles(pane), before);
        expect_sound(pane);
    }
}

TEST(PaneRefine, KeepsTheBoundaryUnlessItIsToldOtherwise)
{
    Pane pane = with_points(30);
    pane.add({5, 0.01}); // a thin triangle at the boundary
    const auto kept = pane.refine();
    EXPECT_EQ(pane.boundary_count(), 4u);
    EXPECT_GT(kept.falling_short, 0u);
    EXPECT_TRUE(kept.complete);
    expect_sound(pane);
    const auto split = pane.refine({20, {}, true});
    EXPECT_GT(pane.boundary_count(), 4u);
    EXPECT_EQ(split.falling_short, 0u);
    expect_sound(pane);
}

TEST(PaneRefine, EndsAtSharpCorners)
{
    for (const double degrees : {2.0, 10.0, 35.0}) {
        const double turn = degrees * std::numbers::pi / 180;
        Pane pane(std::vector<Point2>{{0, 0}, {10, 0}, {10, 10 * std::tan(turn)}}, {}, {0.0, {}});
        const auto refined = pane.refine({20, {}, true});
        EXPECT_TRUE(refined.complete) << degrees;
        expect_sound(pane);
        Pane star = with_points(0);
        for (int i = 0; i < 7; ++i) star.constrain_line(std::array{Point2(5, 5), Point2(5 + 4 * std::cos(i * turn), 5 + 4 * std::sin(i * turn))});
        EXPECT_TRUE(star.refine({20, {}, true}).complete) << degrees;
        expect_sound(star);
    }
}

TEST(PaneRefine, MakesTrianglesNoLargerThanAskedFor)
{
    Pane pane = with_points(0);
    const auto refined = pane.refine({20, 0.5, true});
    EXPECT_TRUE(refined.complete);
    EXPECT_EQ(refined.falling_short, 0u);
    EXPECT_LE(largest_area(pane), 0.5 + 1e-12);
    expect_sound(pane);
}

TEST(PaneRefine, StopsAtFiftyNewPointsForEachOldOneWhereItMightNotEnd)
{
    Pane star = with_points(0);
    for (int i = 0; i < 7; ++i) star.constrain_line(std::array{Point2(5, 5), Point2(5 + 4 * std::cos(i * 0.03), 5 + 4 * std::sin(i * 0.03))});
    const auto refined = star.refine({30, {}, true});
    EXPECT_FALSE(refined.complete);
    EXPECT_GT(refined.falling_short, 0u);
    EXPECT_EQ(refined.too_large, 0u);
    EXPECT_LE(refined.made, 50 * 12u + 2); // of the corners and the star's points
    expect_sound(star);
}

// A square of side s has its angles, so the rectangle takes about as many of them as it is longer than wide.
TEST(PaneRefine, EndsInRectanglesHoweverLong)
{
    for (const double width : {0.1, 0.01, 0.001}) {
        Pane pane(std::vector<Point2>{{0, 0}, {10, 0}, {10, width}, {0, width}}, {}, {0.0, {}});
        const auto refined = pane.refine({20, {}, true});
        EXPECT_TRUE(refined.complete);
        EXPECT_EQ(refined.falling_short, 0u);
        EXPECT_GT(refined.made, 5 / width);
        EXPECT_LT(refined.made, 80 / width);
        expect_sound(pane);
    }
}

// Behind each line are fans of as many triangles, which a boundary that is kept does not let become better.
TEST(PaneRefine, EndsBetweenLinesHoweverNear)
{
    for (const bool split : {false, true}) {
        Pane pane = with_points(0);
        for (const double y : {5.0, 5.001}) pane.constrain_line(std::array{Point2(1, y), Point2(9, y)});
        const auto refined = pane.refine({20, {}, split});
        EXPECT_TRUE(refined.complete);
        EXPECT_EQ(refined.falling_short == 0, split);
        EXPECT_GT(refined.made, 2 * 8 / 0.003); // pieces that are no longer than three times their distance
        EXPECT_LT(refined.made, 4 * 8 / 0.001);
        expect_sound(pane);
    }
}

TEST(PaneRefine, StopsAtTheMostPointsThatItMayMake)
{
    Pane pane(std::vector<Point2>{{0, 0}, {10, 0}, {10, 1e-5}, {0, 1e-5}}, {}, {0.0, {}});
    const auto refined = pane.refine({20, {}, true});
    EXPECT_FALSE(refined.complete);
    EXPECT_EQ(refined.made, Pane::most_refined);
    EXPECT_GT(refined.falling_short, 0u);
    EXPECT_EQ(pane.point_count(), 4 + refined.made);
}

// Of the square of 100, T triangles of at most A each: T ≥ 100 / A, and 2 I + 4 − 2 of I points inside.
TEST(PaneRefine, MeetsAreasWhereTheBoundaryIsKept)
{
    for (const double angle : {0.0, 20.0})
        for (const double most : {5.0, 1.0, 0.1, 0.02}) {
            Pane pane = with_points(0);
            const auto refined = pane.refine({angle, most, false});
            EXPECT_TRUE(refined.complete);
            EXPECT_EQ(refined.too_large, 0u);
            EXPECT_EQ(pane.boundary_count(), 4u);
            EXPECT_EQ(pane.triangle_count(), 2 * refined.made + 2);
            EXPECT_GE(double(refined.made), (100 / most - 2) / 2);
            EXPECT_LE(double(refined.made), 100 / most + 4); // half of the area allowed, on average, is no waste
            EXPECT_LE(largest_area(pane), most + 1e-12);
            expect_sound(pane);
        }
}

TEST(PaneRefine, MeetsAreasInNarrowPanesAndAroundHoles)
{
    const std::vector<std::vector<Point2>> hole{{{4, 4}, {4, 6}, {6, 6}, {6, 4}}};
    for (Pane pane : {Pane(rectangle(10, 0.1), {}, {0.0, {}}), Pane(std::vector<Point2>{{0, 0}, {10, 0}, {10, 1}}, {}, {0.0, {}}), Pane(rectangle(10, 10), hole, {0.0, {}})}) {
        const std::size_t boundary = pane.boundary_count();
        EXPECT_EQ(pane.refine({20, 0.05, false}).too_large, 0u);
        EXPECT_EQ(pane.boundary_count(), boundary);
        EXPECT_LE(largest_area(pane), 0.05 + 1e-12);
        expect_sound(pane);
    }
}

// On a side of 10, an area of 0.1 leaves a height of 0.02: less than a weld of 0.05 keeps points apart from lines.
TEST(PaneRefine, LeavesTrianglesLargerWhereTheirPointsWouldBeTooNear)
{
    Pane pane(rectangle(10, 10), {}, {0.0, 0.05});
    const auto refined = pane.refine({0, 0.1, false});
    EXPECT_TRUE(refined.complete);
    EXPECT_GE(refined.too_large, 4u); // on each side
    EXPECT_LE(refined.too_large, 100u);
    EXPECT_EQ(refined.falling_short, refined.too_large);
    EXPECT_GT(largest_area(pane), 0.1);
    EXPECT_LE(largest_area(pane), 10 * 0.6 / 2); // nothing is left that has room for three points, one above the other
    expect_sound(pane);
}

TEST(PaneRefine, RefusesAreasThatTakeMoreThanAMillionPoints)
{
    Pane pane = with_points(0);
    expect_refused(pane, Reason::range, [&] { pane.refine({20, 100 / 2'000'010.0, false}); });
    expect_refused(pane, Reason::range, [&] { pane.refine({20, 1e-300, true}); });
}

TEST(PaneRefine, HearsCancel)
{
    Pane pane = with_points(30);
    const auto before = pane.fingerprint();
    Progress progress;
    progress.cancel();
    EXPECT_THROW(pane.refine({20, 0.1, false}, &progress), Cancelled);
    EXPECT_EQ(pane.fingerprint(), before);
    expect_sound(pane);
}

TEST(PaneRefine, SplitsTwinsTogether)
{
    Pane pane(rectangle(10, 3), {}, {0.0, {}});
    const Isometry up{{1, 0}, {0, 1}, {0, 3}}, down{{1, 0}, {0, 1}, {0, -3}};
    for (const auto& [a, b] : {std::pair{0u, 3u}, {1u, 2u}}) {
        pane.add_twin(PointId(a), PointId(b), up);
        pane.add_twin(PointId(b), PointId(a), down);
    }
    pane.add({5, 0.4});
    pane.refine({20, {}, true});
    std::vector<double> low, high;
    for (const PointId p : pane.loop(0)) {
        if (pane.position(p).y == 0) low.push_back(pane.position(p).x);
        if (pane.position(p).y == 3) high.push_back(pane.position(p).x);
    }
    std::sort(low.begin(), low.end());
    std::sort(high.begin(), high.end());
    EXPECT_GT(low.size(), 2u);
    EXPECT_EQ(low, high);
    expect_sound(pane);
}

TEST(PaneRefine, RefusesAnglesThatCannotBePromised)
{
    Pane pane = with_points(5);
    expect_refused(pane, Reason::angle_too_large, [&] { pane.refine({30.5, {}, false}); });
    expect_refused(pane, Reason::range, [&] { pane.refine({20, 0.0, false}); });
    expect_refused(pane, Reason::range, [&] { pane.spread(0); });
}

TEST(PaneSpread, MovesFreePointsApart)
{
    Pane pane = with_points(100);
    const PointId locked = pane.add({1, 1}), held = pane.add({9, 1});
    pane.lock(std::array{locked});
    pane.constrain(held, PointId(1));
    const double before = check(pane).smallest_angle;
    pane.spread(20);
    EXPECT_GT(check(pane).smallest_angle, before);
    EXPECT_EQ(pane.position(locked), Point2(1, 1));
    EXPECT_EQ(pane.position(held), Point2(9, 1));
    expect_sound(pane);
}

} // namespace
} // namespace druse
