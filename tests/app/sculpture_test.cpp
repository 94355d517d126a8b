// graph.tess, graph.map and graph.sculpture as a document runs them: the tables of figures, what they refuse, and what is kept of them.
#include "app/documents.h"
#include "app/info.h"
#include "app/registry.h"
#include "app/script.h"
#include "dlfl/measures.h"
#include "dlfl/self_intersections.h"
#include "graph/graph_facts.h"
#include "io/read.h"
#include "support/folder.h"

#include <nlohmann/json.hpp>

#include <ostream>

namespace druse {
namespace {

using namespace test;
using Json = nlohmann::ordered_json;

const Graph& graph_in(const Document& document) { return std::get<Graph>(*document.scene().source); }

Document ran(const std::vector<std::string>& commands)
{
    Document document(all_operators());
    for (const std::string& command : commands) EXPECT_EQ(complaint(document, command), "") << command;
    return document;
}

// --- figures --------------------------------------------------------------------------------------------------------------------

/// A figure and the counts of its graph, verified with an independent program.
struct Figure {
    const char *name, *tess, *map;
    std::uint32_t vertices, edges;
    std::int64_t cycle_rank;
    friend std::ostream& operator<<(std::ostream& out, const Figure& f) { return out << f.name; }
};

const std::vector<Figure> figures{
    {"disk_777", "config=7,7,7 layers=3", "to=disk", 315, 399, 85},
    {"polyp_777", "config=7,7,7 center=vertex layers=3", "to=polyp", 181, 228, 48},
    {"disk_3_7", "config=3,3,3,3,3,3,3 center=vertex layers=3", "to=disk", 85, 196, 112},
    {"disk_5454", "config=5,4,5,4 center=face:5 layers=2", "to=disk", 80, 120, 41},
    {"helix_53433", "config=5,3,4,3,3 center=face:5 layers=3", "to=helix", 480, 952, 473},
    {"helix_766", "config=7,6,6 center=face:7 layers=3", "to=helix", 588, 780, 193},
    {"cylinder_3_7", "config=3,3,3,3,3,3,3 layers=2", "to=helix shape=cylinder", 192, 425, 234},
    {"torus_5454", "config=5,4,5,4 center=face:5 layers=2", "to=torus", 400, 600, 201},
    {"torus_766", "config=7,6,6 center=face:7 layers=3", "to=torus cycles=7", 1029, 1372, 344},
    {"knot_766_2", "config=7,6,6 center=face:7 layers=2", "to=knot", 630, 819, 190},
    {"knot_766_3", "config=7,6,6 center=face:7 layers=3", "to=knot", 1323, 1764, 442},
    {"cube", "config=5,4,5,4 center=face:5 layers=2", "to=polyhedron solid=cube", 204, 312, 109},
    {"icosahedron", "config=5,4,5,4 center=face:5 layers=2", "to=polyhedron", 486, 780, 295},
    {"dodecahedron", "config=5,4,5,4 center=face:5 layers=2", "to=polyhedron solid=dodecahedron", 510, 780, 271},
    {"icosahedron_3", "config=5,4,5,4 center=face:5 layers=3", "to=polyhedron", 1338, 2130, 793},
    {"dodecahedron_3", "config=5,4,5,4 center=face:5 layers=3", "to=polyhedron solid=dodecahedron", 1370, 2130, 761},
};

class EveryFigure : public testing::TestWithParam<Figure> {};
INSTANTIATE_TEST_SUITE_P(Graph, EveryFigure, testing::ValuesIn(figures), [](const auto& f) { return std::string(f.param.name); });

TEST_P(EveryFigure, HasAsManyVerticesEdgesAndCyclesAsItsTableSays)
{
    const Figure& figure = GetParam();
    const Document document = ran({std::string("graph.tess ") + figure.tess, std::string("graph.map ") + figure.map});
    const GraphFacts f = facts(graph_in(document));
    EXPECT_EQ(f.vertices, figure.vertices);
    EXPECT_EQ(f.edges, figure.edges);
    EXPECT_EQ(f.cycle_rank, figure.cycle_rank);
    EXPECT_EQ(f.components, 1u);
    const Json j = Json::parse(info_json(document.scene(), "x"));
    EXPECT_EQ(j["kind"], "graph");
    EXPECT_EQ(j["faces"], 0);
    EXPECT_EQ(j["cycle_rank"], figure.cycle_rank);
    EXPECT_GT(j["smallest_angle"], 1.0);
}

// --- what is kept ---------------------------------------------------------------------------------------------------------------

TEST(Tessellation, KnowsWhatIsAtTheCentreAfterUndoAndFromItsScript)
{
    Document document = ran({"graph.tess", "graph.map to=torus", "document.undo", "graph.map to=knot", "document.undo", "document.undo", "document.redo"});
    EXPECT_EQ(graph_in(document).disk->sides, 7);
    EXPECT_EQ(complaint(document, "graph.map to=helix"), "");
    const Folder folder;
    folder.write("a.druse", document.script({}));
    Document again(all_operators());
    Progress progress;
    again.open(folder.path() / "a.druse", progress);
    EXPECT_EQ(State(again), State(document));
}

TEST(Tessellation, KeepsOfATessellationInAFileItsPointsAndLines)
{
    const Folder folder;
    folder.write("a.obj", "v 0 0 0\nv 0.5 0 0\nl 1 2\n");
    Document document(all_operators());
    Progress progress;
    document.open(folder.path() / "a.obj", progress);
    EXPECT_EQ(complaint(document, "graph.map to=disk"), "graph.map: expected a tessellation of the disk, as graph.tess makes one; a file keeps only its points and lines");
}

TEST(Tessellation, HasPolygonsInItsMeshIfAsked)
{
    const Document document = ran({"make.cube", "graph.tess layers=2 faces=true"});
    const MeshFacts f = facts(document.scene().mesh);
    EXPECT_EQ(f.counts.faces, 6u + 29);
    EXPECT_EQ(f.counts.vertices, 8u + 112);
    EXPECT_EQ(f.components, 2u);
    EXPECT_EQ(f.euler, 2 + 1);
    EXPECT_EQ(document.scene().selection->faces.size(), 29u);
    EXPECT_EQ(document.scene().mesh.boundary_count(), 1u);
    const Json j = Json::parse(info_json(document.scene(), "x"));
    EXPECT_EQ(j["kind"], "mesh");
    EXPECT_EQ(j["graph"]["vertices"], 112);
    EXPECT_EQ(j["graph"]["edges"], 140);
    EXPECT_EQ(j["graph"]["cycle_rank"], 29);
    for (const char* command : {"graph.tess layers=1 arc=3 mirror=true faces=true", "graph.tess center=vertex layers=0 faces=true"}) {
        const Document other = ran({command});
        EXPECT_GT(graph_in(other).vertices.size(), 0u);
    }
}

TEST(Tessellation, SaysTheSameOfAPlaneTessellationInEveryModel)
{
    for (const char* model : {"poincare", "klein", "halfplane"}) {
        const Document document = ran({std::string("graph.tess turn=10 model=") + model});
        EXPECT_EQ(facts(graph_in(document)).cycle_rank, 85);
    }
    EXPECT_EQ(facts(graph_in(ran({"graph.tess model=klein", "graph.map to=torus"}))).cycle_rank, 5 * 399 - 5 * 315 + 1);
}

// --- presets --------------------------------------------------------------------------------------------------------------------

TEST(Sculpture, IsOneStepWithTheGenusOfItsGraph)
{
    // Those of tessellations are in the gallery, and tested there.
    for (const auto& [name, genus] : {std::pair("diamond", 38), std::pair("double-diamond", 73), std::pair("triamond", 16), std::pair("double-triamond", 37)}) {
        Document document = ran({std::string("graph.sculpture name=") + name});
        const MeshFacts f = facts(document.scene().mesh);
        EXPECT_EQ(f.genus, genus) << name;
        EXPECT_EQ(f.boundary_edges, 0u);
        EXPECT_EQ(facts(graph_in(document)).cycle_rank, genus);
        EXPECT_EQ(document.history().size(), 1u);
        document.apply("document.undo");
        EXPECT_EQ(State(document), State());
    }
    const Document cube = ran({"make.cube", "graph.sculpture name=bunny-struts"});
    EXPECT_EQ(facts(cube.scene().mesh).genus, 5); // 12 − 8 + 1
}

TEST(Sculpture, OfOtherFiguresIsClosedAndMeetsItselfNowhere)
{
    struct Other {
        const char *tess, *map, *struts;
        std::int64_t genus;
    };
    for (const Other& o : {Other{"config=5,4,5,4 center=face:5 layers=2", "to=disk", "radius=0.08", 41},
                           Other{"config=7,6,6 center=face:7 layers=3", "to=knot", "radius=0.08 sides=3", 442},
                           Other{"config=5,4,5,4 center=face:5 layers=2", "to=polyhedron solid=cube", "radius=0.08", 109}}) {
        const Document document = ran({std::string("graph.tess ") + o.tess, std::string("graph.map ") + o.map, std::string("graph.struts ") + o.struts});
        Progress progress;
        EXPECT_EQ(facts(document.scene().mesh).component_genus, std::vector<std::int64_t>{o.genus}) << o.map;
        EXPECT_EQ(document.scene().mesh.boundary_count(), 0u);
        EXPECT_EQ(self_intersections(document.scene().mesh, progress, 1).pairs, 0u) << o.map;
    }
}

TEST(Sculpture, IsRefusedWithoutAMeshToTakeEdgesFrom)
{
    Document document(all_operators());
    EXPECT_EQ(complaint(document, "graph.sculpture name=bunny-struts"), "graph.sculpture: there is no mesh to take edges from");
    EXPECT_EQ(State(document), State());
    EXPECT_TRUE(complaint(document, "graph.sculpture name=bunny").starts_with("graph.sculpture: name=bunny: expected sand-dollar, "));
}

// --- refusals -------------------------------------------------------------------------------------------------------------------

struct Refusal {
    const char *command, *line;
};

TEST(Tessellation, IsUnchangedByWhatIsRefused)
{
    const std::string no_disk = "expected a tessellation of the disk, as graph.tess makes one; a file keeps only its points and lines";
    Document document = ran({"graph.tess center=vertex"});
    const State before(document);
    for (const auto& [command, line] : std::vector<Refusal>{
             {"graph.tess config=3,3,3,3,3,3", "config=3,3,3,3,3,3: six triangles are flat; did you mean 3,3,3,3,3,3,3?"},
             {"graph.tess config=4,4,4,4", "config=4,4,4,4 is Euclidean: the angles make exactly 360 degrees; expected more polygons, or larger ones"},
             {"graph.tess config=3,4,5", "config=3,4,5 is spherical: the angles make less than 360 degrees; expected more polygons, or larger ones"},
             {"graph.tess config=5,5,5,4", "config=5,5,5,4 has no vertex-uniform tessellation"},
             {"graph.tess config=7,7", "config=7,7: expected 3 to 12 integers, found 2"},
             {"graph.tess config=7,7,41", "config=7,7,41: expected 3 to 40 (an integer)"},
             {"graph.tess layers=13", "layers=13: expected 0 to 12 (an integer)"},
             {"graph.tess center=hole", "center=hole: expected face, face:N, vertex, edge or edge:S"},
             {"graph.tess center=face:", "center=face:: expected face, face:N, vertex, edge or edge:S"},
             {"graph.tess center=vertex:1", "center=vertex:1: expected face, face:N, vertex, edge or edge:S"},
             {"graph.tess center=face:5", "center=face:5: config=7,7,7 has no such polygon"},
             {"graph.tess center=edge:3", "center=edge:3: expected a slot 0 to 2"},
             {"graph.tess shift=0.8,0.6", "shift=0.8,0.6: expected a point inside the unit disk"},
             {"graph.tess arc=65", "arc=65: expected 1 to 64 (an integer)"},
             {"graph.map", "to= is missing; expected disk, polyp, helix, torus, knot or polyhedron: what it becomes"},
             {"graph.map to=torus rim=1", "rim: to=torus does not use it; it uses size, cycles, major and rho"},
             {"graph.map to=disk turns=3", "turns: to=disk does not use it; it uses size"},
             {"graph.map to=polyp solid=cube", "solid: to=polyp does not use it; it uses size, rim, height and height_expr"},
             {"graph.map to=helix span=1", "span=1: expected between 0 and 1, both excluded"},
             {"graph.map to=polyp rim=0", "rim=0: expected above 0"},
             {"graph.map to=polyp height_expr=log(r)", "height_expr=log(r): log(0) is not a finite number, at vertex 0 (0, 0)"},
             {"graph.map to=polyp height=2 height_expr=x", "height_expr is in place of height: give one of them"},
             {"graph.map to=polyp height_expr=x+", "height_expr=x+: expected a value at the end"},
             {"graph.map to=torus", "expected a face at the centre, not a vertex; graph.tess with center=face or face:N makes one"},
             {"graph.map to=knot rho=0.9", "expected a face at the centre, not a vertex; graph.tess with center=face or face:N makes one"}}) {
        EXPECT_EQ(complaint(document, command), std::string(command).substr(0, std::string(command).find(' ')) + ": " + line);
        EXPECT_EQ(State(document), before);
    }
    document.apply("document.clear");
    EXPECT_EQ(complaint(document, "graph.map to=disk"), "graph.map: " + no_disk);
    for (const char* command : {"graph.tess config=7,7,7", "graph.map to=torus"}) document.apply(command);
    EXPECT_EQ(complaint(document, "graph.map to=disk"), "graph.map: " + no_disk); // it lies in the disk no more
}

TEST(Tessellation, IsRefusedMoreLayersThanFit)
{
    Document document(all_operators());
    const std::string line = complaint(document, "graph.tess model=klein layers=12");
    EXPECT_TRUE(line.starts_with("graph.tess: layers=12 would give edges shorter than 1e-06; expected ")) << line;
    EXPECT_TRUE(line.ends_with(" or less")) << line;
    EXPECT_TRUE(std::holds_alternative<std::monostate>(*document.scene().source));
}

} // namespace
} // namespace druse
