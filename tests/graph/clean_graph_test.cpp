#include "graph/clean_graph.h"

#include "dlfl/errors.h"
#include "graph/edge_graph.h"
#include "graph/incidence.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace druse {
namespace {

CleanGraph cleaned(const Graph& graph, double weld, GraphRepairs& repairs)
{
    Progress progress;
    return druse::cleaned(graph, weld, repairs, progress);
}

std::string complaint(const Graph& graph, double weld = 0)
{
    GraphRepairs repairs;
    try {
        cleaned(graph, weld, repairs);
    } catch (const CommandError& e) {
        return e.what();
    }
    return "(none)";
}

TEST(CleanGraph, KeepsARepeatedEdgeOnce)
{
    GraphRepairs repairs;
    const CleanGraph clean = cleaned({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1}, {1, 2}, {1, 0}, {0, 1}}}, 0, repairs);
    EXPECT_EQ(clean.graph.edges, (std::vector<std::array<std::uint32_t, 2>>{{0, 1}, {1, 2}}));
    EXPECT_EQ(repairs.notes(), std::vector<std::string>{"2 edges were there already: kept once"});
}

TEST(CleanGraph, WeldsVerticesAtTheSamePlaceAndLeavesOutThoseWithoutAnEdge)
{
    const Graph graph{{{5, 5, 5}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {{1, 2}, {3, 4}, {5, 6}}};
    GraphRepairs repairs;
    const CleanGraph clean = cleaned(graph, 0, repairs);
    EXPECT_EQ(clean.graph.vertices, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
    EXPECT_EQ(clean.graph.edges, (std::vector<std::array<std::uint32_t, 2>>{{0, 1}, {1, 2}}));
    EXPECT_EQ(clean.vertex_ids, (std::vector<std::uint32_t>{1, 2, 4}));
    EXPECT_EQ(clean.edge_ids, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(repairs.welded, 3u);
    EXPECT_EQ(repairs.repeated, 1u);
    EXPECT_EQ(repairs.isolated, 1u);
}

TEST(CleanGraph, WeldsWithinAToleranceOnly)
{
    const Graph graph{{{0, 0, 0}, {1, 0, 0}, {1, 0.01, 0}, {2, 0, 0}}, {{0, 1}, {2, 3}}};
    GraphRepairs exact, near;
    EXPECT_EQ(cleaned(graph, 0, exact).graph.vertices.size(), 4u);
    EXPECT_EQ(cleaned(graph, 0.01, near).graph.vertices.size(), 3u);
    EXPECT_EQ(near.welded, 1u);
}

TEST(CleanGraph, SaysWhatCannotBeMended)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(complaint({{{0, 0, 0}, {0, 0, 0}}, {{0, 1}}}), "edge 0 of the graph has no length: it ends at vertex 0 where it begins");
    EXPECT_EQ(complaint({{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}}, {{0, 1}, {1, 2}}}, 0.6), "edge 0 of the graph has no length: it ends at vertex 0 where it begins");
    EXPECT_EQ(complaint({{{0, 0, 0}, {nan, 0, 0}}, {{0, 1}}}), "vertex 1 of the graph lies beyond 1e+38");
    EXPECT_EQ(complaint({{{0, 0, 0}, {1, 0, 0}}, {{0, 2}}}), "edge 0 of the graph names vertex 2, there are 2");
    EXPECT_EQ(complaint({{{0, 0, 0}}, {}}), "the graph has no edges");
}

TEST(EdgeGraph, HasTheEdgesOfAMeshWithTheMeanNormalsOfTheirFaces)
{
    const Mesh cube = test::cube();
    std::vector<Edge> all(cube.edges().begin(), cube.edges().end());
    const Graph graph = edge_graph(cube, all);
    EXPECT_EQ(graph.vertices.size(), 8u);
    ASSERT_EQ(graph.edges.size(), 12u);
    for (std::size_t e = 0; e < 12; ++e) {
        // From the middle of the cube to the middle of the edge.
        const Vector out = unit(0.5 * (graph.vertices[graph.edges[e][0]] + graph.vertices[graph.edges[e][1]]));
        EXPECT_NEAR(glm::distance(graph.normals[e], out), 0, 1e-12);
    }
    const Graph one = edge_graph(cube, std::vector{Edge(5)});
    EXPECT_EQ(one.vertices.size(), 2u);
    EXPECT_EQ(one.edges.size(), 1u);
}

TEST(EdgeGraph, LeavesOutLoops)
{
    const Mesh mesh = test::cube_with_loop();
    const std::vector<Edge> all(mesh.edges().begin(), mesh.edges().end());
    EXPECT_EQ(edge_graph(mesh, all).edges.size(), 12u);
}

TEST(Incidence, ListsTheEndsAtEachVertexInOrder)
{
    const Graph graph{{Point(0), Point(1), Point(2)}, {{0, 1}, {2, 0}, {1, 0}}};
    const Incidence incidence(graph);
    const auto at = [&](std::size_t v) { return std::vector<std::uint32_t>(incidence.ends(v).begin(), incidence.ends(v).end()); };
    EXPECT_EQ(at(0), (std::vector<std::uint32_t>{0, 3, 5}));
    EXPECT_EQ(at(1), (std::vector<std::uint32_t>{1, 4}));
    EXPECT_EQ(incidence.valence(2), 1u);
}

} // namespace
} // namespace druse
