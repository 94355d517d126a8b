// graph.wireframe and graph.struts as operators: where their graph comes from, what they say, and what they leave behind.
#include "dlfl/self_intersections.h"
#include "graph/graph_facts.h"
#include "ops/group.h"
#include "ops/run.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <random>

namespace druse {
namespace {

using namespace test;
using Notes = std::vector<std::string>;

Scene scene_of(Graph graph)
{
    Scene scene;
    scene.source.replace_with(std::move(graph));
    return scene;
}

const Graph& graph(const Scene& scene) { return std::get<Graph>(*scene.source); }

std::uint64_t crossings(const Scene& scene)
{
    Progress progress;
    return self_intersections(scene.mesh, progress).pairs;
}

/// Two bars side by side, so far apart.
Graph two_bars(double apart) { return {{{0, 0, 0}, {2, 0, 0}, {0, apart, 0}, {2, apart, 0}}, {{0, 1}, {2, 3}}}; }
Graph cross() { return {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}}, {{0, 1}, {2, 3}}}; }
Graph corner() { return {{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}, {{0, 1}, {1, 2}}}; }

TEST(Wireframe, TakesTheEdgesOfAMeshInItsPlaceOrBesideIt)
{
    Scene scene = test::scene_of(cube());
    run(scene, "graph.wireframe", {{"edges", "0-3"}, {"keep", "true"}});
    EXPECT_EQ(counts(scene.mesh), (Counts{8, 12, 6}));
    EXPECT_EQ(graph(scene).edges.size(), 4u);
    EXPECT_EQ(graph(scene).vertices.size(), 4u);
    run(scene, "graph.wireframe");
    EXPECT_EQ(counts(scene.mesh), (Counts{0, 0, 0}));
    EXPECT_EQ(graph(scene).edges.size(), 12u);
    EXPECT_EQ(complaint(Scene(), "graph.wireframe"), "there is no mesh to take edges from");
    EXPECT_EQ(complaint(Scene(), "graph.sculpture", {{"name", "bunny-struts"}}), "there is no mesh to take edges from");
}

TEST(Lattice, BecomesTheGraphOfTheDocument)
{
    Scene scene = test::scene_of(cube());
    run(scene, "graph.lattice", {{"kind", "srs"}, {"cells", "3,3,3"}, {"trim", "ball"}, {"size", "auto"}});
    EXPECT_EQ(facts(graph(scene)).cycle_rank, 28);
    EXPECT_EQ(counts(scene.mesh), (Counts{8, 12, 6}));
    EXPECT_EQ(complaint(Scene(), "graph.lattice", {{"kind", "srs"}, {"cells", "1,1,1"}, {"leaves", "false"}}), "no edge is left: take more cells, or keep the leaves");
}

TEST(Struts, AreMadeOfTheEdgesOfAMeshAndLeaveTheirGraphToRunAgain)
{
    Scene scene = test::scene_of(cube());
    EXPECT_EQ(run(scene, "graph.struts").notes, Notes{});
    EXPECT_EQ(genus(scene.mesh), 5);
    EXPECT_EQ(graph(scene).edges.size(), 12u);
    run(scene, "graph.struts", {{"sides", "4"}, {"frame", "axis"}});
    EXPECT_EQ(genus(scene.mesh), 5);
    EXPECT_EQ(counts(scene.mesh).vertices, 104u);
    EXPECT_EQ(scene.groups->name(1) + scene.groups->name(2) + scene.groups->name(3), "ballstrutcap");
    // Of the mesh itself: every edge of it is a strut now.
    const std::int64_t edges = scene.mesh.edge_count(), vertices = scene.mesh.vertex_count();
    run(scene, "graph.struts", {{"source", "edges"}, {"sides", "3"}, {"radius", "0.01"}, {"clearance", "off"}});
    EXPECT_EQ(genus(scene.mesh), edges - vertices + 1);
}

TEST(Struts, StandBesideAKeptMeshInGroupsOfTheirOwn)
{
    Mesh given = cube();
    for (const Face f : given.faces()) given.set_group(f, 7);
    Scene scene = test::scene_of(std::move(given));
    run(scene, "graph.struts", {{"keep", "true"}});
    EXPECT_SOUND(scene.mesh);
    EXPECT_EQ(components(scene.mesh).parts.size(), 2u);
    EXPECT_EQ(existing_groups(scene.mesh), (std::vector<int>{7, 8, 9}));
    EXPECT_EQ(scene.groups->name(9), "strut");
    EXPECT_EQ(ids(FaceSelector::parse("strut:0").resolve(scene)).size(), 6u);
    EXPECT_EQ(scene.mesh.group(FaceSelector::parse("ball:3").resolve(scene)[0]), 8);
}

