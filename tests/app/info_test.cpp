#include "app/info.h"

#include "app/documents.h"
#include "app/registry.h"
#include "graph/graph_facts.h"
#include "support/shapes.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace druse {
namespace {

using namespace test;
using Json = nlohmann::ordered_json;

Json info(const Document& document) { return Json::parse(info_json(document.scene(), "a.obj")); }
Json info(Mesh mesh) { return info(document_of(all_operators(), std::move(mesh))); }

Scene scene_of(Graph graph)
{
    Scene scene;
    scene.source.replace_with(std::move(graph));
    return scene;
}

std::vector<std::string> keys(const Json& j)
{
    std::vector<std::string> list;
    for (const auto& [key, value] : j.items()) list.push_back(key);
    return list;
}

const std::vector<std::string> all_keys{
    "file",           "kind",   "units", "vertices", "edges",       "faces", "corners",  "components",       "euler",  "genus",     "watertight",     "oriented",
    "manifold",       "boundary_edges", "volume", "area",  "bbox",     "edge_length", "sides", "valences", "max_nonplanarity", "groups", "selection", "parallel_edges",
    "point_spheres",  "zero_thickness_walls", "self_intersections"};

class FactsOfEveryShape : public testing::TestWithParam<NamedShape> {};

TEST_P(FactsOfEveryShape, AreThereInOrder)
{
    const Json j = info(GetParam().make());
    EXPECT_EQ(keys(j), all_keys);
    EXPECT_EQ(j["euler"].get<std::int64_t>(), j["vertices"].get<std::int64_t>() - j["edges"].get<std::int64_t>() + j["faces"].get<std::int64_t>());
    EXPECT_EQ(j["watertight"].get<bool>(), j["boundary_edges"].get<int>() == 0);
    EXPECT_TRUE(j["self_intersections"].is_null());
}
INSTANTIATE_TEST_SUITE_P(Info, FactsOfEveryShape, testing::ValuesIn(all_shapes()), shape_name<testing::TestParamInfo<NamedShape>>);

TEST(Info, TellsWhatACubeIs)
{
    const Json j = info(cube());
    EXPECT_EQ(j["file"], "a.obj");
    EXPECT_EQ(j["kind"], "mesh");
    EXPECT_EQ(j["units"], "mm");
    EXPECT_EQ(j["corners"], 24);
    EXPECT_EQ(j["components"], 1);
    EXPECT_EQ(j["genus"], 0);
    EXPECT_NEAR(j["volume"], 1.0, 1e-12);
    EXPECT_NEAR(j["area"], 6.0, 1e-12);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(j["bbox"]["max"][i].get<double>() - j["bbox"]["min"][i].get<double>(), 1.0, 1e-12);
    EXPECT_EQ(keys(j["edge_length"]), (std::vector<std::string>{"min", "mean", "max"}));
    EXPECT_NEAR(j["edge_length"]["mean"], 1.0, 1e-12);
    EXPECT_EQ(j["sides"], Json({{"4", 6}}));
    EXPECT_EQ(j["valences"], Json({{"3", 8}}));
    EXPECT_EQ(j["groups"], Json({{"0", {{"faces", 6}, {"color", "#cccccc"}, {"name", nullptr}}}}));
    EXPECT_EQ(j["selection"], Json({{"faces", Json::array()}, {"edges", Json::array()}, {"vertices", Json::array()}}));
}

TEST(Info, TellsColoursNamesAndSelection)
{
    Document document = document_of(all_operators(), cube());
    for (const char* command : {"group.assign faces=0,2 id=7", "group.color id=7 color=#010203", "group.name id=7 name=lid", "select.edges edges=3-5"})
        document.apply(command);
    const Json j = info(document);
    EXPECT_EQ(j["groups"]["7"], Json({{"faces", 2}, {"color", "#010203"}, {"name", "lid"}}));
    EXPECT_EQ(j["groups"]["0"]["faces"], 4);
    EXPECT_EQ(j["selection"]["edges"], Json({3, 4, 5}));
    const std::string text = info_text(document.scene(), "a.obj");
    EXPECT_NE(text.find("group 7                2 faces, #010203, lid\n"), std::string::npos) << text;
    EXPECT_NE(text.find("selected edges         3-5\n"), std::string::npos) << text;
}

TEST(Info, TellsThatAnOpenPatchIsNotWatertight)
{
    // 3 × 2 squares: 12 vertices, 17 edges, 10 of them at the rim.
    const Document document = document_of(all_operators(), open_grid(3, 2));
    const Json j = info(document);
    EXPECT_EQ(j["watertight"], false);
    EXPECT_EQ(j["boundary_edges"], 10);
    EXPECT_EQ(j["faces"], 6);
    EXPECT_NE(info_text(document.scene(), "x").find("watertight             no, 10 open edges\n"), std::string::npos);
}

TEST(Info, TellsOfSelfIntersectionsThatWereLookedFor)
{
    const Document document = document_of(all_operators(), cube());
    const auto told = [&](const std::optional<SelfIntersections>& met) { return info_text(document.scene(), "x", met); };
    EXPECT_NE(told({}).find("self-intersections     not looked for; --check does\n"), std::string::npos);
    EXPECT_NE(told(SelfIntersections{}).find("self-intersections     none\n"), std::string::npos);
    EXPECT_NE(told(SelfIntersections{1, {Face(0), Face(4)}}).find("self-intersections     1 pair of triangles, in 2 faces\n"), std::string::npos);
    EXPECT_EQ(Json::parse(info_json(document.scene(), "x", SelfIntersections{}))["self_intersections"], 0);
    EXPECT_EQ(Json::parse(info_json(document.scene(), "x", SelfIntersections{7, {Face(1)}}))["self_intersections"], 7);
    EXPECT_TRUE(Json::parse(info_json(scene_of(Graph{{Point(0), Point(1)}, {{0, 1}}}), "x", SelfIntersections{}))["self_intersections"].is_null());
}

TEST(Info, SumsTheGeneraOfTheComponents)
{
    Document document(all_operators());
    for (const char* command : {"make.torus", "make.torus", "make.cube"}) document.apply(command);
    const Json j = info(document);
    EXPECT_EQ(j["components"], 3);
    EXPECT_EQ(j["genus"], 2);
    EXPECT_EQ(j["euler"], 2); // 0 + 0 + 2
    EXPECT_NE(info_text(document.scene(), "x").find("genus                  2 (1 + 1 + 0)\n"), std::string::npos);
}

TEST(Info, HasNoBoxOfNothing)
{
    const Document document(all_operators());
    const Json j = info(document);
    EXPECT_EQ(keys(j), all_keys);
    EXPECT_TRUE(j["bbox"].is_null());
    EXPECT_TRUE(j["edge_length"].is_null());
    EXPECT_EQ(j["volume"], 0.0);
}

TEST(Info, StaysValidJsonWhateverTheFileIsCalled)
{
    const Scene scene;
    EXPECT_TRUE(Json::accept(info_json(scene, "bad \xff name\n\"")));
}

/// A square with one diagonal: 4 vertices, 5 edges, cycle rank 2, least angle 45 degrees.
Graph square_with_diagonal()
{
    return {{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}}};
}

