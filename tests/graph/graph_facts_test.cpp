#include "graph/graph_facts.h"

#include <gtest/gtest.h>

namespace druse {
namespace {

TEST(GraphFacts, AreRightOfAGraphThatNobodyCleaned)
{
    // An edge three times, one without a length, one beside another that ends at the same place, and an isolated vertex.
    const Graph graph{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}, {0, 4, 0}, {0, 0, 0}, {9, 9, 9}}, {{0, 1}, {1, 0}, {0, 1}, {0, 4}, {0, 2}, {0, 3}}};
    const GraphFacts f = facts(graph);
    EXPECT_EQ(f.vertices, 6u);
    EXPECT_EQ(f.edges, 6u);
    EXPECT_EQ(f.components, 2u);
    EXPECT_EQ(f.cycle_rank, 2); // 6 - 6 + 2: the edge that is there three times
    EXPECT_EQ(f.smallest_angle, 90.0);
    EXPECT_EQ(f.shortest_edge, 0);
    EXPECT_EQ(f.longest_edge, 4);
    EXPECT_DOUBLE_EQ(f.mean_edge, (3 * 3 + 0 + 4 + 4) / 6.0);
    EXPECT_EQ(f.valences, (std::map<int, std::uint32_t>{{0, 1}, {1, 3}, {3, 1}, {6, 1}}));
    EXPECT_FALSE(facts({{{0, 0, 0}, {1, 0, 0}}, {{0, 1}, {1, 0}}}).smallest_angle);
}

TEST(GraphFacts, AreRightAndFiniteOfGraphsOfAnySize)
{
    for (const double size : {1e-300, 1e-160, 1.0, 1e38}) {
        const GraphFacts f = facts({{{0, 0, 0}, {3 * size, 0, 0}, {0, 4 * size, 0}}, {{0, 1}, {0, 2}, {1, 2}}});
        EXPECT_DOUBLE_EQ(f.shortest_edge, 3 * size);
        EXPECT_DOUBLE_EQ(f.longest_edge, 5 * size);
        EXPECT_DOUBLE_EQ(f.mean_edge, 4 * size);
        EXPECT_NEAR(f.smallest_angle.value(), 36.86989764584402, 1e-12); // atan(3/4)
        EXPECT_EQ(f.cycle_rank, 1);
    }
}

} // namespace
} // namespace druse
