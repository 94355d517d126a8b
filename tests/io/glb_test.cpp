#include "io/glb_support.h"

#include <fmt/format.h>

#include <map>

namespace druse::test {
namespace {

using nlohmann::json;

Model read(const Glb& glb)
{
    return read_text(file_of(glb), "glb");
}

TEST(WriteGlb, PutsEachGroupIntoAPrimitiveWithItsMaterial)
{
    Model model;
    model.mesh = cube();
    model.mesh.set_group(Face(1), 7);
    model.mesh.set_group(Face(3), 2);
    model.mesh.set_group(Face(4), 7);
    model.groups.set_colour(7, {255, 0, 188});
    model.groups.set_name(7, "rim");
    const Glb glb = taken_apart(written(view(model), "glb").text);
    const json& primitives = glb.description["meshes"][0]["primitives"];
    ASSERT_EQ(primitives.size(), 3u);
    const std::array<int, 3> triangles = {6, 2, 4}; // of groups 0, 2 and 7
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(glb.description["accessors"][primitives[i]["indices"].get<std::size_t>()]["count"], 3 * triangles[i]);
        EXPECT_EQ(primitives[i]["attributes"]["POSITION"], 0);
        EXPECT_EQ(primitives[i]["material"], i);
    }
    const json& materials = glb.description["materials"];
    EXPECT_EQ(materials[0]["name"], "group_0");
    EXPECT_EQ(materials[1]["name"], "group_2");
    EXPECT_EQ(materials[2]["name"], "group_7");
    EXPECT_EQ(materials[2]["extras"]["name"], "rim");
    const json& colour = materials[2]["pbrMetallicRoughness"]["baseColorFactor"];
    EXPECT_EQ(colour[0], 1);
    EXPECT_EQ(colour[1], 0);
    EXPECT_NEAR(colour[2].get<double>(), 0.5, 0.005); // sRGB 188 is half the light
}

TEST(WriteGlb, TurnsUpFromZToY)
{
    const Glb glb = taken_apart(written(read_text(four_points + tetrahedron_faces, "obj").mesh, "glb").text);
    std::array<float, 12> at;
    std::memcpy(at.data(), glb.buffer.data(), sizeof at);
    EXPECT_EQ(at, (std::array<float, 12>{0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 1, 0}));
    EXPECT_EQ(glb.description["accessors"][0]["min"], (std::array{0, 0, -1}));
    EXPECT_EQ(glb.description["accessors"][0]["max"], (std::array{1, 1, 0}));
    EXPECT_FALSE(glb.description.contains("materials")); // nobody grouped
    std::array<std::uint32_t, 12> corners;
    std::memcpy(corners.data(), glb.buffer.data() + 48, sizeof corners);
    EXPECT_EQ(corners, (std::array<std::uint32_t, 12>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3}));
}

TEST(WriteGlb, RefusesWhatItCannotHold)
{
    const TemporaryFolder folder;
    for (const std::string format : {"glb", "gltf"}) {
        const std::string path = (folder / ("x." + format)).string();
        const auto error = [&](const Mesh& mesh) {
            return error_of([&] { OutputSet().write({mesh, GroupTable(), nullptr}, path); });
        };
        EXPECT_EQ(error(Mesh()), path + ": the document holds no faces");
        EXPECT_EQ(error(point_sphere()), path + ": the document holds no face with more than 2 corners");
        Mesh far = cube();
        far.set_position(Vertex(5), {0, 1e39, 0});
        EXPECT_EQ(error(far), path + ": vertex 5 lies at 0,1e+39,0: too far for the single precision of glTF");
    }
    EXPECT_TRUE(folder.names().empty());
}

class EveryShapeInGlb : public testing::TestWithParam<NamedShape> {};
INSTANTIATE_TEST_SUITE_P(Glb, EveryShapeInGlb, testing::ValuesIn(all_shapes()), shape_name<testing::TestParamInfo<NamedShape>>);