TEST(Struts, AreFoundByTheEdgeAndVertexThatTheyWereMadeOf)
{
    Scene scene = scene_of(corner());
    run(scene, "graph.struts", {{"sides", "5"}});
    EXPECT_EQ(ids(FaceSelector::parse("strut:1").resolve(scene)).size(), 5u);
    for (const Face f : FaceSelector::parse("strut:1").resolve(scene)) EXPECT_EQ(scene.mesh.group(f), 2);
    for (const Face f : FaceSelector::parse("ball:1").resolve(scene)) EXPECT_EQ(scene.mesh.group(f), 1);
    ASSERT_EQ(FaceSelector::parse("ball:2").resolve(scene).size(), 1u);
    EXPECT_EQ(scene.mesh.group(FaceSelector::parse("ball:2").resolve(scene)[0]), 3);
    EXPECT_THROW(FaceSelector::parse("strut:2").resolve(scene), CommandError);
    run(scene, "mesh.transform", {{"scale", "2"}});
    EXPECT_EQ(ids(FaceSelector::parse("strut:0").resolve(scene)).size(), 5u);
    run(scene, "remesh.doo_sabin");
    EXPECT_THROW(FaceSelector::parse("strut:0").resolve(scene), CommandError);
}

TEST(Struts, SayWhereTheyAreThinnerThanAskedFor)
{
    const std::vector<std::pair<std::string, std::string>> thick{{"radius", "0.4"}, {"scale", "absolute"}};
    Scene scene = scene_of(corner());
    // At the corner a polygon is seen under 0.9 · 45°, on a sphere of radius 0.95 / 2: 0.3084878, in place of 0.4.
    EXPECT_EQ(notes(scene, "graph.struts", thick), Notes{"2 ends thinned, least to 0.77"});
    auto refused = thick;
    refused.emplace_back("fit", "error");
    EXPECT_EQ(complaint(scene_of(corner()), "graph.struts", refused), "radius=0.4: does not fit at vertex 1; the largest that fits everywhere is 0.308487");
    for (const char* radius : {"1e+12", "1e+300"}) // nothing depends on how much larger it is
        EXPECT_EQ(complaint(scene_of(corner()), "graph.struts", {{"radius", radius}, {"scale", "absolute"}, {"fit", "error"}}),
                  std::string("radius=") + radius + ": does not fit at vertex 1; the largest that fits everywhere is 0.308487");
}

TEST(Struts, RefuseOrSplitEdgesThatCross)
{
    EXPECT_EQ(complaint(scene_of(cross()), "graph.struts"), "edges (0 1) and (2 3) cross at 0,0,0; crossings=split joins them");
    Scene joined = scene_of(cross()), ignored = scene_of(cross());
    EXPECT_EQ(notes(joined, "graph.struts", {{"crossings", "split"}}), Notes{"1 crossing: split"});
    EXPECT_EQ(components(joined.mesh).parts.size(), 1u);
    EXPECT_EQ(genus(joined.mesh), 0);
    EXPECT_EQ(crossings(joined), 0u);
    EXPECT_EQ(ids(FaceSelector::parse("strut:1").resolve(joined)).size(), 12u); // two pieces of six sides
    const Notes said = notes(ignored, "graph.struts", {{"crossings", "ignore"}});
    ASSERT_EQ(said.size(), 1u); // and it does not advise what is refused
    EXPECT_NE(said[0].find(" cross where edges meet or struts come too near each other; crossings=split joins those edges"), std::string::npos) << said[0];
    EXPECT_EQ(components(ignored.mesh).parts.size(), 2u);
    for (const char* clearance : {"shrink", "thin"})
        EXPECT_EQ(complaint(scene_of(cross()), "graph.struts", {{"crossings", "ignore"}, {"clearance", clearance}}),
                  std::string("clearance=") + clearance + ": edges (0 1) and (2 3) meet at 0,0,0, so no radius keeps their struts apart; crossings=split joins them");
    EXPECT_EQ(complaint(scene_of(cross()), "graph.struts", {{"crossings", "split"}, {"radius", "0.6"}, {"scale", "absolute"}, {"fit", "error"}}),
              "radius=0.6: does not fit at the crossing at 0,0,0; the largest that fits everywhere is 0.308487");
}

