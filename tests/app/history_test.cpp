#include "app/history.h"

#include "app/documents.h"
#include "app/registry.h"
#include "support/mesh_checks.h"

#include <fmt/format.h>

namespace druse {
namespace {

using namespace test;

TEST(History, CostsWhatAStepTouchesNotWhatTheMeshHolds)
{
    Document document(all_operators());
    document.apply("make.grid nx=300 ny=300");
    const std::size_t before = document.history().bytes();
    document.apply("extrude.cubical faces=1000");
    EXPECT_LT(document.history().bytes() - before, document.scene().mesh.bytes() / 10);
}

TEST(History, DropsTheOldestStatesWhenItsBudgetIsPassed)
{
    Document document(all_operators());
    document.history().set_budget(20'000);
    std::vector<State> states{State(document)};
    for (int i = 0; i < 40; ++i) {
        document.apply("make.sphere nu=8 nv=6");
        states.emplace_back(document);
        EXPECT_LE(document.history().bytes(), document.history().budget());
    }
    const History& history = document.history();
    ASSERT_GT(history.first(), 0u);
    ASSERT_LT(history.first(), 39u);
    EXPECT_EQ(history.size(), 40u);
    EXPECT_EQ(complaint(document, "document.goto step=0"),
              fmt::format("document.goto: step=0: expected {} to 40; earlier states are no longer kept", history.first()));
    EXPECT_EQ(complaint(document, "document.undo steps=40"), fmt::format("document.undo: steps=40: expected 1 to {}", 40 - history.first()));
    for (std::size_t k : {history.first(), std::size_t(40), history.first() + 1}) {
        document.apply(fmt::format("document.goto step={}", k));
        EXPECT_EQ(State(document), states[k]);
    }
}

TEST(History, KeepsTheWholeScriptWhenStatesAreDropped)
{
    Document document(all_operators());
    document.history().set_budget(1);
    std::string script;
    for (int i = 3; i < 20; ++i) {
        document.apply(fmt::format("make.prism n={}", i));
        script += fmt::format("make.prism n={}\n", i);
    }
    EXPECT_EQ(document.script({}), script);
}

TEST(History, CanAlwaysTakeTheLastStepBack)
{
    Document document(all_operators());
    document.history().set_budget(0);
    document.apply("make.cube");
    const State before(document);
    document.apply("make.grid nx=100 ny=100");
    EXPECT_EQ(document.history().first(), 1u);
    document.apply("document.undo");
    EXPECT_EQ(State(document), before);
    EXPECT_EQ(complaint(document, "document.undo"), "document.undo: there is nothing to undo");
    document.apply("document.redo");
    EXPECT_EQ(document.scene().mesh.face_count(), 6u + 10001u);
}

TEST(History, CountsASelectionThatOnlyAStepHolds)
{
    Document document(all_operators());
    document.apply("make.grid nx=100 ny=100");
    const std::size_t before = document.history().bytes();
    document.apply("select.faces faces=none"); // the step holds the 10 001 faces that were selected
    EXPECT_GT(document.history().bytes() - before, 10001 * sizeof(Face));
    const std::size_t after = document.history().bytes();
    document.apply("select.edges edges=0"); // and this one shares what the one before it holds
    EXPECT_LT(document.history().bytes() - after, 4096u);
}

TEST(History, ForgetsTheBytesOfStepsThatAreDropped)
{
    Document document(all_operators());
    document.apply("make.cube");
    const std::size_t bytes = document.history().bytes();
    document.apply("make.grid nx=50 ny=50");
    document.apply("make.grid nx=50 ny=50");
    document.apply("document.undo steps=2");
    document.apply("select.faces faces=0");
    document.apply("document.undo");
    EXPECT_LT(document.history().bytes(), bytes + 4096);
}

} // namespace
} // namespace druse
