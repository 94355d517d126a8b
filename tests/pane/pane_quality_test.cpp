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
        EXPECT_EQ(star.refine({20, {}, true}).complete, degrees > 5); // two degrees take more points than fifty for each
        expect_sound(star);
    }
}

TEST(PaneRefine, MakesTrianglesNoLargerThanAskedFor)
{
    Pane pane = with_points(0);
    const auto refined = pane.refine({20, 0.5, true});
    EXPECT_TRUE(refined.complete);
    EXPECT_EQ(refined.falling_short, 0u);
    pane.for_triangles([&](PointId a, PointId b, PointId c) {
        const Point2 u = pane.position(b) - pane.position(a), w = pane.position(c) - pane.position(a);
        EXPECT_LE((u.x * w.y - u.y * w.x) / 2, 0.5 + 1e-12);
    });
    expect_sound(pane);
}

TEST(PaneRefine, StopsAtFiftyNewPointsForEachOldOne)
{
    Pane pane = with_points(0);
    const auto refined = pane.refine({20, 1e-3, true});
    EXPECT_FALSE(refined.complete);
    EXPECT_LE(refined.made, 202u);
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
