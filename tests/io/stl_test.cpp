#include "dlfl/mesh_builder.h"
#include "io/io_support.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

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
    std::uint32_t cut = 0;
    for (const Face f : mesh.faces()) cut += static_cast<std::uint32_t>(std::max(0, valence(mesh, f) - 2));
    bool upon_each_other = false; // faces, which have more triangles then
    for (const Vertex v : mesh.vertices()) upon_each_other = upon_each_other || valence(mesh, v) == 2;
    bool has_loop = false; // of which facets are left out
    for (const Edge e : mesh.edges()) has_loop = has_loop || mesh.vertex(mesh.corner(e, 0)) == mesh.vertex(mesh.corner(e, 1));
    if (has_loop) EXPECT_LT(triangle_count(binary), cut);
    else if (upon_each_other) EXPECT_GE(triangle_count(binary), cut);
    else EXPECT_EQ(triangle_count(binary), cut);
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

/// How many facets have a side, by its two ends, at most; facets with two corners at one place, which readers leave out, do not count.
std::size_t most_facets_at_a_side(const std::string& file)
{
    using Place = std::array<float, 3>;
    std::map<std::pair<Place, Place>, std::pair<std::size_t, std::size_t>> sides; // one way, and the other
    for (std::size_t i = 0; i < triangle_count(file); ++i) {
        const auto f = record(file, i);
        std::array<Place, 3> p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = {f[3 + 3 * k] + 0.0f, f[4 + 3 * k] + 0.0f, f[5 + 3 * k] + 0.0f};
        if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const Place &a = p[k], &b = p[(k + 1) % 3];
            auto& count = sides[std::minmax(a, b)];
            ++(a < b ? count.first : count.second);
        }
    }
    std::size_t most = 0;
    for (const auto& [side, count] : sides) {
        EXPECT_EQ(count.first, count.second);
        most = std::max(most, count.first + count.second);
    }
    return most;
}

/// Polygons upon each other, each with two sides: `layers` times the same places, but for the heights that single precision does not see.
Mesh layered(const std::vector<Point2>& ring, int layers)
{
    MeshBuilder builder;
    for (int k = 0; k < layers; ++k) {
        std::vector<std::uint32_t> v;
        for (const Point2& p : ring) v.push_back(builder.add_vertex({p.x, p.y, 1 + 1e-12 * k}));
        builder.add_face(v);
        std::reverse(v.begin(), v.end());
        builder.add_face(v);
    }
    Repairs repairs;
    return builder.build(repairs);
}

TEST(WriteStl, GivesEachSideTwoFacetsWhereFacesLieUponEachOther)
{
    const std::vector<Point2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, dart{{0, 0}, {2, -1}, {0.5, 0}, {2, 1}};
    const std::vector<Point2> triangle{{0, 0}, {1, 0}, {0, 1}}, hexagon{{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}};
    const std::vector<Point2> l{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    for (const auto* ring : {&square, &dart, &triangle, &hexagon, &l})
        for (const int layers : {1, 2, 3, 5}) {
            SCOPED_TRACE(std::to_string(ring->size()) + " sides, " + std::to_string(layers));
            const Mesh mesh = layered(*ring, layers);
            const std::string file = written(mesh, "stl").text;
            EXPECT_EQ(most_facets_at_a_side(file), 2u);
            // No facet lies outside: their areas add up to those of the faces.
            double sum = 0, faces = 0;
            for (std::size_t i = 0; i < triangle_count(file); ++i) {
                const auto f = record(file, i);
                sum += 0.5 * glm::length(glm::cross(Vector(f[6] - f[3], f[7] - f[4], f[8] - f[5]), Vector(f[9] - f[3], f[10] - f[4], f[11] - f[5])));
            }
            for (const Face f : mesh.faces()) faces += area(mesh, f);
            EXPECT_NEAR(sum, faces, 1e-5 * faces);
        }
}

TEST(WriteStl, PutsNoPointWhereAVertexIs)
{
    // Two tetrahedra that have an edge in common, and a third one with a vertex in the middle of it.
    MeshBuilder builder;
    const auto tetrahedron = [&](const Point& a, const Point& b, const Point& c, const Point& d) {
        std::vector<std::uint32_t> v;
        for (const Point& p : {a, b, c, d}) v.push_back(builder.add_vertex(p));
        for (const auto& t : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{2, 0, 3}})
            builder.add_face(std::array{v[std::size_t(t[0])], v[std::size_t(t[1])], v[std::size_t(t[2])]});
    };
    tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    tetrahedron({0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1});
    tetrahedron({0.5, 0, 0}, {0.5, -1, 1}, {0.6, -1, 1}, {0.5, -1.5, 1});
    Repairs repairs;
    const Written out = written(builder.build(repairs), "stl");
    EXPECT_EQ(most_facets_at_a_side(out.text), 2u);
    EXPECT_EQ(out.notes, std::vector<std::string>{"1 coincident edge divided"});
    std::size_t facets_at_middle = 0;
    for (std::size_t i = 0; i < triangle_count(out.text); ++i) {
        const auto f = record(out.text, i);
        for (std::size_t k = 3; k < 12; k += 3) facets_at_middle += f[k] == 0.5f && f[k + 1] == 0.0f && f[k + 2] == 0.0f;
    }
    EXPECT_EQ(facets_at_middle, 3u); // of the third one alone
}

TEST(WriteStl, SaysWhereEdgesAreTooShortToBeDivided)
{
    // Two triangles, each with two sides, whose first side goes from one number of single precision to the next.
    const float next = std::nextafter(1.0f, 2.0f);
    const Written out = written(layered({{1, 0}, {next, 0}, {1, 1}}, 2), "stl");
    EXPECT_NE(std::ranges::find(out.notes, "1 coincident edge is too short to be divided in single precision"), out.notes.end());
}

TEST(WriteStl, LeavesOutFacetsOfEdgesWithoutLength)
{
    MeshBuilder builder; // a cube with a corner that is two
    for (const double z : {0.0, 1.0})
        for (const Point2& p : {Point2{0, 0}, {1, 0}, {1, 1}, {0, 1}}) builder.add_vertex({p.x, p.y, z});
    builder.add_vertex({0, 0, 0});
    for (const std::vector<std::uint32_t>& face : std::vector<std::vector<std::uint32_t>>{
             {0, 3, 2, 1, 8}, {8, 1, 5, 4, 0}, {0, 4, 7, 3}, {1, 2, 6, 5}, {2, 3, 7, 6}, {4, 5, 6, 7}})
        builder.add_face(face);
    const Mesh mesh = builder.build();
    const Written out = written(mesh, "stl");
    for (std::size_t i = 0; i < triangle_count(out.text); ++i) {
        const auto f = record(out.text, i);
        const Point a(f[3], f[4], f[5]), b(f[6], f[7], f[8]), c(f[9], f[10], f[11]);
        EXPECT_TRUE(a != b && b != c && c != a);
    }
    EXPECT_EQ(most_facets_at_a_side(out.text), 2u);
    EXPECT_NE(std::ranges::find(out.notes, "2 facets have corners at one place: not saved in STL"), out.notes.end());
    EXPECT_NEAR(volume(read_text(out.text, "stl").mesh), 1, 1e-12);
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
    Mesh point = cube();
    for (Point& p : point.write_positions()) p = Point(1);
    EXPECT_EQ(error(point), path + ": no facet has an area in the single precision of STL");
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