TEST_P(EveryShapeInGlb, ComesBackAsFromStl)
{
    Mesh mesh = GetParam().make();
    bool has_triangles = false;
    for (const Face f : mesh.faces()) has_triangles = has_triangles || valence(mesh, f) > 2;
    if (!has_triangles) return;
    for (const Edge e : mesh.edges())
        if (mesh.vertex(mesh.corner(e, 0)) == mesh.vertex(mesh.corner(e, 1))) return; // STL leaves out what has corners at one place
    for (const Face f : mesh.faces()) mesh.set_group(f, 4); // one primitive, so that triangles keep their order
    const Model from_stl = there_and_back(mesh, "stl"), binary = there_and_back(mesh, "glb"), text = there_and_back(mesh, "gltf");
    ASSERT_SOUND(binary.mesh);
    EXPECT_EQ(connections(binary.mesh), connections(from_stl.mesh));
    EXPECT_EQ(points(binary.mesh), points(from_stl.mesh));
    EXPECT_EQ(binary.notes, from_stl.notes);
    EXPECT_EQ(groups(binary.mesh), std::vector<int>(binary.mesh.face_count(), 4));
    EXPECT_TRUE(binary.mesh == text.mesh);
}

TEST(ReadGlb, KeepsIdsColoursAndNames)
{
    Model model;
    model.mesh = torus(12, 8);
    for (const Face f : model.mesh.faces()) model.mesh.set_group(f, static_cast<int>(f.index % 50 * 3));
    for (int i = 0; i < 50; ++i)
        model.groups.set_colour(3 * i, {static_cast<std::uint8_t>(5 * i), static_cast<std::uint8_t>(255 - i), 77});
    model.groups.set_name(6, "six");
    model.groups.set_name(9, "9");
    std::map<int, double> areas;
    for (const Face f : model.mesh.faces())
        if (valence(model.mesh, f) > 2) areas[model.mesh.group(f)] += area(model.mesh, f);
    for (const std::string format : {"glb", "gltf"}) {
        const Model back = there_and_back(view(model), format);
        std::map<int, double> its;
        for (const Face f : back.mesh.faces()) its[back.mesh.group(f)] += area(back.mesh, f);
        ASSERT_EQ(its.size(), areas.size());
        for (const auto& [id, a] : areas) {
            EXPECT_NEAR(its[id], a, 1e-5 * (1 + a)) << id;
            EXPECT_EQ(back.groups.colour(id), model.groups.colour(id)) << id;
            EXPECT_EQ(back.groups.name(id), model.groups.name(id)) << id;
        }
    }
}

TEST(ReadGlb, KeepsEveryShadeExactly)
{
    Model model;
    model.mesh = torus(16, 16);
    for (const Face f : model.mesh.faces()) {
        model.mesh.set_group(f, static_cast<int>(f.index) + 1);
        const auto shade = static_cast<std::uint8_t>(f.index);
        model.groups.set_colour(static_cast<int>(f.index) + 1, {shade, shade, static_cast<std::uint8_t>(255 - shade)});
    }
    EXPECT_TRUE(there_and_back(view(model), "glb").groups == model.groups);
}

// --- files of others
// --------------------------------------------------------------------------------------------------------------

const std::vector<Point> plain_points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}}; // in the order of their first use
const std::vector<std::vector<std::uint32_t>> plain_rings = {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {1, 0, 3}};

void expect_plain_tetrahedron(const Model& model)
{
    EXPECT_EQ(points(model.mesh), plain_points);
    EXPECT_EQ(rings(model.mesh), plain_rings);
    EXPECT_TRUE(model.notes.empty()) << model.notes[0];
    EXPECT_EQ(groups(model.mesh), std::vector<int>(4, 0));
}

TEST(ReadGlb, TurnsUpFromYToZ)
{
    const Model model = read(tetrahedron_glb());
    expect_plain_tetrahedron(model);
    EXPECT_NEAR(volume(model.mesh), 1.0 / 6, 1e-15);
}

