#include "ui/live_step.h"
#include "ui/session.h"

#include "app/registry.h"
#include "support/folder.h"
#include "support/mesh_checks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>

namespace druse::ui {
namespace {

/// A session on a cube of edge length 1, with everything that happened in it.
class CubeSession : public testing::Test {
protected:
    CubeSession() : session(all_operators())
    {
        session.on_event = [this](const std::string& line) { events.push_back(line); };
        run("make.cube");
    }
    void run(const std::string& command)
    {
        session.run(command);
        session.wait();
    }
    void choose(const char* name) { session.choose(&all_operators().get(name)); }
    void click(int face)
    {
        session.apply_chosen({{"faces", std::to_string(face)}});
        session.wait();
    }
    void set(const char* parameter, const char* value)
    {
        session.set(parameter, value);
        session.wait();
    }
    const std::vector<std::string>& steps() const { return session.display().steps; }

    Session session;
    std::vector<std::string> events;
};

TEST_F(CubeSession, ShowsWhatACommandMade)
{
    EXPECT_EQ(session.display().counts, (Counts{8, 12, 6}));
    EXPECT_EQ(session.display().lists.triangle_count(), 12u);
    EXPECT_EQ(session.display().facts->genus, 0);
    EXPECT_EQ(steps(), std::vector<std::string>{"make.cube"});
    EXPECT_EQ(events, std::vector<std::string>{"applied make.cube faces=6"});
}

TEST_F(CubeSession, ShowsAGraphAsLinesAndStrutsThatFollowASlider)
{
    run("graph.wireframe");
    EXPECT_EQ(session.display().lists.edge_limit(), 12u);
    EXPECT_EQ(session.display().lists.triangle_count(), 0u);
    run("graph.lattice cells=1,1,1"); // the mesh stays empty, and another graph is shown
    EXPECT_EQ(session.display().lists.edge_limit(), 16u);
    choose("graph.struts");
    session.apply_chosen({});
    session.wait();
    set("sides", "8");
    EXPECT_EQ(steps(), (std::vector<std::string>{"make.cube", "graph.wireframe", "graph.lattice cells=1,1,1", "graph.struts sides=8"}));
    EXPECT_EQ(session.display().facts->genus, 3);
    run("document.undo");
    EXPECT_EQ(session.display().lists.edge_limit(), 16u);
    EXPECT_EQ(session.display().lists.triangle_count(), 0u);
}

TEST_F(CubeSession, AStepThatIsDraggedTakesThePlaceOfNoneThatWasBegunBefore)
{
    session.run("remesh.catmull_clark iterations=6"); // longer than anybody waits for
    LiveStep step(session);
    session.on_change = [&] { step.go_on(); };
    step.send("extrude.cubical faces=0 heights=0.1");
    session.wait();
    session.wait();
    step.send("extrude.cubical faces=0 heights=0.2");
    session.wait();
    ASSERT_EQ(steps().size(), 3u);
    EXPECT_TRUE(steps()[1].starts_with("remesh.catmull_clark")) << steps()[1];
    step.cancel();
    session.wait();
    EXPECT_EQ(session.display().done, 2u);
    session.on_change = nullptr;
}

TEST_F(CubeSession, AnErrorIsSaidAndChangesNothing)
{
    run("extrude.cubical faces=99");
    EXPECT_EQ(session.message().kind, Message::Kind::error);
    EXPECT_NE(session.message().text.find("extrude.cubical"), std::string::npos);
    EXPECT_EQ(session.display().counts, (Counts{8, 12, 6}));
    EXPECT_EQ(steps().size(), 1u);
    run("no.such");
    EXPECT_EQ(session.message().kind, Message::Kind::error);
}

TEST_F(CubeSession, AClickThatCannotBeDoneLeavesItsFaceMarked)
{
    choose("extrude.cubical");
    session.set("heights", "2");
    session.apply_chosen({{"faces", "3"}, {"angle", "270"}});
    session.wait();
    EXPECT_EQ(session.message().kind, Message::Kind::error);
    EXPECT_EQ(session.failed_faces(), std::vector<Face>{Face(3)});
    click(3);
    EXPECT_TRUE(session.failed_faces().empty());
}

TEST_F(CubeSession, AClickNamesItsFaceAndOnlyWhatIsNotTheDefault)
{
    choose("extrude.cubical");
    session.set("angle", "80");
    session.set("heights", "0.5");
    session.set("heights", "1"); // the default again
    click(4);
    EXPECT_EQ(steps().back(), "extrude.cubical faces=4 angle=80");
    EXPECT_EQ(session.display().counts, (Counts{12, 20, 10}));
}

TEST_F(CubeSession, ASliderRunsTheLastStepAgainInsteadOfAddingOne)
{
    choose("extrude.cubical");
    click(0);
    for (const char* angle : {"80", "70", "60"}) set("angle", angle);
    EXPECT_EQ(steps(), (std::vector<std::string>{"make.cube", "extrude.cubical faces=0 angle=60"}));

    Session direct(all_operators());
    direct.run("make.cube");
    direct.wait();
    direct.run("extrude.cubical faces=0 angle=60");
    direct.wait();
    EXPECT_TRUE(*session.mesh() == *direct.mesh());
    session.undo();
    session.wait();
    EXPECT_EQ(session.display().counts, (Counts{8, 12, 6}));
}

TEST_F(CubeSession, APanelLetsGoOfItsStepWhenSomethingElseHappens)
{
    choose("extrude.cubical");
    click(0);
    EXPECT_TRUE(session.is_bound());
    EXPECT_EQ(session.bound_target(), "faces=0");
    run("select.faces faces=1");
    EXPECT_FALSE(session.is_bound());
    set("angle", "80");
    EXPECT_EQ(steps().size(), 3u);
}

TEST_F(CubeSession, WithoutLiveASliderOnlySetsTheValueOfTheNextStep)
{
    session.set_live(false);
    choose("extrude.cubical");
    click(0);
    set("angle", "80");
    EXPECT_EQ(steps().back(), "extrude.cubical faces=0");
    click(0);
    EXPECT_EQ(steps().back(), "extrude.cubical faces=0 angle=80");
}

TEST_F(CubeSession, AValueThatIsOutOfRangeIsRefusedWithTheTextOfTheTerminal)
{
    choose("extrude.cubical");
    session.set("angle", "270");
    EXPECT_EQ(session.message().text, "extrude.cubical: angle=270: expected 1 to 179 degrees");
    EXPECT_EQ(session.arguments().text("angle"), "90");
}

TEST_F(CubeSession, AnAdjustmentThatFailsLeavesTheStepAsItWas)
{
    choose("make.torus");
    session.apply_chosen();
    session.wait();
    const std::string before = steps().back();
    set("minor", "5"); // in the range of its type, but not below the major radius
    EXPECT_EQ(session.message().kind, Message::Kind::error);
    EXPECT_EQ(steps().back(), before);
}

TEST_F(CubeSession, EachOperatorKeepsItsValues)
{
    choose("extrude.cubical");
    session.set("angle", "80");
    choose("extrude.octahedral");
    EXPECT_TRUE(session.arguments().is_default("angle"));
    choose("extrude.cubical");
    EXPECT_EQ(session.arguments().text("angle"), "80");
    session.reset_arguments();
    EXPECT_EQ(session.arguments().text("angle"), "90");
}

TEST_F(CubeSession, UndoRedoAndGoToFollowTheHistory)
{
    choose("extrude.cubical");
    click(0);
    click(0);
    EXPECT_EQ(session.display().counts.faces, 14u);
    session.undo();
    session.wait();
    EXPECT_EQ(session.display().counts.faces, 10u);
    EXPECT_EQ(session.display().done, 2u);
    EXPECT_EQ(steps().size(), 3u);
    session.redo();
    session.wait();
    EXPECT_EQ(session.display().counts.faces, 14u);
    session.go_to(0);
    session.wait();
    EXPECT_EQ(session.display().counts.faces, 0u);
    EXPECT_EQ(session.display().lists.triangle_count(), 0u);
}

TEST_F(CubeSession, TheDrawnTrianglesAreThoseOfTheMeshAfterEveryStep)
{
    choose("extrude.icosahedral");
    const auto agrees = [&] {
        const DrawLists fresh(*session.mesh(), [](int) { return Colour(); });
        ASSERT_EQ(session.display().lists.triangle_count(), fresh.triangle_count());
        for (const Face f : session.mesh()->faces()) ASSERT_EQ(session.display().lists.triangles(f).count, fresh.triangles(f).count);
        for (const Vertex v : session.mesh()->vertices()) ASSERT_EQ(session.display().lists.position(v.index), session.mesh()->position(v));
    };
    click(0);
    agrees();
    for (const char* n : {"3", "1", "2"}) {
        set("iterations", n); // more faces, then fewer, than are drawn
        agrees();
    }
    session.undo();
    session.wait();
    agrees();
    session.redo();
    session.wait();
    agrees();
    run("topology.delete_edge edges=0");
    agrees();
}

TEST_F(CubeSession, KnowsWhetherTheStateOnDiskIsTheOneShown)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "druse_session_test";
    std::filesystem::create_directories(folder);
    EXPECT_EQ(session.title(), "untitled*");
    session.save(folder / "cube.obj");
    session.wait();
    EXPECT_EQ(session.title(), "cube.obj");
    EXPECT_EQ(session.saved_step(), 1u);
    choose("extrude.cubical");
    click(0);
    EXPECT_EQ(session.title(), "cube.obj*");
    session.undo();
    session.wait();
    EXPECT_FALSE(session.is_changed());
    session.undo();
    session.wait();
    EXPECT_TRUE(session.is_changed());
    run("make.tetrahedron"); // takes the place of the saved state
    EXPECT_TRUE(session.is_changed());
    EXPECT_FALSE(session.saved_step());