TEST(Struts, RefuseEdgesThatOverlap)
{
    const Graph beside{{{0, 0, 0}, {1, 0, 0}, {1, 1e-5, 0}}, {{0, 1}, {0, 2}}};
    EXPECT_EQ(complaint(scene_of(beside), "graph.struts"), "edges (0 1) and (0 2) overlap");
    const Graph along{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0, 1}, {2, 3}}};
    for (const char* what : {"error", "split"})
        EXPECT_EQ(complaint(scene_of(along), "graph.struts", {{"crossings", what}}), "edges (0 1) and (2 3) run along each other");
}

TEST(Struts, NameEdgesAndVerticesAsTheyWereGiven)
{
    // Vertices 0 and 1 lie at one place, so what is left is numbered anew.
    const Graph beside{{{0, 0, 0}, {0, 0, 0}, {5, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{1, 4}, {0, 2}, {1, 3}}};
    EXPECT_EQ(complaint(scene_of(beside), "graph.struts"), "edges (0 2) and (1 3) overlap");
    const Graph crossed{{{9, 9, 9}, {-1, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 1, 0}}, {{3, 2}, {4, 5}}};
    EXPECT_EQ(complaint(scene_of(crossed), "graph.struts"), "edges (3 2) and (4 5) cross at 0,0,0; crossings=split joins them");
    Graph far{{{0, 0, 0}, {1e15, 0, 0}, {1e15, 1, 0}, {1e15, 0, 1}, {0, 0, 0}}, {{1, 2}, {1, 3}}};
    const std::vector<std::pair<std::string, std::string>> thin{{"radius", "0.01"}, {"scale", "absolute"}, {"clearance", "off"}};
    EXPECT_EQ(complaint(scene_of(far), "graph.struts", thin), "vertex 1: its struts are too thin for coordinates of that size");
    far.edges.pop_back();
    EXPECT_EQ(complaint(scene_of(far), "graph.struts", thin), "vertex 1: its strut is too thin for coordinates of that size");
}

TEST(Struts, AreKeptApartWhateverRadiusIsAskedFor)
{
    for (const char* radius : {"0.1", "100", "1e12", "1e300"}) {
        const std::vector<std::pair<std::string, std::string>> thick{{"radius", radius}, {"scale", "absolute"}, {"sides", "4"}};
        auto thin = thick, shrink = thick;
        thin.emplace_back("clearance", "thin");
        shrink.emplace_back("clearance", "shrink");
        Scene thinner = scene_of(two_bars(0.15)), smaller = thinner;
        run(thinner, "graph.struts", thin);
        EXPECT_EQ(crossings(thinner), 0u) << radius;
        EXPECT_EQ(notes(smaller, "graph.struts", shrink), Notes{"radius lowered to 0.075, so that nothing meets"}) << radius;
    }
    // As near as edges can be that do not meet.
    Scene near = scene_of(two_bars(1e-7));
    run(near, "graph.struts", {{"clearance", "thin"}});
    EXPECT_EQ(crossings(near), 0u);
}

TEST(Struts, SayAndColourWhereTheyCrossOrAreMadeThinner)
{
    const std::vector<std::pair<std::string, std::string>> thick{{"radius", "0.1"}, {"scale", "absolute"}, {"sides", "4"}};
    const auto with = [&](const char* clearance) {
        auto arguments = thick;
        arguments.emplace_back("clearance", clearance);
        return arguments;
    };
    Scene warned = scene_of(two_bars(0.15)), off = warned, thinner = warned, apart = scene_of(two_bars(0.21));
    const Notes said = notes(warned, "graph.struts", thick);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0], std::to_string(crossings(warned)) + " pairs of triangles cross where struts come too near each other; clearance=thin keeps them apart");
    EXPECT_GT(crossings(warned), 0u);
    EXPECT_EQ(warned.groups->name(4), "crossing");
    EXPECT_EQ(existing_groups(warned.mesh).back(), 4);

    EXPECT_EQ(notes(off, "graph.struts", with("off")), Notes{});
    Scene thinned = scene_of(two_bars(0.15));
    EXPECT_EQ(notes(thinned, "graph.struts", with("thin")), Notes{"4 vertices thinned, so that nothing meets, least to 0.64"}); // 0.8 of 0.1 is still too much
    EXPECT_EQ(crossings(thinned), 0u);
    EXPECT_EQ(notes(thinner, "graph.struts", with("shrink")), Notes{"radius lowered to 0.075, so that nothing meets"}); // half of how far apart they are
    EXPECT_EQ(crossings(thinner), 0u);
    EXPECT_EQ(notes(apart, "graph.struts", thick), Notes{});
    EXPECT_EQ(complaint(scene_of(two_bars(0.15)), "graph.struts", with("error")).substr(2), " pairs of triangles cross; a smaller radius or clearance=thin keeps struts apart");
    // Nearer than spheres and cylinders may be, but squares on their corners: these two stand apart.
    Scene squares = scene_of(two_bars(0.15));
    EXPECT_EQ(notes(squares, "graph.struts", {{"radius", "0.1"}, {"scale", "absolute"}, {"sides", "4"}, {"phase", "45"}}), Notes{});
    EXPECT_EQ(crossings(squares), 0u);
}

