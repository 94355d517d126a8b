#include "io/io_support.h"

#include "dlfl/measures.h"

#include <fmt/format.h>
#include <zip.h>

#include <map>
#include <memory>
#include <random>

namespace druse::test {
namespace {

/// A package with that model in it.
std::string packed(const std::string& model)
{
    const std::pair<const char*, std::string> parts[] = {
        {"[Content_Types].xml", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
                                "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
                                "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>"},
        {"_rels/.rels", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
                        "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
        {"3D/3dmodel.model", model}};
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* bytes = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_source_keep(bytes);
    zip_t* package = zip_open_from_source(bytes, ZIP_TRUNCATE, &error);
    for (const auto& [name, text] : parts) zip_file_add(package, name, zip_source_buffer(package, text.data(), text.size(), 0), ZIP_FL_OVERWRITE);
    EXPECT_EQ(zip_close(package), 0);
    zip_source_open(bytes);
    zip_source_seek(bytes, 0, SEEK_END);
    std::string result(static_cast<std::size_t>(zip_source_tell(bytes)), '\0');
    zip_source_seek(bytes, 0, SEEK_SET);
    EXPECT_EQ(zip_source_read(bytes, result.data(), result.size()), static_cast<zip_int64_t>(result.size()));
    zip_source_close(bytes);
    zip_source_free(bytes);
    return result;
}

std::string model_of(const std::string& resources, const std::string& build, const std::string& unit = "millimeter")
{
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"{}\" xml:lang=\"en-US\" "
                       "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n"
                       "<resources>{}</resources>\n<build>{}</build>\n</model>\n", unit, resources, build);
}

/// A tetrahedron with legs of length 1 along the axes, as object 1; `more` goes into the first triangle.
std::string tetrahedron_object(const std::string& more = "", const std::string& head = "")
{
    return fmt::format("<object id=\"1\" type=\"model\"{}><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>"
                       "<vertex x=\"0\" y=\"1\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"1\"/></vertices>\n<triangles><triangle v1=\"0\" v2=\"2\" v3=\"1\"{}/>\n"
                       "<triangle v1=\"0\" v2=\"1\" v3=\"3\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/><triangle v1=\"0\" v2=\"3\" v3=\"2\"/></triangles></mesh></object>\n",
                       head, more);
}

Model read(const std::string& model) { return read_text(packed(model), "3mf"); }

TEST(Write3mf, KeepsIdsColoursAndNamesOfGroups)
{
    Model model;
    model.mesh = torus(12, 8);
    for (const Face f : model.mesh.faces()) model.mesh.set_group(f, static_cast<int>(f.index % 5 * 3));
    for (int i = 0; i < 5; ++i) model.groups.set_colour(3 * i, {static_cast<std::uint8_t>(5 * i), static_cast<std::uint8_t>(255 - i), 77});
    model.groups.set_name(6, "six");
    std::map<int, double> areas;
    for (const Face f : model.mesh.faces()) areas[model.mesh.group(f)] += area(model.mesh, f);
    const Model back = there_and_back(view(model), "3mf");
    ASSERT_SOUND(back.mesh);
    EXPECT_TRUE(back.notes.empty());
    EXPECT_NEAR(volume(back.mesh), volume(model.mesh), 1e-5 * volume(model.mesh));
    std::map<int, double> its;
    for (const Face f : back.mesh.faces()) its[back.mesh.group(f)] += area(back.mesh, f);
    ASSERT_EQ(its.size(), areas.size());
    for (const auto& [id, a] : areas) {
        EXPECT_NEAR(its[id], a, 1e-4 * (1 + a)) << id; // a warped quad may be cut along either diagonal
        EXPECT_EQ(back.groups.colour(id), model.groups.colour(id)) << id;
        EXPECT_EQ(back.groups.name(id), model.groups.name(id)) << id;
    }
}

class EveryShapeIn3mf : public testing::TestWithParam<NamedShape> {};
INSTANTIATE_TEST_SUITE_P(ThreeMf, EveryShapeIn3mf, testing::ValuesIn(all_shapes()), shape_name<testing::TestParamInfo<NamedShape>>);

TEST_P(EveryShapeIn3mf, ComesBackAsFromGlbAndIsWrittenAlikeEachTime)
{
    Mesh mesh = GetParam().make();
    bool has_triangles = false;
    for (const Face f : mesh.faces()) has_triangles = has_triangles || valence(mesh, f) > 2;
    if (!has_triangles) return;
    for (const Edge e : mesh.edges())
        if (mesh.vertex(mesh.corner(e, 0)) == mesh.vertex(mesh.corner(e, 1))) return; // what has a vertex twice is left out
    for (const Face f : mesh.faces()) mesh.set_group(f, 4);
    const Written once = written(mesh, "3mf");
    EXPECT_EQ(once.text, written(mesh, "3mf").text);
    const Model back = read_text(once.text, "3mf"), from_glb = there_and_back(mesh, "glb");
    ASSERT_SOUND(back.mesh);
    EXPECT_EQ(back.mesh.face_count(), from_glb.mesh.face_count());
    EXPECT_EQ(back.mesh.vertex_count(), from_glb.mesh.vertex_count());
    EXPECT_EQ(back.notes, from_glb.notes);
    EXPECT_NEAR(volume(back.mesh), volume(from_glb.mesh), 1e-5 * (1 + std::abs(volume(from_glb.mesh))));
}

TEST(Write3mf, RefusesWhatItCannotHold)
{
    const TemporaryFolder folder;
    const std::string path = (folder / "x.3mf").string();
    const auto error = [&](const Mesh& mesh) { return error_of([&] { OutputSet().write({mesh, GroupTable(), nullptr}, path); }); };
    EXPECT_EQ(error(Mesh()), path + ": the document holds no faces");
    EXPECT_EQ(error(point_sphere()), path + ": the document holds no face with more than 2 corners");
    Mesh far = cube();
    far.set_position(Vertex(5), {0, 1e39, 0});
    EXPECT_EQ(error(far), path + ": vertex 5 lies at 0,1e+39,0: too far for the single precision of 3MF");
    far.set_position(Vertex(5), {0, 4e9, 0});
    EXPECT_EQ(error(far), path + ": vertex 5 lies at 0,4000000000,0: 3MF goes to 1000000000 mm");
    Mesh small = cube();
    for (const Vertex v : small.vertices()) small.set_position(v, 1e-9 * small.position(v));
    EXPECT_EQ(error(small), path + ": no triangle has an area in steps of 1e-06 mm, those of 3MF");
    EXPECT_TRUE(folder.names().empty());
}

TEST(Read3mf, PlacesComponentsInMillimetres)
{
    // Twice the object, the second half as large and 3 along x, and the whole is placed 10 along z: in inches.
    const std::string resources = tetrahedron_object() + "<object id=\"2\" type=\"model\"><components><component objectid=\"1\"/>"
                                                         "<component objectid=\"1\" transform=\"0.5 0 0 0 0.5 0 0 0 0.5 3 0 0\"/></components></object>";
    const Model model = read(model_of(resources, "<item objectid=\"2\" transform=\"1 0 0 0 1 0 0 0 1 0 0 10\"/>", "inch"));
    ASSERT_SOUND(model.mesh);
    EXPECT_EQ(model.mesh.face_count(), 8u);
    EXPECT_NEAR(volume(model.mesh), 25.4 * 25.4 * 25.4 * (1 + 0.125) / 6, 1e-3);
    Point low(1e9), high(-1e9);
    for (const Point& p : model.mesh.positions()) low = glm::min(low, p), high = glm::max(high, p);
    EXPECT_NEAR(high.x, 3.5 * 25.4, 1e-4);
    EXPECT_NEAR(low.z, 254, 1e-4);
    EXPECT_NEAR(high.z, 11 * 25.4, 1e-4);
}

TEST(Read3mf, KeepsSolidsThatAreMirroredOutsideOut)
{
    const Model model = read(model_of(tetrahedron_object(), "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"));
    EXPECT_NEAR(volume(model.mesh), 1.0 / 6, 1e-6);
}

TEST(Read3mf, TurnsByTheRowsOfATransform)
{
    // x goes to y, y to −x.
    const Model model = read(model_of(tetrahedron_object(), "<item objectid=\"1\" transform=\"0 2 0 -3 0 0 0 0 1 0 0 0\"/>"));
    Point low(1e9), high(-1e9);
    for (const Point& p : model.mesh.positions()) low = glm::min(low, p), high = glm::max(high, p);
    EXPECT_EQ(low, Point(-3, 0, 0));
    EXPECT_EQ(high, Point(0, 2, 1));
}

TEST(Read3mf, MakesGroupsOfMaterialsAndColours)
{
    const std::string materials = "<basematerials id=\"5\"><base name=\"PLA\" displaycolor=\"#FF0000\"/><base name=\"ABS\" displaycolor=\"#00FF00FF\"/></basematerials>";
    const Model by_material = read(model_of(materials + tetrahedron_object(" pid=\"5\" p1=\"1\"", " pid=\"5\" pindex=\"0\""), "<item objectid=\"1\"/>"));
    EXPECT_EQ(groups(by_material.mesh), (std::vector{1, 2, 2, 2}));
    EXPECT_EQ(by_material.groups.colour(1), (Colour{0, 255, 0}));
    EXPECT_EQ(by_material.groups.colour(2), (Colour{255, 0, 0}));
    const std::string colours = "<m:colorgroup id=\"6\"><m:color color=\"#112233\"/></m:colorgroup>";
    const Model by_colour = read(model_of(colours + tetrahedron_object(" pid=\"6\" p1=\"0\""), "<item objectid=\"1\"/>"));
    EXPECT_EQ(groups(by_colour.mesh), (std::vector{1, 0, 0, 0}));
    EXPECT_EQ(by_colour.groups.colour(1), (Colour{0x11, 0x22, 0x33}));
}

TEST(Read3mf, RefusesWhatIsNone)
{
    EXPECT_EQ(error_of([] { read_text("no zip", "3mf"); }), "test.3mf: is no 3MF file: it is no ZIP package");
    EXPECT_EQ(error_of([] { read_text("", "3mf"); }), "test.3mf: 3D/3dmodel.model: is not in the package, or cannot be unpacked");
    EXPECT_EQ(error_of([] { read(model_of(tetrahedron_object(), "")); }), "test.3mf: holds no triangles");
    EXPECT_EQ(error_of([] { read("<model"); }), "test.3mf: 3D/3dmodel.model:1: is no XML from here on: unclosed token");
    const auto error = [](const std::string& resources, const std::string& build = "<item objectid=\"1\"/>") { return error_of([&] { read(model_of(resources, build)); }); };
    EXPECT_EQ(error(tetrahedron_object(), "<item objectid=\"2\"/>"), "test.3mf: object 2, which is to be placed, is not there");
    EXPECT_EQ(error(tetrahedron_object() + tetrahedron_object()), "test.3mf: 3D/3dmodel.model:6: a second object 1");
    EXPECT_EQ(error("<object id=\"1\"><components><component objectid=\"1\"/></components></object>"), "test.3mf: 3D/3dmodel.model:3: objectid 1 is none before it");
    EXPECT_EQ(error("<object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"nan\" z=\"0\"/>"), "test.3mf: 3D/3dmodel.model:3: nan: expected at most 1e+38 in size");
    EXPECT_EQ(error("<object id=\"1\"><mesh><vertices><vertex x=\"0\" z=\"0\"/>"), "test.3mf: 3D/3dmodel.model:3: y is missing");
    EXPECT_EQ(error("<object id=\"1\"><mesh><triangles><triangle v1=\"0\" v2=\"1\" v3=\"-2\"/>"), "test.3mf: 3D/3dmodel.model:3: v3: expected a whole number, 0 or above");
    EXPECT_EQ(error("<object id=\"1\"><mesh><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/>"), "test.3mf: 3D/3dmodel.model:3: a triangle names vertex 0, its mesh has 0");
    EXPECT_EQ(error(tetrahedron_object(), "<item objectid=\"1\" transform=\"1 2 3\"/>"), "test.3mf: 3D/3dmodel.model:7: transform: expected 12 numbers");
    EXPECT_EQ(error_of([] { read("<!DOCTYPE a [<!ENTITY b \"c\">]><a>&b;</a>"); }), "test.3mf: 3D/3dmodel.model:1: declares entities, which 3MF has none of");
    std::string deep;
    for (int i = 0; i < 100; ++i) deep += "<a>";
    EXPECT_EQ(error_of([&] { read(deep); }), "test.3mf: 3D/3dmodel.model:1: elements in elements, more than 64 deep");
}

TEST(Read3mf, RefusesObjectsThatNameEachOtherAgainAndAgain)
{
    std::string resources = tetrahedron_object();
    for (int id = 2; id < 42; ++id) resources += fmt::format("<object id=\"{}\" type=\"model\"><components><component objectid=\"{}\"/><component objectid=\"{}\"/></components></object>", id, id - 1, id - 1);
    EXPECT_EQ(error_of([&] { read(model_of(resources, "<item objectid=\"41\"/>")); }), "test.3mf: places more than 1048576 objects");
}

void expect_one_line_or_sound(const std::string& package)
{
    try {
        const Model model = read_text(package, "3mf");
        EXPECT_SOUND(model.mesh);
        for (const Point& p : model.mesh.positions()) EXPECT_LE(std::abs(p.x) + std::abs(p.y) + std::abs(p.z), 3e38);
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
}

TEST(Read3mf, OfAnyMutationEndsInOneLineOrASoundMesh)
{
    Mesh grouped = cube();
    grouped.set_group(Face(2), 3);
    const std::string package = written(grouped, "3mf").text;
    const std::string text = model_of("<basematerials id=\"5\"><base name=\"PLA\" displaycolor=\"#FF0000\"/></basematerials>" + tetrahedron_object(" pid=\"5\" p1=\"0\"") +
                                          "<object id=\"2\" type=\"model\"><components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 0\"/></components></object>",
                                      "<item objectid=\"2\"/>");
    for (unsigned seed = 0; seed < 600; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        std::string model = text, bytes = package;
        for (unsigned changes = 1 + random() % 3; changes > 0; --changes) {
            model[random() % model.size()] = "0123456789-e.\"<>/ #F"[random() % 20];
            bytes[random() % bytes.size()] = static_cast<char>(random());
        }
        expect_one_line_or_sound(packed(model));
        expect_one_line_or_sound(bytes);
        expect_one_line_or_sound(package.substr(0, random() % package.size()));
        if (HasFailure()) break;
    }
}

} // namespace
} // namespace druse::test