TEST(ReadGlb, TakesDataBesideTheFileAndInIt)
{
    Glb glb = tetrahedron_glb();
    const TemporaryFolder folder;
    put_contents(folder / "my data.bin", glb.buffer);
    glb.description["buffers"][0]["uri"] = "my%20data.bin";
    expect_plain_tetrahedron(read_text(glb.description.dump(), "gltf", folder.path()));
    expect_plain_tetrahedron(read_text(glb_of(glb.description.dump(), ""), "glb", folder.path()));
    put_contents(folder / "with spaces.bin", glb.buffer + "more");
    glb.description["buffers"][0]["uri"] = "with spaces.bin";
    expect_plain_tetrahedron(read_text(glb.description.dump(), "glb", folder.path())); // text, whatever it is called
    glb.description["buffers"][0]["uri"] = "data:application/octet-stream;base64,"
                                           "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/"
                                           "AAIBAAEDAQIDAgAD";
    expect_plain_tetrahedron(read_text("\xEF\xBB\xBF" + glb.description.dump(), "gltf"));
}

TEST(ReadGlb, TakesEveryKindOfIndex)
{
    for (const int type : {5121, 5123, 5125}) {
        Glb glb = tetrahedron_glb();
        const std::string bytes = glb.buffer.substr(48);
        glb.buffer.resize(48);
        for (const char v : bytes) {
            if (type == 5121) append(glb.buffer, static_cast<std::uint8_t>(v));
            if (type == 5123) append(glb.buffer, static_cast<std::uint16_t>(v));
            if (type == 5125) append(glb.buffer, static_cast<std::uint32_t>(v));
        }
        glb.description["buffers"][0]["byteLength"] = glb.buffer.size();
        glb.description["bufferViews"][1]["byteLength"] = glb.buffer.size() - 48;
        glb.description["accessors"][1]["componentType"] = type;
        expect_plain_tetrahedron(read(glb));
    }
}

TEST(ReadGlb, TakesStripsFansAndTrianglesWithoutIndices)
{
    for (const auto& [mode, expected] : {std::pair{4, std::vector<std::vector<std::uint32_t>>{{0, 1, 2}}},
                                         std::pair{5, std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {1, 3, 2}}},
                                         std::pair{6, std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {0, 2, 3}}}}) {
        Glb glb = tetrahedron_glb();
        json& primitive = glb.description["meshes"][0]["primitives"][0];
        primitive.erase("indices");
        primitive["mode"] = mode;
        if (mode == 4) glb.description["accessors"][0]["count"] = 3;
        EXPECT_EQ(rings(read(glb).mesh), expected) << mode;
    }
}

TEST(ReadGlb, TakesPositionsBetweenOtherValuesAndInSmallNumbers)
{
    Glb glb = tetrahedron_glb();
    std::string apart(4, 'x');
    for (std::size_t v = 0; v < 4; ++v) apart += glb.buffer.substr(12 * v, 12) + std::string(v < 3 ? 20 : 0, 'x');
    glb.description["bufferViews"][0] = {{"buffer", 0}, {"byteLength", apart.size()}, {"byteStride", 32}};
    glb.description["accessors"][0]["byteOffset"] = 4;
    glb.description["bufferViews"][1]["byteOffset"] = apart.size();
    glb.description["buffers"][0]["byteLength"] = apart.size() + 12;
    glb.buffer = apart + glb.buffer.substr(48);
    expect_plain_tetrahedron(read(glb));

    Glb small = tetrahedron_glb();
    std::string bytes;
    for (const std::uint8_t x : {0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0, 0, 0, 255, 0}) append(bytes, x); // and one to spare
    small.buffer = bytes + small.buffer.substr(48);
    small.description["buffers"][0]["byteLength"] = 28;
    small.description["bufferViews"][0] = {{"buffer", 0}, {"byteLength", 16}, {"byteStride", 4}};
    small.description["bufferViews"][1]["byteOffset"] = 16;
    small.description["accessors"][0]["componentType"] = 5121;
    small.description["accessors"][0]["normalized"] = true;
    small.description["extensionsRequired"] = json::array({"KHR_mesh_quantization"});
    expect_plain_tetrahedron(read(small));
}

