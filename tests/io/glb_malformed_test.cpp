#include "io/glb_support.h"

#include <fmt/format.h>

// What a glTF file says about places in its data is believed only as far as the data goes.

namespace druse::test {
namespace {

using nlohmann::json;

std::string error_of_file(const std::string& file, const std::string& format = "glb")
{
    return error_of([&] { read_text(file, format); });
}

TEST(MalformedGlb, EndsInOneLineWhereTheContainerIsBroken)
{
    const std::string file = file_of(tetrahedron_glb());
    EXPECT_EQ(error_of_file("glTF"), "test.glb: ends in its header");
    EXPECT_EQ(error_of_file(std::string("glTF\1\0\0\0\14\0\0\0", 12)), "test.glb: glTF version 1; expected 2");
    EXPECT_EQ(error_of_file(file.substr(0, file.size() - 1)),
              fmt::format("test.glb: ends after {} bytes, its header promises {}", file.size() - 1, file.size()));
    std::string chunk = file;
    chunk[14] = '\x7f';
    EXPECT_EQ(error_of_file(chunk), "test.glb: the chunk at byte 12 is longer than the file");
    std::string type = file;
    type[16] = 'X';
    EXPECT_EQ(error_of_file(type), "test.glb: the first chunk is no description");
    EXPECT_EQ(error_of_file(std::string("glTF\2\0\0\0\0\0\0\0", 12)),
              "test.glb: is no glTF file: its description is no JSON from byte 1 on");
}

TEST(MalformedGlb, EndsInOneLineWhereTheDescriptionIsBroken)
{
    EXPECT_EQ(error_of_file("", "gltf"), "test.gltf: is no glTF file: its description is no JSON from byte 1 on");
    EXPECT_EQ(error_of_file("{\"asset\": ]", "gltf"), "test.gltf: is no glTF file: its description is no JSON from byte 11 on");
    EXPECT_EQ(error_of_file("[1]", "gltf"), "test.gltf: is no glTF file: its description is no object of JSON");
    EXPECT_EQ(error_of_file("{\"scene\": 1e999}", "gltf"),
              "test.gltf: is no glTF file: its description holds a number that is too large");
    EXPECT_EQ(error_of_file("{}", "gltf").find("test.gltf: is no glTF file: "), 0u);
    EXPECT_EQ(error_of_file("{\"asset\": {\"version\": \"2.0\"}}", "gltf"), "test.gltf: holds no triangles");
    const std::string deep =
        "{\"asset\": {\"version\": \"2.0\", \"extras\": " + std::string(1000000, '[') + std::string(1000000, ']') + "}}";
    EXPECT_EQ(error_of_file(deep, "gltf"), "test.gltf: lists in lists, more than 100 deep");
}

struct Change {
    const char* at; // in the description
    json value;
    std::string error;
};

class EveryMalformedGlb : public testing::TestWithParam<Change> {};

TEST_P(EveryMalformedGlb, EndsInOneLine)
{
    Glb glb = tetrahedron_glb();
    glb.description[json::json_pointer(GetParam().at)] = GetParam().value;
    EXPECT_EQ(error_of_file(file_of(glb)), "test.glb: " + GetParam().error);
}

const std::uint64_t huge = 0xfffffffffffffff0;

INSTANTIATE_TEST_SUITE_P(
    Glb, EveryMalformedGlb,
    testing::Values(
        Change{"/buffers", 7, "buffer 0 has no byteLength"}, Change{"/buffers/0", json::object(), "buffer 0 has no byteLength"},
        Change{"/buffers/0/byteLength", -1, "buffer 0 has no byteLength"},
        Change{"/buffers/0/byteLength", 61, "buffer 0 has 60 bytes, its byteLength is 61"},
        Change{"/buffers/0/byteLength", 59, "bufferView 1 reaches beyond the 59 bytes of its buffer"},
        Change{"/buffers/1", {{"byteLength", 60}}, "buffer 1 has no data"}, Change{"/buffers/0/uri", 5, "buffer 0 has no uri"},
        Change{"/buffers/0/uri", "gone.bin", "buffer 0 lies in a file that is not there"},
        Change{"/buffers/0/uri", "data:application/x-thing;base64,AAAA", "buffer 0 is coded in an unknown way"},
        Change{"/buffers/0/uri", "data:application/octet-stream;base64,AAAA", "buffer 0 has 3 bytes, its byteLength is 60"},
        Change{"/bufferViews/0/buffer", 1, "there is no buffer 1, the file has 1"},
        Change{"/bufferViews/0/byteOffset", 13, "bufferView 0 reaches beyond the 60 bytes of its buffer"},
        Change{"/bufferViews/0/byteOffset", huge, "bufferView 0 reaches beyond the 60 bytes of its buffer"},
        Change{"/bufferViews/0/byteLength", huge, "bufferView 0 reaches beyond the 60 bytes of its buffer"},
        Change{"/bufferViews/0/byteLength", 47, "accessor 0 reaches beyond the 47 bytes of its bufferView"},
        Change{"/bufferViews/0/byteStride", 8, "accessor 0 reaches beyond the 48 bytes of its bufferView"},
        Change{"/bufferViews/0/byteStride", 16, "accessor 0 reaches beyond the 48 bytes of its bufferView"},
        Change{"/accessors/0/byteOffset", 1, "accessor 0 reaches beyond the 48 bytes of its bufferView"},
        Change{"/accessors/0/byteOffset", huge, "accessor 0 reaches beyond the 48 bytes of its bufferView"},
        Change{"/accessors/0/count", 5, "accessor 0 reaches beyond the 48 bytes of its bufferView"},
        Change{"/accessors/0/count", huge, "accessor 0 reaches beyond the 48 bytes of its bufferView"},
        Change{"/accessors/0/count", 3, "a triangle names position 3, its mesh has 3"},
        Change{"/accessors/0/componentType", 5125, "accessor 0 does not hold positions"},
        Change{"/accessors/0/type", "VEC2", "accessor 0 does not hold positions"},
        Change{"/accessors/0/bufferView", 2, "there is no bufferView 2, the file has 2"},
        Change{"/accessors/0/sparse",
               json::parse(R"({"count": 1, "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 0}})"),
               "accessor 0 is sparse, which is not read"},
        Change{"/accessors/1/componentType", 5126, "accessor 1 does not hold indices"},
        Change{"/accessors/1/componentType", 5125, "accessor 1 reaches beyond the 12 bytes of its bufferView"},
        Change{"/accessors/1/count", 11, "11 corners are no whole number of triangles"},
        Change{"/meshes/0/primitives/0/attributes/POSITION", 2, "there is no accessor 2, the file has 2"},
        Change{"/meshes/0/primitives/0/attributes/POSITION", -1, "there is no accessor -1, the file has 2"},
        Change{"/meshes/0/primitives/0/attributes/POSITION", 1, "accessor 1 does not hold positions"},
        Change{"/meshes/0/primitives/0/material", 0, "there is no material 0, the file has 0"},
        Change{"/meshes/0/primitives/0/material", -2, "there is no material -2, the file has 0"},
        Change{"/meshes/0/primitives/0/mode", 1, "holds no triangles"},
        Change{"/nodes/0/mesh", 1, "there is no mesh 1, the file has 1"},
        Change{"/nodes/0/children", json::array({0}), "node 0 is in the scene twice"},
        Change{"/nodes/0/children", json::array({4}), "there is no node 4, the file has 1"},
        Change{"/nodes/0/scale", json::array({1, 2}), "node 0: scale has 2 numbers; expected 3"},
        Change{"/nodes/0/matrix", json::array({1, 2}), "node 0: matrix has 2 numbers; expected 16"},
        Change{"/nodes/0/scale", json::array({1e300, 1, 1}), "coordinate 1e+300: expected at most 1e+38 in size"},
        Change{"/scene", 1, "there is no scene 1, the file has 1"},
        Change{"/scenes/0/nodes", json::array({0, 0}), "node 0 is in the scene twice"},
        Change{"/scenes/0/nodes", json::array({-1}), "there is no node -1, the file has 1"},
        Change{"/extensionsRequired", json::array({"KHR_draco_mesh_compression"}),
               "needs the extension 'KHR_draco_mesh_compression', which is not read"}));

