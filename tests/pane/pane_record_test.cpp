// What files keep of a pane brings it back as it was.
#include "pane/pane_record.h"
#include "pane_support.h"

namespace druse {
namespace {

Pane some_pane()
{
    Pane pane(rectangle(10, 10), std::vector<std::vector<Point2>>{{{2, 2}, {2, 4}, {4, 2}}}, {0.02, {}});
    pane.add({8, 8});
    const PointId gone = pane.add({6, 6});
    pane.constrain_line(std::array{Point2(1, 6), Point2(9, 5)});
    pane.constrain_line(std::array{Point2(6, 3), Point2(7, 9), Point2(3, 9)});
    pane.unconstrain(pane.constrain_line(std::array{Point2(5, 1), Point2(9, 1)}));
    pane.remove(gone);
    pane.lock(std::array{PointId(2), PointId(7)});
    pane.add({5, 0});
    return pane;
}

TEST(PaneRecord, BringsAPaneBackWithItsIdsAndTriangles)
{
    const Pane pane = some_pane();
    const PaneRecord told = record(pane);
    Pane again = restore(told);
    EXPECT_EQ(record(again), told);
    EXPECT_EQ(triangles(again), triangles(pane));
    expect_sound(again);
    EXPECT_EQ(again.add({1, 1}), pane.next_point()); // ids go on where they were
    EXPECT_EQ(again.constrain(PointId(0), PointId(4)), pane.next_segment());
    const PaneCheck found = check(pane);
    EXPECT_EQ(told.triangles.size(), found.triangles);
    EXPECT_EQ(told.boundary.size(), 2u);
    EXPECT_EQ(told.locked.size(), 2u);
}

TEST(PaneRecord, IsRefusedWhereItTellsOfNoPane)
{
    const PaneRecord good = record(some_pane());
    const auto refused = [&](auto&& spoil) {
        PaneRecord bad = good;
        spoil(bad);
        EXPECT_THROW(restore(bad), PaneRefusal);
    };
    refused([](PaneRecord& r) { r.ids.pop_back(); });
    refused([](PaneRecord& r) { std::swap(r.ids[0], r.ids[1]); });
    refused([](PaneRecord& r) { r.next_point = 3; });
    refused([](PaneRecord& r) { r.boundary.clear(); });
    refused([](PaneRecord& r) { r.boundary[0][0] = 1000; });
    refused([](PaneRecord& r) { std::swap(r.boundary[0], r.boundary[1]); });
    refused([](PaneRecord& r) { r.boundary[1][0] = r.boundary[0][0]; });
    refused([](PaneRecord& r) { r.points.back() = r.points.front(); });
    refused([](PaneRecord& r) { r.points.back() = {50, 50}; });
    refused([](PaneRecord& r) { r.weld = 0; });
    refused([](PaneRecord& r) { r.segments[0].second.pop_back(), r.segments[0].second.resize(1); });
    refused([](PaneRecord& r) { r.segments[0].first = r.segments[1].first; });
    refused([](PaneRecord& r) { r.segments[0].second[0] = 77; });
    refused([](PaneRecord& r) { std::erase(r.segments[0].second, r.segments[0].second[1]); }); // crosses the other one without its point
    refused([](PaneRecord& r) { r.locked.push_back(1000); });
}

} // namespace
} // namespace druse
