#include "graph/map.h"

#include "dlfl/errors.h"
#include "geom/angle.h"
#include "graph/graph_facts.h"
#include "graph/map_knot.h"
#include "graph/tess.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace druse {
namespace {

Graph tess(const TessShape& shape)
{
    Progress progress;
    return tessellate(shape, false, progress).graph;
}

Graph mapped(const Graph& graph, const MapShape& shape, const Graph& solid = {})
{
    Progress progress;
    std::vector<std::string> notes;
    return map_disk(graph, shape, solid, notes, progress);
}

std::string complaint_of_map(const Graph& graph, const MapShape& shape, const Graph& solid = {})
{
    try {
        mapped(graph, shape, solid);
    } catch (const CommandError& e) {
        return e.what();
    }
    return "(none)";
}

const TessShape fives{.config = {5, 4, 5, 4}, .center_number = 5, .layers = 1};

Graph unit_octahedron()
{
    Graph g{.vertices = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, .edges = {}};
    for (std::uint32_t a = 0; a < 6; ++a)
        for (std::uint32_t b = a + 1; b < 6; ++b)
            if (b != a + 3) g.edges.push_back({a, b});
    return g;
}

/// How far the points of a graph are from those of the same graph turned about the z axis.
double asymmetry(const Graph& graph, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    double most = 0;
    for (const Point& p : graph.vertices) {
        const Point q(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
        double least = 1e9;
        for (const Point& other : graph.vertices) least = std::min(least, glm::distance(q, other));
        most = std::max(most, least);
    }
    return most;
}

TEST(Trefoil, HasTheThicknessOfItsCurve)
{
    const Trefoil line(2, 1);
    EXPECT_NEAR(line.least_radius_of_curvature(), 1.4303, 5e-5);
    EXPECT_NEAR(0.5 * line.least_strand_distance(), 0.8316, 5e-5);
    EXPECT_EQ(line.thickness(), 0.5 * line.least_strand_distance());
    EXPECT_NEAR(Trefoil(20, 10).thickness(), 10 * line.thickness(), 1e-8); // it grows with the curve
    // A thin tube about a circle run through twice: the strands are at most twice the swing apart.
    EXPECT_LT(Trefoil(2, 0.1).thickness(), 0.1 + 1e-12);
}

TEST(Trefoil, HasAFrameThatComesBackToItself)
{
    const Trefoil line(2, 1);
    EXPECT_TRUE(line.is_bent());
    const auto first = line.frame(0), last = line.frame(2 * pi), third = line.frame(2 * pi / 3);
    EXPECT_NEAR(glm::distance(first.place, last.place) + glm::distance(first.normal, last.normal) + glm::distance(first.binormal, last.binormal), 0, 1e-13);
    EXPECT_NEAR(glm::dot(third.normal, third.binormal), 0, 1e-15);
    EXPECT_NEAR(glm::length(third.normal), 1, 1e-15);
    // Frenet's normal points to where the curve bends.
    const double h = 1e-4;
    const Vector bend = line.frame(h).place - 2.0 * first.place + line.frame(-h).place;
    EXPECT_GT(glm::dot(bend, first.normal), 0);
}

TEST(MapDisk, LeavesTheDiskFlatOrLiftsIt)
{
    const Graph disk = tess({});
    EXPECT_EQ(mapped(disk, {.size = 2}).vertices[5], 2.0 * disk.vertices[5]);
    EXPECT_FALSE(mapped(disk, {}).disk);
    const Graph polyp = mapped(disk, {.to = MapTo::polyp, .rim = 0.5, .height = 0.8});
    for (std::size_t v = 0; v < disk.vertices.size(); ++v) {
        const double r = glm::length(disk.vertices[v]), part = (r - 0.5) / 0.5;
        EXPECT_NEAR(polyp.vertices[v].z, 0.8 * (1 - part * part), 1e-15);
    }
    const Graph waves = mapped(disk, {.to = MapTo::polyp, .height_expr = "0.1*sin(7*t)*r^2"});
    for (std::size_t v = 0; v < disk.vertices.size(); ++v) {
        const Point& p = disk.vertices[v];
        EXPECT_NEAR(waves.vertices[v].z, 0.1 * std::sin(7 * std::atan2(p.y, p.x)) * (p.x * p.x + p.y * p.y), 1e-15);
    }
}

TEST(MapDisk, SweepsToAHelixInASphereOrACylinder)
{
    // Four turns of 25 vertices; the edges over the ends go, but none of the vertices.
    const Graph ball = mapped(tess(fives), {.to = MapTo::helix});
    EXPECT_EQ(ball.vertices.size(), 100u);
    EXPECT_EQ(facts(ball).components, 1u);
    double highest = 0;
    for (const Point& p : ball.vertices) {
        EXPECT_LT(glm::length(p), 1);
        highest = std::max(highest, p.z);
    }
    EXPECT_LT(highest, std::sin(0.45 * pi));
    const Graph spring = mapped(tess(fives), {.to = MapTo::helix, .turns = 3, .shape = HelixShape::cylinder, .pitch = 2});
    double low = 0, high = 0;
    for (const Point& p : spring.vertices) {
        low = std::min(low, p.z);
        high = std::max(high, p.z);
        EXPECT_LT(std::hypot(p.x, p.y), 1);
    }
    EXPECT_NEAR(low, -6, 1e-12);
    EXPECT_GT(high, 5);
}

TEST(MapDisk, SweepsRoundATorusWithTheSymmetryOfItsCentre)
{
    const Graph disk = tess(fives), five = mapped(disk, {.to = MapTo::torus}), three = mapped(disk, {.to = MapTo::torus, .cycles = 3});
    EXPECT_EQ(five.vertices.size(), 5 * disk.vertices.size());
    EXPECT_EQ(five.edges.size(), 5 * disk.edges.size());
    EXPECT_LT(asymmetry(five, 2 * pi / 5), 1e-12);
    EXPECT_GT(asymmetry(three, 2 * pi / 5), 1e-2);
    for (const Point& p : five.vertices) EXPECT_LT(std::hypot(std::hypot(p.x, p.y) - 1.6, p.z), 1);
}

TEST(MapDisk, SweepsAlongAKnotWithThreefoldSymmetry)
{
    const Graph disk = tess({.config = {7, 6, 6}, .layers = 1}), knot = mapped(disk, {.to = MapTo::knot});
    EXPECT_EQ(knot.vertices.size(), 9 * disk.vertices.size());
    EXPECT_EQ(knot.edges.size(), 9 * disk.edges.size());
    EXPECT_LT(asymmetry(knot, 2 * pi / 3), 1e-12);
    Progress progress;
    std::vector<std::string> notes;
    const Graph other = map_disk(disk, {.to = MapTo::knot, .cycles = 8, .rho = 0.83}, {}, notes, progress);
    EXPECT_GT(asymmetry(other, 2 * pi / 3), 1e-3);
    EXPECT_EQ(notes, (std::vector<std::string>{"cycles=8 is no multiple of 3, so the knot is not the same after a third of a turn"}));
    EXPECT_EQ(complaint_of_map(disk, {.to = MapTo::knot, .rho = 0.84}), "rho=0.84: expected less than 0.8316, or the tube would meet itself; force=true allows that");
    EXPECT_EQ(complaint_of_map(disk, {.to = MapTo::knot, .rho = 0.84, .force = true}), "(none)");
    EXPECT_EQ(complaint_of_map(disk, {.to = MapTo::knot, .minor = 2}), "minor=2: expected less than major=2");
    EXPECT_EQ(complaint_of_map(disk, {.to = MapTo::torus, .rho = 1.6}), "rho=1.6: expected less than major=1.6, or the tube would meet itself");
}

TEST(MapDisk, PutsSectorsInPlaceOfEdges)
{
    const Graph lace = mapped(tess(fives), {.to = MapTo::polyhedron}, unit_octahedron());
    EXPECT_EQ(facts(lace).components, 1u);
    EXPECT_GT(facts(lace).shortest_edge, 1e-3);
    EXPECT_LT(asymmetry(lace, pi / 2), 1e-12);
    TessShape turned = fives;
    turned.turn = 33;
    const Graph same = mapped(tess(turned), {.to = MapTo::polyhedron}, unit_octahedron());
    ASSERT_EQ(same.edges, lace.edges);
    for (std::size_t v = 0; v < same.vertices.size(); ++v) EXPECT_LT(glm::distance(same.vertices[v], lace.vertices[v]), 1e-12);
    // Pieces of arcs are cut at the rays as edges are.
    for (const int arc : {2, 3}) {
        TessShape bent = fives;
        bent.arc = arc;
        const Graph arcs = mapped(tess(bent), {.to = MapTo::polyhedron}, unit_octahedron());
        EXPECT_EQ(facts(arcs).cycle_rank, facts(lace).cycle_rank);
    }
}

TEST(MapDisk, RefusesWhatHasNotTheCentreItNeeds)
{
    EXPECT_EQ(complaint_of_map(unit_octahedron(), {}), "expected a tessellation of the disk, as graph.tess makes one; a file keeps only its points and lines");
    EXPECT_EQ(complaint_of_map(mapped(tess({}), {}), {}), "expected a tessellation of the disk, as graph.tess makes one; a file keeps only its points and lines");
    EXPECT_EQ(complaint_of_map(tess({.model = DiskModel::halfplane}), {}), "expected a tessellation of the disk, as graph.tess makes one; a file keeps only its points and lines");
    for (const MapTo to : {MapTo::helix, MapTo::torus, MapTo::knot, MapTo::polyhedron}) {
        EXPECT_EQ(complaint_of_map(tess({.center = Disk::Center::vertex}), {.to = to}, unit_octahedron()),
                  "expected a face at the centre, not a vertex; graph.tess with center=face or face:N makes one");
        EXPECT_EQ(complaint_of_map(tess({.center = Disk::Center::edge}), {.to = to}, unit_octahedron()),
                  "expected a face at the centre, not an edge; graph.tess with center=face or face:N makes one");
        EXPECT_EQ(complaint_of_map(tess({.shift_x = 0.1}), {.to = to}, unit_octahedron()), "expected a face at the centre; the tessellation was shifted away from it");
    }
    EXPECT_EQ(complaint_of_map(tess({.config = {5, 3, 4, 3, 3}}), {.to = MapTo::polyhedron}, unit_octahedron()),
              "expected mirror rays through the corners of the face at the centre; this face of 5 sides has none, or the tessellation is chiral");
    EXPECT_EQ(complaint_of_map(tess({.config = {7, 6, 6}, .center_number = 6}), {.to = MapTo::polyhedron}, unit_octahedron()),
              "expected mirror rays through the corners of the face at the centre; this face of 6 sides has none, or the tessellation is chiral");
    EXPECT_EQ(complaint_of_map(tess({.center = Disk::Center::vertex, .layers = 0}), {}), "the graph has no edges");
}

TEST(MapDisk, SaysWhereAFormulaHasNoValue)
{
    EXPECT_EQ(complaint_of_map(tess({.center = Disk::Center::vertex}), {.to = MapTo::polyp, .height_expr = "log(r)"}),
              "height_expr=log(r): log(0) is not a finite number, at vertex 0 (0, 0)");
    EXPECT_EQ(complaint_of_map(tess({}), {.to = MapTo::polyp, .height_expr = "2*"}), "height_expr=2*: expected a value at the end");
    EXPECT_EQ(complaint_of_map(tess({}), {.size = 1e39}), "vertex 0 would lie beyond 1e+38");
}

} // namespace
} // namespace druse