TEST(MalformedGlb, HasNoCoordinateThatIsNoNumber)
{
    Glb glb = tetrahedron_glb();
    glb.buffer.replace(8, 4, std::string("\0\0\xc0\x7f", 4));
    EXPECT_EQ(error_of_file(file_of(glb)), "test.glb: coordinate nan: expected at most 1e+38 in size");
}

TEST(MalformedGlb, DoesNotGrowWithoutEndByNamingAMeshAgainAndAgain)
{
    // 60 kB of positions, named by 2000 parts of a mesh, which stands at 30 000 nodes.
    Glb glb = tetrahedron_glb();
    glb.buffer.resize(60000, '\0');
    glb.description["buffers"][0]["byteLength"] = 60000;
    glb.description["bufferViews"][0] = {{"buffer", 0}, {"byteLength", 60000}};
    glb.description["accessors"][0]["count"] = 4998;
    json& primitives = glb.description["meshes"][0]["primitives"];
    primitives = json::array();
    for (int i = 0; i < 2000; ++i) primitives.push_back({{"attributes", {{"POSITION", 0}}}});
    glb.description["nodes"] = json::array();
    json nodes = json::array();
    for (int i = 0; i < 30000; ++i) {
        glb.description["nodes"].push_back({{"mesh", 0}});
        nodes.push_back(i);
    }
    glb.description["scenes"][0]["nodes"] = nodes;
    EXPECT_EQ(error_of_file(file_of(glb)), "test.glb: more than 268435456 corners, with each mesh at all of its nodes");
}

} // namespace
} // namespace druse::test
