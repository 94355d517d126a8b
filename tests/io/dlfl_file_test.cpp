#include "io/io_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace druse::test {
namespace {

/// A triangle with two sides, as TopMod would write it.
const std::string two_sided_triangle = R"(DLFL
#
v 0 0 0
v 1 0 0
v 0 1 0
#
fv 0 [0.000000 0.000000 1.000000] [0.000000 0.000000] 
fv 1 [0.000000 0.000000 1.000000] [0.000000 0.000000] 
fv 2 [0.000000 0.000000 1.000000] [0.000000 0.000000] 
fv 1 [0.000000 0.000000 -1.000000] [0.000000 0.000000] 
fv 0 [0.000000 0.000000 -1.000000] [0.000000 0.000000] 
fv 2 [0.000000 0.000000 -1.000000] [0.000000 0.000000] 
#
e 0 3
e 1 5
e 2 4
#
f 0 1 2
f 3 4 5
#
)";

TEST(ReadDlfl, ReadsWhatTopModWrites)
{
    const Model model = read_text(two_sided_triangle, "dlfl");
    EXPECT_SOUND(model.mesh);
    EXPECT_EQ(counts(model.mesh), (Counts{3, 3, 2}));
    EXPECT_EQ(rings(model.mesh), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {1, 0, 2}}));
    EXPECT_TRUE(model.notes.empty());
}

TEST(ReadDlfl, TakesPlainNumbersBlanksAndCarriageReturns)
{
    std::string text = two_sided_triangle;
    for (char& c : text)
        if (c == '[' || c == ']') c = ' ';
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 3) text.replace(at, 1, " \r\n");
    EXPECT_EQ(connections(read_text(text, "dlfl").mesh), connections(read_text(two_sided_triangle, "dlfl").mesh));
    EXPECT_EQ(counts(read_text(text.substr(0, text.size() - 3), "dlfl").mesh), (Counts{3, 3, 2}));
}

TEST(WriteDlfl, KeepsToTopModsGrammarAndAddsGroupsAfterIt)
{
    Model model = read_text(two_sided_triangle, "dlfl");
    EXPECT_EQ(written(model.mesh, "dlfl").text, two_sided_triangle + "druse 1\ng 0 0\n");
    model.mesh.set_group(Face(1), 4);
    const Written file = written(model.mesh, "dlfl");
    EXPECT_EQ(file.text.substr(0, 23), "DLFL\nmtllib test.mtl\n#\n");
    EXPECT_EQ(file.text.substr(file.text.find("usemtl")),
              "usemtl group_0\nf 0 1 2\nusemtl group_4\nf 3 4 5\n#\ndruse 1\ng 0 4\n");
    EXPECT_EQ(file.materials.substr(0, 14), "newmtl group_0");
}

class EveryShapeInDlfl : public testing::TestWithParam<NamedShape> {};
INSTANTIATE_TEST_SUITE_P(Dlfl, EveryShapeInDlfl, testing::ValuesIn(all_shapes()), shape_name<testing::TestParamInfo<NamedShape>>);

TEST_P(EveryShapeInDlfl, ComesBackExactly)
{
    const Mesh mesh = GetParam().make();
    if (mesh.face_count() == 0) return;
    const Model model = there_and_back(mesh, "dlfl");
    ASSERT_SOUND(model.mesh);
    EXPECT_TRUE(model.notes.empty()) << model.notes[0];
    EXPECT_EQ(points(model.mesh), points(mesh));
    EXPECT_EQ(connections(model.mesh), connections(mesh));
    EXPECT_TRUE(edges_are_in_order_of_use(model.mesh));
    EXPECT_EQ(groups(model.mesh), groups(mesh));
    EXPECT_EQ(model.mesh.boundary_count(), mesh.boundary_count());
    EXPECT_EQ(genus(model.mesh), genus(mesh));
}

TEST_P(EveryShapeInDlfl, StaysAsItIsWhenWrittenAgain)
{
    const Mesh mesh = GetParam().make();
    if (mesh.face_count() == 0) return;
    const Mesh once = there_and_back(mesh, "dlfl").mesh; // edges are in order of use now
    EXPECT_TRUE(there_and_back(once, "dlfl").mesh == once);
}