    session.export_to(folder / "cube.stl");
    session.wait();
    EXPECT_TRUE(std::filesystem::exists(folder / "cube.stl"));
    EXPECT_EQ(session.file(), folder / "cube.obj");
    session.open(folder / "cube.obj");
    session.wait();
    EXPECT_EQ(session.display().counts, (Counts{8, 12, 6}));
    EXPECT_FALSE(session.is_changed());
    session.open(folder / "not_there.obj");
    session.wait();
    EXPECT_EQ(session.message().kind, Message::Kind::error);
    EXPECT_EQ(session.title(), "cube.obj");
    session.start_over();
    session.wait();
    EXPECT_EQ(session.title(), "untitled");
    EXPECT_EQ(session.display().counts, Counts());
}

TEST_F(CubeSession, ItsScriptMakesTheSameMesh)
{
    choose("extrude.dodecahedral");
    click(0);
    set("angle", "100");
    run("remesh.catmull_clark iterations=1");
    const std::filesystem::path script = std::filesystem::path(testing::TempDir()) / "druse_session_test.druse";
    std::ofstream(script) << session.script();
    Session other(all_operators());
    other.open(script);
    other.wait();
    EXPECT_EQ(other.message().kind, Message::Kind::note) << other.message().text;
    EXPECT_TRUE(*session.mesh() == *other.mesh());
}

TEST_F(CubeSession, ASolidBringsItsOwnAngleAndAHeightForEachTier)
{
    choose("extrude.solid");
    EXPECT_TRUE(session.implied().empty());
    session.set("solid", "dodecahedron");
    EXPECT_EQ(session.shown_text("angle"), "116.565051"); // acos(-1/sqrt 5)
    EXPECT_EQ(session.shown_text("heights"), "1,1,1");
    session.set("heights", "1,0.5,1");
    click(0);
    EXPECT_EQ(steps().back(), "extrude.solid solid=dodecahedron heights=1,0.5,1 faces=0");
    set("angle", "100");
    EXPECT_EQ(session.shown_text("angle"), "100");
    set("solid", "cube"); // of one tier: what was set for three goes
    EXPECT_EQ(session.shown_text("heights"), "1");
    EXPECT_EQ(steps().back(), "extrude.solid solid=cube angle=100 faces=0");
    EXPECT_EQ(steps().size(), 2u);
    set("solid", "no_such");
    EXPECT_EQ(session.message().kind, Message::Kind::error);
    EXPECT_EQ(steps().size(), 2u);
    EXPECT_EQ(session.display().counts, (Counts{12, 20, 10}));
}

TEST_F(CubeSession, AfterManyAdjustmentsTheRecordedHistoryMakesTheSameMesh)
{
    choose("extrude.solid");
    session.set("solid", "truncated_cube");
    click(5);
    for (const char* angle : {"95", "100", "105", "80"}) set("angle", angle);
    for (const char* heights : {"1,1,2", "1,0.5,2"}) set("heights", heights);
    set("iterations", "2");
    EXPECT_EQ(steps().size(), 2u);
    Document recorded(all_operators());
    for (const std::string& step : steps()) recorded.apply(step);
    EXPECT_TRUE(*session.mesh() == recorded.scene().mesh);
}

TEST_F(CubeSession, APresetSetsItsValuesAndLeavesAllOthersAtTheirDefaults)
{
    choose("extrude.cubical");
    session.set("angle", "70");
    session.set("iterations", "3");
    session.set("faces", "all");
    session.store_preset("tower of three");
    session.reset_arguments();
    session.set("heights", "2");
    EXPECT_THROW(session.take_preset("tower of four"), CommandError);
    session.take_preset("tower of three");
    EXPECT_EQ(session.arguments().command(), "extrude.cubical angle=70 iterations=3");
    click(0);
    EXPECT_EQ(steps().back(), "extrude.cubical faces=0 angle=70 iterations=3");
    session.reset_arguments(); // the step is bound still
    session.wait();
    EXPECT_EQ(steps().back(), "extrude.cubical faces=0");
    run("extrude.cubical faces=1 preset=\"tower of three\" angle=80");
    EXPECT_EQ(steps().back(), "extrude.cubical faces=1 angle=80 iterations=3");
    session.forget_preset("tower of three");
    EXPECT_TRUE(session.presets().of(*session.chosen()).empty());
}

TEST_F(CubeSession, APresetThatDoesNotFitIsRefusedAsAWhole)
{
    choose("extrude.cubical");
    session.set("angle", "70");
    session.take_preset(Preset{"broken", "iterations=2 angle=270"});
    EXPECT_EQ(session.message().kind, Message::Kind::error);
    EXPECT_EQ(session.arguments().command(), "extrude.cubical angle=70");
}

TEST_F(CubeSession, AQueryTellsWhatItFoundAndIsNoStep)
{
    std::string found;
    session.on_output = [&](const std::string&, const std::string& text) { found = text; };
    run("check.manifold");
    EXPECT_EQ(found.front(), '{');
    EXPECT_EQ(steps().size(), 1u);
}

TEST(Session, ALongCommandDoesNotHoldUpTheCallerAndCanBeCancelled)
{
    Session session(all_operators());
    session.run("make.sphere nu=200 nv=100");
    session.wait();
    const Counts before = session.display().counts;
    std::atomic<int> woken{0};
    session.wake = [&] { ++woken; };

    session.run("remesh.catmull_clark iterations=3"); // a million faces
    ASSERT_TRUE(session.busy());
    EXPECT_EQ(session.mesh(), nullptr);
    EXPECT_EQ(session.display().counts, before);
    session.run("select.faces faces=all");
    EXPECT_NE(session.message().text.find("still busy"), std::string::npos);
    session.cancel();
    session.wait();
    EXPECT_EQ(session.message().text, "cancelled");
    EXPECT_EQ(session.display().counts, before);
    EXPECT_EQ(session.display().steps.size(), 1u);
    EXPECT_FALSE(session.busy());
    while (woken == 0) std::this_thread::yield(); // the worker says so after the job is done
    EXPECT_EQ(woken, 1);
}

TEST(Session, WhileAStepIsAdjustedOnlyTheNewestValueIsKept)
{
    Session session(all_operators());
    int adjusted = 0;
    session.on_event = [&](const std::string& line) { adjusted += line.starts_with("adjusted"); };
    session.choose(&all_operators().get("make.grid"));
    session.apply_chosen({{"ny", "1000"}});
    session.wait();
    for (const char* nx : {"500", "501", "502", "503", "2"}) session.set("nx", nx);
    session.wait();
    EXPECT_EQ(session.display().steps.back(), "make.grid nx=2 ny=1000");
    EXPECT_LT(adjusted, 5);
}

TEST(Session, WhatIsAskedForDuringAnAutosaveIsDoneOrRefusedButNeverForgotten)
{
    const test::Folder folder;
    Session session(all_operators());
    session.run("make.grid nx=300 ny=300");
    session.wait();
    session.keep_copy(folder / "copy.obj");
    session.save(folder / "saved.obj");
    session.run("make.cube");
    const bool refused = session.message().text.find("still busy") != std::string::npos;
    session.wait();
    EXPECT_TRUE(std::filesystem::exists(folder / "copy.obj"));
    EXPECT_TRUE(std::filesystem::exists(folder / "saved.obj"));
    EXPECT_EQ(session.display().steps.size(), refused ? 1u : 2u);
}

TEST(Session, AScriptWhoseStrictQueryFailsIsNotOpened)
{
    const test::Folder folder;
    folder.write("strict.druse", "make.cube\nmesh.transform vertices=0 move=0.3,0,0\ncheck.planarity strict=true\n");
    Session session(all_operators());
    session.run("make.cube size=3");
    session.wait();
    session.open(folder / "strict.druse");
    session.wait();
    EXPECT_EQ(session.message().kind, Message::Kind::error);
    EXPECT_NE(session.message().text.find("check.planarity: found something wrong"), std::string::npos) << session.message().text;
    EXPECT_TRUE(session.file().empty());
    EXPECT_TRUE(session.is_changed());
    EXPECT_EQ(session.display().steps, std::vector<std::string>{"make.cube size=3"});
}

TEST(Session, TheFactsOfALargeMeshAreCountedOnDemand)
{
    Session session(all_operators());
    session.run("make.grid nx=200 ny=200");
    session.wait();
    EXPECT_FALSE(session.display().facts);
    std::vector<std::string> events;
    session.on_event = [&](const std::string& line) { events.push_back(line); };
    session.count_facts();
    session.run("make.cube"); // need not wait for them
    session.wait();
    EXPECT_EQ(session.display().counts.faces, 40007u);
    EXPECT_EQ(events, std::vector<std::string>{"applied make.cube faces=40007"});
    session.count_facts();
    session.wait();
    EXPECT_EQ(session.display().facts->components, 2u);
}

} // namespace
} // namespace druse::ui
