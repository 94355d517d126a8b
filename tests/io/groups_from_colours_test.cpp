#include "io/io_support.h"

#include <fmt/format.h>

// The rules by which the colours of a coloured OBJ become face groups.

namespace druse::test {
namespace {

/// The groups of a cube whose faces are preceded by these lines, one for each face.
Model coloured_cube(const std::vector<std::string>& before, const std::string& header = "",
                    const std::filesystem::path& folder = {})
{
    std::string text = header;
    std::size_t face = 0;
    std::istringstream lines(cube_obj);
    for (std::string line; std::getline(lines, line);) {
        if (line[0] == 'f' && face < before.size() && !before[face].empty()) text += before[face] + "\n";
        face += line[0] == 'f';
        text += line + "\n";
    }
    return read_text(text, "obj", folder);
}

TEST(GroupsFromColours, TakesIdsFromMaterialsThatAreCalledGroups)
{
    const Model model = coloured_cube({"", "usemtl group_7", "", "usemtl group_0", "usemtl group_3", "usemtl group_7"});
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{0, 7, 7, 0, 3, 7}));
}

TEST(GroupsFromColours, NumbersMaterialsOtherwise)
{
    // One material that is called something else, and all are colours (here: names, as there is no .mtl).
    EXPECT_EQ(groups(coloured_cube({"usemtl group_7", "usemtl brass", "usemtl group_7", "", "usemtl group_1", ""}).mesh),
              (std::vector<int>{1, 2, 1, 1, 3, 3}));
    for (const char* name :
         {"group_", "group_x", "group_07", "group_-1", "group_1 ", "Group_1", "group_99999999999", "group_1 b"}) {
        const bool is_group = std::string(name) == "group_1 "; // the blank is not part of the name
        EXPECT_EQ(groups(coloured_cube({"", "", "", "", "", std::string("usemtl ") + name}).mesh)[5], 1) << name;
        EXPECT_EQ(groups(coloured_cube({"usemtl group_5", "", "", "", "", std::string("usemtl ") + name}).mesh)[0],
                  is_group ? 5 : 1)
            << name;
    }
}

TEST(GroupsFromColours, CountsOnlyMaterialsThatAreUsed)
{
    EXPECT_EQ(groups(coloured_cube({"usemtl brass\nusemtl group_4"}).mesh), (std::vector<int>(6, 4)));
}

TEST(GroupsFromColours, PutsMaterialsOfOneColourTogether)
{
    const TemporaryFolder folder;
    put_contents(folder / "a.mtl", "newmtl brass\nKd 0.5 0.25 0\nnewmtl gold\nNs 10\nKd 0.5001 0.2502 0\nnewmtl glass\nd 0.5\n");
    put_contents(folder / "b.mtl", "newmtl iron\r\nKd 0.2 \r\nnewmtl odd\nKd spectral x.rfl\n");
    const Model model =
        coloured_cube({"usemtl iron", "usemtl brass", "usemtl gold", "usemtl glass", "usemtl odd", "usemtl missing"},
                      "mtllib a.mtl b.mtl\n", folder.path());
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{1, 2, 2, 3, 4, 5}));
    EXPECT_EQ(model.groups.colour(1), (Colour{51, 51, 51}));
    EXPECT_EQ(model.groups.colour(2), (Colour{128, 64, 0})); // 127.5 rounds up, 63.75 too
    EXPECT_EQ(model.groups.colour(3), GroupTable::default_colour(3));
    EXPECT_TRUE(model.notes.empty());
}

TEST(GroupsFromColours, FindsAMaterialFileWithBlanksInItsName)
{
    const TemporaryFolder folder;
    put_contents(folder / "my colours.mtl", "newmtl a\nKd 1 0 0\nnewmtl b\nKd 1 0 0\n");
    EXPECT_EQ(groups(coloured_cube({"usemtl a", "usemtl b"}, "mtllib my colours.mtl\n", folder.path()).mesh),
              std::vector<int>(6, 1));
}

