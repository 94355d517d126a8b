// Panes as a document keeps them: through commands, refusals, undo, files and facts.
#include "app/documents.h"
#include "app/info.h"
#include "app/registry.h"
#include "app/save.h"
#include "io/output.h"
#include "ops/shown_lines.h"
#include "support/shapes.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <random>

namespace druse {
namespace {

using namespace test;
using Json = nlohmann::ordered_json;

constexpr const char* square_pane = "pane.new loop=0,0,10,0,10,10,0,10 snap=0";

const Pane& pane_in(const Document& document) { return std::get<Pane>(*document.scene().source); }

Document with_pane(const std::vector<const char*>& commands = {})
{
    Document document(all_operators());
    document.apply(square_pane);
    for (const char* command : commands) EXPECT_EQ(complaint(document, command), "") << command;
    return document;
}

std::vector<std::string> notes_of(Document& document, const std::string& command) { return document.apply(command).notes; }

TEST(PaneInDocument, IsTheSameToTheByteAfterUndoAndRedo)
{
    Document document = document_of(all_operators(), cube());
    std::vector<std::uint64_t> states;
    const std::vector<std::string> commands{square_pane,
                                            "pane.add at=3,3",
                                            "pane.constrain line=1,1,9,8,1,8",
                                            "pane.constrain line=1,7,9,1",
                                            "pane.move point=2 to=12,11",
                                            "select.faces faces=0",
                                            "pane.add_boundary at=5,-2",
                                            "pane.refine min_angle=20 boundary=split",
                                            "pane.spread rounds=3",
                                            "pane.unrefine",
                                            "pane.unconstrain segment=0",
                                            "pane.remove point=4",
                                            "pane.lock points=0,1"};
    for (const std::string& command : commands) {
        EXPECT_EQ(complaint(document, command), "") << command;
        states.push_back(pane_in(document).fingerprint());
    }
    std::mt19937 random(4);
    for (int i = 0; i < 40; ++i) {
        const std::size_t step = 1 + random() % commands.size();
        document.apply(fmt::format("document.goto step={}", step));
        EXPECT_EQ(pane_in(document).fingerprint(), states[step - 1]) << commands[step - 1];
    }
    document.apply("document.goto step=0");
    EXPECT_TRUE(std::holds_alternative<std::monostate>(*document.scene().source));
    EXPECT_EQ(document.scene().mesh.face_count(), 6u); // which panes leave alone
}

TEST(PaneInDocument, ComesBackWhenAnotherSourceTookItsPlace)
{
    Document document = with_pane({"pane.add at=3,3"});
    const auto before = pane_in(document).fingerprint();
    document.apply("graph.lattice");
    EXPECT_EQ(complaint(document, "pane.add at=1,1"), "pane.add: the document holds a graph, not a pane");
    document.apply("pane.new loop=0,0,1,0,0,1");
    document.apply("pane.add at=0.2,0.2");
    EXPECT_EQ(complaint(document, "graph.struts source=lines"), "graph.struts: the document holds a pane, not a graph");
    document.apply("document.undo steps=3");
    EXPECT_EQ(pane_in(document).fingerprint(), before);
    document.apply("document.redo steps=3");
    EXPECT_EQ(pane_in(document).point_count(), 4u);
    Document empty(all_operators());
    EXPECT_EQ(complaint(empty, "pane.check"), "pane.check: the document holds no pane; pane.new makes one");
}

TEST(PaneInDocument, CostsAStepWhatItsEditChanges)
{
    Document document = with_pane();
    std::string line = "pane.constrain line=1,1,9,9";
    std::mt19937 random(5);
    for (int i = 0; i < 2000; ++i)
        document.apply(fmt::format("pane.add at={},{}", 0.01 + double(random() % 9900) / 1000, 0.01 + double(random() % 9900) / 1000));
    const History& history = document.history();
    std::size_t most = 0;
    for (std::size_t i = 1000; i < history.size(); ++i) most = std::max(most, history[i].bytes);
    EXPECT_LT(most, 20000u);
    EXPECT_GT(pane_in(document).bytes(), 200000u);
    document.apply("pane.spread rounds=100"); // every point again and again, yet kept once or twice
    EXPECT_LT(history[history.size() - 1].bytes, 3 * pane_in(document).bytes());
}

TEST(PaneInDocument, IsDraggedByTheLastStepRunAgain)
{
    Document dragged = with_pane({"pane.add at=5,5", "pane.move point=4 to=5,6"}), straight = with_pane({"pane.add at=5,5", "pane.move point=4 to=2,8"});
    Progress progress;
    for (const char* command : {"pane.move point=4 to=4,7", "pane.move point=4 to=3,9", "pane.move point=4 to=2,8"}) dragged.apply_again(command, progress);
    EXPECT_EQ(State(dragged), State(straight));
    const State before(dragged);
    EXPECT_THROW(dragged.apply_again("pane.move point=4 to=20,8", progress), CommandError);
    EXPECT_EQ(State(dragged), before);
}

/// One command that is refused by each word, with what makes it so.
struct PaneRefused {
    const char *name, *command, *word;
    std::vector<const char*> before{};
};

class RefusedPaneEdit : public testing::TestWithParam<PaneRefused> {};

TEST_P(RefusedPaneEdit, SaysItsWordAndChangesNothing)
{
    Document document = with_pane(GetParam().before);
    const auto before = pane_in(document).fingerprint();
    const std::string said = complaint(document, GetParam().command);
    const std::string command = GetParam().command;
    const std::string op = command.substr(0, command.find(' '));
    EXPECT_TRUE(said.starts_with(op + ": ")) << said;
    EXPECT_NE(said.find(std::string(" ") + GetParam().word + ": "), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos);
    EXPECT_EQ(pane_in(document).fingerprint(), before);
    EXPECT_EQ(document.history().size(), 1 + GetParam().before.size());
}

INSTANTIATE_TEST_SUITE_P(
    Panes, RefusedPaneEdit,
    testing::Values(PaneRefused{"bow_tie", "pane.new loop=0,0,10,10,10,0,0,10", "boundary-crosses"},
                    PaneRefused{"loop_twice_at_a_point", "pane.new loop=0,0,10,0,10,10,5,0,0,10", "boundary-touches"},
                    PaneRefused{"loop_of_two_points", "pane.new loop=0,0,10,10", "too-few-points"},
                    PaneRefused{"hole_of_two_points", "pane.new loop=0,0,10,0,0,10 hole=1,1,2,2", "too-few-points"},
                    PaneRefused{"hole_outside", "pane.new loop=0,0,10,0,0,10 hole=11,1,12,1,12,2", "boundary-crosses"},
                    PaneRefused{"far_loop", "pane.new loop=0,0,1e151,0,0,10", "range"},
                    PaneRefused{"tiny_weld", "pane.new loop=0,0,1,0,0,1 weld=1e-150", "range"},
                    PaneRefused{"add_outside", "pane.add at=11,5", "outside"},
                    PaneRefused{"add_twice", "pane.add at=5,5 strict=true", "coincides", {"pane.add at=5,5"}},
                    PaneRefused{"add_on_no_edge", "pane.add at=5,5 edge=0~77", "no-such-point"},
                    PaneRefused{"add_on_what_is_no_edge", "pane.add at=5,5 edge=4~5", "no-such-edge", {"pane.add at=1,1", "pane.add at=9,9", "pane.constrain line=1,9,9,1"}},
                    PaneRefused{"bulge_over_the_boundary", "pane.add_boundary at=5,12 edge=0~1", "boundary-crosses"},
                    PaneRefused{"bulge_onto_the_boundary", "pane.add_boundary at=5,10 edge=0~1", "boundary-touches"},
                    PaneRefused{"move_over_the_boundary", "pane.move point=0 to=12,5", "boundary-crosses"},
                    PaneRefused{"move_onto_the_boundary", "pane.move point=0 to=10,5", "boundary-touches"},
                    PaneRefused{"move_past_a_point", "pane.move point=0 to=5,6", "swallows-point", {"pane.add at=2,2"}},
                    PaneRefused{"move_outside", "pane.move point=4 to=11,5", "outside", {"pane.add at=5,5"}},
                    PaneRefused{"move_what_is_locked", "pane.move point=0 to=1,1", "locked", {"pane.lock points=0"}},
                    PaneRefused{"remove_before_a_point", "pane.remove point=0", "swallows-point", {"pane.add at=1,1"}},
                    PaneRefused{"remove_over_the_boundary", "pane.remove point=1", "boundary-crosses", {"pane.new loop=0,0,10,0,10,9,8,9,8,2,2,2,2,10,0,10"}},
                    PaneRefused{"remove_of_three", "pane.remove point=1", "too-few-points", {"pane.remove point=0"}},
                    PaneRefused{"remove_what_is_locked", "pane.remove point=0", "locked", {"pane.lock points=0"}},
                    PaneRefused{"constrain_outside", "pane.constrain line=1,1,11,1", "outside"},
                    PaneRefused{"constrain_through_the_outside", "pane.constrain from=0 to=1", "outside", {"pane.add_boundary at=5,5 edge=0~1"}},
                    PaneRefused{"constrain_to_itself", "pane.constrain from=1 to=1", "same-point"},
                    PaneRefused{"constrain_nothing", "pane.constrain path=0,99", "no-such-point"},
                    PaneRefused{"unconstrain_nothing", "pane.unconstrain segment=0", "no-such-segment"},
                    PaneRefused{"unconstrain_nothing_by_ends", "pane.unconstrain from=0 to=2", "no-such-segment"},
                    PaneRefused{"lock_nothing", "pane.lock points=0,9", "no-such-point"},
                    PaneRefused{"refine_too_far", "pane.refine min_angle=30.5", "angle-too-large"}),
    [](const auto& parameter) { return parameter.param.name; });

TEST(PaneOperators, SayWhatOneCouldNotKnow)
{
    Document document(all_operators());
    using Notes = std::vector<std::string>;
    EXPECT_EQ(notes_of(document, "pane.new loop=0,0,0,10,10,10,10,0 hole=1,1,2,1,2,2"),
              (Notes{"clockwise: the loop was turned round", "anticlockwise: hole 0 was turned round"}));
    EXPECT_EQ(notes_of(document, "pane.add at=5,5"), Notes());
    EXPECT_EQ(notes_of(document, "pane.add at=5,5.01"), (Notes{"coincides: point 7 is there already"}));
    EXPECT_EQ(notes_of(document, "pane.constrain line=4,7,9,7"), Notes());
    EXPECT_EQ(notes_of(document, "pane.constrain from=9 to=8"), (Notes{"duplicate: segment 0 is there already"}));
    EXPECT_EQ(notes_of(document, "pane.constrain line=6,6,6,9"), (Notes{"crossing: point 12"}));
    EXPECT_EQ(notes_of(document, "pane.move point=7 to=6,6"), (Notes{"merged: point 10 is now point 7"}));
}

TEST(PaneOperators, SayWhatARefinementCouldNotDo)
{
    Document document = with_pane();
    EXPECT_EQ(notes_of(document, "pane.refine min_angle=0 max_area=0.1"), std::vector<std::string>());
    EXPECT_EQ(pane_in(document).boundary_count(), 4u);
    EXPECT_EQ(complaint(document, "pane.refine max_area=1e-9"),
              "pane.refine: range: max_area=1e-09: it takes 5e+10 points and more, and 1000000 are the most; expected well above 5e-05");
    document.apply("pane.new loop=0,0,10,0,10,10,0,10 snap=0 weld=0.05");
    const auto larger = notes_of(document, "pane.refine min_angle=0 max_area=0.1");
    ASSERT_EQ(larger.size(), 1u);
    EXPECT_TRUE(larger[0].ends_with(" of them larger")) << larger[0];
    document.apply(square_pane);
    for (int i = 0; i < 7; ++i) document.apply(fmt::format("pane.constrain line=5,5,{},{}", 5 + 4 * std::cos(0.03 * i), 5 + 4 * std::sin(0.03 * i)));
    const auto stopped = notes_of(document, "pane.refine min_angle=30 boundary=split");
    ASSERT_EQ(stopped.size(), 2u);
    EXPECT_TRUE(stopped[0].starts_with("stopped at 60")) << stopped[0]; // fifty for each of twelve
    EXPECT_TRUE(stopped[1].ends_with(" fall short of what was asked for")) << stopped[1];
}

TEST(PaneOperators, TakeWhatExcludesOtherThingsOneAtATime)
{
    Document document = with_pane({"pane.add at=5,5"});
    EXPECT_EQ(complaint(document, "pane.constrain from=0"), "pane.constrain: from= and to= are given together");
    EXPECT_EQ(complaint(document, "pane.constrain from=0 to=2 path=0,2"), "pane.constrain: expected exactly one of from, path and line, found from and path");
    EXPECT_EQ(complaint(document, "pane.constrain line=0,0,1"), "pane.constrain: line=0,0,1: too-few-points: expected 4 or more numbers, found 3");
    EXPECT_EQ(complaint(document, "pane.constrain line=0,0,1,1,2"), "pane.constrain: line=0,0,1,1,2: expected x and y of each point, found 5 numbers");
    EXPECT_EQ(complaint(document, "pane.add at=1,2,3"), "pane.add: at=1,2,3: expected a point x,y");
    EXPECT_EQ(complaint(document, "pane.add at=1,2 edge=4"), "pane.add: edge=4: expected an edge by the ids of its ends, like 4~9");
    EXPECT_EQ(complaint(document, "pane.spread rounds=101"), "pane.spread: rounds=101: expected 1 to 100 (an integer)");
}

TEST(PaneOperators, TakeSeveralHolesAndWriteThemAgain)
{
    Document document(all_operators());
    const std::string text = document.apply("pane.new hole=1,1,2,1,2,2 loop=0,0,10,0,10,10,0,10 hole=5,5,6,5,6,6").text;
    EXPECT_EQ(text, "pane.new loop=0,0,10,0,10,10,0,10 hole=1,1,2,1,2,2 hole=5,5,6,5,6,6");
    EXPECT_EQ(pane_in(document).hole_count(), 2u);
    EXPECT_EQ(pane_in(document).position(PointId(7)), Point2(5, 5));
    EXPECT_EQ(complaint(document, "pane.new loop=0,0,1,0,0,1 loop=0,0,1,0,0,1"), "pane.new: loop is given twice");
    Document again(all_operators());
    again.apply(text);
    EXPECT_EQ(State(again), State(document));
}

TEST(PaneOperators, CheckCountsAndIsStrictOnlyAboutWhatIsWrong)
{
    Document document = with_pane({"pane.add at=5,0.01", "pane.constrain line=1,5,9,6"});
    const Document::Outcome outcome = document.apply("pane.check strict=true nozzle=1");
    EXPECT_FALSE(outcome.failed);
    const Json found = Json::parse(outcome.output);
    EXPECT_EQ(found["sound"], true);
    EXPECT_EQ(found["faults"], Json::array());
    EXPECT_EQ(found["points"], 7);
    EXPECT_EQ(found["triangles"], 8); // 2·3 + 4 − 2
    EXPECT_EQ(found["edges"], 14);    // 3·3 + 2·4 − 3
    EXPECT_EQ(found["area"], 100.0);
    EXPECT_GT(found["thin_triangles"], 0);
}

TEST(PaneInDocument, TellsItsFacts)
{
    Document document(all_operators());
    document.apply("pane.new loop=0,0,10,0,10,10,0,10 hole=4,4,4,6,6,4");
    document.apply("pane.add at=8,8");
    document.apply("pane.lock points=0,7");
    document.apply("pane.constrain from=7 to=2");
    const Json j = Json::parse(info_json(document.scene(), "a.pane.json"));
    EXPECT_EQ(j["kind"], "pane");
    EXPECT_EQ(j["points"], 8);
    EXPECT_EQ(j["boundary_points"], 7);
    EXPECT_EQ(j["holes"], 1);
    EXPECT_EQ(j["segments"], 1);
    EXPECT_EQ(j["triangles"], 9); // 2·1 + 7 + 2·1 − 2
    EXPECT_EQ(j["edges"], 17);    // 3·1 + 2·7 + 3·1 − 3
    EXPECT_EQ(j["euler"], 0);
    EXPECT_EQ(j["area"], 98.0);
    EXPECT_EQ(j["locked"], 2);
    EXPECT_GT(j["smallest_angle"], 0.0);
    EXPECT_TRUE(j["volume"].is_null());
    EXPECT_EQ(j["bbox"]["max"], Json({10.0, 10.0, 0.0}));
    EXPECT_NE(info_text(document.scene(), "a.pane.json").find("boundary points        7\n"), std::string::npos);
    document.apply("make.cube");
    const Json both = Json::parse(info_json(document.scene(), "a.pane.json"));
    EXPECT_EQ(both["kind"], "mesh");
    EXPECT_EQ(both["pane"]["triangles"], 9);
}

TEST(PaneInDocument, IsShownByItsEdgesWhileThereAreNoFaces)
{
    Document document = with_pane({"pane.add at=5,5"});
    {
        const ShownLines lines(document.scene());
        ASSERT_NE(lines.graph(), nullptr);
        EXPECT_EQ(lines.graph()->vertices.size(), 5u);
        EXPECT_EQ(lines.graph()->edges.size(), 8u);
    }
    document.apply("make.cube");
    EXPECT_EQ(ShownLines(document.scene()).graph(), nullptr);
}

TEST(PaneInDocument, IsSavedAndReadAgainAsItWas)
{
    const Folder folder;
    Document document(all_operators());
    for (const char* command : {"pane.new loop=0,0,10,0,10,10,0,10 hole=4,4,4,6,6,4", "pane.add at=8,8", "pane.constrain line=1,1,3,9", "pane.constrain line=3,1,1,9",
                                "pane.remove point=7", "pane.refine min_angle=15", "pane.lock points=2,5"})
        EXPECT_EQ(complaint(document, command), "") << command;
    const auto save = [&](const Document& d, const char* name) {
        OutputSet output;
        write_document(d, output, folder / name);
        output.commit();
        return folder.read(name);
    };
    const std::string bytes = save(document, "a.pane.json");
    Document again(all_operators());
    Progress progress;
    EXPECT_EQ(again.open(folder / "a.pane.json", progress).notes, std::vector<std::string>());
    EXPECT_TRUE(pane_in(again) == pane_in(document));
    EXPECT_EQ(save(again, "b.pane.json"), bytes);
    // What depends on how points came to be goes on too.
    for (const char* command : {"pane.unconstrain segment=1", "pane.unrefine", "pane.add at=9,9"}) {
        EXPECT_EQ(complaint(document, command), "");
        EXPECT_EQ(complaint(again, command), "");
    }
    EXPECT_EQ(save(again, "b.pane.json"), save(document, "a.pane.json"));
    Document mesh = document_of(all_operators(), cube());
    EXPECT_THROW(save(mesh, "c.pane.json"), InputError);
    Document of_script(all_operators());
    of_script.apply("document.open file=a.pane.json", progress, folder.path());
    EXPECT_TRUE(pane_in(of_script) == pane_in(again));
}

} // namespace
} // namespace druse