TEST(WriteDlfl, NamesTheFacesThatAreAnOpenBoundary)
{
    const std::string text = written(open_tube(5), "dlfl").text;
    EXPECT_EQ(text.substr(text.find("druse")), "druse 1\ng 0 0 0 0 0 0 0\nopen 5 6\n");
}

TEST(ReadDlfl, ClosesSidesWithoutAnEdge)
{
    // The same without its second face, and so without edges: the corner list says what is there.
    const Model model = read_text("DLFL\n#\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\n#\nfv 0\nfv 1\nfv 2\n#\n#\nf 0 1 2\n#\n", "dlfl");
    EXPECT_SOUND(model.mesh);
    EXPECT_EQ(counts(model.mesh), (Counts{3, 3, 1}));
    EXPECT_EQ(model.mesh.boundary_count(), 1u);
    EXPECT_EQ(model.notes, (std::vector<std::string>{"1 vertex belongs to no face: left out",
                                                     "the surface is open: 3 boundary edges in 1 loop"}));
}

TEST(ReadDlfl, WalksTheBoundaryAroundEachVertex)
{
    // An open strip of two triangles, joined by the edge 1 2.
    const Model model = read_text(
        "DLFL\n#\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n#\nfv 0\nfv 1\nfv 2\nfv 2\nfv 1\nfv 3\n#\ne 1 3\n#\nf 0 1 2\nf 3 4 5\n#\n",
        "dlfl");
    EXPECT_SOUND(model.mesh);
    EXPECT_EQ(counts(model.mesh), (Counts{4, 5, 2}));
    EXPECT_EQ(model.mesh.boundary_count(), 1u);
    EXPECT_EQ(model.mesh.valence(Face::boundary(0)), 4);
}

TEST(ReadDlfl, SplitsAVertexWithSeveralRotations)
{
    // Two two-sided triangles that name the same vertex 0 and share no edge.
    const Model model = read_text("DLFL\n#\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\n#\n"
                                  "fv 0\nfv 1\nfv 2\nfv 1\nfv 0\nfv 2\nfv 0\nfv 3\nfv 4\nfv 3\nfv 0\nfv 4\n#\n"
                                  "e 0 3\ne 1 5\ne 2 4\ne 6 9\ne 7 11\ne 8 10\n#\nf 0 1 2\nf 3 4 5\nf 6 7 8\nf 9 10 11\n#\n",
                                  "dlfl");
    EXPECT_SOUND(model.mesh);
    EXPECT_EQ(counts(model.mesh), (Counts{6, 6, 4}));
    EXPECT_EQ(model.mesh.position(Vertex(5)), Point(0, 0, 0));
    EXPECT_EQ(model.notes, (std::vector<std::string>{"1 vertex joined surfaces in a point only: split"}));
}

