#include "io/io_support.h"

#include <cstring>

namespace druse::test {
namespace {

constexpr std::size_t header_size = 84, record_size = 50;

std::uint32_t triangle_count(const std::string& file)
{
    std::uint32_t count = 0;
    std::memcpy(&count, file.data() + 80, 4);
    return count;
}

std::array<float, 12> record(const std::string& file, std::size_t i)
{
    std::array<float, 12> facet;
    std::memcpy(facet.data(), file.data() + header_size + record_size * i, sizeof facet);
    return facet;
}

TEST(WriteStl, CutsACubeIntoTwelveTrianglesThatLookOutward)
{
    Mesh mesh = cube();
    for (const Vertex v : mesh.vertices()) mesh.set_position(v, 2.0 * mesh.position(v));
    const std::string file = written(mesh, "stl").text;
    ASSERT_EQ(triangle_count(file), 12u);
    ASSERT_EQ(file.size(), header_size + 12 * record_size);
    EXPECT_NE(file.substr(0, 5), "solid");
    double six_volumes = 0;
    for (std::size_t i = 0; i < 12; ++i) {
        const auto f = record(file, i);
        const Vector normal(f[0], f[1], f[2]), a(f[3], f[4], f[5]), b(f[6], f[7], f[8]), c(f[9], f[10], f[11]);
        EXPECT_EQ(normal, glm::normalize(glm::cross(b - a, c - a)));
        six_volumes += glm::dot(a, glm::cross(b, c));
    }
    EXPECT_DOUBLE_EQ(six_volumes / 6, 8);
}

TEST(WriteStl, CutsConcaveFacesWithoutLeavingThem)
{
    const Mesh mesh = l_prism(); // area of the L is 3, its height 1
    const Model back = there_and_back(mesh, "stl");
    EXPECT_EQ(counts(back.mesh), (Counts{12, 30, 20})); // 2 (6 − 2) + 6 · 2 triangles
    EXPECT_NEAR(volume(back.mesh), volume(mesh), 1e-6);
    EXPECT_NEAR(surface_area(back.mesh), surface_area(mesh), 1e-5); // more, if one lay outside
}

class EveryShapeInStl : public testing::TestWithParam<NamedShape> {};
INSTANTIATE_TEST_SUITE_P(Stl, EveryShapeInStl, testing::ValuesIn(all_shapes()), shape_name<testing::TestParamInfo<NamedShape>>);

TEST_P(EveryShapeInStl, KeepsItsVolumeInBothKinds)
{
    const Mesh mesh = GetParam().make();
    bool has_triangles = false;
    for (const Face f : mesh.faces()) has_triangles = has_triangles || valence(mesh, f) > 2;
    if (!has_triangles) return;
    const std::string binary = written(mesh, "stl").text, ascii = written(mesh, "stl", true).text;
    const Model from_binary = read_text(binary, "stl"), from_ascii = read_text(ascii, "stl");
    ASSERT_SOUND(from_binary.mesh);
    EXPECT_EQ(connections(from_binary.mesh), connections(from_ascii.mesh));
    EXPECT_EQ(triangle_count(binary), [&] {
        std::uint32_t n = 0;
        for (const Face f : mesh.faces()) n += static_cast<std::uint32_t>(std::max(0, valence(mesh, f) - 2));
        return n;
    }());
    bool flat = flatness(mesh) < 1e-9;
    for (const Face f : mesh.faces())
        flat = flat && (area(mesh, f) > 0 || valence(mesh, f) < 3); // a face of two opposite parts has none
    if (flat) {
        EXPECT_NEAR(volume(from_binary.mesh), volume(mesh), 1e-5 * (1 + std::abs(volume(mesh))));
    }
}

TEST(WriteStl, StaysClosed)
{
    for (const Mesh& mesh : {torus(12, 8), block_with_holes(2), dodecahedron(), prism(7), l_prism(), dented_cube()}) {
        const Model back = there_and_back(mesh, "stl");
        EXPECT_EQ(boundary_edge_count(back.mesh), 0u);
        EXPECT_EQ(genus(back.mesh), genus(mesh));
        EXPECT_TRUE(back.notes.empty()) << back.notes[0];
    }
}

TEST(WriteStl, WritesReadableTextIfWanted)
{
    const Mesh mesh = read_text("v 0 0 0\nv 1 0 0\nv 0 0.1 0\nv 0 0 1\n" + tetrahedron_faces, "obj").mesh;
    const std::string text = written(mesh, "stl", true).text;
    EXPECT_EQ(text.substr(0, 34), "solid druse\n facet normal 0 0 -1\n ");
    EXPECT_NE(text.find("   vertex 0 0.1 0\n"), std::string::npos); // as a single-precision number: not 0.10000000149
    EXPECT_EQ(text.substr(text.size() - 25), " endfacet\nendsolid druse\n");
}

TEST(WriteStl, SaysThatGroupsAreNotSaved)
{
    EXPECT_TRUE(written(cube(), "stl").notes.empty());
    Mesh mesh = cube();
    mesh.set_group(Face(3), 1);
    EXPECT_EQ(written(mesh, "stl").notes, (std::vector<std::string>{"groups are not saved in STL"}));
}

TEST(WriteStl, RefusesWhatItCannotHold)
{
    const TemporaryFolder folder;
    const std::string path = (folder / "x.stl").string();
    const auto error = [&](const Mesh& mesh, const Graph* graph = nullptr) {
        return error_of([&] { OutputSet().write({mesh, GroupTable(), graph}, path); });
    };
    EXPECT_EQ(error(Mesh()), path + ": the document holds no faces");
    const Graph graph{{{0, 0, 0}, {1, 0, 0}}, {{0, 1}}};
    EXPECT_EQ(error(Mesh(), &graph), path + ": the document holds a graph and no faces; STL holds only faces");
    EXPECT_EQ(error(point_sphere()), path + ": the document holds no face with more than 2 corners");
    Mesh far = cube();
    far.set_position(Vertex(5), {0, 1e39, 0});
    EXPECT_EQ(error(far), path + ": vertex 5 lies at 0,1e+39,0: too far for the single precision of STL");
    EXPECT_TRUE(folder.names().empty());
}

// --- reading ------------------------------------------------------------------------------------------------------------------

std::string facet(const std::string& a, const std::string& b, const std::string& c)
{
    return "facet normal 0 0 0\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c + "\nendloop\nendfacet\n";
}

const std::string o = "0 0 0", x = "1 0 0", y = "0 1 0", z = "0 0 1";
const std::string tetrahedron_stl = facet(o, y, x) + facet(o, x, z) + facet(x, y, z) + facet(y, o, z);

TEST(ReadStl, WeldsCornersAtTheSamePlace)
{
    const Model model = read_text("solid\n" + tetrahedron_stl + "endsolid\n", "stl");
    EXPECT_EQ(counts(model.mesh), (Counts{4, 6, 4}));
    EXPECT_NEAR(volume(model.mesh), 1.0 / 6.0, 1e-15);
    EXPECT_EQ(rings(model.mesh)[1], (std::vector<std::uint32_t>{0, 2, 3}));
}

TEST(ReadStl, TakesMinusZeroForZero)
{
    const Model model =
        read_text("solid\n" + facet("-0 0 0", y, x) + facet("0 -0 0", x, z) + facet(x, y, z) + facet(y, "0 0 -0.0", z), "stl");
    EXPECT_EQ(counts(model.mesh), (Counts{4, 6, 4}));
}

TEST(ReadStl, WeldsExactlyAndNoFurther)
{
    const std::string near = "1.0000002 0 0"; // the next number in single precision
    EXPECT_EQ(
        read_text("solid\n" + facet(o, y, x) + facet(o, near, z) + facet(x, y, z) + facet(y, o, z), "stl").mesh.vertex_count(),
        5u);
    const std::string same = "1.00000001 0 0"; // the same number in single precision
    EXPECT_EQ(
        read_text("solid\n" + facet(o, y, x) + facet(o, same, z) + facet(x, y, z) + facet(y, o, z), "stl").mesh.vertex_count(),
        4u);
}

TEST(ReadStl, TakesAsciiHoweverItIsLaidOut)
{
    std::string one_line = "solid a b c\n" + tetrahedron_stl + "endsolid a b c\nsolid second\nendsolid";
    const auto plain = connections(read_text(one_line, "stl").mesh);
    std::string upper = one_line;
    for (char& c : upper) c = static_cast<char>(std::toupper(c));
    EXPECT_EQ(connections(read_text(upper, "stl").mesh), plain);
    std::string joined = one_line;
    for (std::size_t i = 12; i < joined.size(); ++i)
        if (joined[i] == '\n' && joined.compare(i + 1, 3, "end") != 0 && joined.compare(i + 1, 5, "solid") != 0) joined[i] = ' ';
    EXPECT_EQ(connections(read_text(joined, "stl").mesh), plain);
    EXPECT_EQ(connections(read_text("\r\n\t" + one_line, "stl").mesh), plain);
}

TEST(ReadStl, TakesThePolygonsThatTopModWrites)
{
    const std::string square =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n";
    const std::string back =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 1 0\nvertex 1 0 0\nendloop\nendfacet\n";
    EXPECT_EQ(counts(read_text("solid ascii\n" + square + back, "stl").mesh), (Counts{4, 4, 2}));
}

TEST(ReadStl, TellsABinaryFileThatBeginsLikeAscii)
{
    std::string file = written(tetrahedron(), "stl").text;
    file.replace(0, 5, "solid");
    EXPECT_EQ(counts(read_text(file, "stl").mesh), (Counts{4, 6, 4}));
    file += "more"; // then the size does not tell, but the zeros in the header do
    const Model model = read_text(file, "stl");
    EXPECT_EQ(counts(model.mesh), (Counts{4, 6, 4}));
    EXPECT_EQ(model.notes, (std::vector<std::string>{"there is more after the last triangle: passed over"}));
}

TEST(ReadStl, LeavesOutFacetsThatAreNoTriangle)
{
    const Model model = read_text("solid\n" + tetrahedron_stl + facet(o, o, x) + facet(z, z, z), "stl");
    EXPECT_EQ(counts(model.mesh), (Counts{4, 6, 4}));
    EXPECT_FALSE(model.notes.empty());
}

TEST(ReadStl, ReadsTheNumbersOfALargeMeshBackExactly)
{
    const std::string file = written(torus(150, 100), "stl").text;
    const Mesh once = read_text(file, "stl").mesh;
    const Mesh twice = there_and_back(once, "stl").mesh;
    EXPECT_EQ(triangle_count(file), 30000u);
    EXPECT_TRUE(points(once) == points(twice));
    EXPECT_TRUE(connections(once) == connections(twice));
}

} // namespace
} // namespace druse::test