TEST(Info, TellsOfAGraphWhatItHas)
{
    const Json j = Json::parse(info_json(scene_of(square_with_diagonal()), "g.obj"));
    std::vector<std::string> expected = all_keys;
    expected.insert(expected.end(), {"cycle_rank", "smallest_angle"});
    EXPECT_EQ(keys(j), expected);
    EXPECT_EQ(j["kind"], "graph");
    EXPECT_EQ(j["vertices"], 4);
    EXPECT_EQ(j["edges"], 5);
    EXPECT_EQ(j["faces"], 0);
    EXPECT_TRUE(j["volume"].is_null());
    EXPECT_TRUE(j["watertight"].is_null());
    EXPECT_EQ(j["valences"], Json({{"2", 2}, {"3", 2}}));
    EXPECT_EQ(j["cycle_rank"], 2);
    EXPECT_NEAR(j["smallest_angle"], 45.0, 1e-9);
    EXPECT_NEAR(j["edge_length"]["max"], std::sqrt(2.0), 1e-12);
}

TEST(Info, TellsOfAGraphBesideAMesh)
{
    Scene scene = scene_of(square_with_diagonal());
    scene.mesh = cube();
    const Json j = Json::parse(info_json(scene, "x"));
    EXPECT_EQ(j["kind"], "mesh");
    EXPECT_EQ(j["vertices"], 8);
    EXPECT_EQ(keys(j["graph"]), (std::vector<std::string>{"vertices", "edges", "components", "cycle_rank", "smallest_angle"}));
    EXPECT_EQ(j["graph"]["edges"], 5);
}

TEST(GraphFacts, CountComponentsAndCycles)
{
    EXPECT_EQ(facts(Graph{}).components, 0u);
    EXPECT_FALSE(facts(Graph{}).smallest_angle);
    const Graph apart{{Point(0), Point(1), Point(2), Point(3)}, {{0, 1}}};
    EXPECT_EQ(facts(apart).components, 3u);
    EXPECT_EQ(facts(apart).cycle_rank, 0);
    EXPECT_FALSE(facts(apart).smallest_angle);
}

TEST(GraphFacts, MeasureTheSmallestAngleOfAStarOfManyEdges)
{
    // 20 000 spokes, evenly spread: 360/20 000 degrees apart.
    Graph star{{Point(0.0)}, {}};
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const double t = 2.0 * 3.14159265358979323846 * i / 20000;
        star.vertices.emplace_back(std::cos(t), std::sin(t), 0.0);
        star.edges.push_back({0, i + 1});
    }
    EXPECT_NEAR(*facts(star).smallest_angle, 0.018, 1e-9);
    EXPECT_EQ(facts(star).valences.at(20000), 1u);
}

TEST(GraphFacts, MeasureAStraightAngleAndNone)
{
    const Graph straight{{Point(0, 0, 0), Point(1, 2, 3), Point(-1, -2, -3)}, {{0, 1}, {0, 2}}};
    EXPECT_NEAR(*facts(straight).smallest_angle, 180.0, 1e-5);
    const Graph twice{{Point(0, 0, 0), Point(1, 2, 3)}, {{0, 1}, {0, 1}}};
    EXPECT_EQ(facts(twice).smallest_angle, std::nullopt) << "an edge given twice is one";
}

} // namespace
} // namespace druse
