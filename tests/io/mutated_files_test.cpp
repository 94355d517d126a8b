#include "io/glb_support.h"

#include <fmt/format.h>

#include <random>

// Files that someone else's program, or a bad cable, has made: each ends in one line or in a sound mesh.

namespace druse::test {
namespace {

void expect_one_line_or_a_sound_mesh(const std::string& text, const std::string& format)
{
    try {
        const Model model = read_text(text, format);
        EXPECT_SOUND(model.mesh);
        for (const Point& p : model.mesh.positions()) EXPECT_LE(std::abs(p.x) + std::abs(p.y) + std::abs(p.z), 3e38);
        for (const std::string& note : model.notes) EXPECT_EQ(note.find('\n'), std::string::npos);
    } catch (const InputError& error) {
        const std::string what = error.what();
        EXPECT_EQ(what.substr(0, 5), "test.");
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    }
}

std::string mutated(std::string text, std::mt19937& random)
{
    const auto at = [&] { return random() % text.size(); };
    for (std::uint32_t changes = 1 + random() % 4; changes > 0 && !text.empty(); --changes) {
        switch (random() % 7) {
        case 0:
            text[at()] = static_cast<char>(random());
            break;
        case 1:
            text[at()] = "0123456789 \n-./\\#ef"[random() % 19];
            break;
        case 2:
            text.erase(at(), 1 + random() % 8);
            break;
        case 3:
            text.insert(at(), 1, static_cast<char>(' ' + random() % 90));
            break;
        case 4:
            text.resize(at());
            break;
        case 5: { // a line twice, somewhere else
            const std::size_t begin = at(), end = std::min(text.find('\n', begin), text.size() - 1) + 1;
            const std::string line = text.substr(begin, end - begin);
            text.insert(at(), line);
            break;
        }
        default: { // two bytes change places
            std::swap(text[at()], text[at()]);
        }
        }
    }
    return text;
}

struct Original {
    const char* name;
    std::string format, text;
};
void PrintTo(const Original& original, std::ostream* out)
{
    *out << original.name;
}

class EveryMutation : public testing::TestWithParam<Original> {};

TEST_P(EveryMutation, EndsInOneLineOrASoundMesh)
{
    const Original& original = GetParam();
    for (unsigned seed = 0; seed < 2000; ++seed) {
        std::mt19937 random(seed);
        SCOPED_TRACE("seed " + std::to_string(seed));
        expect_one_line_or_a_sound_mesh(mutated(original.text, random), original.format);
        if (HasFailure()) break;
    }
}

TEST_P(EveryMutation, TruncatedAnywhereEndsInOneLineOrASoundMesh)
{
    const Original& original = GetParam();
    for (std::size_t size = 0; size < original.text.size(); ++size) {
        SCOPED_TRACE("size " + std::to_string(size));
        expect_one_line_or_a_sound_mesh(original.text.substr(0, size), original.format);
        if (HasFailure()) break;
    }
}

std::vector<Original> originals()
{
    Mesh grouped = cube();
    grouped.set_group(Face(2), 3);
    return {
        {"obj", "obj", written(mixed(), "obj").text},
        {"obj_with_all_forms", "obj",
         "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 0 0 1 1 1 1\nvt 0 0\nvn 0 0 1\nusemtl a\nf 1/1/1 3/1 2//1\nc 1 0 0.5\nf "
         "-4 2 \\\n 4\n"
         "f 2 3 4\nf 3 1 4\nl 1 2 3\np 4\n"},
        {"dlfl", "dlfl", written(grouped, "dlfl").text},
        {"dlfl_with_everything", "dlfl", written(mixed(), "dlfl").text},
        {"dlfl_of_lunes", "dlfl", written(three_lunes(), "dlfl").text},
        {"binary_stl", "stl", written(tetrahedron(), "stl").text},
        {"ascii_stl", "stl", written(tetrahedron(), "stl", true).text},
        {"binary_ply", "ply", written(grouped, "ply").text},
        {"ascii_ply", "ply", written(grouped, "ply", true).text},
        {"glb", "glb", written(grouped, "glb").text},
        {"glb_of_bytes", "glb", file_of(tetrahedron_glb())},
        {"gltf", "gltf", written(grouped, "gltf").text},
        {"off", "off", written(grouped, "off").text},
        {"off_with_everything", "off",
         "STCNOFF # all\n3 2 3\n0 0 0 0 0 1 1 0 0 9 9\n1 0 0 0 0 1 1 0 0 9 9\n0 1 0 0 0 1 1 0 0.5 9 9\n3 0 1 2 1 0 0 1\n3 2 1 0 "
         "7\n"},
        {"tile_of_a_cell", "tile",
         "{\"format\":\"druse-tile\",\"version\":1,\"kind\":\"cell\",\"cell\":\"cube\",\"size\":40,\"matrix\":[1,0.3,0,0,1,0,0,0,1],\n\"panes\":[{\"points\":[[2,3],[-3,1]],"
         "\"segments\":[[\"v0\",\"i0\"]]},{},{\"points\":[[0,2],[3,-2]]}],\n\"edges\":[[0.5],[],[0.25]],\"phase\":2,\"shape\":{\"moved\":{\"c0\":[1,0,-2],\"x0:1\":[1,0,2],\"s1\":[0.5,0.5,0]},\n"
         "\"splits\":[{\"pane\":0,\"triangle\":2,\"at\":[0.2,0.3,0.5]},{\"pane\":0,\"edge\":[\"v0\",\"i0\"],\"t\":0.5},{\"pane\":0,\"flip\":[\"v2\",\"i1\"]}],"
         "\"flat\":[{\"pane\":2,\"keep\":true,\"new\":[\"i1\"]}]}}\n"},
    };
}
INSTANTIATE_TEST_SUITE_P(Files, EveryMutation, testing::ValuesIn(originals()), shape_name<testing::TestParamInfo<Original>>);

TEST(MutatedFiles, OfShuffledFacesAreMended)
{
    // Random triangles on few vertices: every kind of edge and vertex that is no manifold.
    for (unsigned seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const unsigned vertices = 3 + random() % 8;
        std::string text;
        for (unsigned v = 0; v < vertices; ++v) text += fmt::format("v {} {} {}\n", random() % 10, random() % 10, random() % 10);
        for (unsigned f = 1 + random() % 12; f > 0; --f) {
            text += "f";
            for (unsigned k = 3 + random() % 3; k > 0; --k) text += fmt::format(" {}", 1 + random() % vertices);
            text += "\n";
        }
        expect_one_line_or_a_sound_mesh(text, "obj");
        if (HasFailure()) break;
    }
}

TEST(MutatedFiles, DoNotMakeRoomForWhatIsNotThere)
{
    std::string header(84, '\0');
    for (int i = 80; i < 84; ++i) header[static_cast<std::size_t>(i)] = '\xff'; // four thousand million triangles
    EXPECT_EQ(error_of([&] { read_text(header, "stl"); }), "test.stl: ends in triangle 1, its header promises 4294967295");
}

} // namespace
} // namespace druse::test
