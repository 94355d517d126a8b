// Inputs of the kinds that triangulators stumble over: lines that end in nothing, curved outlines, overlapping lines, too many crossings.
#include "pane_support.h"

#include <cmath>
#include <numbers>

namespace druse {
namespace {

const Pane::Settings as_given{0.0, {}};

/// A closed curve in polar form about a centre, counter-clockwise.
template <class Radius>
std::vector<Point2> round(int count, const Point2& centre, Radius&& radius)
{
    std::vector<Point2> points;
    for (int i = 0; i < count; ++i) {
        const double turn = 2 * std::numbers::pi * i / count;
        points.push_back(centre + radius(turn) * Point2(std::cos(turn), std::sin(turn)));
    }
    return points;
}

std::vector<Point2> circle_of(int count, const Point2& centre, double radius)
{
    return round(count, centre, [radius](double) { return radius; });
}

/// Sound, with its counts, and the same when it is built in another order.
void expect_good(const Pane& pane)
{
    expect_sound(pane);
    std::mt19937 random(1);
    EXPECT_EQ(triangles(pane), triangles_built_anew(pane, random));
}

TEST(PaneInputs, MayHoldLinesThatEndInNothing)
{
    // A comb: lines from the boundary inward, lines that hang on those, one that touches nothing, and one that closes a cell only almost.
    Pane pane(rectangle(100, 60), {}, as_given);
    for (int i = 1; i < 10; ++i) {
        const SegmentId tooth = pane.constrain_line(std::array{Point2(10 * i, 0), Point2(10 * i, 25 + i)});
        pane.constrain_line(std::array{pane.position(pane.chain(tooth).back()), Point2(10 * i + 7, 40)});
    }
    pane.constrain_line(std::array{Point2(40, 50), Point2(60, 50)});
    pane.constrain_line(std::array{Point2(70, 45), Point2(80, 45), Point2(80, 55), Point2(70, 55), Point2(70, 45 + 1e-4)});
    EXPECT_EQ(pane.segment_count(), 20u);
    EXPECT_EQ(pane.boundary_count(), 13u); // each tooth begins with a point of the boundary
    expect_good(pane);
}

TEST(PaneInputs, MayBeBentLikeAKidney)
{
    const auto outline = round(120, Point2(0), [](double turn) { return 3 + 1.2 * std::cos(turn) + 0.9 * std::cos(2 * turn); });
    Pane pane(outline, std::vector<std::vector<Point2>>{circle_of(24, {3, 0}, 0.8)}, as_given);
    EXPECT_EQ(pane.report().notes.size(), 1u); // the hole turned the wrong way
    expect_good(pane);
    // Chords leave it at its dents, or run into the hole.
    int refused = 0;
    for (int i = 0; i < 24; ++i) {
        try {
            pane.constrain(PointId(5 * i), PointId((5 * i + 27) % 120));
        } catch (const PaneRefusal& refusal) {
            EXPECT_STREQ(name(refusal.reason()), "outside");
            ++refused;
        }
    }
    EXPECT_GT(refused, 0);
    EXPECT_GT(pane.segment_count(), 5u);
    expect_good(pane);
}

TEST(PaneInputs, MayHaveALongNeckAndStrings)
{
    // A body with a waist, a neck a hundredth as wide as long, a sound hole, and strings along both that end beside the hole.
    std::vector<Point2> outline;
    for (int i = 0; i <= 60; ++i) {
        const double t = std::numbers::pi * (0.06 + 1.88 * i / 60);
        outline.emplace_back(-8 + 6 * std::cos(t), (3.2 + 0.8 * std::cos(2 * t)) * std::sin(t));
    }
    const double neck = outline.front().y;
    EXPECT_GT(neck, 0);
    outline.emplace_back(40, -0.2);
    outline.emplace_back(40, 0.2);
    Pane pane(outline, std::vector<std::vector<Point2>>{circle_of(32, {-6, 0}, 0.9)}, as_given);
    for (int i = 0; i < 6; ++i) pane.constrain_line(std::array{Point2(-5 + 0.02 * i, 0.12 - 0.05 * i), Point2(39.9, 0.1 - 0.04 * i)});
    EXPECT_EQ(pane.segment_count(), 6u);
    expect_refused(pane, Reason::outside, [&] { pane.constrain_line(std::array{Point2(-9, 0), Point2(30, 0.01)}); }); // through the sound hole
    expect_good(pane);
    const auto refined = pane.refine({20, {}, true});
    EXPECT_GT(refined.made, 0u);
    expect_sound(pane);
}

TEST(PaneInputs, MayBeALakeWithIslands)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> rough(-1, 1);
    const auto shore = [&](int count, const Point2& centre, double size) {
        std::array<double, 12> waves;
        for (double& w : waves) w = rough(random);
        return round(count, centre, [&](double turn) {
            double r = 1;
            for (std::size_t k = 0; k < waves.size(); ++k) r += 0.25 * waves[k] / double(k + 2) * std::cos(double(k + 1) * turn + waves[(k + 5) % 12] * 3);
            return size * r;
        });
    };
    std::vector<std::vector<Point2>> islands;
    for (int i = 0; i < 7; ++i) islands.push_back(shore(40, Point2(4.5 * std::cos(0.9 * i), 4.5 * std::sin(0.9 * i)), 0.6));
    Pane pane(shore(600, Point2(0), 12), islands, as_given);
    EXPECT_EQ(pane.hole_count(), 7u);
    EXPECT_EQ(pane.boundary_count(), 880u);
    expect_good(pane);
    int inside = 0;
    for (int i = 0; i < 500; ++i) {
        try {
            pane.add(Point2(14 * rough(random), 14 * rough(random)));
            ++inside;
        } catch (const PaneRefusal& refusal) {
            EXPECT_STREQ(name(refusal.reason()), "outside");
        }
    }
    EXPECT_GT(inside, 150);
    expect_good(pane);
}

TEST(PaneInputs, MayHoldLinesUponLines)
{
    // Parts of one straight line, overlapping in every way, and lines across them through their ends.
    Pane pane(rectangle(20, 10), {}, as_given);
    for (const auto& [from, to] : {std::pair{2, 8}, {4, 12}, {12, 6}, {2, 8}, {1, 15}, {8, 2}, {5, 5 + 1}})
        pane.constrain_line(std::array{Point2(from, 5), Point2(to, 5)});
    EXPECT_EQ(pane.segment_count(), 5u); // one of them was there, once more and the other way round
    for (const int x : {1, 2, 4, 5, 6, 8, 12, 15}) pane.constrain_line(std::array{Point2(x, 1), Point2(x, 9)});
    EXPECT_EQ(pane.point_count(), 4u + 8u + 16u);
    expect_good(pane);
    for (const SegmentId segment : pane.segments()) pane.unconstrain(segment);
    expect_good(pane);
}

TEST(PaneInputs, WithTooManyCrossingsInOneEditAreRefused)
{
    Pane pane(rectangle(210, 120), {}, as_given);
    std::vector<Point2> ends;
    for (int i = 0; i < 101; ++i) {
        ends.emplace_back(2 * i + 2, 1);
        ends.emplace_back(2 * i + 2, 119);
    }
    const auto ids = pane.add_all(ends);
    std::vector<std::pair<PointId, PointId>> bars;
    for (std::size_t i = 0; i < ids.size(); i += 2) bars.emplace_back(ids[i], ids[i + 1]);
    pane.constrain_all(bars);
    std::vector<Point2> weave;
    for (int i = 0; i < 100; ++i) {
        weave.emplace_back(i % 2 == 0 ? 1 : 205, 2 + i);
        weave.emplace_back(i % 2 == 0 ? 205 : 1, 2 + i);
    }
    expect_refused(pane, Reason::unresolvable, [&] { pane.constrain_line(weave); }); // 101 bars by 100 rows
    pane.constrain_line(std::span(weave).subspan(0, 20));
    EXPECT_EQ(pane.point_count(), 4u + 202u + 20u + 1010u);
    expect_sound(pane);
}

} // namespace
} // namespace druse
