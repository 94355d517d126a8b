// Triangulations that are known: counts, ties, crossings, and lines over what is there.
#include "pane_support.h"

#include <cmath>
#include <numbers>

namespace druse {
namespace {

const Pane::Settings exactly{0.0, {}};

Pane square(double size) { return Pane(rectangle(size, size), {}, exactly); }

std::vector<Point2> random_places(std::size_t count, double size, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(0.001 * size, 0.999 * size);
    std::vector<Point2> places(count);
    for (Point2& p : places) p = {number(random), number(random)};
    return places;
}

TEST(PaneCounts, FollowEulersFormulaForPointsInASquare)
{
    for (const auto& [count, triangles, edges] : {std::array<std::size_t, 3>{100, 202, 305}, {1000, 2002, 3005}}) {
        Pane one_by_one = square(10), at_once = square(10);
        for (const Point2& p : random_places(count, 10, 1)) one_by_one.add(p);
        at_once.add_all(random_places(count, 10, 1));
        for (const Pane* pane : {&one_by_one, &at_once}) {
            const PaneCheck found = check(*pane);
            EXPECT_EQ(found.faults, std::vector<std::string>());
            EXPECT_EQ(found.triangles, triangles);
            EXPECT_EQ(found.edges, edges);
        }
        EXPECT_EQ(druse::triangles(one_by_one), druse::triangles(at_once));
    }
}

TEST(PaneTies, CutEveryCellOfAGridAtItsLowerLeftCorner)
{
    std::vector<Point2> loop, inner;
    for (int i = 0; i < 10; ++i) loop.emplace_back(i, 0);
    for (int i = 0; i < 10; ++i) loop.emplace_back(10, i);
    for (int i = 0; i < 10; ++i) loop.emplace_back(10 - i, 10);
    for (int i = 0; i < 10; ++i) loop.emplace_back(0, 10 - i);
    Pane pane(loop, {}, exactly);
    std::mt19937 random(3);
    for (int y = 1; y < 10; ++y)
        for (int x = 1; x < 10; ++x) inner.emplace_back(x, y);
    std::shuffle(inner.begin(), inner.end(), random);
    for (const Point2& p : inner) pane.add(p);
    const PaneCheck found = check(pane);
    EXPECT_EQ(found.faults, std::vector<std::string>());
    EXPECT_EQ(found.boundary_points, 40u);
    EXPECT_EQ(found.points, 121u);
    EXPECT_EQ(found.triangles, 200u);
    EXPECT_EQ(found.edges, 320u);
    const auto at = [&](int x, int y) { return std::uint32_t(pane.add(Point2(x, y))); };
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x) EXPECT_TRUE(has_edge(pane, at(x, y), at(x + 1, y + 1))) << x << ' ' << y;
}

TEST(PaneTies, MakeAFanOfManyPointsOnOneCircle)
{
    // 1 185 665 = 5·13·17·29·37 is the hypotenuse of whole-numbered triangles in many ways: 972 points of the circle are whole.
    constexpr std::int64_t R = 1185665;
    std::vector<Point2> circle;
    for (std::int64_t x = -R; x <= R; ++x) {
        const auto y2 = R * R - x * x;
        const auto y = static_cast<std::int64_t>(std::llround(std::sqrt(double(y2))));
        if (y * y != y2) continue;
        circle.emplace_back(double(x), double(y));
        if (y != 0) circle.emplace_back(double(x), double(-y));
    }
    ASSERT_EQ(circle.size(), 972u);
    std::sort(circle.begin(), circle.end(), [](const Point2& p, const Point2& q) { return std::atan2(p.y, p.x) < std::atan2(q.y, q.x); });
    Pane pane(circle, {}, exactly);
    expect_sound(pane);
    const auto first = std::uint32_t(pane.add(Point2(double(-R), 0)));
    std::size_t fan = 0;
    for (const IdTriangle& t : triangles(pane)) fan += t[0] == first || t[1] == first || t[2] == first;
    EXPECT_EQ(fan, 970u);
}

TEST(PaneTies, KeepTheDiagonalAtTheFirstPointUnlessASegmentSaysOtherwise)
{
    // (0,0) (4,0) (5,1) (1,1) are not on one circle, but 1–3 is the shorter diagonal.
    Pane pane(std::vector<Point2>{{0, 0}, {4, 0}, {5, 1}, {1, 1}}, {}, exactly);
    EXPECT_TRUE(has_edge(pane, 1, 3));
    EXPECT_FALSE(has_edge(pane, 0, 2));
    const SegmentId segment = pane.constrain(PointId(0), PointId(2));
    EXPECT_TRUE(has_edge(pane, 0, 2));
    expect_sound(pane);
    pane.unconstrain(segment);
    EXPECT_TRUE(has_edge(pane, 1, 3));
}

TEST(Pane, IsItsLoopAgainWhenAllInnerPointsAreRemoved)
{
    Pane pane(std::vector<Point2>{{0, 0}, {10, 0}, {10, 4}, {6, 5}, {10, 7}, {9, 10}, {0, 10}, {3, 5}}, {}, exactly);
    const auto before = triangles(pane);
    std::vector<PointId> made;
    for (const Point2& p : random_places(300, 10, 4)) {
        try {
            made.push_back(pane.add(p));
        } catch (const PaneRefusal&) {
        }
    }
    EXPECT_GT(made.size(), 150u);
    expect_sound(pane);
    std::mt19937 random(5);
    std::shuffle(made.begin(), made.end(), random);
    for (const PointId p : made) pane.remove(p);
    EXPECT_EQ(triangles(pane), before);
    expect_sound(pane);
}

// --- crossings ----------------------------------------------------------------------------------------------------------------------

TEST(PaneCrossings, LieOnBothSegmentsWhereNoDoubleDoes)
{
    Pane pane = square(10);
    const SegmentId a = pane.constrain_line(std::array{Point2(1, 1), Point2(4, 2)}), b = pane.constrain_line(std::array{Point2(1, 2), Point2(4, 1)});
    const auto first = pane.chain(a), second = pane.chain(b);
    ASSERT_EQ(first.size(), 3u);
    ASSERT_EQ(second.size(), 3u);
    EXPECT_EQ(first[1], second[1]);
    EXPECT_EQ(pane.kind(first[1]), PointKind::crossing);
    expect_sound(pane);
    Pane thirds = square(10); // the lines meet at (4/3, 4/3) and (7/3, …): thirds are not doubles
    thirds.constrain_line(std::array{Point2(1, 1), Point2(2, 2)});
    thirds.constrain_line(std::array{Point2(1, 2), Point2(3, 0.5)});
    thirds.constrain_line(std::array{Point2(1, 1.25), Point2(2, 1.5)});
    expect_sound(thirds);
    EXPECT_EQ(thirds.point_count(), 4u + 6u + 3u);
    pane.unconstrain(a);
    EXPECT_FALSE(pane.exists(first[1])); // nothing crosses there any more
    EXPECT_EQ(pane.chain(b).size(), 2u);
    expect_sound(pane);
}

TEST(PaneCrossings, OfThreeSegmentsThroughNearlyOnePointAreOneOrThree)
{
    for (const double off : {0.0, 1e-13, -1e-13, 1e-12, 1e-10, 3e-9}) {
        Pane pane = square(10);
        for (int i = 0; i < 3; ++i) {
            const double turn = i * std::numbers::pi / 3 + 0.1;
            const Point2 along(std::cos(turn), std::sin(turn)), across(-std::sin(turn), std::cos(turn)), middle = Point2(5, 5) + (i == 2 ? off : 0.0) * across;
            pane.constrain_line(std::array{middle - 3.0 * along, middle + 3.0 * along});
        }
        std::size_t crossings = 0;
        for (const PointId p : pane.points()) crossings += pane.kind(p) == PointKind::crossing;
        EXPECT_TRUE(crossings == 1 || crossings == 3) << off;
        expect_sound(pane);
    }
}

TEST(PaneCrossings, OfManyRandomSegmentsKeepEveryPieceAnEdge)
{
    Pane pane = square(1);
    std::mt19937 random(6);
    const auto places = random_places(80, 1, 7);
    for (std::size_t i = 0; i + 1 < places.size(); i += 2) pane.constrain_line(std::array{places[i], places[i + 1]});
    EXPECT_EQ(pane.segment_count(), 40u);
    expect_sound(pane);
    EXPECT_EQ(triangles(pane), triangles_built_anew(pane, random));
    for (const SegmentId s : pane.segments()) pane.unconstrain(s);
    EXPECT_EQ(pane.point_count(), 84u);
    expect_sound(pane);
}

// --- segments over what is there ----------------------------------------------------------------------------------------------------

TEST(PaneSegments, EndInTheMiddleOfOthersAndPassThem)
{
    Pane pane = square(10);
    const SegmentId across = pane.constrain_line(std::array{Point2(2, 5), Point2(8, 5)});
    const SegmentId up = pane.constrain_line(std::array{Point2(5, 5), Point2(5, 8)});
    EXPECT_EQ(pane.chain(across).size(), 3u);
    EXPECT_EQ(pane.chain(up).size(), 2u);
    EXPECT_EQ(pane.point_count(), 8u);
    expect_sound(pane);
}

TEST(PaneSegments, AreNotMadeTwice)
{
    Pane pane = square(10);
    const PointId p = pane.add({2, 2}), q = pane.add({8, 3});
    const SegmentId first = pane.constrain(p, q);
    const auto before = pane.fingerprint();
    EXPECT_EQ(pane.constrain(q, p), first);
    EXPECT_EQ(pane.report().notes.size(), 1u);
    EXPECT_EQ(pane.fingerprint(), before);
    pane.add({5, 2.5}); // exactly in the middle
    EXPECT_EQ(pane.chain(first).size(), 3u);
    EXPECT_EQ(pane.constrain(p, q), first);
    EXPECT_EQ(pane.segment_count(), 1u);
}

TEST(PaneSegments, PassThroughThePointsOnThem)
{
    Pane pane = square(10);
    std::vector<PointId> on_it;
    for (const int x : {7, 3, 5, 1, 9}) on_it.push_back(pane.add(Point2(x, x)));
    const SegmentId segment = pane.constrain(on_it[3], on_it[4]);
    EXPECT_EQ(pane.chain(segment), (std::vector<PointId>{on_it[3], on_it[1], on_it[2], on_it[0], on_it[4]}));
    EXPECT_EQ(pane.point_count(), 9u);
    const SegmentId part = pane.constrain(on_it[1], on_it[0]); // over a part of the other
    EXPECT_EQ(pane.chain(part).size(), 3u);
    pane.unconstrain(segment);
    expect_sound(pane);
    EXPECT_EQ(pane.segment_count(), 1u);
}

TEST(PaneSegments, PassThroughPointsWithinSnap)
{
    Pane pane(rectangle(10, 10), {}, {0.1, {}});
    const PointId from = pane.add({1, 5}), to = pane.add({9, 5}), near = pane.add({4, 5.09}), far = pane.add({6, 5.2});
    const SegmentId segment = pane.constrain(from, to);
    EXPECT_EQ(pane.chain(segment), (std::vector<PointId>{from, near, to}));
    EXPECT_TRUE(pane.exists(far));
    expect_sound(pane);
}

TEST(PaneSegments, RunAlongTheBoundary)
{
    Pane pane = square(10);
    const SegmentId segment = pane.constrain(PointId(0), PointId(1));
    pane.add({4, 0});
    EXPECT_EQ(pane.chain(segment).size(), 3u);
    EXPECT_EQ(pane.boundary_count(), 5u);
    expect_sound(pane);
    pane.move(PointId(4), {4, 1}); // the boundary bends, and the segment with it
    EXPECT_EQ(pane.chain(segment).size(), 3u);
    expect_sound(pane);
    pane.remove(PointId(4));
    EXPECT_EQ(pane.chain(segment).size(), 2u);
    expect_sound(pane);
}

// --- where numbers are large, small or shifted ----------------------------------------------------------------------------------------

TEST(Pane, HasTheSameEdgesShiftedAndScaled)
{
    const auto build = [](double scale, double shift) {
        std::vector<Point2> loop = rectangle(1024, 1024);
        for (Point2& p : loop) p = scale * (p + shift);
        Pane pane(loop, {}, exactly);
        std::mt19937 random(8);
        for (int i = 0; i < 150; ++i) { // sixteenths, so that shifting rounds nothing
            const double x = 1 + double(random() % 16000) / 16, y = 1 + double(random() % 16000) / 16;
            pane.add(scale * (Point2(x, y) + shift));
        }
        for (std::uint32_t i = 4; i < 34; i += 2) pane.constrain(PointId(i), PointId(i + 20));
        return pane;
    };
    const Pane plain = build(1, 0);
    expect_sound(plain);
    const auto expected = triangles(plain);
    for (const double scale : {0x1p200, 0x1p-200}) EXPECT_EQ(triangles(build(scale, 0)), expected);
    // Crossings round elsewhere after a shift, but their edges are the same.
    const Pane shifted = build(1, 0x1p40);
    expect_sound(shifted);
    EXPECT_EQ(shifted.point_count(), plain.point_count());
}

TEST(Pane, TakesManyPointsOnALineACircleAGridAndASpiral)
{
    constexpr int count = 5000;
    std::array<std::vector<Point2>, 4> shapes;
    for (int i = 0; i < count; ++i) {
        const double t = double(i) / count, turn = 2 * std::numbers::pi * t;
        shapes[0].emplace_back(0.1 + 0.8 * t, 0.5);
        shapes[1].emplace_back(0.5 + 0.4 * std::cos(turn), 0.5 + 0.4 * std::sin(turn));
        shapes[2].emplace_back(0.1 + 0.01 * (i % 71), 0.1 + 0.01 * (i / 71));
        shapes[3].emplace_back(0.5 + 0.4 * t * std::cos(50 * turn), 0.5 + 0.4 * t * std::sin(50 * turn));
    }
    for (const auto& shape : shapes) {
        Pane one_by_one = square(1), at_once = square(1);
        for (const Point2& p : shape) one_by_one.add(p);
        at_once.add_all(shape);
        EXPECT_EQ(check(one_by_one).faults, std::vector<std::string>());
        EXPECT_EQ(triangles(one_by_one), triangles(at_once));
    }
}

TEST(Pane, RemovesAHubOfManyTriangles)
{
    Pane pane = square(1);
    std::vector<Point2> circle;
    for (int i = 0; i < 2000; ++i) circle.emplace_back(0.5 + 0.4 * std::cos(i * std::numbers::pi / 1000), 0.5 + 0.4 * std::sin(i * std::numbers::pi / 1000));
    pane.add_all(circle);
    const auto before = triangles(pane);
    const PointId hub = pane.add({0.5, 0.5});
    EXPECT_EQ(triangles(pane).size(), before.size() + 2);
    pane.remove(hub);
    EXPECT_EQ(triangles(pane), before);
}

TEST(PaneBoundary, MayTurnAHoleInsideOutButNotLeaveItOutside)
{
    const std::vector<std::vector<Point2>> holes{{{4, 4}, {4, 6}, {6, 5}}};
    Pane pane(rectangle(10, 10), holes, {0.0, {}});
    const std::vector<PointId> inner = pane.add_all(std::array{Point2(1, 5), Point2(5, 1), Point2(5, 9), Point2(9, 9)});
    pane.move(PointId(6), {2, 5}); // over the opposite side
    expect_sound(pane);
    EXPECT_EQ(double_areas(pane).first, 196);
    EXPECT_EQ(pane.loop(1), (std::vector{PointId(4), PointId(6), PointId(5)})); // clockwise
    pane.move(PointId(6), {6, 5});
    EXPECT_EQ(pane.loop(1), (std::vector{PointId(4), PointId(5), PointId(6)}));
    expect_sound(pane);
    expect_refused(pane, Reason::swallows_point, [&] { pane.move(PointId(2), {8, 8}); });
    pane.remove(inner[3]);
    pane.remove(inner[2]);
    pane.move(PointId(2), {8, 8});
    expect_sound(pane);
    EXPECT_EQ(double_areas(pane).first, 2 * (100 - 20 - 2));
    expect_refused(pane, Reason::boundary_crosses, [&] { pane.move(PointId(2), {3, 3}); }); // the whole hole would be outside
}

} // namespace
} // namespace druse
