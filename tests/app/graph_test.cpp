// Graphs and struts as a document keeps them: through undo, files and sliders.
#include "app/documents.h"
#include "app/info.h"
#include "app/registry.h"
#include "app/save.h"
#include "graph/graph_facts.h"
#include "io/output.h"
#include "support/folder.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace druse {
namespace {

using namespace test;

const Graph& graph(const Document& document) { return std::get<Graph>(*document.scene().source); }

TEST(GraphInDocument, ComesBackByUndoAndRedo)
{
    Document document = document_of(all_operators(), cube());
    std::vector<State> states{State(document)};
    for (const char* command : {"graph.wireframe keep=true", "graph.struts", "graph.lattice kind=srs", "graph.struts keep=true", "graph.wireframe", "graph.struts sides=3 crossings=ignore clearance=off"}) {
        EXPECT_EQ(complaint(document, command), "") << command;
        states.emplace_back(document);
    }
    for (const std::size_t k : {3u, 6u, 0u, 1u, 5u, 2u, 4u}) {
        document.apply("document.goto step=" + std::to_string(k));
        EXPECT_EQ(State(document), states[k]) << k;
    }
}

TEST(GraphInDocument, IsWrittenAsLinesAndReadAgain)
{
    const Folder folder;
    Document document(all_operators());
    document.apply("graph.lattice kind=srs cells=2,1,1");
    OutputSet output;
    write_document(document, output, folder / "net.obj");
    output.commit();
    Document again(all_operators());
    Progress progress;
    again.open(folder / "net.obj", progress);
    EXPECT_EQ(graph(again).vertices, graph(document).vertices);
    EXPECT_EQ(graph(again).edges, graph(document).edges);
    const auto info = nlohmann::json::parse(info_json(again.scene(), "net.obj", std::nullopt));
    EXPECT_EQ(info["kind"], "graph");
    EXPECT_EQ(info["cycle_rank"], facts(graph(document)).cycle_rank);
    EXPECT_NEAR(info["smallest_angle"].get<double>(), 120, 1e-9);
    document.apply("graph.struts");
    again.apply("graph.struts");
    EXPECT_TRUE(document.scene().mesh == again.scene().mesh);
}

TEST(GraphInDocument, IsThereForStrutsToRunAgainWithOtherValues)
{
    Document dragged = document_of(all_operators(), dodecahedron()), fresh = document_of(all_operators(), dodecahedron());
    Progress progress;
    for (Document* document : {&dragged, &fresh}) document->apply("graph.wireframe");
    dragged.apply("graph.struts radius=0.02");
    for (const char* command : {"graph.struts radius=0.05", "graph.struts sides=3 cap=round", "graph.struts radius=0.15 ball=2"}) dragged.apply_again(command, progress);
    fresh.apply("graph.struts radius=0.15 ball=2");
    EXPECT_EQ(State(dragged), State(fresh));
    EXPECT_EQ(dragged.history().size(), 2u);
    // Of a mesh without a graph the edges are taken anew each time, as they were before the first run.
    Document direct = document_of(all_operators(), dodecahedron());
    direct.apply("graph.struts radius=0.02");
    direct.apply_again("graph.struts radius=0.15 ball=2", progress);
    EXPECT_TRUE(direct.scene().mesh == fresh.scene().mesh);
}

TEST(GraphInDocument, StaysAsItWasWhenStrutsAreCancelledOrRefused)
{
    Document document(all_operators());
    document.apply("graph.lattice");
    const State before(document);
    Progress progress;
    progress.cancel();
    EXPECT_THROW(document.apply("graph.struts", progress), Cancelled);
    EXPECT_EQ(complaint(document, "graph.struts radius=3 fit=error").substr(0, 46), "graph.struts: radius=3: does not fit at vertex");
    EXPECT_EQ(State(document), before);
}

} // namespace
} // namespace druse