TEST(ReadDlfl, MakesGroupsOfMaterialsUnlessIdsFollow)
{
    const TemporaryFolder folder;
    put_contents(folder / "m.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    std::string text = two_sided_triangle;
    text.replace(text.find("#"), 1, "mtllib m.mtl\n#");
    text.replace(text.find("f 0 1 2"), 0, "usemtl red\n");
    text.replace(text.find("f 3 4 5"), 0, "usemtl blue\n");
    const Model colours = read_text(text, "dlfl", folder.path());
    EXPECT_EQ(groups(colours.mesh), (std::vector<int>{1, 2}));
    EXPECT_EQ(colours.groups.colour(2), (Colour{0, 0, 255}));
    const Model ids = read_text(text + "druse 1\ng 9\ng 0\n", "dlfl", folder.path());
    EXPECT_EQ(groups(ids.mesh), (std::vector<int>{9, 0}));
    EXPECT_EQ(ids.groups.colour(9), (Colour{255, 0, 0}));
}

/// Two two-sided triangles, the second of them inside the first.
std::string nested_triangles()
{
    Mesh mesh = read_text(two_sided_triangle, "dlfl").mesh;
    mesh.append(mesh);
    mesh.reverse_components(std::array{Face(2)});
    return written(mesh, "dlfl").text;
}

TEST(ReadDlfl, KnowsWhichFacesOfARindBelongTogether)
{
    const std::string text = nested_triangles();
    const Model model = read_text(text + "rind 3 1 1 2\nrind 0 2 0 0\n", "dlfl");
    EXPECT_EQ(model.rind.pairs(model.mesh), (std::vector<Rind::Pair>{{Face(0), Face(2), 0, 0}, {Face(1), Face(3), 2, 1}}));
    const std::string again = written(view(model), "dlfl").text;
    EXPECT_EQ(again.substr(again.find("druse")), "druse 1\ng 0 0 0 0\nrind 0 2 0 0\nrind 1 3 2 1\n");
}

TEST(ReadDlfl, CountsFacesOfARindAsTheFileDoes)
{
    // The lid of a tube is open, and stands before the sides of the file that are in the rind.
    Mesh mesh = open_tube(3);
    mesh.append(mesh);
    std::string text = written(mesh, "dlfl").text;
    ASSERT_NE(text.find("\nopen 6 7 8 9\n"), std::string::npos);
    const std::size_t faces = text.rfind("\nf "), first = text.find("\nf ");
    const std::string last = text.substr(faces, text.find('\n', faces + 1) - faces);
    text.erase(faces, last.size());
    text.insert(first, last); // the last face of the file comes first
    text.replace(text.find("open 6 7 8 9"), 12, "open 0 7 8 9");
    const Model model = read_text(text + "rind 2 5 1 3\n", "dlfl");
    EXPECT_EQ(model.rind.pairs(model.mesh), (std::vector<Rind::Pair>{{Face(1), Face(4), 1, 3}}));
    EXPECT_EQ(error_of([&] { read_text(text + "rind 2 8 1 3\n", "dlfl"); }).substr(0, 10), "test.dlfl:");
}

TEST(ReadDlfl, SaysWhatIsWrongWithARind)
{
    const std::string text = nested_triangles();
    const long line = std::ranges::count(text, '\n') + 1;
    const auto complaint = [&](const std::string& rind) {
        const std::string error = error_of([&] { read_text(text + rind + "\n", "dlfl"); });
        return error.substr(std::min(error.size(), error.find("test.dlfl")));
    };
    EXPECT_EQ(complaint("rind 0 4 0 0"), fmt::format("test.dlfl:{}: a rind of face 4, which is not there", line));
    EXPECT_EQ(complaint("rind 0 1 0 3"), fmt::format("test.dlfl:{}: face 1 has corners 0 to 2, not 3", line));
    EXPECT_EQ(complaint("rind 2 2 0 0"), fmt::format("test.dlfl:{}: face 2 is in the rind twice", line));
    EXPECT_EQ(complaint("rind 0 1 0 0\nrind 2 1 0 0"), fmt::format("test.dlfl:{}: face 1 is in the rind twice", line + 1));
    EXPECT_EQ(complaint("rind 0 1 0"), fmt::format("test.dlfl:{}: expected the number of a corner, found the end of the line", line));
    std::string unlike = written(prism(5), "dlfl").text;
    const long its_line = std::ranges::count(unlike, '\n') + 1;
    EXPECT_EQ(error_of([&] { read_text(unlike + "rind 0 1 0 0\n", "dlfl"); }).find(fmt::format("test.dlfl:{}: faces of a rind with 5 and 4 sides", its_line)) != std::string::npos, true);
}

TEST(ReadDlfl, PassesOverWhatItDoesNotKnow)
{
    EXPECT_EQ(read_text(two_sided_triangle + "druse 1\n# a comment\ntwist 5\n", "dlfl").notes, std::vector<std::string>{"1 line was passed over"});
    EXPECT_TRUE(read_text(two_sided_triangle + "anything else\ng 1\n", "dlfl").notes.empty());
}

} // namespace
} // namespace druse::test