TEST(ReadGlb, PutsMeshesWhereTheirNodesAre)
{
    Glb glb = tetrahedron_glb();
    const double h = std::sqrt(0.5);
    glb.description["nodes"] = {
        {{"children", {1, 2}}, {"translation", {10, 0, 0}}},
        {{"mesh", 0}, {"scale", {2, 3, 4}}, {"rotation", {0, h, 0, h}}},                // x to −z, z to x
        {{"mesh", 0}, {"matrix", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 20, 0, 1}}}}; // a mirror image, lifted
    const Model model = read(glb);
    ASSERT_EQ(counts(model.mesh), (Counts{8, 12, 8}));
    const auto near = [&](std::uint32_t v, const Point& p) {
        EXPECT_LT(glm::distance(model.mesh.position(Vertex(v)), p), 1e-12) << v;
    };
    near(0, {10, 0, 0});
    near(1, {10, 0, 3});
    near(2, {10, 2, 0});
    near(3, {14, 0, 0});
    near(4, {10, 0, 20});
    double least = 100;
    for (const Point& p : model.mesh.positions()) least = std::min(least, p.x);
    EXPECT_DOUBLE_EQ(least, 9);
    EXPECT_NEAR(volume(model.mesh), (24 + 1) / 6.0, 1e-12); // the mirror image looks outward too
}

TEST(ReadGlb, TakesTheSceneThatIsShown)
{
    Glb glb = tetrahedron_glb();
    glb.description["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {5, 0, 0}}}, {{"children", {0}}}};
    glb.description["scenes"] = {{{"nodes", {1}}}, {{"nodes", {2}}}};
    glb.description["scene"] = 1;
    expect_plain_tetrahedron(read(glb));
    glb.description.erase("scene");
    EXPECT_EQ(read(glb).mesh.position(Vertex(0)), Point(5, 0, 0));
    glb.description.erase("scenes");
    EXPECT_EQ(read(glb).mesh.face_count(), 8u); // all of them
    glb.description.erase("nodes");
    expect_plain_tetrahedron(read(glb));
}

/// The tetrahedron's faces one by one, with these materials.
Model coloured(const std::string& materials, const std::array<int, 4>& of_faces)
{
    Glb glb = tetrahedron_glb();
    json primitives = json::array();
    for (int f = 0; f < 4; ++f) {
        glb.description["accessors"].push_back(
            {{"bufferView", 1}, {"byteOffset", 3 * f}, {"componentType", 5121}, {"count", 3}, {"type", "SCALAR"}});
        primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"indices", 2 + f}});
        if (of_faces[static_cast<std::size_t>(f)] >= 0) primitives.back()["material"] = of_faces[static_cast<std::size_t>(f)];
    }
    glb.description["meshes"][0]["primitives"] = primitives;
    glb.description["materials"] = json::parse(materials);
    return read(glb);
}

TEST(ReadGlb, TakesIdsFromMaterialsThatAreCalledGroups)
{
    const Model model = coloured(
        R"([{"name": "group_5", "extras": {"name": "rim of it"}}, {"name": "brass"}, {"name": "group_0"}])", {0, -1, 2, 0});
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{5, 0, 0, 5}));
    EXPECT_EQ(model.groups.name(5), "rim"); // one word
    EXPECT_EQ(model.groups.colour(5), (Colour{255, 255, 255}));
}

TEST(ReadGlb, MakesGroupsOfBaseColoursOtherwise)
{
    const Model model =
        coloured(R"([{"name": "group_5"}, {"name": "brass", "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0, 1, 0.3]}},
                                     {"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1]}}])",
                 {1, 0, -1, 2});
    EXPECT_EQ(groups(model.mesh), (std::vector<int>{1, 2, 0, 2}));
    EXPECT_EQ(model.groups.colour(1), (Colour{188, 0, 255}));
    EXPECT_EQ(model.groups.colour(2), (Colour{255, 255, 255}));
}

TEST(ReadGlb, PassesOverWhatIsNoTriangle)
{
    Glb glb = tetrahedron_glb();
    glb.description["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 1}});
    glb.description["images"] = {{{"uri", "gone.png"}}, {{"bufferView", 99}}};
    glb.description["textures"] = {{{"source", 0}}};
    glb.description["animations"] = "none";
    const Model model = read(glb);
    EXPECT_EQ(rings(model.mesh), plain_rings);
    EXPECT_EQ(model.notes, (std::vector<std::string>{"1 part without triangles: passed over"}));
}

} // namespace
} // namespace druse::test
