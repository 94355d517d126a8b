#include "io/io_support.h"

#include <fmt/format.h>

namespace druse::test {
namespace {

const std::string corners = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::vector<std::vector<std::uint32_t>> tetrahedron_rings = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

/// The faces of a tetrahedron, each with something behind it.
std::string faces(const std::array<std::string, 4>& more)
{
    return "3 0 2 1 " + more[0] + "\n3 0 1 3 " + more[1] + "\n3 1 2 3 " + more[2] + "\n3 2 0 3 " + more[3] + "\n";
}

TEST(WriteOff, PutsTheColourOfItsGroupBehindAFace)
{
    Model model;
    model.mesh = read_text(four_points + tetrahedron_faces, "obj").mesh;
    EXPECT_EQ(written(model.mesh, "off").text, "OFF\n4 4 6\n" + corners + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    model.mesh.set_group(Face(1), 3);
    model.mesh.set_group(Face(3), 5);
    model.groups.set_colour(3, {1, 0, 1});
    const Colour fifth = GroupTable::default_colour(5);
    EXPECT_EQ(written(view(model), "off").text, "OFF\n4 4 6\n" + corners + "3 0 2 1\n3 0 1 3 1 0 1\n3 1 2 3\n" +
                                                    fmt::format("3 2 0 3 {} {} {}\n", fifth.red, fifth.green, fifth.blue));
}

TEST(WriteOff, RefusesWhatItCannotHold)
{
    const TemporaryFolder folder;
    const std::string path = (folder / "x.off").string();
    EXPECT_EQ(error_of([&] {
                  OutputSet().write({Mesh(), GroupTable(), nullptr}, path);
              }),
              path + ": the document holds no faces");
}

class EveryShapeInOff : public testing::TestWithParam<NamedShape> {};
INSTANTIATE_TEST_SUITE_P(Off, EveryShapeInOff, testing::ValuesIn(all_shapes()), shape_name<testing::TestParamInfo<NamedShape>>);

TEST_P(EveryShapeInOff, ComesBackAsFromObj)
{
    const Mesh mesh = GetParam().make();
    if (mesh.face_count() == 0) return;
    EXPECT_EQ(written(mesh, "off").notes, written(mesh, "obj").notes); // of edges that were split
    const Model model = there_and_back(mesh, "off"), plain = there_and_back(mesh, "obj");
    ASSERT_SOUND(model.mesh);
    EXPECT_EQ(points(model.mesh), points(plain.mesh));
    EXPECT_EQ(connections(model.mesh), connections(plain.mesh));
    EXPECT_EQ(model.notes, plain.notes);
}

TEST(ReadOff, KeepsColoursAndStartCorners)
{
    Model model;
    model.mesh = cube();
    model.mesh.set_start(model.mesh.next(model.mesh.corner(Face(2))));
    for (const int f : {1, 2, 4}) model.mesh.set_group(Face(static_cast<std::uint32_t>(f)), 10 - f);
    model.groups.set_colour(8, {0, 0, 1}); // nearly black
    const Model back = there_and_back(view(model), "off");
    EXPECT_EQ(rings(back.mesh), rings(model.mesh));
    EXPECT_EQ(groups(back.mesh), (std::vector<int>{0, 1, 2, 0, 3, 0})); // in the order of the faces
    EXPECT_EQ(back.groups.colour(1), GroupTable::default_colour(9));
    EXPECT_EQ(back.groups.colour(2), (Colour{0, 0, 1}));
    EXPECT_EQ(back.groups.colour(3), GroupTable::default_colour(6));
}

TEST(ReadOff, TakesEveryKindOfHeader)
{
    const std::string plain = corners + faces({});
    const std::string normals = "0 0 0 0 0 -1\n1 0 0 0 0 -1\n0 1 0 0 0 -1\n0 0 1 0 0 1\n";
    const std::string coloured = "0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n0 0 1 1 1 1 1\n";
    const std::string textured = "0 0 0 9 9\n1 0 0 9 9\n0 1 0 9 9\n0 0 1 9 9\n";
    for (const std::string& text : {
             "OFF\n4 4 6\n" + plain,
             "OFF 4 4 6\n" + plain,
             "4 4 0\n" + plain,
             "OFF\n4 4\n" + plain,
             "# first\n\nOFF # of Geomview\n# second\n4 4 6 # counts\n\n" + plain + "# the end",
             "NOFF\n4 4 6\n" + normals + faces({}),
             "COFF\n4 4 6\n" + coloured + faces({"1 2 3", "1 2 3", "1 2 3", "1 2 3"}),
             "CNOFF\n4 4 6\n" + normals + faces({}),
             "STOFF\n4 4 6\n" + textured + faces({}),
             "OFF\n4 4 6\n" + corners + faces({"7", "7", "# none", "8 # of a list"}),
         }) {
        const Model model = read_text(text, "off");
        EXPECT_EQ(rings(model.mesh), tetrahedron_rings) << text;
        EXPECT_EQ(points(model.mesh), (std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})) << text;
        EXPECT_EQ(model.mesh.largest_group(), text[0] == 'C' && text[1] == 'O' ? 1 : 0) << text;
        EXPECT_TRUE(model.notes.empty()) << text;
    }
}

TEST(ReadOff, TakesCarriageReturns)
{
    std::string text = "OFF\n4 4 6\n" + corners + faces({});
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
    EXPECT_EQ(rings(read_text(text, "off").mesh), tetrahedron_rings);
}

TEST(ReadOff, MakesGroupsOfFaceColours)
{
    const Model model = read_text("OFF\n4 4 6\n" + corners + faces({"255 0 0", "1.0 0 0 0.5", "", "0 0 1"}), "off");
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{1, 1, 0, 2}));
    EXPECT_EQ(model.groups.colour(1), (Colour{255, 0, 0}));
    EXPECT_EQ(model.groups.colour(2), (Colour{0, 0, 1})); // whole numbers: of 255
    const Model full = read_text("OFF\n4 4 6\n" + corners + faces({"1 0 0 1", "0 1 0 1", "0.2 1 0", "51 255 0 255"}), "off");
    EXPECT_EQ(groups(full.mesh), (std::vector<int>{1, 2, 3, 3}));
    EXPECT_EQ(full.groups.colour(1), (Colour{255, 0, 0}));
    EXPECT_EQ(full.groups.colour(3), (Colour{51, 255, 0}));
    EXPECT_EQ(groups(read_text("OFF\n4 4 6\n" + corners + faces({"0 0 0", "0 0 0", "0 0 0", "0 0 0"}), "off").mesh),
              std::vector<int>(4, 1));
}

TEST(ReadOff, TakesColoursOfVerticesWhereFacesHaveNone)
{
    const std::string coloured = "0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 0 0 255\n0 0 1 0 255 0\n";
    const Model model = read_text("COFF\n4 4 6\n" + coloured + faces({}), "off");
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{1, 2, 3, 3}));
    EXPECT_EQ(model.groups.colour(1), (Colour{170, 0, 85}));
    const std::string three = "0 0 0\n1 0 0 0 1 0 1\n0 1 0 0 1 0 1\n0 0 1 0 1 0 1\n"; // the first has none
    EXPECT_EQ(groups(read_text("COFF\n4 4 6\n" + three + faces({}), "off").mesh), (std::vector<int>{0, 0, 1, 0}));
}

TEST(ReadOff, NotesWhatComesAfterTheLastFace)
{
    EXPECT_EQ(read_text("OFF\n4 4 6\n" + corners + faces({}) + "3 0 1 2\n", "off").notes,
              (std::vector<std::string>{"there is more after the last face: passed over"}));
}

} // namespace
} // namespace druse::test
