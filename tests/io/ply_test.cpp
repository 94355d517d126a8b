#include "io/io_support.h"

#include <fmt/format.h>

#include <cstring>

namespace druse::test {
namespace {

/// A tetrahedron with one face of each kind of group.
Model grouped_tetrahedron()
{
    Model model;
    model.mesh = tetrahedron();
    model.mesh.set_group(Face(1), 7);
    model.mesh.set_group(Face(2), 2);
    model.mesh.set_group(Face(3), 7);
    model.groups.set_colour(7, {1, 2, 3});
    model.groups.set_name(7, "rim");
    return model;
}

TEST(WritePly, WritesReadableTextIfWanted)
{
    const Mesh mesh = read_text(four_points + tetrahedron_faces, "obj").mesh;
    EXPECT_EQ(written(mesh, "ply", true).text, "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                                               "property double z\nelement face 4\nproperty list uchar int vertex_indices\n"
                                               "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
}

TEST(WritePly, GivesFacesTheirGroupAndItsColour)
{
    const Colour grey = GroupTable::default_colour(0), second = GroupTable::default_colour(2);
    const std::string text = written(view(grouped_tetrahedron()), "ply", true).text;
    EXPECT_NE(text.find("\ncomment group 7 rim\nelement vertex"), std::string::npos);
    EXPECT_NE(text.find("vertex_indices\nproperty int group\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend"),
              std::string::npos);
    std::vector<std::string> ends;
    std::istringstream lines(text.substr(text.find("end_header")));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("3 ")) ends.push_back(line.substr(8));
    const auto end = [](int id, Colour c) { return fmt::format("{} {} {} {}", id, c.red, c.green, c.blue); };
    EXPECT_EQ(ends, (std::vector<std::string>{end(0, grey), "7 1 2 3", end(2, second), "7 1 2 3"}));
}

TEST(WritePly, IsBinaryUnlessToldOtherwise)
{
    const std::string file = written(tetrahedron(), "ply").text;
    const std::size_t header = file.find("end_header\n") + 11;
    EXPECT_EQ(file.substr(0, 36), "ply\nformat binary_little_endian 1.0\n");
    ASSERT_EQ(file.size(), header + 4 * 24 + 4 * 13);
    const Point first = tetrahedron().position(Vertex(0));
    double x = 0;
    std::memcpy(&x, file.data() + header, 8);
    EXPECT_EQ(x, first.x);
    EXPECT_EQ(file[header + 96], 3);
}

TEST(WritePly, TakesFacesOfAnySize)
{
    for (const int n : {255, 256, 70000}) {
        const Mesh mesh = dihedron(n);
        const Model model = there_and_back(mesh, "ply");
        EXPECT_EQ(connections(model.mesh), connections(mesh));
        EXPECT_EQ(written(mesh, "ply").text.find("list uchar") == std::string::npos, n > 255);
    }
}

TEST(WritePly, RefusesWhatItCannotHold)
{
    const TemporaryFolder folder;
    const std::string path = (folder / "x.ply").string();
    const Graph graph{{{0, 0, 0}, {1, 0, 0}}, {{0, 1}}};
    const auto error = [&](const Graph* its) { return error_of([&] { OutputSet().write({Mesh(), GroupTable(), its}, path); }); };
    EXPECT_EQ(error(nullptr), path + ": the document holds no faces");
    EXPECT_EQ(error(&graph), path + ": the document holds a graph and no faces; PLY holds only faces");
}

class EveryShapeInPly : public testing::TestWithParam<NamedShape> {};
INSTANTIATE_TEST_SUITE_P(Ply, EveryShapeInPly, testing::ValuesIn(all_shapes()), shape_name<testing::TestParamInfo<NamedShape>>);

TEST_P(EveryShapeInPly, ComesBackAsFromObjInBothKinds)
{
    const Mesh mesh = GetParam().make();
    if (mesh.face_count() == 0) return;
    const Written obj = written(mesh, "obj"), binary = written(mesh, "ply"), ascii = written(mesh, "ply", true);
    EXPECT_EQ(binary.notes, obj.notes); // of edges that were split
    const Model plain = there_and_back(mesh, "obj"), from_binary = read_text(binary.text, "ply"),
                from_ascii = read_text(ascii.text, "ply");
    ASSERT_SOUND(from_binary.mesh);
    EXPECT_TRUE(from_binary.mesh == from_ascii.mesh);
    EXPECT_EQ(points(from_binary.mesh), points(plain.mesh));
    EXPECT_EQ(connections(from_binary.mesh), connections(plain.mesh));
    EXPECT_EQ(groups(from_binary.mesh), groups(mesh));
    EXPECT_EQ(from_binary.notes, plain.notes);
    EXPECT_EQ(from_binary.groups, GroupTable()); // nobody coloured them
}

TEST(ReadPly, KeepsStartCornersIdsColoursAndNames)
{
    Model model = grouped_tetrahedron();
    model.mesh.set_start(model.mesh.next(model.mesh.corner(Face(2))));
    for (const bool ascii : {false, true}) {
        const Model back = read_text(written(view(model), "ply", ascii).text, "ply");
        EXPECT_EQ(rings(back.mesh), rings(model.mesh));
        EXPECT_EQ(groups(back.mesh), (std::vector<int>{0, 7, 2, 7}));
        EXPECT_EQ(back.groups, model.groups);
        EXPECT_TRUE(back.notes.empty());
    }
}

// --- files of others
// --------------------------------------------------------------------------------------------------------------

const std::string vertex_header = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string vertex_lines = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string face_header = "element face 4\nproperty list uchar int vertex_index\n";
const std::string face_lines = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

/// An ASCII file whose vertices and faces carry more.
std::string with_more(const std::string& more_vertex_header, const std::array<std::string, 4>& more_of_vertices,
                      const std::string& more_face_header, const std::array<std::string, 4>& more_of_faces)
{
    std::string text =
        "ply\nformat ascii 1.0\n" + vertex_header + more_vertex_header + face_header + more_face_header + "end_header\n";
    const auto put = [&](const std::string& lines, const std::array<std::string, 4>& more) {
        std::istringstream in(lines);
        for (const std::string& m : more) {
            std::string line;
            std::getline(in, line);
            text += line + " " + m + "\n";
        }
    };
    put(vertex_lines, more_of_vertices);
    put(face_lines, more_of_faces);
    return text;
}

const std::string colour_header = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
const std::string float_colour_header = "property float red\nproperty float green\nproperty float blue\n";

TEST(ReadPly, MakesGroupsOfFaceColours)
{
    const Model model = read_text(with_more("", {}, colour_header, {"9 8 7", "1 2 3", "9 8 7", "0 0 0"}), "ply");
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{1, 2, 1, 3}));
    EXPECT_EQ(model.groups.colour(1), (Colour{9, 8, 7}));
    EXPECT_EQ(model.groups.colour(3), (Colour{0, 0, 0}));
}

