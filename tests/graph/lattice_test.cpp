// Counts of 1 to 4 cells each way: Wells 1977 for the nets; the numbers were counted by hand for one cell, by another program for more.
#include "graph/lattice.h"

#include "dlfl/errors.h"
#include "geom/segments.h"
#include "graph/graph_facts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <queue>
#include <tuple>
#include <vector>

namespace druse {
namespace {

using Row = std::array<std::int64_t, 4>; // V, E, components, cycle rank

Row row(const Graph& graph)
{
    const GraphFacts f = facts(graph);
    return {f.vertices, f.edges, f.components, f.cycle_rank};
}

Graph lattice_of(const LatticeShape& shape)
{
    Progress progress;
    return lattice(shape, progress);
}

TEST(Lattice, HasTheCountsOfItsTable)
{
    struct Entry {
        Net kind;
        bool twin;
        Trim trim;
        bool leaves;
        std::array<Row, 4> rows; // for 1 to 4 cells; all 0: nothing is left
    };
    const std::vector<Entry> table{
        {Net::diamond, false, Trim::cell, true, {{{8, 7, 1, 0}, {64, 86, 1, 23}, {216, 333, 1, 118}, {512, 844, 1, 333}}}},
        {Net::diamond, false, Trim::box, true, {{{14, 16, 1, 3}, {91, 128, 1, 38}, {276, 432, 1, 157}, {617, 1024, 1, 408}}}},
        {Net::diamond, false, Trim::box, false, {{{10, 12, 1, 3}, {75, 112, 1, 38}, {248, 404, 1, 157}, {577, 984, 1, 408}}}},
        {Net::diamond, false, Trim::ball, true, {{{10, 12, 1, 3}, {35, 52, 1, 18}, {136, 212, 1, 77}, {281, 476, 1, 196}}}},
        {Net::diamond, true, Trim::box, true, {{{31, 32, 2, 3}, {185, 256, 2, 73}, {555, 864, 2, 311}, {1237, 2048, 2, 813}}}},
        {Net::diamond, true, Trim::box, false, {{{10, 12, 1, 3}, {141, 212, 2, 73}, {487, 796, 2, 311}, {1145, 1956, 2, 813}}}},
        {Net::srs, false, Trim::cell, true, {{{7, 6, 1, 0}, {63, 72, 1, 10}, {215, 270, 1, 56}, {511, 672, 1, 162}}}},
        {Net::srs, false, Trim::box, true, {{{16, 15, 1, 0}, {93, 108, 1, 16}, {278, 351, 1, 74}, {619, 816, 1, 198}}}},
        {Net::srs, false, Trim::box, false, {{{0, 0, 0, 0}, {66, 81, 1, 16}, {236, 309, 1, 74}, {562, 759, 1, 198}}}},
        {Net::srs, false, Trim::ball, true, {{{4, 3, 1, 0}, {42, 45, 1, 4}, {111, 138, 1, 28}, {266, 345, 1, 80}}}},
        {Net::srs, true, Trim::box, true, {{{30, 30, 2, 2}, {181, 216, 2, 37}, {548, 702, 2, 156}, {1227, 1632, 2, 407}}}},
        {Net::srs, true, Trim::box, false, {{{14, 15, 1, 2}, {154, 189, 2, 37}, {506, 660, 2, 156}, {1170, 1575, 2, 407}}}},
    };
    for (const Entry& e : table)
        for (int n = 1; n <= 4; ++n) {
            SCOPED_TRACE(testing::Message() << (e.kind == Net::srs ? "srs" : "diamond") << " twin " << e.twin << " trim " << int(e.trim) << " leaves " << e.leaves
                                            << " cells " << n);
            const LatticeShape shape{.kind = e.kind, .cells = {n, n, n}, .twin = e.twin, .trim = e.trim, .leaves = e.leaves, .bond = 1, .size = {}};
            const Row& expected = e.rows[std::size_t(n - 1)];
            if (expected == Row{}) {
                EXPECT_THROW(lattice_of(shape), CommandError);
            } else {
                EXPECT_EQ(row(lattice_of(shape)), expected);
            }
        }
}

TEST(Lattice, HasBondsOfOneLengthAroundTheOriginAtTheAnglesOfItsNet)
{
    for (const auto& [kind, angle] : {std::pair(Net::diamond, 109.47122063449069), std::pair(Net::srs, 120.0)}) {
        const Graph graph = lattice_of({.kind = kind, .cells = {3, 2, 1}, .bond = 2.5, .size = {}});
        const GraphFacts f = facts(graph);
        EXPECT_NEAR(f.shortest_edge, 2.5, 1e-12);
        EXPECT_NEAR(f.longest_edge, 2.5, 1e-12);
        EXPECT_NEAR(*f.smallest_angle, angle, 1e-9);
        EXPECT_NEAR(glm::length(f.bounds.center()), 0, 1e-12);
    }
}

/// The least distance of two edges without a common vertex; of one net, or of two.
double least_distance(const Graph& graph, bool between, std::size_t first_edges)
{
    double least = 1e9;
    for (std::size_t e = 0; e < graph.edges.size(); ++e)
        for (std::size_t f = e + 1; f < graph.edges.size(); ++f) {
            if (((e < first_edges) != (f < first_edges)) != between) continue;
            const auto& [a, b] = graph.edges[e];
            const auto& [c, d] = graph.edges[f];
            if (a == c || a == d || b == c || b == d) continue;
            least = std::min(least, nearest_points(graph.vertices[a], graph.vertices[b], graph.vertices[c], graph.vertices[d]).distance);
        }
    return least;
}

TEST(Lattice, KeepsItsNetsAsFarApartAsTheyCanBe)
{
    struct Distances {
        Net kind;
        double own, between; // in bonds
    };
    for (const auto& [kind, own, between] : {Distances{Net::diamond, 1.0, std::sqrt(2.0 / 3)}, Distances{Net::srs, 1.0, std::sqrt(1.5)}}) {
        const std::size_t first = lattice_of({.kind = kind, .size = {}}).edges.size();
        const Graph graph = lattice_of({.kind = kind, .twin = true, .size = {}});
        EXPECT_NEAR(least_distance(graph, false, first), own, 1e-9);
        EXPECT_NEAR(least_distance(graph, true, first), between, 1e-9);
    }
}

TEST(Lattice, HasNoRingOfLessThanTenEdgesInTheNetSrs)
{
    const Graph graph = lattice_of({.kind = Net::srs, .cells = {3, 3, 3}, .size = {}});
    std::vector<std::vector<std::uint32_t>> next(graph.vertices.size());
    for (const auto& [a, b] : graph.edges) {
        next[a].push_back(b);
        next[b].push_back(a);
    }
    // The shortest ring through an edge: the way between its ends that does not use it.
    std::size_t least = 1000;
    for (const auto& [a, b] : graph.edges) {
        std::vector<int> steps(next.size(), -1);
        std::queue<std::uint32_t> waiting({a});
        steps[a] = 0;
        while (!waiting.empty() && steps[b] < 0) {
            const std::uint32_t v = waiting.front();
            waiting.pop();
            for (const std::uint32_t w : next[v])
                if (steps[w] < 0 && !(v == a && w == b)) {
                    steps[w] = steps[v] + 1;
                    waiting.push(w);
                }
        }
        if (steps[b] > 0) least = std::min(least, std::size_t(steps[b]) + 1);
    }
    EXPECT_EQ(least, 10u);
}

TEST(Lattice, HasFifteenRingsOfTenEdgesThroughEachVertexOfTheNetSrs)
{
    const Graph graph = lattice_of({.kind = Net::srs, .cells = {4, 4, 4}, .size = {}});
    std::vector<std::vector<std::uint32_t>> next(graph.vertices.size());
    for (const auto& [a, b] : graph.edges) {
        next[a].push_back(b);
        next[b].push_back(a);
    }
    std::uint32_t middle = 0; // a ring reaches no farther than five bonds, and the cells are four times 2.8 wide
    for (std::uint32_t v = 0; v < next.size(); ++v)
        if (glm::length(graph.vertices[v]) < glm::length(graph.vertices[middle])) middle = v;
    std::vector<std::uint32_t> way{middle};
    int rings = 0;
    const auto walk = [&](auto&& self) -> void {
        for (const std::uint32_t v : next[way.back()]) {
            if (way.size() == 10) rings += v == middle;
            else if (std::ranges::find(way, v) == way.end()) {
                way.push_back(v);
                self(self);
                way.pop_back();
            }
        }
    };
    walk(walk);
    EXPECT_EQ(rings, 2 * 15); // each in both directions
}

TEST(Lattice, IsCutToABallOfAnySize)
{
    const Graph small = lattice_of({.cells = {2, 2, 2}, .trim = Trim::ball, .size = 0.5});
    EXPECT_EQ(row(small), (Row{5, 4, 1, 0})); // a vertex with its neighbours: the next ones are 2 √2 away
    EXPECT_THROW(lattice_of({.trim = Trim::ball, .size = 0.1}), CommandError);
    for (const double size : {100.0, 1e9, 1e300}) EXPECT_THROW(lattice_of({.trim = Trim::ball, .size = size}), CommandError);
    // It may go beyond the cells, whose middle it keeps: the same as in more of them.
    const Graph beyond = lattice_of({.kind = Net::srs, .cells = {2, 2, 2}, .twin = true, .trim = Trim::ball, .size = 2.1});
    EXPECT_EQ(beyond, lattice_of({.kind = Net::srs, .cells = {6, 6, 6}, .twin = true, .trim = Trim::ball, .size = 2.1}));
}

TEST(Lattice, ReachesNoFartherThanNumbersDo)
{
    const auto with_bond = [](double bond) {
        LatticeShape shape;
        shape.bond = bond;
        return shape;
    };
    EXPECT_NO_THROW(lattice_of(with_bond(1e37)));
    for (const double bond : {1e38, 1e308}) EXPECT_THROW(lattice_of(with_bond(bond)), CommandError);
}

TEST(Lattice, CanBeCancelled)
{
    Progress progress;
    progress.cancel();
    EXPECT_THROW(lattice({}, progress), Cancelled);
}

} // namespace
} // namespace druse
