#include "app/document.h"

#include "app/documents.h"
#include "app/registry.h"
#include "dlfl/mesh_tables.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

namespace druse {
namespace {

using namespace test;

enum class How { command, input, cancelled, memory, internal, unsound_selection, success };

struct Trouble {
    How how = How::command;
};

/// Changes everything that can be changed, makes holes, and then fails in the way asked for.
void make_trouble(Scene& scene, const Trouble& p, Context& context)
{
    Mesh& mesh = scene.mesh;
    for (const Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v) * 2.0 + Vector(1.0));
    if (mesh.face_count() > 0) mesh.set_group(first_face(mesh), 77);
    const Vertex a = mesh.create_vertex(Point(0.0)), b = mesh.create_vertex(Point(1.0)), c = mesh.create_vertex(Point(2.0));
    mesh.insert_edge(mesh.corner(a), mesh.corner(c));
    mesh.delete_vertex(b);
    for (const Edge e : mesh.edges())
        if (!mesh.is_on_boundary(e)) {
            mesh.delete_edge(e);
            break;
        }
    scene.groups.edit().set_name(1, "changed");
    scene.selection.edit().faces = {Face(0)};
    scene.source.replace_with(Graph{{Point(0.0)}, {}});
    switch (p.how) {
    case How::command: throw CommandError("it did not go");
    case How::input: throw InputError("some.obj", 3, "is no good");
    case How::cancelled:
        context.progress.cancel();
        context.progress.step(0.5);
        break;
    case How::memory: throw std::bad_alloc();
    case How::internal: ASSERT(mesh.face_count() == 12345, "what cannot be"); break;
    case How::unsound_selection: scene.selection.edit().faces = {Face(0), Face(0)}; break;
    case How::success: break;
    }
}

struct Look {
    bool strict = false, meddle = false, fail = false;
};

const Registry& troubled()
{
    static const Registry registry = [] {
        Registry r;
        register_make(r);
        register_select(r);
        register_document(r);
        r.add(define<Trouble>("test.trouble", "Changes everything and fails")
                  .param(&Trouble::how, "how", words({"command", "input", "cancelled", "memory", "internal", "selection", "success"}), "how")
                  .run(make_trouble));
        r.add(define<Look>("test.look", "Looks")
                  .param(&Look::strict, "strict", "whether it fails")
                  .param(&Look::meddle, "meddle", "whether it changes what it must not")
                  .param(&Look::fail, "fail", "whether it throws")
                  .query()
                  .run([](Scene& scene, const Look& p, Context& context) {
                      if (p.meddle) make_trouble(scene, {How::success}, context);
                      if (p.fail) throw CommandError("cannot look");
                      context.output = "{}";
                      context.failed = p.strict;
                  }));
        return r;
    }();
    return registry;
}

/// All of a document that could differ after a command that failed.
struct WholeState {
    explicit WholeState(const Document& d)
        : state(d), version(d.version()), done(d.history().done()), size(d.history().size()), bytes(d.history().bytes()), script(d.history().script())
    {
    }
    State state;
    std::uint64_t version;
    std::size_t done, size, bytes;
    std::vector<ScriptCommand> script;
    friend bool operator==(const WholeState&, const WholeState&) = default;
};

class EveryShape : public testing::TestWithParam<NamedShape> {};

TEST_P(EveryShape, IsAsItWasToTheBitAfterACommandThatFails)
{
    Document document = document_of(troubled(), GetParam().make());
    document.apply("make.cube");
    document.apply("make.torus nu=3 nv=3");
    document.apply("document.undo");
    document.apply("select.vertices vertices=all");
    document.apply("document.undo"); // a redo step that must survive
    const WholeState before(document);

    EXPECT_THROW(document.apply("trouble how=command"), CommandError);
    EXPECT_EQ(WholeState(document), before);
    EXPECT_THROW(document.apply("trouble how=input"), InputError);
    EXPECT_EQ(WholeState(document), before);
    EXPECT_THROW(document.apply("trouble how=cancelled"), Cancelled);
    EXPECT_EQ(WholeState(document), before);
    EXPECT_THROW(document.apply("trouble how=memory"), std::bad_alloc);
    EXPECT_EQ(WholeState(document), before);
    EXPECT_THROW(document.apply("trouble how=internal"), InternalError);
    EXPECT_EQ(WholeState(document), before);
    EXPECT_THROW(document.apply("trouble how=selection"), InternalError);
    EXPECT_EQ(WholeState(document), before);
    EXPECT_THROW(document.apply("trouble how=boldly"), CommandError);
    EXPECT_EQ(WholeState(document), before);
    EXPECT_THROW(document.apply("document.open file=there_is_none.obj"), InputError);
    EXPECT_EQ(WholeState(document), before);
    EXPECT_SOUND(document.scene().mesh);

    document.apply("document.redo");
    EXPECT_EQ(document.scene().selection->vertices.size(), document.scene().mesh.vertex_count());
}

TEST_P(EveryShape, ComesBackExactlyByUndoAndRedo)
{
    Document document = document_of(troubled(), GetParam().make());
    const State before(document);
    document.apply("trouble how=success");
    const State after(document);
    EXPECT_SOUND(after.mesh);
    EXPECT_FALSE(after == before);
    for (int i = 0; i < 3; ++i) {
        document.apply("document.undo");
        EXPECT_EQ(State(document), before);
        document.apply("document.redo");
        EXPECT_EQ(State(document), after);
    }
}

TEST_P(EveryShape, IsNotChangedByLooking)
{
    Document document = document_of(troubled(), GetParam().make());
    const WholeState before(document);
    EXPECT_EQ(document.apply("look").output, "{}");
    document.apply("look meddle=true");
    EXPECT_THROW(document.apply("look meddle=true fail=true"), CommandError);
    EXPECT_EQ(WholeState(document), before);
}

INSTANTIATE_TEST_SUITE_P(Document, EveryShape, testing::ValuesIn(all_shapes()), shape_name<testing::TestParamInfo<NamedShape>>);

TEST(Document, NamesTheOperatorInErrorsOfCommandsButNotOfFiles)
{
    Document document(troubled());
    EXPECT_EQ(complaint(document, "trouble"), "test.trouble: it did not go");
    EXPECT_EQ(complaint(document, "trouble how=input"), "some.obj:3: is no good");
    EXPECT_EQ(complaint(document, "make.cube size=0"), "make.cube: size=0: expected above 0 model units");
}

TEST(Document, SaysWhatAStrictQueryFoundWrong)
{
    Document document(troubled());
    const Document::Outcome calm = document.apply("look"), strict = document.apply("look strict=true");
    EXPECT_FALSE(calm.failed);
    EXPECT_EQ(calm.failure, "");
    EXPECT_TRUE(strict.failed);
    EXPECT_EQ(strict.failure, "test.look: found something wrong, and strict=true");
    EXPECT_EQ(strict.text, "test.look strict=true");
    EXPECT_EQ(document.history().size(), 0u);
    EXPECT_EQ(document.version(), 0u);
}

TEST(Document, DoesNothingForAnEmptyLine)
{
    Document document(all_operators());
    EXPECT_EQ(document.apply("  # nothing").text, "");
    EXPECT_EQ(document.history().size(), 0u);
}

TEST(Document, GrowsItsVersionWithEveryChangeOfTheScene)
{
    Document document(all_operators());
    std::uint64_t version = document.version();
    for (const char* command : {"make.cube", "select.faces faces=0", "document.undo", "document.redo", "document.goto step=0", "document.redo"}) {
        document.apply(command);
        EXPECT_GT(document.version(), version) << command;
        version = document.version();
    }
    document.apply("document.goto step=1"); // where it is already
    document.apply("check.manifold");
    EXPECT_EQ(document.version(), version);
}

// --- selection ------------------------------------------------------------------------------------------------------------------

TEST(Document, KeepsWhatSurvivesSelectedUnderItsNewIds)
{
    // Deleting the edge between faces 0 and its neighbour of a cube merges the two: the higher id goes, those above it move down by one.
    Document document = document_of(all_operators(), cube());
    const Mesh& mesh = document.scene().mesh;
    const auto [f, g] = mesh.faces(Edge(0));
    const std::uint32_t kept = std::min(f.index, g.index), gone = std::max(f.index, g.index);
    document.apply("select.faces faces=all");
    document.apply("topology.delete_edge edges=0");
    EXPECT_EQ(counts(mesh), (Counts{8, 11, 5}));
    ASSERT_EQ(document.scene().selection->faces.size(), 5u);
    EXPECT_EQ(document.scene().selection->faces[kept], Face(kept));

    document.apply("document.undo");
    document.apply(fmt::format("select.faces faces={}", gone));
    document.apply("topology.delete_edge edges=0");
    EXPECT_TRUE(document.scene().selection->faces.empty());
}

TEST(Document, SelectsNothingOfAMeshPutInPlaceOfAnother)
{
    Document document = document_of(all_operators(), cube());
    document.apply("select.edges edges=all");
    document.apply("remesh.catmull_clark");
    EXPECT_TRUE(document.scene().selection->edges.empty());
}

TEST(Document, SaysThatNothingIsSelected)
{
    Document document = document_of(all_operators(), cube());
    EXPECT_EQ(complaint(document, "extrude.cubical"), "extrude.cubical: no faces are selected");
}

// --- travel ---------------------------------------------------------------------------------------------------------------------

TEST(Document, TravelsToEveryStateExactly)
{
    Document document(all_operators());
    std::vector<State> states{State(document)};
    for (const char* command : {"make.cube", "extrude.dodecahedral faces=0", "select.faces faces=all", "remesh.doo_sabin", "document.clear", "make.sphere"}) {
        document.apply(command);
        states.emplace_back(document);
    }
    for (const int k : {0, 6, 3, 5, 1, 4, 2, 6, 0}) {
        document.apply(fmt::format("document.goto step={}", k));
        EXPECT_EQ(State(document), states[static_cast<std::size_t>(k)]) << k;
        EXPECT_EQ(document.history().done(), static_cast<std::size_t>(k));
        EXPECT_EQ(document.history().size(), 6u);
    }
    document.apply("document.redo steps=4");
    EXPECT_EQ(State(document), states[4]);
    document.apply("document.undo steps=3");
    EXPECT_EQ(State(document), states[1]);
}

TEST(Document, DropsWhatWasUndoneWhenSomethingElseIsDone)
{
    Document document(all_operators());
    document.apply("make.cube");
    document.apply("make.torus");
    document.apply("document.undo");
    document.apply("make.tetrahedron");
    EXPECT_EQ(document.history().size(), 2u);
    EXPECT_EQ(complaint(document, "document.redo"), "document.redo: there is nothing to redo");
    EXPECT_EQ(document.script({}), "make.cube\nmake.tetrahedron\n");
}

TEST(Document, SaysHowFarItCanTravel)
{
    Document document(all_operators());
    EXPECT_EQ(complaint(document, "undo"), "document.undo: there is nothing to undo");
    document.apply("make.cube");
    EXPECT_EQ(complaint(document, "undo steps=2"), "document.undo: steps=2: expected 1");
    document.apply("make.cube");
    EXPECT_EQ(complaint(document, "undo steps=3"), "document.undo: steps=3: expected 1 to 2");
    EXPECT_EQ(complaint(document, "goto step=3"), "document.goto: step=3: expected 0 to 2");
    EXPECT_EQ(complaint(document, "undo steps=0"), "document.undo: steps=0: expected 1 or more (an integer)");
}

// --- apply_again ----------------------------------------------------------------------------------------------------------------

TEST(Document, RunsTheLastStepAgainWithOtherValues)
{
    Document document(all_operators()), other(all_operators());
    Progress progress;
    for (Document* d : {&document, &other}) d->apply("make.cube");
    document.apply("extrude.cubical faces=0 heights=1");
    for (const char* height : {"2", "3", "0.5"}) document.apply_again(fmt::format("extrude.cubical faces=0 heights={}", height), progress);
    other.apply("extrude.cubical faces=0 heights=0.5");
    EXPECT_EQ(State(document), State(other));
    EXPECT_EQ(document.history().size(), 2u);
    EXPECT_EQ(document.script({}), other.script({}));
    EXPECT_EQ(document.history().bytes(), other.history().bytes());
    document.apply("document.undo");
    other.apply("document.undo");
    EXPECT_EQ(State(document), State(other));
}

TEST(Document, KeepsTheLastStepIfItCannotBeRunAgain)
{
    Document document(all_operators());
    Progress progress;
    document.apply("make.cube");
    document.apply("extrude.cubical faces=0");
    const State before(document);
    const std::string script = document.script({});
    EXPECT_THROW(document.apply_again("extrude.cubical faces=0 angle=300", progress), CommandError);
    EXPECT_THROW(document.apply_again("extrude.cubical faces=99", progress), CommandError);
    EXPECT_THROW(document.apply_again("document.undo", progress), CommandError);
    EXPECT_EQ(State(document), before);
    EXPECT_EQ(document.script({}), script);
    document.apply("document.undo");
    EXPECT_EQ(counts(document.scene().mesh), (Counts{8, 12, 6}));
}

TEST(Document, MovesTheVerticesOfARemeshingThatIsRunAgain)
{
    struct Drag {
        const char *click, *drags[3];
    };
    const Drag all[] = {{"remesh.truncate", {"remesh.truncate t=0.1", "remesh.truncate t=0.3", "remesh.truncate t=0.4"}},
                        {"remesh.snub iterations=2", {"remesh.snub iterations=2 t=0.2", "remesh.snub iterations=2 t=0.4", "remesh.snub iterations=2 t=0.15"}},
                        {"remesh.catmull_clark groups=keep", {"remesh.catmull_clark smooth=false groups=keep", "remesh.catmull_clark groups=keep", "remesh.catmull_clark smooth=false groups=keep"}}};
    for (const auto& [click, drags] : all) {
        Document document(all_operators()), other(all_operators());
        Progress progress;
        for (Document* d : {&document, &other})
            for (const char* before : {"make.cube", "group.by rule=normal", "extrude.dodecahedral faces=1", "select.faces faces=2"}) d->apply(before);
        document.apply(click);
        const Mesh& mesh = document.scene().mesh;
        const Corner* const connectivity = MeshTables::view(mesh).next.data();
        bool is_first = true;
        for (const char* drag : drags) {
            if (!std::exchange(is_first, false)) other.apply("document.undo");
            const std::uint64_t version = document.version();
            EXPECT_EQ(document.apply_again(drag, progress).text, other.apply(drag).text);
            EXPECT_EQ(State(document), State(other)) << drag;
            EXPECT_EQ(document.script({}), other.script({}));
            EXPECT_EQ(document.history().bytes(), other.history().bytes());
            EXPECT_GT(document.version(), version);
            EXPECT_EQ(MeshTables::view(mesh).next.data(), connectivity) << "nothing but positions is made";
        }
        for (const char* travel : {"document.undo", "document.redo", "group.assign faces=0 id=7", "document.goto step=4"}) {
            for (Document* d : {&document, &other}) d->apply(travel);
            EXPECT_EQ(State(document), State(other)) << travel;
        }
    }
}

TEST(Document, RemeshesAnewWhereMoreThanPositionsChanges)
{
    Document document(all_operators());
    Progress progress;
    document.apply("make.cube");
    document.apply("remesh.truncate");
    for (const char* again : {"remesh.truncate t=0.3", "remesh.truncate iterations=2", "remesh.truncate iterations=2 t=0.3", "remesh.truncate groups=none", "remesh.truncate only=3 t=0.1",
                              "remesh.truncate only=3 t=0.2", "remesh.truncate t=0.2", "remesh.pentagonal", "remesh.pentagonal mirror=true", "remesh.pentagonal mirror=true offset=0.1",
                              "remesh.conway recipe=tk", "remesh.dual", "remesh.dual polar=true", "extrude.cubical faces=1", "remesh.truncate t=0.1"}) {
        document.apply_again(again, progress);
        Document other(all_operators());
        other.apply("make.cube");
        other.apply(again);
        EXPECT_EQ(State(document), State(other)) << again;
        EXPECT_EQ(document.history().size(), 2u);
    }
}

TEST(Document, RemeshesAnewWhereTheBudgetHasNoRoomForMore)
{
    Document document(all_operators()), other(all_operators());
    Progress progress;
    document.apply("make.dodecahedron");
    document.apply("remesh.truncate");
    document.history().set_budget(document.history().bytes());
    other.apply("make.dodecahedron");
    for (const char* drag : {"remesh.truncate t=0.1", "remesh.truncate t=0.2"}) {
        document.apply_again(drag, progress);
        EXPECT_EQ(document.history().size(), 2u);
    }
    other.apply("remesh.truncate t=0.2");
    EXPECT_EQ(State(document), State(other));
    EXPECT_EQ(document.script({}), other.script({}));
}

TEST(Document, ForgetsWhatItKeptWhenAnotherFileIsOpened)
{
    Document document(all_operators()), other(all_operators());
    Progress progress;
    document.apply("make.cube");
    document.apply("remesh.truncate");
    document.apply_again("remesh.truncate t=0.1", progress); // kept from here on
    document.open(Model{});
    for (Document* d : {&document, &other}) {
        d->apply("make.tetrahedron");
        d->apply("remesh.truncate");
    }
    document.apply_again("remesh.truncate t=0.2", progress);
    other.apply("document.undo");
    other.apply("remesh.truncate t=0.2");
    EXPECT_EQ(State(document).mesh, State(other).mesh);
}

TEST(Document, KeepsARemeshingThatCannotBeRunAgain)
{
    // The middle of all vertices lies in the planes of two faces, which have no pole.
    Document document(all_operators());
    Progress progress;
    document.apply("make.cube");
    document.apply("make.cube");
    document.apply("mesh.transform vertices=8-15 move=3,0,1");
    document.apply("remesh.dual");
    for (int i = 0; i < 2; ++i) {
        const State before(document);
        const std::string script = document.script({});
        try {
            document.apply_again("remesh.dual polar=true", progress);
            FAIL() << "a face passes through the centre";
        } catch (const CommandError& e) {
            EXPECT_EQ(std::string(e.what()).substr(0, 18), "remesh.dual: face ") << e.what();
        }
        EXPECT_EQ(State(document), before);
        EXPECT_EQ(document.script({}), script);
        document.apply_again("remesh.dual groups=keep", progress);
        document.apply_again("remesh.dual", progress);
    }
    document.apply("rind.crust guard=off");
    document.apply("remesh.truncate");
    EXPECT_EQ(document.apply_again("remesh.truncate t=0.3", progress).notes, std::vector<std::string>{"the rind can no longer be punched"});
}

// --- beginnings -------------------------------------------------------------------------------------------------------------------

TEST(Document, BeginsWithAFileWhichUndoDoesNotPass)
{
    Document document(all_operators());
    Progress progress;
    document.apply("document.open file=cube.obj", progress, DRUSE_MODELS);
    EXPECT_EQ(counts(document.scene().mesh), (Counts{8, 12, 6}));
    EXPECT_EQ(document.history().size(), 0u);
    EXPECT_EQ(complaint(document, "document.undo"), "document.undo: there is nothing to undo");
}

TEST(Document, OpensAFileAsAStepLaterOn)
{
    Document document(all_operators());
    Progress progress;
    document.apply("make.torus");
    const State before(document);
    document.apply("document.open file=cube.obj", progress, DRUSE_MODELS);
    EXPECT_EQ(counts(document.scene().mesh), (Counts{8, 12, 6}));
    document.apply("document.undo");
    EXPECT_EQ(State(document), before);
}

TEST(Document, HoldsTheGroupsAndTheGraphOfAFile)
{
    Document document(all_operators());
    Progress progress;
    document.open(std::filesystem::path(DRUSE_MODELS) / "colored_cube.obj", progress);
    EXPECT_EQ(document.scene().mesh.largest_group(), 3);
    document.open(std::filesystem::path(DRUSE_MODELS) / "body_centred_cell.obj", progress);
    ASSERT_TRUE(std::holds_alternative<Graph>(*document.scene().source));
    document.apply("document.clear");
    EXPECT_TRUE(std::holds_alternative<std::monostate>(*document.scene().source));
    document.apply("document.undo");
    EXPECT_TRUE(std::holds_alternative<Graph>(*document.scene().source));
}

TEST(Document, StaysAsItWasIfAFileCannotBeOpened)
{
    Document document(all_operators());
    Progress progress;
    document.apply("make.cube");
    const WholeState before(document);
    EXPECT_THROW(document.open("there_is_none.obj", progress), InputError);
    EXPECT_THROW(document.open("there_is_none.druse", progress), InputError);
    progress.cancel();
    EXPECT_THROW(document.open(std::filesystem::path(DRUSE_MODELS) / "cube.obj", progress), Cancelled);
    EXPECT_EQ(WholeState(document), before);
}

} // namespace
} // namespace druse