TEST(GroupsFromColours, NotesMaterialFilesThatAreNotThere)
{
    const Model model = coloured_cube({"usemtl a", "usemtl b"}, "mtllib gone.mtl also.mtl\n");
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{1, 2, 2, 2, 2, 2}));
    EXPECT_EQ(model.notes, (std::vector<std::string>{"gone.mtl and 1 more .mtl file cannot be read: their colours are unknown"}));
    EXPECT_EQ(coloured_cube({"usemtl a"}, "mtllib gone.mtl\nmtllib gone.mtl\n").notes,
              (std::vector<std::string>{"gone.mtl cannot be read: its colours are unknown"}));
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "odd.mtl");
    EXPECT_EQ(coloured_cube({"usemtl a"}, "mtllib odd.mtl\n", folder.path()).notes,
              (std::vector<std::string>{"odd.mtl cannot be read: its colours are unknown"}));
}

TEST(GroupsFromColours, KnowsAMaterialWhoseColourIsNoneByItsName)
{
    const TemporaryFolder folder;
    put_contents(folder / "a.mtl", "newmtl red\nKd 1 0 0\nnewmtl odd\nKd 1 x 0\nnewmtl ruby\nKd 1 0 0\n");
    const Model model = coloured_cube({"usemtl odd", "usemtl red", "usemtl ruby", "usemtl odd"}, "mtllib a.mtl\n", folder.path());
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{1, 2, 2, 1, 1, 1}));
    EXPECT_EQ(model.groups.colour(1), GroupTable::default_colour(1));
    const std::string where = (folder / "a.mtl").string();
    EXPECT_EQ(model.notes, (std::vector<std::string>{where + ":4: Kd: expected a number, found 'x': the colour is unknown"}));
    put_contents(folder / "a.mtl", "newmtl red\nKd\nnewmtl odd\nKd 1 0 -\n");
    EXPECT_EQ(coloured_cube({"usemtl red", "usemtl odd"}, "mtllib a.mtl\n", folder.path()).notes,
              (std::vector<std::string>{where + ":2: Kd: expected a number, found the end of the line: this and 1 more colour are unknown"}));
}

TEST(GroupsFromColours, TakesTheColourRecordsOfTopMod)
{
    const TemporaryFolder folder;
    put_contents(folder / "a.mtl", "newmtl red\nKd 1 0 0\n");
    const Model model =
        coloured_cube({"", "c 0 1 0", "c 1 0 0", "c 0 1 0", "usemtl red", "c 0 0.999 0"}, "mtllib a.mtl\n", folder.path());
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{0, 1, 2, 1, 2, 1})); // 0.999 is 255 of 255
    EXPECT_EQ(model.groups.colour(1), (Colour{0, 255, 0}));
}

/// A tetrahedron with these colours on its four vertices.
Model coloured_tetrahedron(const std::array<const char*, 4>& rgb, const std::string& before_faces = "")
{
    const char* const at[] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
    std::string text;
    for (std::size_t i = 0; i < 4; ++i) text += std::string("v ") + at[i] + " " + rgb[i] + "\n";
    return read_text(text + before_faces + tetrahedron_faces, "obj");
}

TEST(GroupsFromColours, TakesTheMeanOfVertexColours)
{
    const Model model = coloured_tetrahedron({"1 0 0", "1 0 0", "0 0 1", "0 1 0"}); // faces 0 2 1, 0 1 3, 1 2 3, 2 0 3
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{1, 2, 3, 3}));
    EXPECT_EQ(model.groups.colour(1), (Colour{170, 0, 85}));
    EXPECT_EQ(model.groups.colour(2), (Colour{170, 85, 0}));
    EXPECT_EQ(model.groups.colour(3), (Colour{85, 85, 85}));
}

