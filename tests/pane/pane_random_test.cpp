// Edits in random order, with every invariant held against a look that knows nothing of how edits work.
#include "pane_support.h"

#include <cmath>

namespace druse {
namespace {

class RandomEdits {
public:
    RandomEdits(unsigned seed, double snap) : random_(seed), pane_(outline(), holes(), {snap, {}}) {}

    /// One edit; true if it took place.
    bool step()
    {
        const auto before = pane_.fingerprint();
        try {
            edit();
        } catch (const PaneRefusal&) {
            EXPECT_EQ(pane_.fingerprint(), before) << last;
            return false;
        }
        if (number(0, 9) == 0 && !no_edit_) {
            const auto after = pane_.fingerprint();
            Pane::Change change = pane_.take_change();
            pane_.undo(change);
            EXPECT_EQ(pane_.fingerprint(), before) << last;
            pane_.redo(change);
            EXPECT_EQ(pane_.fingerprint(), after) << last;
            if (number(0, 3) == 0) pane_.undo(change);
        }
        return true;
    }

    Pane& pane() { return pane_; }
    std::mt19937& random() { return random_; }
    std::string last;

private:
    static std::vector<Point2> outline() { return {{0, 0}, {20, 0}, {20, 8}, {12, 8}, {12, 12}, {20, 12}, {20, 20}, {0, 20}, {0, 12}}; }
    static std::vector<std::vector<Point2>> holes() { return {{{3, 3}, {3, 6}, {6, 6}, {6, 3}}, {{14, 14}, {14, 18}, {17, 15}}}; }

    int number(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }
    double real(double least, double most) { return std::uniform_real_distribution<double>(least, most)(random_); }

    /// Often on a grid, so that points come to lie on lines and circles.
    Point2 place()
    {
        if (number(0, 1) == 0) return {number(0, 40) * 0.5, number(0, 40) * 0.5};
        return {real(-0.5, 20.5), real(-0.5, 20.5)};
    }
    PointId point()
    {
        const auto all = pane_.points();
        return all[std::size_t(number(0, int(all.size()) - 1))];
    }

    void edit()
    {
        no_edit_ = false;
        const int kind = number(0, 14);
        switch (pane_.point_count() > 100 && kind > 5 && kind < 12 ? (kind < 8 ? 3 : 13) : kind) {
        case 0: case 1: case 2: {
            const Point2 p = place();
            last = fmt::format("add {} {}", p.x, p.y);
            pane_.add(p);
            return;
        }
        case 3: {
            const PointId p = point();
            last = fmt::format("remove {}", int(p));
            pane_.remove(p, number(0, 1) == 0 ? Pane::Through::join : Pane::Through::cut);
            return;
        }
        case 4: case 5: {
            const PointId p = point();
            const Point2 to = place();
            last = fmt::format("move {} {} {}", int(p), to.x, to.y);
            pane_.move(p, to);
            return;
        }
        case 6: case 7: {
            const PointId p = point();
            const Point2 to = pane_.position(p) + Point2(real(-1, 1), real(-1, 1));
            last = fmt::format("drag {} {} {}", int(p), to.x, to.y);
            pane_.move(p, to);
            return;
        }
        case 8: case 9: case 10: {
            const PointId p = point(), q = point();
            last = fmt::format("constrain {} {}", int(p), int(q));
            pane_.constrain(p, q);
            no_edit_ = !pane_.report().notes.empty();
            return;
        }
        case 11: {
            const std::array line{place(), place(), place()};
            last = fmt::format("line {} {}, {} {}, {} {}", line[0].x, line[0].y, line[1].x, line[1].y, line[2].x, line[2].y);
            pane_.constrain_line(line);
            no_edit_ = !pane_.report().notes.empty();
            return;
        }
        case 12: {
            const Point2 at = place();
            last = fmt::format("add_boundary {} {}", at.x, at.y);
            pane_.add_boundary(at);
            return;
        }
        case 13: {
            const auto all = pane_.segments();
            no_edit_ = all.empty();
            if (no_edit_) return;
            const SegmentId s = all[std::size_t(number(0, int(all.size()) - 1))];
            last = fmt::format("unconstrain {}", int(s));
            pane_.unconstrain(s);
            return;
        }
        default: {
            const std::array some{point()};
            last = fmt::format("lock {}", int(some[0]));
            pane_.lock(some, number(0, 3) == 0);
            return;
        }
        }
    }

    std::mt19937 random_;
    Pane pane_;
    bool no_edit_ = false; // there was nothing to do, or it was there already
};

class Seeds : public testing::TestWithParam<unsigned> {};

TEST_P(Seeds, KeepEveryInvariant)
{
    const unsigned seed = GetParam();
    RandomEdits edits(seed, seed % 2 == 0 ? 0.0 : 0.04);
    int done = 0;
    for (int i = 0; i < 5000; ++i) {
        try {
            done += edits.step();
        } catch (const std::exception& e) {
            FAIL() << "seed " << seed << ", edit " << i << ", " << edits.last << ": " << e.what();
        }
        if (i < 500) {
            EXPECT_EQ(check(edits.pane()).faults, std::vector<std::string>());
        }
        if (i % 100 == 0) {
            expect_sound(edits.pane());
            EXPECT_EQ(triangles(edits.pane()), triangles_built_anew(edits.pane(), edits.random()));
        }
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed << ", edit " << i << ", " << edits.last;
    }
    EXPECT_GT(done, 1000);
}
INSTANTIATE_TEST_SUITE_P(RandomEdits, Seeds, testing::Range(1u, 21u));

} // namespace
} // namespace druse
