// What edits mean and what they refuse: snapping, merging, boundaries, locks, twins, listeners.
#include "pane_support.h"

namespace druse {
namespace {

Pane square(double snap = 0.0) { return Pane(rectangle(10, 10), {}, {snap, {}}); }

// --- making ---------------------------------------------------------------------------------------------------------------------------

TEST(NewPane, NumbersPointsAsTheyAreGivenAndTurnsLoopsRound)
{
    const std::vector<Point2> clockwise{{0, 0}, {0, 10}, {10, 10}, {10, 0}};
    const std::vector<std::vector<Point2>> holes{{{2, 2}, {4, 2}, {4, 4}}};
    const Pane pane(clockwise, holes);
    EXPECT_EQ(pane.report().notes.size(), 2u); // the hole was counter-clockwise
    EXPECT_EQ(pane.position(PointId(1)), Point2(0, 10));
    EXPECT_EQ(pane.position(PointId(5)), Point2(4, 2));
    EXPECT_EQ(pane.loop(0), (std::vector{PointId(0), PointId(3), PointId(2), PointId(1)}));
    EXPECT_EQ(pane.loop(1), (std::vector{PointId(4), PointId(6), PointId(5)}));
    EXPECT_EQ(pane.snap(), 0.02); // a five-hundredth of 10
    EXPECT_DOUBLE_EQ(pane.weld(), 1e-8);
    expect_sound(pane);
    EXPECT_EQ(check(pane).area, 98.0);
}

TEST(NewPane, RefusesWhatIsNoRegion)
{
    const auto refused = [](const std::vector<Point2>& loop, const std::vector<std::vector<Point2>>& holes, Reason reason) {
        try {
            Pane pane(loop, holes);
            ADD_FAILURE() << "not refused: " << name(reason);
        } catch (const PaneRefusal& refusal) {
            EXPECT_STREQ(name(refusal.reason()), name(reason)) << refusal.what();
        }
    };
    refused({{0, 0}, {1, 0}}, {}, Reason::too_few_points);
    refused({{0, 0}, {10, 10}, {10, 0}, {0, 10}}, {}, Reason::boundary_crosses);
    refused({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}}, {}, Reason::boundary_touches);
    refused({{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}}, {}, Reason::boundary_touches);
    refused(rectangle(10, 10), {{{12, 2}, {14, 2}, {14, 4}}}, Reason::boundary_crosses);           // outside
    refused(rectangle(10, 10), {{{8, 2}, {14, 2}, {14, 4}}}, Reason::boundary_crosses);            // half
    refused(rectangle(10, 10), {{{1, 1}, {9, 1}, {5, 9}}, {{5, 3}, {6, 3}, {5, 4}}}, Reason::boundary_crosses); // in a hole
    refused(rectangle(10, 10), {{{10, 5}, {8, 5}, {8, 6}}}, Reason::boundary_touches);
    refused({{0, 0}, {1e151, 0}, {0, 1}}, {}, Reason::range);
    refused({{0, 0}, {std::numeric_limits<double>::quiet_NaN(), 0}, {0, 1}}, {}, Reason::range);
    refused({{0, 0}, {1e-132, 0}, {0, 1e-132}}, {}, Reason::range);
}

TEST(NewPane, TakesCoordinatesToTheEndOfItsRange)
{
    for (const double size : {1e150, 1e-130}) {
        Pane pane(std::vector<Point2>{{-size, -size}, {size, -size}, {size, size}, {-size, size}});
        for (int i = 1; i < 40; ++i) pane.add(size * Point2(0.9 - 0.043 * i, 0.8 - 0.041 * ((i * 17) % 40)));
        pane.constrain_line(std::array{Point2(-0.9, -0.8) * size, Point2(0.9, 0.7) * size});
        pane.move(PointId(1), size * Point2(0.99, -0.99));
        EXPECT_EQ(check(pane).faults, std::vector<std::string>());
    }
}

// --- adding ---------------------------------------------------------------------------------------------------------------------------

TEST(PaneAdd, MeansAPointThatIsThere)
{
    Pane pane = square(0.1);
    const PointId p = pane.add({5, 5});
    EXPECT_EQ(pane.add({5.05, 5.05}), p);
    EXPECT_EQ(pane.add({0.05, 0.05}), PointId(0));
    expect_refused(pane, Reason::coincides, [&] { pane.add({5.05, 5}, {}, true); });
    EXPECT_NE(pane.add({5.2, 5}), p);
    pane.set_snap(0.01);
    EXPECT_NE(pane.add({5.05, 5.05}), p);
    expect_refused(pane, Reason::range, [&] { pane.set_snap(-1); });
    Pane welded = square();
    const PointId q = welded.add({5, 5});
    EXPECT_EQ(welded.add({5, 5 + 5e-9}), q); // weld counts even without snap
    EXPECT_NE(welded.add({5, 5 + 5e-8}), q);
}

TEST(PaneAdd, SplitsTheEdgesItIsOn)
{
    Pane pane = square(0.1);
    const SegmentId segment = pane.constrain_line(std::array{Point2(2, 2), Point2(8, 3)});
    const PointId on_segment = pane.add({5, 2.55}), on_boundary = pane.add({4, 0.05});
    EXPECT_EQ(pane.chain(segment).size(), 3u);
    EXPECT_EQ(pane.chain(segment)[1], on_segment);
    EXPECT_EQ(pane.kind(on_boundary), PointKind::boundary);
    EXPECT_EQ(pane.position(on_boundary), Point2(4, 0));
    EXPECT_EQ(pane.boundary_count(), 5u);
    const PointId near_end = pane.add({9.85, 0.06}); // no nearer than snap to the end of the edge
    EXPECT_NEAR(pane.position(near_end).x, 9.85, 1e-9);
    const PointId nearer = pane.add({9.91, 0.085});
    EXPECT_EQ(nearer, near_end);
    expect_sound(pane);
}

TEST(PaneAdd, AvoidsSliversAtFreeEdges)
{
    Pane pane = square(0.1); // its diagonal runs from (0,0) to (10,10)
    const PointId on_it = pane.add({5, 5.02}), beside = pane.add({2, 2.2});
    EXPECT_EQ(pane.position(on_it).x, pane.position(on_it).y);
    EXPECT_EQ(pane.position(beside), Point2(2, 2.2));
    expect_sound(pane);
}

TEST(PaneAdd, FindsTheEdgeItIsToldAndRefusesOthers)
{
    Pane pane = square();
    const PointId p = pane.add({4, 1}, PaneEdge{PointId(0), PointId(1)});
    EXPECT_EQ(pane.position(p), Point2(4, 0));
    EXPECT_EQ(pane.kind(p), PointKind::boundary);
    expect_refused(pane, Reason::no_such_edge, [&] { pane.add({4, 1}, PaneEdge{PointId(0), PointId(1)}); });
    expect_refused(pane, Reason::no_such_point, [&] { pane.add({4, 1}, PaneEdge{PointId(0), PointId(77)}); });
    expect_refused(pane, Reason::outside, [&] { pane.add({-1, 5}); });
    expect_refused(pane, Reason::outside, [&] { pane.add({1e100, 5}); });
    expect_refused(pane, Reason::range, [&] { pane.add({std::numeric_limits<double>::infinity(), 5}); });
    expect_refused(pane, Reason::outside, [&] { pane.add_all(std::array{Point2(1, 1), Point2(5, 11), Point2(2, 2)}); });
}

TEST(PaneAddBoundary, SplitsTheNearestEdgeAndTakesThePointThere)
{
    Pane pane = square();
    const PointId out = pane.add_boundary({5, -3}), far = pane.add_boundary({500, 5});
    EXPECT_EQ(pane.loop(0), (std::vector{PointId(0), out, PointId(1), far, PointId(2), PointId(3)}));
    const PointId in = pane.add_boundary({5, 9}, PaneEdge{PointId(3), PointId(2)});
    EXPECT_EQ(check(pane).area, 100 + 15 + 490 * 5 - 5.0);
    EXPECT_EQ(pane.kind(in), PointKind::boundary);
    expect_sound(pane);
    expect_refused(pane, Reason::boundary_crosses, [&] { pane.add_boundary({4, -4}, PaneEdge{PointId(2), in}); });
    expect_refused(pane, Reason::boundary_touches, [&] { pane.add_boundary({0, 5}, PaneEdge{PointId(2), in}); });
    expect_refused(pane, Reason::no_such_edge, [&] { pane.add_boundary({5, 5}, PaneEdge{PointId(2), PointId(0)}); });
    pane.add({4, 1});
    expect_refused(pane, Reason::swallows_point, [&] { pane.add_boundary({5, 5}, PaneEdge{PointId(0), out}); });
}

// --- moving and merging ---------------------------------------------------------------------------------------------------------------

TEST(PaneMove, TakesSegmentsAlong)
{
    Pane pane = square();
    const PointId a = pane.add({2, 2}), b = pane.add({5, 5}), c = pane.add({8, 2});
    const SegmentId bent = pane.constrain(std::array{a, b, c});
    pane.add({5, 3});
    pane.add({5, 7});
    pane.move(b, {5, 9}); // over a point
    EXPECT_EQ(pane.chain(bent), (std::vector{a, b, c}));
    EXPECT_TRUE(has_edge(pane, std::uint32_t(a), std::uint32_t(b)));
    expect_sound(pane);
    pane.move(b, {5, 2}); // the segment is straight now
    expect_sound(pane);
}

TEST(PaneMove, IsRefusedWhereItWouldSpoilTheBoundary)
{
    Pane pane(std::vector<Point2>{{0, 0}, {10, 0}, {10, 10}, {5, 6}, {0, 10}}, std::vector<std::vector<Point2>>{{{4, 2}, {5, 3}, {6, 2}}}, {0.0, {}});
    const PointId inner = pane.add({2, 5}), locked = pane.add({8, 1});
    pane.lock(std::array{locked, PointId(4)});
    expect_refused(pane, Reason::outside, [&] { pane.move(inner, {5, 9}); });
    expect_refused(pane, Reason::outside, [&] { pane.move(inner, {5, 2.5}); });
    expect_refused(pane, Reason::locked, [&] { pane.move(locked, {7, 1}); });
    expect_refused(pane, Reason::locked, [&] { pane.move(PointId(4), {0, 11}); });
    expect_refused(pane, Reason::boundary_crosses, [&] { pane.move(PointId(3), {5, -1}); });
    expect_refused(pane, Reason::boundary_crosses, [&] { pane.move(PointId(5), {11, 5}); }); // a hole over the outer loop
    expect_refused(pane, Reason::boundary_touches, [&] { pane.move(PointId(3), {5, 0}); });
    expect_refused(pane, Reason::boundary_touches, [&] { pane.move(PointId(3), {5, 3}); });
    expect_refused(pane, Reason::swallows_point, [&] { pane.move(PointId(0), {3, 6}); });
    expect_refused(pane, Reason::no_such_point, [&] { pane.move(PointId(99), {5, 3}); });
    Pane holed(rectangle(10, 10), std::vector<std::vector<Point2>>{{{1, 1}, {2, 1}, {1, 2}}}, {0.0, {}});
    expect_refused(holed, Reason::boundary_crosses, [&] { holed.move(PointId(0), {4, 4}); }); // past the whole hole
    const PointId other = pane.add({8, 5});
    pane.constrain_line(std::array{Point2(7, 4), Point2(7, 7)});
    expect_refused(pane, Reason::outside, [&] { pane.constrain(PointId(4), PointId(2)); });
    expect_refused(pane, Reason::outside, [&] { pane.constrain(other, PointId(4)); });
    expect_refused(pane, Reason::boundary_crosses, [&] { pane.move(PointId(3), {7.5, 5.2}); }); // over a segment, ends inside
    expect_sound(pane);
}

TEST(PaneMove, StopsABoundaryPointBeforeTheOppositeEdge)
{
    Pane pane = square();
    int stopped = 0;
    for (int i = 1; i <= 100; ++i) {
        try {
            pane.add_boundary({5, 10}); // once; afterwards the point is there
        } catch (const PaneRefusal&) {
        }
        const PointId p = PointId(4);
        if (!pane.exists(p)) continue;
        try {
            pane.move(p, {5, 10 - 0.12 * i});
        } catch (const PaneRefusal& refusal) {
            ++stopped;
            EXPECT_TRUE(refusal.reason() == Reason::boundary_crosses || refusal.reason() == Reason::boundary_touches) << refusal.what();
        }
        expect_sound(pane);
    }
    EXPECT_GT(stopped, 10);
    EXPECT_GT(pane.position(PointId(4)).y, 0);
}

TEST(PaneMerge, KeepsTheIdThatCountsMore)
{
    Pane pane = square(0.1);
    const PointId a = pane.add({3, 3}), b = pane.add({6, 3}), c = pane.add({6, 6}), d = pane.add({3, 6});
    const SegmentId ab = pane.constrain(a, b), bc = pane.constrain(b, c), ad = pane.constrain(a, d);
    EXPECT_EQ(pane.move(b, {3.01, 3}), a); // the smaller one
    EXPECT_FALSE(pane.exists(b));
    EXPECT_FALSE(pane.exists(ab)); // without length
    EXPECT_EQ(pane.chain(bc), (std::vector{a, c}));
    ASSERT_EQ(pane.report().merged.size(), 1u);
    EXPECT_EQ(pane.report().merged[0].gone, b);
    expect_sound(pane);
    EXPECT_EQ(pane.move(c, {3, 6.01}), c); // smaller than d
    EXPECT_EQ(pane.position(c), Point2(3, 6));
    EXPECT_TRUE(pane.exists(bc));
    EXPECT_FALSE(pane.exists(ad)); // over the same points as the other
    expect_sound(pane);
    const PointId e = pane.add({7, 7}), f = pane.add({8, 8});
    pane.lock(std::array{f});
    EXPECT_EQ(pane.move(e, {8, 8}), f);
    EXPECT_EQ(pane.move(f == e ? e : c, {0, 0}), PointId(0)); // the boundary
    EXPECT_EQ(pane.boundary_count(), 4u);
    expect_sound(pane);
}

TEST(PaneMerge, OfBoundaryPointsIsForNeighboursOfALongEnoughLoop)
{
    Pane pane = square(0.1);
    const PointId p = pane.add({5, 0}), q = pane.add({5, 5});
    expect_refused(pane, Reason::boundary_touches, [&] { pane.move(p, {10, 10}); });
    pane.constrain(p, q);
    EXPECT_EQ(pane.move(p, {9.95, 0}), PointId(1));
    EXPECT_EQ(pane.boundary_count(), 4u);
    EXPECT_EQ(pane.chain(SegmentId(0)), (std::vector{PointId(1), q}));
    expect_sound(pane);
    EXPECT_EQ(pane.move(PointId(2), {5, 5}), PointId(2)); // on an inner point, which is then of the boundary
    EXPECT_FALSE(pane.exists(q));
    EXPECT_EQ(pane.boundary_count(), 4u);
    EXPECT_EQ(check(pane).area, 50.0);
    expect_sound(pane);
    EXPECT_EQ(pane.move(PointId(3), {0, 0}), PointId(0));
    expect_refused(pane, Reason::too_few_points, [&] { pane.move(PointId(0), {10, 0}); });
    EXPECT_EQ(check(pane).area, 25.0);
    expect_sound(pane);
}

// --- removing -------------------------------------------------------------------------------------------------------------------------

TEST(PaneRemove, JoinsOrCutsTheSegmentsThroughAPoint)
{
    for (const auto through : {Pane::Through::join, Pane::Through::cut}) {
        Pane pane = square();
        const PointId a = pane.add({1, 1}), b = pane.add({3, 4}), c = pane.add({5, 1}), d = pane.add({7, 4}), e = pane.add({9, 1});
        const SegmentId line = pane.constrain(std::array{a, b, c, d, e});
        pane.remove(c, through);
        if (through == Pane::Through::join) {
            EXPECT_EQ(pane.chain(line), (std::vector{a, b, d, e}));
        } else {
            EXPECT_EQ(pane.chain(line), (std::vector{a, b}));
            EXPECT_EQ(pane.chain(SegmentId(1)), (std::vector{d, e}));
        }
        expect_sound(pane);
        pane.remove(a);
        EXPECT_EQ(pane.exists(line), through == Pane::Through::join);
        expect_sound(pane);
    }
}

TEST(PaneRemove, MakesOneEdgeOfTwoAtTheBoundary)
{
    Pane pane(std::vector<Point2>{{0, 0}, {10, 0}, {10, 10}, {5, 5}, {0, 10}});
    pane.remove(PointId(3));
    EXPECT_EQ(check(pane).area, 100.0);
    expect_sound(pane);
    const PointId p = pane.add({9, 9});
    expect_refused(pane, Reason::swallows_point, [&] { pane.remove(PointId(2)); });
    pane.lock(std::array{p});
    expect_refused(pane, Reason::locked, [&] { pane.remove(p); });
    pane.lock(std::array{p}, false);
    pane.remove(p);
    pane.remove(PointId(2));
    expect_refused(pane, Reason::too_few_points, [&] { pane.remove(PointId(0)); });
    EXPECT_EQ(pane.add({9, 0.5}), PointId(6)); // ids are not given twice
    Pane notch(std::vector<Point2>{{0, 0}, {10, 0}, {10, 9}, {8, 9}, {8, 2}, {2, 2}, {2, 10}, {0, 10}});
    expect_refused(notch, Reason::boundary_crosses, [&] { notch.remove(PointId(1)); });
}

// --- segments -------------------------------------------------------------------------------------------------------------------------

TEST(PaneConstrain, RefusesWhatIsNoSegment)
{
    Pane pane = square();
    const PointId p = pane.add({5, 5});
    expect_refused(pane, Reason::same_point, [&] { pane.constrain(p, p); });
    expect_refused(pane, Reason::no_such_point, [&] { pane.constrain(p, PointId(50)); });
    expect_refused(pane, Reason::too_few_points, [&] { pane.constrain(std::array{p}); });
    expect_refused(pane, Reason::no_such_segment, [&] { pane.unconstrain(SegmentId(0)); });
    expect_refused(pane, Reason::no_such_segment, [&] { pane.unconstrain(p, PointId(1)); });
    expect_refused(pane, Reason::outside, [&] { pane.constrain_line(std::array{Point2(1, 1), Point2(2, 2), Point2(11, 3)}); });
    pane.constrain(p, PointId(1));
    pane.unconstrain(PointId(1), p);
    EXPECT_EQ(pane.segment_count(), 0u);
}

TEST(PaneConstrain, TakesManyAtOnce)
{
    Pane one_by_one = square(), at_once = square();
    std::mt19937 random(9);
    std::vector<Point2> places;
    for (int i = 0; i < 400; ++i) places.emplace_back(0.01 + double(random() % 9900) / 1000, 0.01 + double(random() % 9900) / 1000);
    one_by_one.add_all(places);
    const auto ids = at_once.add_all(places);
    std::vector<std::pair<PointId, PointId>> ends;
    for (std::size_t i = 0; i + 1 < 60; i += 2) ends.emplace_back(ids[i], ids[i + 1]);
    for (const auto& [a, b] : ends) one_by_one.constrain(a, b);
    EXPECT_EQ(at_once.constrain_all(ends).size(), 30u);
    EXPECT_EQ(at_once.segment_count(), 30u);
    EXPECT_EQ(at_once.point_count(), one_by_one.point_count());
    expect_sound(at_once);
    EXPECT_EQ(at_once.constrain_all(ends).size(), 0u); // all there
    expect_sound(at_once);
}

// --- twins and listeners --------------------------------------------------------------------------------------------------------------

TEST(PaneTwins, AreMovedSplitAndRemovedTogetherOrNotAtAll)
{
    Pane pane = square();
    const Isometry right{{1, 0}, {0, 1}, {10, 0}}, left{{1, 0}, {0, 1}, {-10, 0}};
    for (const auto& [a, b] : {std::pair{0u, 1u}, {3u, 2u}}) {
        pane.add_twin(PointId(a), PointId(b), right);
        pane.add_twin(PointId(b), PointId(a), left);
    }
    const PointId p = pane.add({0, 4}); // and its image on the other side
    EXPECT_EQ(pane.boundary_count(), 6u);
    EXPECT_EQ(pane.report().splits.size(), 2u);
    const PointId q = PointId(std::uint32_t(p) + 1);
    EXPECT_EQ(pane.position(q), Point2(10, 4));
    pane.move(p, {1, 5});
    EXPECT_EQ(pane.position(q), Point2(11, 5));
    pane.move(q, {9, 4});
    EXPECT_EQ(pane.position(p), Point2(-1, 4));
    expect_sound(pane);
    const PointId in_the_way = pane.add({7, 4});
    expect_refused(pane, Reason::swallows_point, [&] { pane.move(p, {-5, 4}); }); // p itself could, its twin could not
    pane.remove(in_the_way);
    pane.move(p, {-5, 4});
    const PointId bulge = pane.add_boundary({-4, 1}, PaneEdge{PointId(0), p});
    EXPECT_EQ(pane.boundary_count(), 8u);
    expect_sound(pane);
    pane.remove(bulge);
    pane.remove(q);
    EXPECT_EQ(pane.boundary_count(), 4u);
    EXPECT_EQ(check(pane).area, 100.0);
    expect_sound(pane);
}

struct Heard : PaneListener {
    std::vector<std::string> said;
    void split(PointId made, PointId a, PointId b) override
    {
        said.push_back(fmt::format("{} on {} {}", int(made), std::min(int(a), int(b)), std::max(int(a), int(b))));
    }
    void merged(PointId gone, PointId into) override { said.push_back(fmt::format("{} into {}", int(gone), int(into))); }
    void removed(PointId gone) override { said.push_back(fmt::format("{} gone", int(gone))); }
};

TEST(PaneListener, HearsWhatWasDoneAndNothingOfWhatWasRefused)
{
    Pane pane = square();
    Heard heard;
    pane.set_listener(&heard);
    const PointId p = pane.add({5, 0}), q = pane.add({5, 5});
    pane.move(q, {5, 6});
    expect_refused(pane, Reason::outside, [&] { pane.move(q, {5, -1}); });
    pane.move(q, pane.position(p));
    pane.remove(p);
    EXPECT_EQ(heard.said, (std::vector<std::string>{"4 on 0 1", "5 into 4", "4 gone"}));
}

TEST(PaneChange, LeadsBackAndForthThroughAnyEdit)
{
    Pane pane = square(0.02);
    std::vector<Pane::Change> changes;
    std::vector<std::uint64_t> states{pane.fingerprint()};
    const auto done = [&] {
        changes.push_back(pane.take_change());
        states.push_back(pane.fingerprint());
    };
    pane.add({5, 5}), done();
    pane.add_boundary({40, 5}), done(); // the box grows
    pane.constrain_line(std::array{Point2(1, 1), Point2(9, 8), Point2(1, 8)}), done();
    pane.constrain_line(std::array{Point2(1, 7), Point2(9, 1)}), done();
    pane.move(PointId(5), {12, 4}), done();
    pane.lock(std::array{PointId(4)}), done();
    pane.unconstrain(SegmentId(0)), done();
    pane.remove(PointId(5)), done();
    pane.add_all(std::array{Point2(2, 3), Point2(4, 3), Point2(6, 2)}), done();
    for (std::size_t i = changes.size(); i-- > 0;) {
        pane.undo(changes[i]);
        EXPECT_EQ(pane.fingerprint(), states[i]) << i;
        expect_sound(pane);
    }
    for (std::size_t i = 0; i < changes.size(); ++i) {
        pane.redo(changes[i]);
        EXPECT_EQ(pane.fingerprint(), states[i + 1]) << i;
        expect_sound(pane);
    }
}

} // namespace
} // namespace druse
