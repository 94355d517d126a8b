#include "graph/strut_contacts.h"

#include "graph/largest_factor.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace druse {
namespace {

TEST(LargestFactor, IsFoundWhateverItsSize)
{
    for (const double most : {0.9999, 0.3, 1e-9, 1e-30, 1e-300}) {
        const double found = largest_factor([most](double factor) { return factor <= most; });
        EXPECT_LE(found, most);
        EXPECT_GE(found, most * (1 - 1e-9));
    }
    EXPECT_EQ(largest_factor([](double) { return true; }), 1);
    EXPECT_EQ(largest_factor([](double) { return false; }), 0);
}

/// Bars side by side, all of them as thick as the whole row is wide: each comes near each.
struct Crowd {
    explicit Crowd(std::uint32_t bars) : clean(cleaned(row(bars), 0, repairs, progress)) {}
    static Graph row(std::uint32_t bars)
    {
        Graph graph;
        for (std::uint32_t i = 0; i < bars; ++i) {
            graph.vertices.insert(graph.vertices.end(), {Point(0, i, 0), Point(10.0 * bars, i, 0)});
            graph.edges.push_back({2 * i, 2 * i + 1});
        }
        return graph;
    }
    Progress progress;
    GraphRepairs repairs;
    CleanGraph clean;
    Incidence incidence{clean.graph};
    StrutNeighbours neighbours{clean.graph, incidence};
};

TEST(NearParts, AreKeptUpToAMillionPairsAndToldInListsBeyond)
{
    Crowd crowd(1500);
    const StrutShape shape{.radius = 1500, .scale = StrutScale::absolute};
    const StrutPlacer placer(crowd.clean, crowd.incidence, shape);
    const StrutPlacement placement = placer.place();
    const NearParts near = crowd.neighbours.near(placement, 0.5, crowd.progress);
    EXPECT_FALSE(near.complete);
    EXPECT_LE(near.pairs.size(), NearParts::most);
    EXPECT_TRUE(near.meeting.empty()); // all are 1 apart
    EXPECT_EQ(crowd.neighbours.near(placement, 1, crowd.progress).meeting.size(), 1499u);
    std::size_t told = 0, lists = 0;
    double factor = 1;
    crowd.neighbours.for_each_list(near, placement, crowd.progress, [&](const std::vector<PartPair>& pairs) {
        EXPECT_LE(pairs.size(), NearParts::most);
        EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
        told += pairs.size();
        ++lists;
        factor = crowd.neighbours.clearing_factor(placer, pairs, factor);
        return true;
    });
    EXPECT_EQ(told, 1500u * 1499 / 2);
    EXPECT_EQ(lists, 2u);
    EXPECT_NEAR(factor, 0.5 / 1500, 1e-9); // half of how far neighbours are apart
    lists = 0;
    crowd.neighbours.for_each_list(near, placement, crowd.progress, [&](const std::vector<PartPair>&) { return ++lists > 1; });
    EXPECT_EQ(lists, 1u);
}

} // namespace
} // namespace druse
