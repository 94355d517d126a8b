// Cells as a document keeps them: through commands, refusals, undo, files and facts.
#include "app/documents.h"
#include "app/info.h"
#include "app/registry.h"
#include "app/save.h"
#include "cell/cell_solid.h"
#include "io/output.h"
#include "support/folder.h"
#include "support/mesh_checks.h"

#include <nlohmann/json.hpp>

#include <string>

namespace druse {
namespace {

using namespace test;
using CellJson = nlohmann::json;

const CellTile& cell_in(const Document& document) { return std::get<CellTile>(*document.scene().source); }

/// A cell with all that a file keeps: points, lines, moves, splits, a flip, a skew and a pane that is rolled back.
Document shaped_cell()
{
    Document document(all_operators());
    for (const char* command :
         {"cell.new cell=fcc size=40", "cell.point_add pane=0 at=2,3", "cell.point_add pane=0 at=-3,1", "cell.point_add pane=3 at=0,2", "cell.edge_add edge=0 t=0.5",
          "cell.edge_add edge=2 t=0.25", "cell.constrain pane=0 from=v0 to=i0", "cell.shape", "cell.move points=p0:i0 along=radial amount=2", "cell.move points=x0:1,c2 by=1,0,-2",
          "cell.move points=p3:i0 along=normal amount=1.5", "cell.move points=p0:i1 pane=0 plane=0.5,0.25", "cell.split face=p0:2 at=0.2,0.3,0.5", "cell.split_edge pane=1 edge=v0,v1 t=0.5",
          "cell.move points=s1 by=0.5,0.5,0", "cell.skew entry=xy value=0.3", "cell.rollback pane=3", "cell.point_add pane=3 at=3,-2"})
        EXPECT_EQ(complaint(document, command), "") << command;
    return document;
}

std::string saved_cell(const Document& document, const Folder& folder, const char* name)
{
    OutputSet output;
    write_document(document, output, folder.path() / name);
    output.commit();
    return folder.read(name);
}

Document opened_cell(const std::filesystem::path& path)
{
    Document document(all_operators());
    Progress progress;
    document.open(path, progress);
    return document;
}

TEST(CellInDocument, MakesASolidWithAGroupForEachPairOfPanes)
{
    Document document = shaped_cell();
    document.apply("cell.shape");
    document.apply("cell.solid");
    const Mesh& mesh = document.scene().mesh;
    EXPECT_SOUND(mesh);
    EXPECT_EQ(genus(mesh), 0);
    EXPECT_NEAR(volume(mesh), 16000, 16000e-9); // det M = 1, size³/4
    const CellJson info = CellJson::parse(info_json(document.scene(), "a.tile"));
    EXPECT_EQ(info["groups"].size(), 6u);
    EXPECT_EQ(info["cell"]["cell"], "fcc");
    EXPECT_EQ(info["cell"]["phase"], 2);
    EXPECT_EQ(info["cell"]["panes"], 6);
    EXPECT_EQ(info["cell"]["orbits"], (CellJson{{"corner", 3}, {"edge", 3}, {"pane", 5}})); // x0:1, x2:1 and s1; four points and s0
    EXPECT_NEAR(double(info["cell"]["volume_expected"]), 16000, 1e-6);
}

TEST(CellInDocument, GoesBackToTheStartByUndo)
{
    Document document = shaped_cell();
    const CellDesign last = cell_in(document).design();
    const std::size_t steps = document.history().done();
    for (std::size_t i = 1; i < steps; ++i) document.apply("document.undo");
    EXPECT_EQ(cell_in(document).design(), CellTile::of_kind(CellKind::fcc, 40).design());
    for (std::size_t i = 1; i < steps; ++i) document.apply("document.redo");
    EXPECT_EQ(cell_in(document).design(), last);
}

TEST(CellInDocument, KeepsForUndoOnlyWhatAnEditChanged)
{
    CellDesign design = CellTile::of_kind(CellKind::bcc, 40).design();
    for (auto& pane : design.panes)
        for (int i = 0; i < 800; ++i) pane.points.emplace_back((i % 28 - 13.5) * 0.3, (i / 28 - 14) * 0.3); // in its middle
    Model model;
    model.cell.emplace(std::move(design));
    Document document(all_operators());
    document.open(std::move(model));
    document.apply("cell.shape");
    const CellTile& cell = cell_in(document);
    ASSERT_GT(cell.point_count(), 5000);
    const std::size_t before = document.history().bytes();
    document.apply("cell.move points=p3:i4 by=0.1,0,0");
    // The moves of its pane, not the others, and no triangles.
    EXPECT_LT(document.history().bytes() - before, cell.interior(3).size() * sizeof(Vector) + 20'000);
}

TEST(CellInDocument, RefusesByOneWordAndStaysAsItWas)
{
    struct Case {
        const char *command, *complaint;
    };
    for (const Case& c : {Case{"cell.point_add pane=0 at=1,1", "cell.point_add: phase: "}, Case{"cell.point_move point=x0:1 to=1,1", "cell.point_move: fixed: "},
                          Case{"cell.skew matrix=1,0,0,0,1,0,0,0,0", "cell.skew: flat-cell: "}, Case{"cell.move points=p9:i0 by=1,0,0", "cell.move: no-such-point: "},
                          Case{"cell.move points=p3:i0 by=1,0,0", "cell.move: phase: "}, Case{"cell.split face=p0:900 at=0.2,0.3,0.5", "cell.split: no-such-triangle: "},
                          Case{"cell.split face=p0:0 at=0.2,0.3,0.6", "cell.split: at=0.2,0.3,0.6: "}, Case{"cell.rollback pane=3", "cell.rollback: phase: "},
                          Case{"cell.move points=c0 along=normal amount=1", "cell.move: along=normal: c0 is in several panes"},
                          Case{"cell.move points=c0 along=x", "cell.move: along= and amount="}, Case{"cell.move points=c0 by=1,2", "cell.move: by=1,2: expected 3 numbers"},
                          Case{"cell.move points=c0 along=1,1 amount=1", "cell.move: along=1,1: expected 3 numbers"},
                          Case{"cell.move points=c0 by=1,2,3 pane=0", "cell.move: pane= says whose plane or normal"},
                          Case{"cell.move points=c0 along=x amount=1 pane=0", "cell.move: pane= says whose plane or normal"},
                          Case{"cell.new size=1e-300", "cell.new: size 1e-300: expected 1e-30 to 1e30"},
                          Case{"cell.new cell=hexprism size=1 height=1e-200", "cell.new: height 1e-200: expected 1e-30 to 1e30"},
                          Case{"cell.solid clearance=1e300", "cell.solid: vanishes: "}, Case{"cell.assemble clearance=100", "cell.assemble: vanishes: "}, Case{"cell.edge_add edge=11", "cell.edge_add: no-such-edge"}}) {
        Document document = shaped_cell();
        const CellDesign before = cell_in(document).design();
        EXPECT_TRUE(complaint(document, c.command).starts_with(c.complaint)) << complaint(document, c.command);
        EXPECT_EQ(cell_in(document).design(), before);
    }
}

TEST(CellAssembly, IsACellForEachNeighbour)
{
    for (const auto& [kind, cells] : {std::pair("cube", 7), std::pair("hexprism", 9), std::pair("fcc", 13), std::pair("elongated", 13), std::pair("bcc", 15)}) {
        Document document(all_operators());
        document.apply(std::string("cell.new size=4 cell=") + kind);
        const double one = cell_in(document).volume();
        document.apply("cell.assemble shrink=0.5");
        EXPECT_NEAR(volume(document.scene().mesh), cells * one / 8, 1e-9 * cells * one);
        EXPECT_EQ(int(components(document.scene().mesh).parts.size()), cells);
    }
}

TEST(CellFile, ComesBackToTheByte)
{
    const Folder folder;
    Document document = shaped_cell();
    const std::string first = saved_cell(document, folder, "a.tile");
    const Document again = opened_cell(folder.path() / "a.tile");
    EXPECT_EQ(cell_in(again).design().moved, cell_in(document).design().moved);
    EXPECT_EQ(make_solid(cell_in(again)).points, make_solid(cell_in(document)).points);
    EXPECT_EQ(saved_cell(again, folder, "b.tile"), first);

    // What is not ours stays, where it is.
    std::string other = first;
    other.insert(other.find("\"matrix\""), "\"view\": {\"camera\": [1, 2, 3]},\n  ");
    other.insert(other.find("{\"points\"") + 1, "\"colour\": \"#ff0000\", ");
    folder.write("c.tile", other);
    EXPECT_EQ(saved_cell(opened_cell(folder.path() / "c.tile"), folder, "d.tile"), other);
}

TEST(CellFile, SaysLineAndKeyOfWhatIsWrong)
{
    const Folder folder;
    const std::string good = saved_cell(shaped_cell(), folder, "a.tile");
    struct Case {
        const char *from, *to, *complaint;
    };
    for (const Case& c : {Case{"\"fcc\"", "\"fec\"", "5: cell: 'fec' is no cell"}, Case{"\"size\": 40", "\"size\": -1", "6: size: "},
                          Case{"[1, 0.3, 0, 0, 1", "[0, 0.3, 0, 0, 1", "7: matrix: flat-cell"}, Case{"[1, 0.3, 0, 0, 1", "[1, 0.3, 0, 0", "7: matrix: expected 9 numbers"},
                          Case{"[2, 3]", "[200, 3]", "8: panes[0].points: outside"}, Case{"[\"v0\", \"i0\"]", "[\"v0\", \"i7\"]", "8: panes[0].segments: no-such-point"},
                          Case{"[\"v0\", \"i0\"]", "[\"v0\", 7]", "8: panes[0].segments[0][1]: expected a text"}, Case{"[0.5]", "[1.5]", "9: edges[0]: "},
                          Case{"\"phase\": 2", "\"phase\": 1", "11: shape: is of phase 2"}, Case{"\"phase\": 2", "\"phase\": 3", "10: phase: "},
                          Case{"\"c2\"", "\"c7\"", "11: shape.moved.c7: no-such-point"}, Case{"\"triangle\": 2", "\"triangle\": 99", "11: shape.splits[0]: no-such-triangle"},
                          Case{"\"triangle\": 2", "\"triangle\": 0.5", "11: shape.splits[0].triangle: expected a whole number"},
                          Case{"\"new\": [\"i1\"]", "\"new\": [\"i9\"]", "11: shape.flat: no-such-point"}, Case{"\"kind\": \"cell\"", "\"kind\": \"sell\"", "3: kind: expected"}}) {
        std::string bad = good;
        ASSERT_NE(bad.find(c.from), std::string::npos) << c.from << "\n" << good;
        bad.replace(bad.find(c.from), std::string(c.from).size(), c.to);
        folder.write("bad.tile", bad);
        try {
            opened_cell(folder.path() / "bad.tile");
            ADD_FAILURE() << "is read: " << c.to;
        } catch (const std::exception& e) {
            EXPECT_NE(std::string(e.what()).find("bad.tile:" + std::string(c.complaint)), std::string::npos) << e.what();
        }
    }
}

TEST(CellOperators, MissPointsWhereNoneAreSelected)
{
    Document document = shaped_cell();
    document.apply("cell.solid");
    document.apply("select.vertices vertices=none");
    EXPECT_EQ(complaint(document, "cell.move points=selected by=0,0,1"), "cell.move: points=selected: no points of the cell are selected");
    EXPECT_EQ(complaint(document, "cell.move points=none by=0,0,1"), "");
}

TEST(CellOperators, TakeSelectedVerticesOfTheSolidOnly)
{
    Document document(all_operators());
    for (const char* command : {"cell.new cell=cube size=4", "cell.shape", "cell.solid", "select.vertices vertices=7"}) document.apply(command);
    const Point corner = document.scene().mesh.position(Vertex(7));
    EXPECT_EQ(complaint(document, "cell.move points=selected along=radial amount=1"), "");
    // All eight corners are one orbit: they move as the selected one says.
    EXPECT_LT(glm::length(cell_in(document).moved(0) - glm::normalize(corner)), 1e-12);
    const char* refused = "cell.move: points=selected: the mesh is not the solid of this cell as it is now: run cell.solid and select again";
    EXPECT_EQ(complaint(document, "cell.move points=selected by=0,0,1"), refused); // it was moved
    document.apply("cell.assemble");
    document.apply("select.vertices vertices=0");
    EXPECT_EQ(complaint(document, "cell.move points=selected by=0,0,1"), refused);
}

TEST(CellOperators, MoveAlongTheCornerThatIsNamed)
{
    for (const char* corner : {"0", "1", "2", "3"}) {
        Document document(all_operators());
        for (const char* command : {"cell.new cell=cube size=4", "cell.shape"}) document.apply(command);
        const CellTile before = cell_in(document);
        document.apply(std::string("cell.move points=p0:v") + corner + " along=radial amount=1");
        const Point place = before.cell().corner(before.cell().panes[0].corners[std::size_t(corner[0] - '0')]);
        EXPECT_LT(glm::length(cell_in(document).moved(0) - glm::normalize(place)), 1e-12) << corner;
    }
}

TEST(CellInfo, TellsWhereItsSolidMeetsItself)
{
    Document document(all_operators());
    Progress progress;
    for (const char* command : {"cell.new cell=cube size=4", "cell.point_add pane=0 at=0,0", "cell.shape"}) document.apply(command);
    const auto told = [&] { return CellJson::parse(info_json(document.scene(), "a.tile", self_intersections(document.scene(), progress)))["self_intersections"]; };
    EXPECT_EQ(told(), 0);
    document.apply("cell.move points=p0:i0 by=-1,7,0"); // through a side
    EXPECT_GT(int(told()), 0);
    EXPECT_EQ(info_text(document.scene(), "a.tile", self_intersections(document.scene(), progress)).find("self-intersections     none"), std::string::npos);
}

TEST(CellFile, KeepsWhatElseIsSaidOfSplitsAndRefusesWhatIsThereTwice)
{
    const Folder folder;
    const std::string good = saved_cell(shaped_cell(), folder, "a.tile");
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        EXPECT_NE(text.find(from), std::string::npos) << from;
        folder.write("b.tile", text.replace(text.find(from), from.size(), to));
        try {
            return saved_cell(opened_cell(folder.path() / "b.tile"), folder, "c.tile");
        } catch (const std::exception& e) {
            return std::string(e.what());
        }
    };
    EXPECT_NE(with("\"new\": [\"i1\"]", "\"new\": [\"i1\"], \"note\": \"mine\"").find("\"note\": \"mine\""), std::string::npos);
    EXPECT_NE(with("\"triangle\": 2", "\"note\": \"mine\", \"triangle\": 2").find("\"note\": \"mine\""), std::string::npos);
    EXPECT_NE(with("\"c2\":", "\"c02\": [1, 2, 3], \"c2\":").find("11: shape.moved.c2: is moved twice"), std::string::npos);
    EXPECT_NE(with("\"flat\": [", "\"flat\": [{\"pane\": 3}, ").find("shape.flat[1].pane: 3 is there twice"), std::string::npos);
    EXPECT_NE(with("\"c2\": [1,", "\"c2\": [1e39,").find("11: shape.moved.c2: c2 would be farther than 1e38"), std::string::npos);
}

} // namespace
} // namespace druse