TEST(Struts, AreThinnedOnceARoundWhateverManyTheyMeet)
{
    // A beam over twenty bars, which it nearly clears: one step is enough for all of them.
    Graph grid;
    const auto bar = [&](const Point& from, const Point& to) {
        const auto first = static_cast<std::uint32_t>(grid.vertices.size());
        grid.vertices.insert(grid.vertices.end(), {from, to});
        grid.edges.push_back({first, first + 1});
    };
    bar({-1, 0, 0.19}, {20, 0, 0.19});
    for (int i = 0; i < 20; ++i) bar({double(i), -1, 0}, {double(i), 1, 0});
    Scene scene = scene_of(grid);
    EXPECT_EQ(notes(scene, "graph.struts", {{"radius", "0.1"}, {"scale", "absolute"}, {"sides", "32"}, {"clearance", "thin"}}),
              Notes{"42 vertices thinned, so that nothing meets, least to 0.8"});
    EXPECT_EQ(crossings(scene), 0u);
}

TEST(Struts, MeetThemselvesNowhereWhenThinned)
{
    int crossed = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> at(0, 1);
        Graph graph;
        for (std::uint32_t i = 0; i < 14; ++i) graph.vertices.emplace_back(at(random), at(random), at(random));
        for (std::uint32_t i = 0; i < 14; ++i)
            for (std::uint32_t j = i + 1; j < 14; ++j)
                if (glm::distance(graph.vertices[i], graph.vertices[j]) < 0.5) graph.edges.push_back({i, j});
        Scene thick = scene_of(graph), thin = thick;
        run(thick, "graph.struts", {{"radius", "0.04"}, {"scale", "absolute"}});
        run(thin, "graph.struts", {{"radius", "0.04"}, {"scale", "absolute"}, {"clearance", "thin"}});
        crossed += crossings(thick) > 0;
        EXPECT_EQ(crossings(thin), 0u);
        EXPECT_EQ(genus(thin.mesh), genus(thick.mesh));
    }
    EXPECT_GT(crossed, 5);
}

TEST(Struts, SayWhatTheyMendInAGraph)
{
    Scene scene = scene_of({{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {9, 9, 9}}, {{0, 1}, {1, 0}, {2, 3}}});
    EXPECT_EQ(notes(scene, "graph.struts", {}),
              (Notes{"1 edge was there twice: kept once", "1 vertex was welded to another one at its place", "1 vertex has no edge: left out"}));
    EXPECT_EQ(components(scene.mesh).parts.size(), 1u);
    EXPECT_EQ(graph(scene).vertices.size(), 5u); // the graph stays as it was
}

TEST(Struts, SayWhatTheyCannotBeMadeOf)
{
    EXPECT_EQ(complaint(Scene(), "graph.struts"), "there are no edges: the document holds neither a graph nor a mesh");
    EXPECT_EQ(complaint(scene_of({{Point(0)}, {}}), "graph.struts"), "the graph has no edges");
    EXPECT_EQ(complaint(scene_of(corner()), "graph.struts", {{"source", "edges"}}), "there is no mesh to take edges from");
    EXPECT_EQ(complaint(test::scene_of(cube()), "graph.struts", {{"source", "lines"}}),
              "the document holds no graph; graph.wireframe makes one of the edges of a mesh");
    EXPECT_EQ(complaint(scene_of(corner()), "graph.struts", {{"frame", "normal"}}), "frame=normal: the graph came from no mesh that has normals");
    Scene large;
    run(large, "graph.lattice", {{"cells", "24,24,24"}});
    EXPECT_EQ(complaint(large, "graph.struts", {{"sides", "32"}}), "would make 36 million edges, more than 20 million");
}

TEST(Struts, StaySolidWhenSmoothed)
{
    Scene scene = test::scene_of(cube());
    run(scene, "graph.struts");
    for (const char* scheme : {"remesh.doo_sabin", "remesh.catmull_clark"}) {
        Scene smooth = scene;
        run(smooth, scheme);
        EXPECT_SOUND(smooth.mesh);
        EXPECT_EQ(genus(smooth.mesh), 5);
    }
}

} // namespace
} // namespace druse