TEST(ReadPly, TakesColoursOfAnyType)
{
    const Model floats = read_text(with_more("", {}, float_colour_header, {"0.2 1 0", "0 0 0.5", "1 1 1", "0 0 0"}), "ply");
    EXPECT_EQ(floats.groups.colour(1), (Colour{51, 255, 0}));
    EXPECT_EQ(floats.groups.colour(2), (Colour{0, 0, 128})); // 127.5 rounds up
    const Model longs = read_text(with_more("", {}, "property ushort blue\nproperty int red\nproperty double green\n",
                                            {"65535 51 1", "0 0 0", "0 0 0", "0 0 0"}),
                                  "ply");
    EXPECT_EQ(longs.groups.colour(1), (Colour{51, 255, 255}));
}

TEST(ReadPly, TakesColoursOfVerticesWhereFacesHaveNone)
{
    const std::array<std::string, 4> at_corners = {"255 0 0", "255 0 0", "0 0 255", "0 255 0"};
    const Model model = read_text(with_more(colour_header, at_corners, "", {}), "ply"); // faces 0 2 1, 0 1 3, 1 2 3, 2 0 3
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{1, 2, 3, 3}));
    EXPECT_EQ(model.groups.colour(1), (Colour{170, 0, 85}));
    const Model faces = read_text(with_more(colour_header, at_corners, colour_header, {"1 1 1", "1 1 1", "1 1 1", "2 2 2"}), "ply");
    EXPECT_EQ(groups(faces.mesh), (std::vector<int>{1, 1, 1, 2}));
}

TEST(ReadPly, LetsIdsWinOverColours)
{
    const Model model = read_text(
        with_more("", {}, "property short group\n" + colour_header, {"5 9 8 7", "0 1 1 1", "5 1 2 3", "300 4 4 4"}), "ply");
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{5, 0, 5, 300}));
    EXPECT_EQ(model.groups.colour(5), (Colour{9, 8, 7})); // of its first face
    EXPECT_EQ(model.groups.colour(300), (Colour{4, 4, 4}));
}

TEST(ReadPly, GivesZeroWithoutColoursAndOneForASingleColour)
{
    EXPECT_EQ(groups(read_text(with_more("", {}, "", {}), "ply").mesh), std::vector<int>(4, 0));
    EXPECT_EQ(groups(read_text(with_more("", {}, colour_header, {"1 1 1", "1 1 1", "1 1 1", "1 1 1"}), "ply").mesh),
              std::vector<int>(4, 1));
}

