// Rinds as a document keeps them: through undo and files, and through what other operators do.
#include "app/documents.h"
#include "app/registry.h"
#include "app/save.h"
#include "io/output.h"
#include "support/folder.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <algorithm>
#include <string>
#include <vector>

namespace druse {
namespace {

using namespace test;

Document after(Mesh mesh, const std::vector<std::string>& commands)
{
    Document document = document_of(all_operators(), std::move(mesh));
    for (const std::string& command : commands) EXPECT_EQ(complaint(document, command), "") << command;
    return document;
}

std::size_t live(const Document& document) { return document.scene().rind.pairs(document.scene().mesh).size(); }

TEST(RindInDocument, ComesBackByUndoAndRedoBitForBit)
{
    const std::vector<std::string> commands{"rind.crust thickness=0.1", "rind.punch faces=0",       "mesh.transform rotate=0,0,30",
                                            "rind.peel faces=1,4",      "rind.punch faces=2,3",     "face.start shift=1 faces=all",
                                            "rind.peel faces=5,7,19",   "rind.nest ratio=0.2",      "rind.peel faces=11-16 pinch=cut",
                                            "remesh.catmull_clark",     "rind.crust thickness=0.01"};
    Document document = document_of(all_operators(), icosahedron());
    std::vector<State> states{State(document)};
    std::vector<std::size_t> pairs{live(document)};
    for (const std::string& command : commands) {
        EXPECT_EQ(complaint(document, command), "") << command;
        states.emplace_back(document);
        pairs.push_back(live(document));
    }
    for (const std::size_t k : {0u, 11u, 3u, 10u, 9u, 2u, 1u, 6u, 4u, 8u, 5u, 7u}) {
        document.apply("document.goto step=" + std::to_string(k));
        EXPECT_EQ(State(document), states[k]) << k;
        EXPECT_EQ(live(document), pairs[k]) << k;
    }
    EXPECT_EQ(pairs[1], 20u);
    EXPECT_EQ(pairs[2], 19u);
    EXPECT_EQ(pairs[10], 0u);
    EXPECT_EQ(pairs[11], states[10].mesh.face_count());
}

TEST(RindInDocument, KeepsLittleOfAPunchForUndo)
{
    Document document = after(torus(100, 100), {"rind.crust guard=off", "rind.punch faces=777"});
    EXPECT_LT(document.history()[1].bytes, 700'000u); // pages of a thousand elements around one face, of 20 000
    EXPECT_LT(document.history()[1].bytes, document.scene().mesh.bytes() / 4);
}

TEST(RindInDocument, OutlivesMovingAndMirroring)
{
    for (const char* command : {"mesh.transform scale=2,1,1 rotate=10,20,30", "mesh.transform scale=-1,1,1", "mesh.transform vertices=0-5 move=0.1,0,0"}) {
        Document document = after(dodecahedron(), {"rind.crust", command});
        EXPECT_EQ(live(document), 12u) << command;
        EXPECT_EQ(complaint(document, "rind.peel faces=0,1,2"), "");
        EXPECT_SOUND(document.scene().mesh);
        EXPECT_EQ(genus(document.scene().mesh), 0);
        EXPECT_GT(volume(document.scene().mesh), 0) << command;
    }
}

TEST(RindInDocument, LosesFacesThatOtherOperatorsChange)
{
    EXPECT_EQ(live(after(dodecahedron(), {"rind.crust", "extrude.cubical faces=3"})), 11u);
    EXPECT_EQ(live(after(icosahedron(), {"rind.crust", "extrude.stellate faces=3,24"})), 18u);
    EXPECT_EQ(live(after(dodecahedron(), {"rind.crust", "topology.insert_edge c1=14:0 c2=14:2"})), 11u);
    EXPECT_EQ(live(after(dodecahedron(), {"rind.crust", "topology.delete_edge edges=0"})), 10u);
    EXPECT_EQ(live(after(dodecahedron(), {"rind.crust", "topology.pipe from=0 to=12"})), 11u);
    EXPECT_EQ(live(after(dodecahedron(), {"rind.crust", "make.cube"})), 12u);
    EXPECT_EQ(live(after(dodecahedron(), {"rind.crust", "rind.crust thickness=-0.01"})), 24u); // a new table takes its place
    Document document = after(dodecahedron(), {"rind.crust", "extrude.cubical faces=3"});
    EXPECT_EQ(complaint(document, "rind.punch faces=3"), "rind.punch: face 3 is not part of a rind");
}

TEST(RindInDocument, LosesAFaceForGoodAlsoWhereItComesBackAsItWas)
{
    // An edge across a face and away again makes the same face; a file between the two steps must make no difference.
    Document document = after(cube(), {"rind.crust", "topology.insert_edge c1=0:0 c2=0:2"});
    const State cut(document);
    EXPECT_EQ(complaint(document, "topology.delete_edge edges=0~2"), "");
    EXPECT_EQ(live(document), 5u);
    EXPECT_EQ(complaint(document, "rind.punch faces=0"), "rind.punch: face 0 is not part of a rind");
    EXPECT_EQ(complaint(document, "rind.punch faces=6"), "rind.punch: face 6 is not part of a rind");
    document.apply("document.undo");
    EXPECT_EQ(State(document), cut);
    document.apply("document.undo");
    EXPECT_EQ(live(document), 6u); // as it was before
    document.apply("document.redo steps=2");
    EXPECT_EQ(live(document), 5u);

    document = after(dodecahedron(), {"rind.crust", "extrude.cubical faces=3", "topology.delete_edge edges=0"});
    const std::size_t left = live(document);
    const Folder folder;
    const std::string file = (folder / "rind.dlfl").string();
    OutputSet out;
    write_document(document, out, file);
    out.commit();
    Document again(all_operators());
    Progress progress;
    again.open(file, progress);
    EXPECT_EQ(live(again), left);
}

TEST(RindInDocument, SaysWhenItCanNoLongerBePunched)
{
    Document document = after(cube(), {"rind.crust"});
    EXPECT_EQ(document.apply("remesh.doo_sabin").notes, std::vector<std::string>{"the rind can no longer be punched"});
    EXPECT_EQ(live(document), 0u);
    EXPECT_TRUE(document.apply("remesh.doo_sabin").notes.empty());
    Document open = after(cube(), {"rind.crust", "rind.punch faces=all"});
    EXPECT_TRUE(open.apply("remesh.doo_sabin").notes.empty()); // there was nothing left to be punched
    document.apply("document.undo steps=2");
    EXPECT_EQ(live(document), 6u);
    EXPECT_TRUE(document.apply("document.clear").notes.empty());
    document.apply("document.undo");
    EXPECT_EQ(live(document), 6u);
    EXPECT_EQ(complaint(document, "rind.crust thickness=0"), "rind.crust: thickness must not be 0");
    EXPECT_EQ(complaint(document, "rind.punch faces=40-44"), "rind.punch: there is no face 40: the faces are 0 to 11");
    EXPECT_EQ(complaint(document, "check.manifold"), "");
    EXPECT_EQ(live(document), 6u);
}

TEST(RindInDocument, FailsWithALineThatTellsWhyAndChangesNothing)
{
    // 30-rind-and-pipes, section 10. Of the cube faces 0 and 5 are opposite; the second cube lies upon it.
    struct Case {
        std::vector<std::string> before;
        std::string command, complaint;
    };
    const Case cases[] = {
        {{"rind.crust", "rind.punch faces=0-2"}, "rind.punch faces=12-14", "rind.punch: faces 12-14: none of them is part of a rind"},
        {{"rind.crust"}, "rind.crust thickness=0", "rind.crust: thickness must not be 0"},
        {{}, "rind.crust by=scale scale=1", "rind.crust: scale must not be 1"},
        {{}, "rind.crust thickness=2 guard=error", "rind.crust: thickness 2 is more than the safe 0.822724: face 0 turns over at vertex 0"},
        {{}, "topology.pipe from=3 to=3", "topology.pipe: from and to are the same face 3"},
        {{"make.prism n=6"}, "topology.pipe from=0 to=6 unequal=error", "topology.pipe: face 0 has 4 sides, face 6 has 6 (unequal=error)"},
        {{"make.cube"}, "topology.handle from=0 to=6", "topology.handle: the two faces have the same centre"},
        {{"rind.crust"}, "rind.peel faces=all", "rind.peel: would remove the whole surface"},
        {{"rind.crust", "rind.peel faces=0,5"}, "rind.peel faces=1-4 pinch=cut", "rind.peel: would remove the whole surface"},
    };
    for (const Case& c : cases) {
        Document document = after(cube(), c.before);
        document.apply("select.edges edges=0-3");
        const State state(document);
        const std::size_t steps = document.history().size();
        EXPECT_EQ(complaint(document, c.command), c.complaint);
        EXPECT_EQ(State(document), state) << c.command;
        EXPECT_EQ(document.history().size(), steps) << c.command;
    }
    Document document = after(cube(), {});
    EXPECT_TRUE(complaint(document, "topology.pipe from=0 to=1").starts_with("topology.pipe: faces 0 and 1 share vertex "));
}

TEST(RindInDocument, GoesThroughFiles)
{
    const Folder folder;
    const std::string file = (folder / "rind.dlfl").string();
    Document document = after(dodecahedron(), {"rind.crust", "rind.peel faces=2", "face.start shift=3 faces=all"});
    OutputSet out;
    write_document(document, out, file);
    out.commit();

    Document again(all_operators());
    Progress progress;
    EXPECT_TRUE(again.open(file, progress).notes.empty());
    EXPECT_EQ(again.scene().rind.pairs(again.scene().mesh), document.scene().rind.pairs(document.scene().mesh));
    EXPECT_EQ(live(again), 11u);
    for (Document* d : {&document, &again}) d->apply("rind.peel faces=3,9,20");
    EXPECT_EQ(rings(again.scene().mesh), rings(document.scene().mesh));

    // As a file that is opened on the way, too.
    Document inside = after(cube(), {"document.open file=\"" + file + "\""});
    EXPECT_EQ(live(inside), 11u);
    inside.apply("document.undo");
    EXPECT_EQ(live(inside), 0u);
}

struct Exported {
    std::vector<std::string> notes;
    Mesh mesh;
};
Exported exported(const Document& document, const char* name = "rind.obj")
{
    const Folder folder;
    const std::string file = (folder / name).string();
    OutputSet out;
    write_document(document, out, file);
    out.commit();
    Document again(all_operators());
    Progress progress;
    const auto mended = again.open(file, progress).notes;
    if (name == std::string("rind.obj")) { // each edge has two faces
        EXPECT_EQ(mended, std::vector<std::string>());
    }
    return {out.notes(), again.scene().mesh};
}

TEST(RindInDocument, IsExportedAsAManifold)
{
    Document document = after(octahedron(), {"rind.crust", "rind.peel faces=0"});
    std::vector<Face> others; // that meet face 0 in a corner only
    const Mesh& solid = octahedron();
    for (const Face f : solid.faces()) {
        int common = 0;
        for (const std::uint32_t v : ring(solid, f)) common += std::ranges::count(ring(solid, Face(0)), v) > 0;
        if (common == 1) others.push_back(f);
    }
    ASSERT_EQ(others.size(), 3u);
    EXPECT_EQ(document.apply("rind.peel faces=" + FaceSelector::of(others).text()).notes, std::vector<std::string>{"6 pinched columns"});
    const Exported columns = exported(document);
    EXPECT_EQ(columns.notes, std::vector<std::string>{"6 parallel edges split"});
    EXPECT_EQ(counts(columns.mesh), (Counts{12 + 6, 36 + 6, 20}));
    EXPECT_EQ(genus(columns.mesh), 3);

    document = after(cube(), {"rind.crust", "rind.punch faces=all"});
    const Exported walls = exported(document);
    EXPECT_EQ(walls.notes, (std::vector<std::string>{"16 parallel edges split", "12 zero-thickness walls, which cannot be printed: rind.peel leaves none"}));
    EXPECT_EQ(genus(walls.mesh), 5);
    EXPECT_EQ(walls.mesh.boundary_count(), 0u);
}

TEST(RindInDocument, IsExportedAsLooseFacetsThatFitTogetherInOneWayOnly)
{
    // STL has places only, and who reads glTF goes by them. Where wedges touch along columns, and on both sides of walls without thickness, more than two facets would meet.
    struct Case {
        std::vector<std::string> commands;
        std::vector<std::string> notes; // but for that on groups
        std::size_t components;
        std::int64_t genus;
    };
    const Case cases[] = {
        {{"rind.crust", "rind.peel faces=0,2,5,7"}, {"6 coincident edges divided"}, 1, 3},
        {{"rind.crust", "rind.peel faces=0,2,5,7 pinch=cut"}, {"6 coincident edges divided"}, 4, 0},
        {{"rind.crust", "rind.punch faces=0,2,5,7"}, {"6 coincident edges divided"}, 1, 3},
        {{"rind.crust", "rind.punch faces=all"}, {"18 coincident edges divided", "12 zero-thickness walls, which cannot be printed: rind.peel leaves none"}, 1, 7},
        {{"rind.crust", "rind.peel faces=0"}, {}, 1, 0},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.commands.back());
        const Document document = after(octahedron(), c.commands);
        EXPECT_EQ(components(document.scene().mesh).parts.size(), c.components); // 0, 2, 5 and 7 meet in corners only
        for (const char* name : {"rind.stl", "rind.glb", "rind.gltf"}) {
            Exported out = exported(document, name);
            std::erase(out.notes, "groups are not saved in STL");
            EXPECT_EQ(out.notes, c.notes) << name;
            EXPECT_EQ(out.mesh.boundary_count(), 0u);
            EXPECT_EQ(components(out.mesh).parts.size(), c.components) << name;
            EXPECT_EQ(genus(out.mesh), c.genus) << name;
            EXPECT_NEAR(volume(out.mesh), volume(document.scene().mesh), 1e-6);
        }
    }
}

TEST(RindInDocument, IsRemeshedInEveryState)
{
    const std::vector<std::vector<std::string>> states{
        {"rind.crust"},
        {"rind.crust", "rind.punch faces=0"},
        {"rind.crust", "rind.punch faces=all"},
        {"rind.crust", "rind.peel faces=0,3,5,6"},
        {"rind.crust", "rind.peel faces=1-6"},
        {"rind.crust", "rind.punch faces=0-3", "rind.peel faces=6"},
        {"rind.crust", "rind.peel faces=0,3,5,6 pinch=cut"}};
    for (const auto& commands : states)
        for (const bool catmull_clark : {true, false}) {
            Document document = after(octahedron(), commands);
            const Mesh before = document.scene().mesh;
            const auto [v, e, f] = before.counts();
            EXPECT_EQ(complaint(document, catmull_clark ? "remesh.catmull_clark" : "remesh.doo_sabin"), "") << commands.back();
            const Mesh& mesh = document.scene().mesh;
            EXPECT_SOUND(mesh);
            EXPECT_EQ(counts(mesh), catmull_clark ? (Counts{v + e + f, 4 * e, 2 * e}) : (Counts{2 * e, 4 * e, v + e + f})) << commands.back();
            EXPECT_EQ(genus(mesh), genus(before));
            EXPECT_EQ(components(mesh).parts.size(), components(before).parts.size());
        }
}

} // namespace
} // namespace druse
