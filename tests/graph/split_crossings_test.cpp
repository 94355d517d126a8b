#include "graph/split_crossings.h"

#include "graph/graph_facts.h"

#include <gtest/gtest.h>

namespace druse {
namespace {

constexpr double reach = 1e-9;

std::vector<Crossing> found(const Graph& graph)
{
    std::vector<PartPair> all;
    const auto joined = [](const auto& e, const auto& f) { return e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1]; };
    for (std::uint32_t e = 0; e < graph.edges.size(); ++e)
        for (std::uint32_t f = e + 1; f < graph.edges.size(); ++f)
            if (!joined(graph.edges[e], graph.edges[f])) all.push_back({e, f});
    return crossings(graph, all, reach);
}

CleanGraph clean(const Graph& graph)
{
    Progress progress;
    GraphRepairs repairs;
    return cleaned(graph, 0, repairs, progress);
}

CleanGraph split_at(const CleanGraph& graph, const std::vector<Crossing>& list)
{
    Progress progress;
    return split(graph, list, reach, progress);
}

TEST(SplitCrossings, PutsAVertexWhereEdgesCross)
{
    const CleanGraph cross = clean({{{0, 0, 0}, {2, 0, 0}, {1, -1, 0}, {1, 1, 0}}, {{0, 1}, {2, 3}}});
    const std::vector<Crossing> list = found(cross.graph);
    ASSERT_EQ(list.size(), 1u);
    EXPECT_FALSE(list[0].along);
    const CleanGraph made = split_at(cross, list);
    EXPECT_EQ(made.graph.vertices.back(), Point(1, 0, 0));
    EXPECT_EQ(made.graph.edges, (std::vector<std::array<std::uint32_t, 2>>{{0, 4}, {4, 1}, {2, 4}, {4, 3}}));
    EXPECT_EQ(made.edge_ids, (std::vector<std::uint32_t>{0, 0, 1, 1}));
    EXPECT_EQ(made.vertex_ids, (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
    EXPECT_TRUE(found(made.graph).empty());
}

TEST(SplitCrossings, MakesOneVertexOfThreeEdgesThroughAPoint)
{
    const CleanGraph star = clean({{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}, {{0, 1}, {2, 3}, {4, 5}}});
    const CleanGraph made = split_at(star, found(star.graph));
    EXPECT_EQ(made.graph.vertices.size(), 7u);
    EXPECT_EQ(made.graph.edges.size(), 6u);
    EXPECT_EQ(facts(made.graph).components, 1u);
}

TEST(SplitCrossings, JoinsAnEdgeToTheEndOfAnotherThatLiesOnIt)
{
    const CleanGraph tee = clean({{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1}, {2, 3}}});
    const CleanGraph made = split_at(tee, found(tee.graph));
    EXPECT_EQ(made.graph.vertices.size(), 4u);
    EXPECT_EQ(made.graph.edges, (std::vector<std::array<std::uint32_t, 2>>{{0, 2}, {2, 1}, {2, 3}}));
}

TEST(SplitCrossings, TellsEdgesThatRunAlongEachOther)
{
    const auto along = [](const Graph& graph) { return found(graph).at(0).along; };
    EXPECT_TRUE(along({{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0, 1}, {2, 3}}}));
    EXPECT_TRUE(along({{{0, 0, 0}, {3, 0, 0}, {2, 0, 0}, {1, 0, 0}}, {{0, 1}, {2, 3}}}));
    EXPECT_FALSE(along({{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1}, {2, 3}}})); // end to end
}

} // namespace
} // namespace druse