TEST(ReadPly, PassesOverWhatItDoesNotKnow)
{
    std::string text = with_more("property double confidence\nproperty list int float many\nproperty float w\n",
                                 {"nan 2 1 inf 0", "x 0 5", "1 1 1 0", "0 3 1 2 3 7"}, "property list uchar uchar flags\n",
                                 {"0", "1 9", "0", "0"});
    text.insert(text.find("element vertex"),
                "comment made by hand\nobj_info C:\\models\\\nelement camera 2\nproperty float view\nelement empty "
                "2000000000\n");
    text.insert(text.find("end_header"), "element edge 1\nproperty int vertex1\nproperty int vertex2\n");
    text.insert(text.find("0 0 0 nan"), "1.5\n\n2.5\n");
    const Model model = read_text(text + "0 1\n", "ply");
    EXPECT_EQ(rings(model.mesh), (std::vector<std::vector<std::uint32_t>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
    EXPECT_TRUE(model.notes.empty()) << model.notes[0];
    EXPECT_EQ(read_text(text + "0 1\n\nmore\n", "ply").notes,
              (std::vector<std::string>{"there is more after the last element: passed over"}));
}

TEST(ReadPly, TakesNoBytesIntoANameThatATerminalWouldObey)
{
    std::string text = with_more("", {}, "property int group\n", {"1", "2", "3", "4"});
    text.insert(text.find("element vertex"),
                "comment group 1 red\x1b[31m\ncomment group 2 \x1b[31m\ncomment group x y\ncomment group 3\n");
    const Model model = read_text(text, "ply");
    EXPECT_EQ(model.groups.name(1), "red");
    EXPECT_EQ(model.groups.name(2), "");
    EXPECT_EQ(model.groups.name(3), "");
}

TEST(ReadPly, TakesCarriageReturnsAndFacesBeforeVertices)
{
    const std::string faces_first =
        "ply\nformat ascii 1.0\n" + face_header + vertex_header + "end_header\n" + face_lines + vertex_lines;
    std::string text = faces_first;
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
    for (const std::string& each : {faces_first, text})
        EXPECT_EQ(rings(read_text(each, "ply").mesh),
                  (std::vector<std::vector<std::uint32_t>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
}

/// Puts a number down in some type and byte order.
template <class T> void put(std::string& text, T value, bool big)
{
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big) std::reverse(bytes.begin(), bytes.end());
    text += bytes;
}

template <class Coordinate, class Length, class Index>
std::string binary_tetrahedron(bool big, const char* coordinate, const char* length, const char* index)
{
    std::string text = big ? "ply\nformat binary_big_endian 1.0\n" : "ply\nformat binary_little_endian 1.0\n";
    text += fmt::format("element vertex 4\nproperty {0} x\nproperty list {1} {0} more\nproperty {0} y\nproperty {0} z\n",
                        coordinate, length);
    text +=
        fmt::format("element face 4\nproperty {1} before\nproperty list {0} {1} vertex_indices\nproperty {1} group\nend_header\n",
                    length, index);
    for (const auto& p : {std::array{0, 0, 0}, std::array{1, 0, 0}, std::array{0, 1, 0}, std::array{0, 0, 1}}) {
        put(text, Coordinate(p[0]), big);
        put(text, Length(2), big);
        put(text, Coordinate(100), big);
        put(text, Coordinate(101), big);
        put(text, Coordinate(p[1]), big);
        put(text, Coordinate(p[2]), big);
    }
    int group = 0;
    for (const auto& f : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{2, 0, 3}}) {
        put(text, Index(77), big);
        put(text, Length(3), big);
        for (const int v : f) put(text, Index(v), big);
        put(text, Index(group++), big);
    }
    return text;
}

TEST(ReadPly, TakesEveryTypeInBothByteOrders)
{
    for (const bool big : {false, true})
        for (const std::string& text : {
                 binary_tetrahedron<float, std::uint8_t, std::int32_t>(big, "float", "uchar", "int"),
                 binary_tetrahedron<double, std::int8_t, std::uint32_t>(big, "float64", "char", "uint32"),
                 binary_tetrahedron<std::int8_t, std::uint16_t, std::uint8_t>(big, "int8", "ushort", "uint8"),
                 binary_tetrahedron<std::int16_t, std::int16_t, std::uint16_t>(big, "short", "int16", "uint16"),
                 binary_tetrahedron<std::int32_t, std::uint32_t, std::int16_t>(big, "int32", "uint", "short"),
                 binary_tetrahedron<float, std::int32_t, float>(big, "float32", "int32", "float"),
             }) {
            const Model model = read_text(text, "ply");
            EXPECT_EQ(rings(model.mesh), (std::vector<std::vector<std::uint32_t>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
            EXPECT_EQ(points(model.mesh), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
            EXPECT_EQ(groups(model.mesh), (std::vector<int>{0, 1, 2, 3}));
            EXPECT_TRUE(model.notes.empty());
        }
}

TEST(ReadPly, ReadsALargeMeshBlockByBlock)
{
    const Mesh mesh = torus(300, 200); // 60000 vertices of 24 bytes: more than a block, whose end cuts into a number
    EXPECT_TRUE(there_and_back(mesh, "ply").mesh == read_text(written(mesh, "ply", true).text, "ply").mesh);
    EXPECT_EQ(points(there_and_back(mesh, "ply").mesh), points(mesh));
}

TEST(ReadPly, MendsWhatIsNoManifold)
{
    std::string text = with_more("", {}, "", {});
    text.replace(text.find("3 2 0 3"), 7, "3 0 2 3");
    EXPECT_EQ(read_text(text, "ply").notes, read_text(four_points + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 3 4\n", "obj").notes);
}

} // namespace
} // namespace druse::test
