// Struts around graphs of every kind: closed, oriented, of the genus of the graph, and embedded where the parts keep apart.
#include "graph/strut_surface.h"

#include "dlfl/errors.h"
#include "dlfl/self_intersections.h"
#include "geom/angle.h"
#include "graph/clean_graph.h"
#include "graph/edge_graph.h"
#include "graph/graph_facts.h"
#include "graph/lattice.h"
#include "graph/strut_ball.h"
#include "graph/strut_contacts.h"
#include "graph/strut_rim.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

namespace druse {
namespace {

using namespace test;

struct Made {
    CleanGraph clean;
    StrutSurface surface;
    bool clear = false;         // nothing comes near what it is not joined to
    std::uint64_t contacts = 0; // of pairs of parts that do
};

Made make(const Graph& graph, const StrutShape& shape)
{
    Progress progress;
    GraphRepairs repairs;
    Made made{cleaned(graph, 0, repairs, progress), {}, false, 0};
    const Graph& g = made.clean.graph;
    const Incidence incidence(g);
    const StrutPlacer placer(made.clean, incidence, shape);
    const StrutPlacement placement = placer.place();
    const StrutNeighbours neighbours(g, incidence);
    const NearParts near = neighbours.near(placement, 0, progress);
    made.clear = near.pairs.empty();
    made.surface = strut_surface(g, incidence, placer, placement, shape, progress);
    StrutContacts met;
    neighbours.add_contacts(made.surface, near.pairs, met, progress);
    made.contacts = met.pairs;
    return made;
}

/// What holds of all struts. @return whether they are also known to keep apart
bool expect_solid(const Graph& graph, const StrutShape& shape)
{
    const Made made = make(graph, shape);
    const Mesh& mesh = made.surface.mesh;
    const GraphFacts of_graph = facts(made.clean.graph);
    EXPECT_SOUND(mesh);
    EXPECT_EQ(mesh.boundary_count(), 0u);
    EXPECT_EQ(genus(mesh), of_graph.cycle_rank);
    EXPECT_EQ(components(mesh).parts.size(), of_graph.components);
    EXPECT_GT(volume(mesh), 0);
    Progress progress;
    const std::uint64_t met = self_intersections(mesh, progress).pairs;
    EXPECT_EQ(met, made.contacts);
    if (made.clear) {
        EXPECT_EQ(met, 0u);
    }
    return made.clear;
}

Graph without_normals(const Mesh& mesh)
{
    Graph graph = edge_graph(mesh, std::vector<Edge>(mesh.edges().begin(), mesh.edges().end()));
    graph.normals.clear();
    return graph;
}

Graph star(const std::vector<Vector>& directions)
{
    Graph graph{{Point(0.3, -0.2, 0.1)}, {}};
    for (const Vector& d : directions) {
        graph.edges.push_back({0, static_cast<std::uint32_t>(graph.vertices.size())});
        graph.vertices.push_back(graph.vertices[0] + d);
    }
    return graph;
}

Vector on_cone(double half_angle, double around)
{
    const double a = radians(half_angle), b = radians(around);
    return {std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
}

TEST(StrutSurface, HasTheCountsOfItsFormulas)
{
    for (const Mesh& solid : {cube(), tetrahedron(), octahedron(), icosahedron(), dodecahedron()})
        for (const int sides : {3, 4, 6, 8, 13}) {
            const Graph graph = without_normals(solid);
            SCOPED_TRACE(testing::Message() << graph.edges.size() << " edges, " << sides << " sides");
            const auto n = static_cast<std::uint32_t>(sides), v = static_cast<std::uint32_t>(graph.vertices.size()), e = static_cast<std::uint32_t>(graph.edges.size());
            const Mesh plain = make(graph, {.sides = sides, .merge = false}).surface.mesh;
            const std::uint32_t apexes = plain.vertex_count() - 2 * n * e;
            EXPECT_LE(apexes, v);
            EXPECT_EQ(plain.face_count(), n * e + 2 * e * (n + 2) - 4 * v + 2 * apexes);
            const Mesh triangles = make(graph, {.sides = sides, .triangulate = true}).surface.mesh;
            EXPECT_EQ(triangles.face_count(), 4 * (n + 1) * e - 4 * v + 2 * apexes);
            EXPECT_EQ(2 * triangles.edge_count(), 3 * triangles.face_count());
            const Mesh merged = make(graph, {.sides = sides}).surface.mesh;
            EXPECT_EQ(merged.vertex_count(), plain.vertex_count());
            EXPECT_LE(merged.face_count(), plain.face_count());
            for (const bool merge : {true, false}) EXPECT_TRUE(expect_solid(graph, {.sides = sides, .merge = merge}));
        }
}

TEST(StrutSurface, HasTheCountsOfTheAxisAlignedCube)
{
    // Vertices, faces, and faces after merging. With three and four sides each apex is a vertex; with 6 and 8 none is needed.
    const std::array<std::array<std::uint32_t, 3>, 4> expected{{{76, 132, 118}, {104, 176, 128}, {144, 232, 184}, {192, 304, 208}}};
    const std::array<int, 4> sides{3, 4, 6, 8};
    for (std::size_t i = 0; i < 4; ++i) {
        const Mesh plain = make(without_normals(cube()), {.sides = sides[i], .merge = false}).surface.mesh;
        const Mesh merged = make(without_normals(cube()), {.sides = sides[i]}).surface.mesh;
        EXPECT_EQ((std::array{plain.vertex_count(), plain.face_count(), merged.face_count()}), expected[i]) << sides[i];
    }
}

TEST(StrutSurface, HasTheCountsOfTheDiamond)
{
    const std::array<std::array<std::uint32_t, 3>, 4> expected{{{773, 1310, 1150}, {1024, 1668, 1448}, {1536, 2404, 1684}, {2048, 3140, 2880}}};
    const std::array<int, 4> sides{3, 4, 6, 8};
    Progress progress;
    const Graph graph = lattice({}, progress);
    for (std::size_t i = 0; i < 4; ++i) {
        const Made made = make(graph, {.sides = sides[i], .merge = false});
        const Mesh &plain = made.surface.mesh, merged = make(graph, {.sides = sides[i]}).surface.mesh;
        EXPECT_EQ((std::array{plain.vertex_count(), plain.face_count(), merged.face_count()}), expected[i]) << sides[i];
        EXPECT_EQ(genus(merged), 38);
        EXPECT_TRUE(expect_solid(graph, {.sides = sides[i]}));
    }
}

TEST(StrutSurface, IsTwoSolidsAroundInterlockedNets)
{
    Progress progress;
    for (const Net kind : {Net::diamond, Net::srs})
        EXPECT_TRUE(expect_solid(lattice({.kind = kind, .twin = true, .size = {}}, progress), {}));
}

TEST(StrutSurface, StaysSolidAroundStarsOfAnyAngle)
{
    for (const double half_angle : {0.012, 0.05, 0.5, 5.0, 30.0, 60.0, 90.0, 120.0, 170.0, 179.9})
        for (const std::uint32_t edges : {2u, 3u, 4u, 7u})
            for (const int sides : {3, 6}) {
                SCOPED_TRACE(testing::Message() << edges << " edges at " << half_angle << " degrees, " << sides << " sides");
                std::vector<Vector> directions;
                for (std::uint32_t i = 0; i < edges; ++i) directions.push_back((1 + 0.1 * i) * on_cone(half_angle, 360.0 * i / edges + 11));
                // Seven edges that near each other are less than 0.01° apart.
                if (edges == 7 && half_angle < 0.02) continue;
                expect_solid(star(directions), {.sides = sides});
                expect_solid(star(directions), {.radius = 0.4, .sides = sides, .ball = 3, .gap = 0.99, .spread = 80});
            }
}

TEST(StrutSurface, StaysSolidAroundFansChainsRingsAndTrees)
{
    for (const double step : {0.02, 0.05, 1.0, 20.0, 72.0})
        for (const int count : {2, 3, 5}) {
            std::vector<Vector> directions;
            for (int i = 0; i < count; ++i) directions.push_back(on_cone(90, 5 + i * step));
            SCOPED_TRACE(testing::Message() << count << " edges, " << step << " degrees");
            expect_solid(star(directions), {});
        }
    Graph chain{{Point(0)}, {}}, ring{{}, {}}, tree{{Point(0)}, {}};
    for (std::uint32_t i = 0; i < 9; ++i) {
        chain.vertices.push_back(Point(0.1, 0.2, 0.3) * double(i + 1));
        chain.edges.push_back({i, i + 1});
        ring.vertices.push_back(on_cone(90, 40 * i));
        ring.edges.push_back({i, (i + 1) % 9});
    }
    std::mt19937 random(3);
    std::uniform_real_distribution<double> at(-1, 1);
    for (std::uint32_t i = 1; i < 40; ++i) {
        tree.vertices.push_back(10.0 * Point(at(random), at(random), at(random)));
        tree.edges.push_back({static_cast<std::uint32_t>(random() % i), i});
    }
    for (const StrutCap cap : {StrutCap::flat, StrutCap::round, StrutCap::point})
        for (const int sides : {3, 6}) {
            EXPECT_TRUE(expect_solid(chain, {.sides = sides, .cap = cap}));
            EXPECT_TRUE(expect_solid(ring, {.sides = sides, .cap = cap}));
            expect_solid(tree, {.radius = 0.02, .sides = sides, .cap = cap});
        }
}

TEST(StrutSurface, MakesABarOfASingleEdge)
{
    const Graph bar{{{0, 0, 0}, {0, 0, 2}}, {{0, 1}}};
    // A prism; with pointed ends; and with half balls: 2 n + 1 more vertices at each end, 3 n faces instead of one.
    EXPECT_EQ(counts(make(bar, {}).surface.mesh), (Counts{12, 18, 8}));
    EXPECT_EQ(counts(make(bar, {.cap = StrutCap::point}).surface.mesh), (Counts{14, 30, 18}));
    EXPECT_EQ(counts(make(bar, {.cap = StrutCap::round}).surface.mesh), (Counts{38, 78, 42}));
    EXPECT_EQ(make(bar, {.cap = StrutCap::round, .triangulate = true}).surface.mesh.face_count(), 12u + 2 * 30);
    EXPECT_NEAR(volume(make(bar, {.radius = 0.5, .scale = StrutScale::absolute, .sides = 4}).surface.mesh), 2 * 0.5, 1e-12); // 2 r² high 2
    for (const StrutCap cap : {StrutCap::flat, StrutCap::round, StrutCap::point})
        for (const bool triangulate : {true, false}) EXPECT_TRUE(expect_solid(bar, {.cap = cap, .triangulate = triangulate}));
}

TEST(StrutSurface, StaysSolidWhateverItsParameters)
{
    const Graph graph = without_normals(dodecahedron());
    for (const double twist : {-100.0, 0.0, 13.0, 60.0, 47.0, 90.0, 359.0}) EXPECT_TRUE(expect_solid(graph, {.radius = 0.05, .twist = twist}));
    for (const double phase : {-20.0, 30.0, 45.0}) EXPECT_TRUE(expect_solid(graph, {.phase = phase}));
    for (const double spread : {5.0, 20.0, 80.0}) EXPECT_TRUE(expect_solid(graph, {.spread = spread}));
    for (const double gap : {0.1, 0.5, 0.99}) EXPECT_TRUE(expect_solid(graph, {.gap = gap}));
    for (const double ball : {2.0, 10.0}) EXPECT_TRUE(expect_solid(graph, {.radius = 0.05, .ball = ball}));
    for (const double radius : {1e-4, 1.0, 100.0}) EXPECT_TRUE(expect_solid(graph, {.radius = radius}));
    EXPECT_TRUE(expect_solid(graph, {.sides = 64}));
}

TEST(StrutSurface, TwistsByTheLeastTurnThatLooksTheSame)
{
    const Graph bar{{{0, 0, 0}, {0, 0, 2}}, {{0, 1}}};
    const Mesh straight = make(bar, {}).surface.mesh, sixth = make(bar, {.twist = 60}).surface.mesh, skew = make(bar, {.twist = 70}).surface.mesh;
    EXPECT_EQ(counts(sixth), counts(straight));
    EXPECT_NEAR(volume(sixth), volume(straight), 1e-12);
    EXPECT_EQ(skew.face_count(), 14u); // each quad cut in two, along the ridge
    // Between a prism and the hull of both ends: convex, so no vertex is above a face.
    for (const Face f : skew.faces())
        for (const Vertex v : skew.vertices()) EXPECT_LT(glm::dot(unit_normal(skew, f), skew.position(v) - skew.position(skew.corner(f))), 1e-12);
}

TEST(StrutSurface, PutsCornerZeroWhereTheFrameSays)
{
    const Graph lines = without_normals(cube());
    Graph with_normals = edge_graph(cube(), std::vector<Edge>(cube().edges().begin(), cube().edges().end()));
    const auto corner = [](const Made& made, std::uint32_t e) {
        const auto& [a, b] = made.clean.graph.edges[e];
        const Point first = made.surface.mesh.position(Vertex(2 * e * 6)), base = made.clean.graph.vertices[a];
        const Vector along = unit(made.clean.graph.vertices[b] - base);
        return unit((first - base) - glm::dot(first - base, along) * along);
    };
    for (std::uint32_t e = 0; e < 12; ++e) {
        const Vector along = lines.vertices[lines.edges[e][1]] - lines.vertices[lines.edges[e][0]];
        EXPECT_LT(glm::distance(corner(make(lines, {}), e), std::abs(along.z) > 0.5 ? Vector(1, 0, 0) : Vector(0, 0, 1)), 1e-9);
        EXPECT_LT(glm::distance(corner(make(with_normals, {}), e), with_normals.normals[e]), 1e-9);
        EXPECT_LT(glm::distance(corner(make(with_normals, {.frame = StrutFrame::axis}), e), corner(make(lines, {}), e)), 1e-9);
    }
}

TEST(StrutSurface, KeepsGroupsAndPartsOfAllFaces)
{
    const Graph wye = star({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    const StrutSurface made = make(wye, {}).surface;
    std::vector<int> part(made.mesh.face_count(), 0);
    const auto expect_group = [&](const std::vector<Face>& faces, int group) {
        EXPECT_FALSE(faces.empty());
        for (const Face f : faces) {
            EXPECT_EQ(made.mesh.group(f), group);
            ++part[f.index];
        }
    };
    expect_group(made.table.ball(made.mesh, 0), strut_group::ball);
    for (std::uint32_t e = 0; e < 3; ++e) expect_group(made.table.strut(made.mesh, e), strut_group::strut);
    for (std::uint32_t v = 1; v < 4; ++v) expect_group(made.table.ball(made.mesh, v), strut_group::cap);
    EXPECT_EQ(part, std::vector<int>(part.size(), 1));
    EXPECT_TRUE(made.table.strut(made.mesh, 3).empty());
    EXPECT_TRUE(made.table.ball(cube(), 0).empty());
}

TEST(StrutSurface, KnowsItsPartsNoMoreWhenOtherFacesHaveComeToTheirPlaces)
{
    const StrutSurface made = make(star({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), {.merge = false}).surface;
    Mesh mesh = made.mesh;
    mesh.set_position(Vertex(0), Point(7));
    EXPECT_EQ(made.table.strut(mesh, 0), made.table.strut(made.mesh, 0));
    // The other diagonal of two triangles of the ball: as many vertices, edges and faces as before.
    for (const Edge e : made.mesh.edges()) {
        const auto [f, g] = made.mesh.faces(e);
        if (made.mesh.valence(f) != 3 || made.mesh.valence(g) != 3 || f == g) continue;
        const Vertex a = made.mesh.vertex(made.mesh.previous(made.mesh.corner(e, 0))), b = made.mesh.vertex(made.mesh.previous(made.mesh.corner(e, 1)));
        mesh.delete_edge(e);
        Corner from, to;
        for (const Face face : mesh.faces())
            if (mesh.valence(face) == 4)
                for (const Corner c : mesh.corners(face)) {
                    const Vertex opposite = mesh.vertex(mesh.next(mesh.next(c)));
                    if (mesh.vertex(c) == a && opposite == b) from = c, to = mesh.next(mesh.next(c));
                }
        mesh.insert_edge(from, to);
        break;
    }
    mesh.compact();
    EXPECT_SOUND(mesh);
    EXPECT_EQ(counts(mesh), counts(made.mesh));
    EXPECT_TRUE(made.table.strut(mesh, 0).empty());
    EXPECT_TRUE(made.table.ball(mesh, 0).empty());
}

class RandomGraphs : public testing::TestWithParam<unsigned> {};

TEST_P(RandomGraphs, BecomeSolidsThatMeetThemselvesOnlyWhereTheyAreNear)
{
    int solids = 0, clear = 0;
    for (unsigned seed = 50 * GetParam(); seed < 50 * (GetParam() + 1); ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> at(0, 1);
        Graph graph;
        const std::uint32_t points = 8 + random() % 10;
        for (std::uint32_t i = 0; i < points; ++i) graph.vertices.emplace_back(at(random), at(random), at(random));
        for (std::uint32_t i = 0; i < points; ++i)
            for (std::uint32_t j = i + 1; j < points; ++j)
                if (glm::distance(graph.vertices[i], graph.vertices[j]) < 0.45) graph.edges.push_back({i, j});
        if (graph.edges.empty()) continue;
        StrutShape shape{.radius = 0.003 + 0.02 * at(random), .scale = StrutScale::absolute, .sides = 3 + static_cast<int>(random() % 5)};
        shape.merge = random() % 2 == 0;
        shape.cap = static_cast<StrutCap>(random() % 3);
        shape.twist = random() % 3 == 0 ? 100 * at(random) : 0;
        clear += expect_solid(graph, shape);
        ++solids;
    }
    EXPECT_GE(solids, 45);
    EXPECT_GE(clear, 5);
}
INSTANTIATE_TEST_SUITE_P(Seeds, RandomGraphs, testing::Range(0u, 10u));

TEST(StrutSurface, RefusesWhatCoordinatesCannotTell)
{
    EXPECT_THROW(make(star({on_cone(0.001, 0), on_cone(0.001, 120), on_cone(0.001, 240)}), {}), CommandError); // overlap
    Graph far = star({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    for (Point& p : far.vertices) p += Point(1e15);
    EXPECT_THROW(make(far, {.radius = 0.01}), CommandError);
    EXPECT_THROW(make({{Point(1e20), Point(1e20, 1e20, 1.1e20)}, {{0, 1}}}, {.radius = 1e-3, .scale = StrutScale::absolute}), CommandError);
    EXPECT_THROW(make({{Point(0), Point(0, 0, 1e-60)}, {{0, 1}}}, {}), CommandError);
    EXPECT_THROW(make({{Point(0), Point(0, 0, 1)}, {{0, 1}}}, {.radius = 1e-60, .scale = StrutScale::absolute}), CommandError);
}

TEST(StrutSurface, KeepsCornersApartOrRefusesHoweverThinStrutsAre)
{
    const Graph graph{{Point(0.1, 0.7, -0.4), Point(1.3, 0.2, 0.6), Point(0.9, 1.1, 2.3)}, {{0, 1}, {1, 2}}};
    std::uint32_t made = 0;
    for (double radius = 1e-10; radius > 1e-18; radius *= 0.7)
        for (const StrutCap cap : {StrutCap::flat, StrutCap::round, StrutCap::point}) {
            try {
                const Made thin = make(graph, {.radius = radius, .scale = StrutScale::absolute, .cap = cap});
                const auto places = thin.surface.mesh.positions();
                std::vector<Point> points(places.begin(), places.end());
                const auto less = [](const Point& a, const Point& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
                std::sort(points.begin(), points.end(), less);
                EXPECT_EQ(std::adjacent_find(points.begin(), points.end()), points.end()) << radius;
                ++made;
            } catch (const CommandError&) {
                EXPECT_LT(radius, 1e-12);
            }
        }
    EXPECT_GT(made, 3u);
}

TEST(StrutSurface, IsTheSameWhateverThreadsMakeIt)
{
    Progress progress;
    const Graph graph = lattice({.cells = {3, 3, 3}, .size = {}}, progress);
    const Mesh first = make(graph, {}).surface.mesh;
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(make(graph, {}).surface.mesh == first);
}

TEST(StrutSurface, CanBeCancelledAlsoWithinOneBall)
{
    Progress progress;
    std::vector<Vector> directions;
    for (int i = 0; i < 300; ++i) directions.push_back(on_cone(degrees(std::acos(1 - (i + 0.5) / 150)), 137.5 * i));
    GraphRepairs repairs;
    const CleanGraph clean = cleaned(star(directions), 0, repairs, progress);
    const Incidence incidence(clean.graph);
    const StrutShape shape;
    const StrutPlacer placer(clean, incidence, shape);
    const StrutPlacement placement = placer.place();
    const RimPlacer rim_placer(clean.graph, placer, shape);
    std::vector<Point> rims(12 * clean.graph.edges.size());
    for (std::uint32_t e = 0; e < clean.graph.edges.size(); ++e) rim_placer.place(placement, e, rims.data() + 12 * e);
    BallMaker maker(clean.graph, incidence, placer, placement, shape, rims, progress);
    BallFaces faces;
    maker.make(0, faces);
    EXPECT_GT(faces.ends.size(), 300u);
    progress.cancel();
    EXPECT_THROW(maker.make(0, faces), Cancelled);
    EXPECT_THROW(strut_surface(clean.graph, incidence, placer, placement, shape, progress), Cancelled);
}

} // namespace
} // namespace druse
