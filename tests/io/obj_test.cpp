#include "io/io_support.h"

#include <fmt/format.h>

namespace druse::test {
namespace {

TEST(ReadObj, KeepsTheOrderOfVerticesFacesAndCorners)
{
    const Model model = read_text(cube_obj, "obj");
    EXPECT_EQ(counts(model.mesh), (Counts{8, 12, 6}));
    EXPECT_SOUND(model.mesh);
    EXPECT_EQ(rings(model.mesh), (std::vector<std::vector<std::uint32_t>>{
                                     {0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}));
    EXPECT_EQ(model.mesh.position(Vertex(3)), Point(-1, 1, -1));
    EXPECT_DOUBLE_EQ(volume(model.mesh), 8);
    EXPECT_TRUE(model.notes.empty());
    EXPECT_FALSE(model.graph);
}

TEST(ReadObj, NumbersEdgesAsTheFacesFirstUseThem)
{
    const Model model = read_text(cube_obj, "obj");
    EXPECT_EQ(model.mesh.ends(Edge(0)), (std::array{Vertex(0), Vertex(3)}));
    EXPECT_EQ(model.mesh.ends(Edge(4)), (std::array{Vertex(4), Vertex(5)}));
    EXPECT_EQ(model.mesh.ends(Edge(8)), (std::array{Vertex(1), Vertex(5)})); // face 2 uses edge 3, then this one
}

/// Ways to write one and the same tetrahedron.
struct Spelling {
    const char* name;
    std::string text;
};

class EverySpelling : public testing::TestWithParam<Spelling> {};

TEST_P(EverySpelling, OfATetrahedronIsRead)
{
    const Model model = read_text(GetParam().text, "obj");
    const Model plain = read_text(four_points + tetrahedron_faces, "obj");
    EXPECT_EQ(connections(model.mesh), connections(plain.mesh));
    EXPECT_EQ(points(model.mesh), points(plain.mesh));
    EXPECT_TRUE(model.notes.empty()) << model.notes[0];
}

std::string with_line_ends(std::string text, const std::string& end)
{
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size()) text.replace(at, 1, end);
    return text;
}

INSTANTIATE_TEST_SUITE_P(
    Obj, EverySpelling,
    testing::Values(
        Spelling{"plain", four_points + tetrahedron_faces},
        Spelling{"carriage_returns", with_line_ends(four_points + tetrahedron_faces, "\r\n")},
        Spelling{"trailing_blanks", with_line_ends(four_points + tetrahedron_faces, " \t \n")},
        Spelling{"no_final_line_end", four_points + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4"},
        Spelling{"ends_in_a_backslash", four_points + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4 \\"},
        Spelling{"byte_order_mark", "\xEF\xBB\xBF" + four_points + tetrahedron_faces},
        Spelling{"indented", fmt::format("\t{}", with_line_ends(four_points + tetrahedron_faces, "\n   "))},
        Spelling{"continued", four_points + "f 1 \\\n3 2\nf 1 2\\\r\n 4\nf\\\n 2 3 4\nf 3 1 4\n"},
        Spelling{"texture", four_points + "vt 0 0\nf 1/1 3/1 2/1\nf 1/1 2/1 4/1\nf 2/1 3/1 4/-1\nf 3/1 1/1 4/1\n"},
        Spelling{"normals", four_points + "vn 0 0 1\nf 1//1 3//1 2//1\nf 1//1 2//1 4//1\nf 2//1 3//1 4//1\nf 3//1 1//-1 4//1\n"},
        Spelling{"both", four_points + "vt 0 0\nvn 0 0 1\nf 1/1/1 3/1/1 2/1/1\nf 1/1/1 2/1/1 4/1/1\nf 2 3 4\nf 3/1 1/ 4/\n"},
        Spelling{"negative", four_points + "f -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -2 -4 -1\n"},
        Spelling{"negative_in_between", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nv 0 0 1\nf -4 -3 -1\nf -3 -2 -1\nf -2 -4 -1\n"},
        Spelling{"faces_first", tetrahedron_faces + four_points},
        Spelling{"weights", "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nv 0 0 1 1\n" + tetrahedron_faces},
        Spelling{"comments",
                 "# a \\\n" + four_points + "# C:\\models\\\n" + with_line_ends(tetrahedron_faces, " # face\n") + "#"},
        Spelling{"passed_over", "o thing\ng a b\ns off\n" + four_points + "vp 1 2\n" + tetrahedron_faces + "\n\n\n"},
        Spelling{"exponents", "v 0e5 0.0 -0\nv 10e-1 0 0\nv 0 .1E1 0\nv 0 0 +1.\n" + tetrahedron_faces}),
    shape_name<testing::TestParamInfo<Spelling>>);

TEST(ReadObj, FollowsBackslashesAcrossThePlaceWhereABlockEnds)
{
    // A block is a megabyte: whatever its end cuts into must come out whole.
    std::string text = four_points;
    for (int i = 0; i < 40; ++i)
        text += fmt::format("# {:x>{}}\n", "", 29000 + 997 * i) + "f 1 \\\n3 \\\r\n2\nf 1 2 4\nf 2 \\\n3 4\nf 3 1 4\n";
    EXPECT_EQ(read_text(text, "obj").mesh.face_count(), 160u);
}

TEST(ReadObj, TakesAFaceOfAHundredThousandCorners)
{
    std::string text, face = "f";
    const int n = 100000;
    for (int i = 0; i < n; ++i) text += fmt::format("v {} {} 0\n", std::cos(i * 2 * M_PI / n), std::sin(i * 2 * M_PI / n));
    for (int i = 1; i <= n; ++i) face += fmt::format(" {}", i);
    std::string back = "f";
    for (int i = n; i >= 1; --i) back += fmt::format(" {}", i);
    const Model model = read_text(text + face + "\n" + back + "\n", "obj");
    EXPECT_EQ(counts(model.mesh), (Counts{100000, 100000, 2}));
    EXPECT_EQ(valence(model.mesh, Face(0)), n);
}

TEST(ReadObj, KeepsLinesAsAGraphOfTheVerticesTheyUse)
{
    const Model model = read_text("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nl 2 3 4\nl 4/1 5/1 2/1\nvt 0\n", "obj");
    ASSERT_TRUE(model.graph);
    EXPECT_EQ(model.graph->vertices, (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}}));
    EXPECT_EQ(model.graph->edges, (std::vector<std::array<std::uint32_t, 2>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}}));
    EXPECT_EQ(model.mesh.face_count(), 0u);
    EXPECT_EQ(model.notes, (std::vector<std::string>{"1 vertex belongs to no face: left out"}));
}

TEST(ReadObj, GivesAMeshAndAGraphOfAFileWithBoth)
{
    const Model model = read_text(four_points + "v 0 0 3\n" + tetrahedron_faces + "l 4 5\n", "obj");
    ASSERT_TRUE(model.graph);
    EXPECT_EQ(model.graph->vertices, (std::vector<Point>{{0, 0, 1}, {0, 0, 3}}));
    EXPECT_EQ(counts(model.mesh), (Counts{4, 6, 4}));
    EXPECT_TRUE(model.notes.empty()) << model.notes[0];
}

TEST(ReadObj, MakesPointSpheresOfPoints)
{
    const Model model = read_text("v 1 2 3\nv 4 5 6\np 2 -2\n", "obj");
    EXPECT_EQ(counts(model.mesh), (Counts{2, 0, 2}));
    EXPECT_TRUE(model.mesh.is_point_sphere(Vertex(0)));
    EXPECT_EQ(model.mesh.vertex(model.mesh.corner(Face(0))), Vertex(1));
}

TEST(ReadObj, LeavesOutWhatBelongsToNothing)
{
    const Model model = read_text("v 7 7 7\n" + four_points + "f 2 4 3\nf 2 3 5\nf 3 4 5\nf 4 2 5\nv 8 8 8\n", "obj");
    EXPECT_EQ(counts(model.mesh), (Counts{4, 6, 4}));
    EXPECT_EQ(model.mesh.position(Vertex(0)), Point(0, 0, 0));
    EXPECT_EQ(model.notes, (std::vector<std::string>{"2 vertices belong to no face: left out"}));
}

TEST(ReadObj, LeavesOutAVertexNamedTwiceInARow)
{
    const Model model = read_text(four_points + "f 1 1 3 2 1\nf 1 2 4\nf 2 3 3 4\nf 3 1 4\nf 1 1 2\n", "obj");
    EXPECT_EQ(connections(model.mesh), connections(read_text(four_points + tetrahedron_faces, "obj").mesh));
    EXPECT_EQ(model.notes.size(), 2u); // sides from a vertex to itself, and the face that was nothing else
}

TEST(ReadObj, ClosesAnOpenSurfaceAndSaysSo)
{
    const Model model = read_text(four_points + "f 1 3 2\nf 1 2 4\nf 2 3 4\n", "obj");
    EXPECT_SOUND(model.mesh);
    EXPECT_EQ(counts(model.mesh), (Counts{4, 6, 3}));
    EXPECT_EQ(model.mesh.boundary_count(), 1u);
    EXPECT_EQ(model.notes, (std::vector<std::string>{"the surface is open: 3 boundary edges in 1 loop"}));
}

TEST(ReadObj, SaysWhatItPassedOver)
{
    EXPECT_EQ(read_text("curv 1 2\n" + four_points + tetrahedron_faces + "surf 3\n", "obj").notes,
              (std::vector<std::string>{"2 lines were passed over, first 'curv' in line 1"}));
}

// --- writing ------------------------------------------------------------------------------------------------------------------

TEST(WriteObj, WritesShortestNumbersAndNoMaterialsWithoutGroups)
{
    Mesh mesh = tetrahedron();
    mesh.set_position(Vertex(0), {0.1, -1e-7, 1.0 / 3.0});
    const Written file = written(mesh, "obj");
    EXPECT_EQ(file.text.substr(0, file.text.find('\n')), "v 0.1 -1e-07 0.3333333333333333");
    EXPECT_EQ(file.text.find("mtl"), std::string::npos);
    EXPECT_EQ(file.materials, "");
}

class EveryShape : public testing::TestWithParam<NamedShape> {};
INSTANTIATE_TEST_SUITE_P(Obj, EveryShape, testing::ValuesIn(all_shapes()), shape_name<testing::TestParamInfo<NamedShape>>);

TEST_P(EveryShape, ComesBackFromObjWithTheSameGenus)
{
    const Mesh mesh = GetParam().make();
    if (mesh.face_count() == 0) return;
    const Model model = there_and_back(mesh, "obj");
    ASSERT_SOUND(model.mesh);
    EXPECT_EQ(model.mesh.face_count(), mesh.face_count());
    EXPECT_EQ(model.mesh.boundary_count(), mesh.boundary_count());
    EXPECT_EQ(euler_characteristic(model.mesh), euler_characteristic(mesh));
    EXPECT_EQ(genus(model.mesh), genus(mesh));
    EXPECT_EQ(groups(model.mesh), groups(mesh));
    for (const Vertex v : mesh.vertices()) EXPECT_EQ(model.mesh.position(v), mesh.position(v));
    if (facts(mesh).parallel_edges == 0 && model.mesh.vertex_count() == mesh.vertex_count()) {
        EXPECT_EQ(connections(model.mesh), connections(mesh));
    }
}

TEST_P(EveryShape, GivesTheSameBytesTwice)
{
    const Mesh mesh = GetParam().make();
    if (mesh.face_count() == 0) return;
    const Written first = written(mesh, "obj"), second = written(mesh, "obj");
    EXPECT_EQ(first.text, second.text);
    EXPECT_EQ(first.materials, second.materials);
}

TEST(WriteObj, SplitsParallelEdgesAndLoopsInTheFileOnly)
{
    Mesh mesh = three_lunes(); // V 2, E 3, F 3
    const Mesh before = mesh;
    EXPECT_EQ(written(mesh, "obj").notes, (std::vector<std::string>{"2 parallel edges split"}));
    EXPECT_TRUE(mesh == before);
    const Mesh back = there_and_back(mesh, "obj").mesh;
    EXPECT_EQ(counts(back), (Counts{4, 5, 3}));

    EXPECT_EQ(written(cube_with_loop(), "obj").notes, (std::vector<std::string>{"1 loop split"}));
    EXPECT_EQ(counts(there_and_back(cube_with_loop(), "obj").mesh),
              (Counts{10, 15, 7})); // one edge more than a cube, and two for the loop
    EXPECT_EQ(written(cube_with_parallel_edges(), "obj").notes, (std::vector<std::string>{"1 parallel edge split"}));
    EXPECT_EQ(counts(there_and_back(segment(), "obj").mesh), (Counts{3, 2, 1}));
}

TEST(WriteObj, BeginsFacesAtTheirStartCorner)
{
    Mesh mesh = cube();
    mesh.set_start(mesh.corner(Face(2), 3));
    const Mesh back = there_and_back(mesh, "obj").mesh;
    EXPECT_EQ(ring(back, Face(2)), ring(mesh, Face(2)));
}

TEST(WriteObj, KeepsGroupsColoursAndNames)
{
    Mesh mesh = cube();
    const int ids[] = {5, 5, 0, 12, 3, 5};
    for (std::uint32_t f = 0; f < 6; ++f) mesh.set_group(Face(f), ids[f]);
    GroupTable table;
    table.set_colour(5, {1, 128, 254});
    table.set_name(5, "lid");
    table.set_name(3, "Füße");
    table.set_colour(77, {1, 2, 3}); // no face carries it
    const ModelView model{mesh, table};
    for (const char* format : {"obj", "dlfl"}) {
        SCOPED_TRACE(format);
        const Model back = there_and_back(model, format);
        EXPECT_EQ(groups(back.mesh), groups(mesh));
        EXPECT_EQ(back.groups.colour(5), (Colour{1, 128, 254}));
        EXPECT_EQ(back.groups.name(5), "lid");
        EXPECT_EQ(back.groups.name(3), "Füße");
        EXPECT_EQ(back.groups.colour(12), GroupTable::default_colour(12));
        EXPECT_FALSE(back.groups.has_own_colour(12));
        EXPECT_FALSE(back.groups.has_own_colour(77));
    }
    const Written file = written(model, "obj");
    EXPECT_EQ(file.text.substr(0, 16), "mtllib test.mtl\n");
    EXPECT_EQ(file.materials.substr(0, 40), "newmtl group_0\nKd 0.8 0.8 0.8\nnewmtl gro");
}

TEST(WriteObj, WritesEveryColourSoThatItReadsBackTheSame)
{
    Mesh mesh = torus(16, 16);
    GroupTable table;
    for (std::uint32_t f = 0; f < 256; ++f) {
        mesh.set_group(Face(f), static_cast<int>(f) + 1);
        const auto c = static_cast<std::uint8_t>(f);
        table.set_colour(static_cast<int>(f) + 1, {c, static_cast<std::uint8_t>(255 - f), c});
    }
    const Model back = there_and_back({mesh, table}, "obj");
    for (int id = 1; id <= 256; ++id) EXPECT_EQ(back.groups.colour(id), table.colour(id)) << id;
}

TEST(WriteObj, WritesTheGraphOfAModelWithoutFaces)
{
    const Graph graph{{{0, 0, 0}, {1, 0, 0}, {0, 0.25, 0}}, {{0, 1}, {2, 1}}};
    const Mesh none;
    const Model back = there_and_back({none, GroupTable(), &graph}, "obj");
    EXPECT_EQ(*back.graph, graph);
    EXPECT_EQ(written({none, GroupTable(), &graph}, "obj").text, "v 0 0 0\nv 1 0 0\nv 0 0.25 0\nl 1 2\nl 3 2\n");
}

TEST(WriteObj, WritesTheGraphBesideAMeshUnlessStrutsWereMadeOfIt)
{
    Model model = read_text(four_points + "v 5 5 5\n" + tetrahedron_faces + "l 5 1\nl 1 2\n", "obj");
    ASSERT_TRUE(model.graph);
    const Model again = there_and_back(view(model), "obj");
    EXPECT_EQ(again.graph, model.graph);
    EXPECT_EQ(connections(again.mesh), connections(model.mesh));
    EXPECT_EQ(points(again.mesh), points(model.mesh));
    EXPECT_EQ(written(view(model), "stl").notes, std::vector<std::string>{"the graph is not saved in STL"});
    model.graph->struts.edge_ids = {0, 1};
    EXPECT_FALSE(there_and_back(view(model), "obj").graph);
    EXPECT_TRUE(written(view(model), "stl").notes.empty());
}

TEST(WriteObj, LeavesOpenBoundariesOut)
{
    const Mesh mesh = open_tube(6);
    const std::string text = written(mesh, "obj").text;
    EXPECT_EQ(std::count(text.begin(), text.end(), 'f'), 6);
    EXPECT_EQ(there_and_back(mesh, "obj").mesh.boundary_count(), 2u);
}

TEST(Models, AreReadWithoutComplaint)
{
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(DRUSE_MODELS)) {
        if (entry.path().extension() != ".obj") continue;
        SCOPED_TRACE(entry.path());
        const Model model = read_model(entry.path());
        EXPECT_SOUND(model.mesh);
        EXPECT_TRUE(model.notes.empty()) << model.notes[0];
        EXPECT_EQ(boundary_edge_count(model.mesh), 0u);
        ++files;
    }
    EXPECT_GE(files, 6);
    const Model cube = read_model(std::filesystem::path(DRUSE_MODELS) / "colored_cube.obj");
    EXPECT_EQ(groups(cube.mesh), (std::vector<int>{1, 2, 3, 3, 3, 3}));
    EXPECT_DOUBLE_EQ(volume(cube.mesh), 8);
    EXPECT_NEAR(volume(read_model(std::filesystem::path(DRUSE_MODELS) / "dodecahedron.obj").mesh), (15 + 7 * std::sqrt(5)) / 4,
                1e-14);
}

} // namespace
} // namespace druse::test