TEST(GroupsFromColours, GivesNoGroupToAFaceWithAnUncolouredVertex)
{
    EXPECT_EQ(groups(coloured_tetrahedron({"", "1 0 0", "1 0 0", "1 0 0"}).mesh), (std::vector<int>{0, 0, 1, 0}));
    EXPECT_EQ(groups(coloured_tetrahedron({"1 0 0", "1 0 0", "1 0 0", ""}).mesh), (std::vector<int>{1, 0, 0, 0}));
}

TEST(GroupsFromColours, TakesVertexColoursBehindAWeightAndInBytes)
{
    const Model weights = coloured_tetrahedron({"1 1 0 0", "1 1 0 0", "1 1 0 0", "1 1 0 0"});
    EXPECT_EQ(weights.groups.colour(1), (Colour{255, 0, 0}));
    const Model bytes = coloured_tetrahedron({"255 0 128", "255 0 128", "255 0 128", "255 0 128"});
    EXPECT_EQ(bytes.groups.colour(1), (Colour{255, 0, 128}));
    EXPECT_EQ(bytes.notes, (std::vector<std::string>{"vertex colours go beyond 1: read as 0 to 255"}));
}

TEST(GroupsFromColours, LetsFaceColoursWinOverVertexColours)
{
    EXPECT_EQ(groups(coloured_tetrahedron({"1 0 0", "0 1 0", "0 0 1", "1 1 1"}, "usemtl one\n").mesh), (std::vector<int>(4, 1)));
}

TEST(GroupsFromColours, GivesZeroWithoutColoursAndOneForASingleColour)
{
    EXPECT_EQ(groups(read_text(cube_obj, "obj").mesh), std::vector<int>(6, 0));
    EXPECT_EQ(groups(coloured_cube({"usemtl steel"}).mesh), std::vector<int>(6, 1));
    EXPECT_EQ(groups(coloured_tetrahedron({"0 0 0", "0 0 0", "0 0 0", "0 0 0"}).mesh), std::vector<int>(4, 1));
    EXPECT_EQ(groups(coloured_cube({"usemtl "}).mesh), std::vector<int>(6, 0));
}

TEST(GroupsFromColours, TellsAllColoursApart)
{
    // 4096 faces of as many colours, twice: each is met again.
    Mesh mesh = torus(64, 64);
    std::string text = written(mesh, "obj").text, coloured;
    std::istringstream lines(text);
    int k = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line[0] == 'f') {
            const int n = k++ % 2048;
            coloured += fmt::format("c {} {} {}\n", (n & 15) / 15.0, (n >> 4 & 15) / 15.0, (n >> 8) / 7.0);
        }
        coloured += line + "\n";
    }
    const std::vector<int> ids = groups(read_text(coloured, "obj").mesh);
    for (int f = 0; f < 4096; ++f) ASSERT_EQ(ids[static_cast<std::size_t>(f)], f % 2048 + 1);
}

TEST(GroupsFromColours, KeepsColourAndNameOfFacesWithoutAGroup)
{
    Model model;
    model.mesh = cube();
    for (const std::string format : {"obj", "dlfl", "ply", "glb", "gltf", "off"}) EXPECT_FALSE(there_and_back(view(model), format).groups.has_own_colour(0)) << format;
    model.groups.set_colour(0, {255, 0, 10});
    model.groups.set_name(0, "base");
    for (const std::string format : {"obj", "dlfl", "ply", "glb", "gltf"}) {
        const Model back = there_and_back(view(model), format);
        EXPECT_EQ(back.mesh.largest_group(), 0) << format;
        EXPECT_EQ(back.groups.colour(0), (Colour{255, 0, 10})) << format;
        EXPECT_EQ(back.groups.name(0), "base") << format;
    }
    const Model off = there_and_back(view(model), "off"); // has no ids: a colour is a group
    EXPECT_EQ(off.groups.colour(off.mesh.group(Face(0))), (Colour{255, 0, 10}));
}

} // namespace
} // namespace druse::test
