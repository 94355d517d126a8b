#include "io/io_support.h"

// Each malformed file ends in one line that says where, what was found, and what would do.

namespace druse::test {
namespace {

struct Malformed {
    std::string format, text, error;
};

class EveryMalformedFile : public testing::TestWithParam<Malformed> {};

TEST_P(EveryMalformedFile, EndsInOneLine)
{
    const Malformed& file = GetParam();
    EXPECT_EQ(error_of([&] { read_text(file.text, file.format); }), "test." + file.format + file.error);
}

std::vector<Malformed> objs()
{
    const std::string p = four_points;
    const std::string v = "a vertex with ", expected = "; expected x y z, an optional w, and an optional colour r g b";
    return {
        {"obj", "", ": holds no faces, lines or points"},
        {"obj", "# nothing\n", ": holds no faces, lines or points"},
        {"obj", p, ": holds no faces, lines or points"},
        {"obj", p + "f 1 2 9\n", ":5: face names vertex 9, the file has 4"},
        {"obj", p + "f 1 2 3\n\n# more\nf 1 2 9000\nf 1 2 5\n", ":8: face names vertex 9000, the file has 4"},
        {"obj", "f 1 2 4\nf 1 2 5\nf 1 2 6\n" + p, ":2: face names vertex 5, the file has 4"},
        {"obj", p + "f 1 2 99999999999999999999\n", ":5: face names vertex 1000000000000000000, the file has 4"},
        {"obj", p + "f 0 1 2\n", ":5: face names vertex 0; they count from 1"},
        {"obj", p + "f 1 2 -5\n", ":5: face names vertex -5, but only 4 came before"},
        {"obj", p + "f 1 2\n", ":5: a face with 2 corners; expected at least 3"},
        {"obj", p + "f 1\n", ":5: a face with 1 corner; expected at least 3"},
        {"obj", p + "f\n", ":5: a face with 0 corners; expected at least 3"},
        {"obj", p + "f 1 2 three\n", ":5: expected a vertex number, found 'three'"},
        {"obj", p + "f 1 2 3.5\n", ":5: expected a vertex number, found '3.5'"},
        {"obj", p + "f 1 2 3 \\\n 4x\n", ":6: expected a vertex number, found '4x'"},
        {"obj", p + "f 1/1 2/1 3/1\n", ":5: face names texture coordinate 1, the file has 0"},
        {"obj", p + "vt 0 0\nf 1/1 2/1 3/-2\n", ":6: face names texture coordinate -2, but only 1 came before"},
        {"obj", p + "vn 0 0 1\nf 1//1 2//2 3//1\n", ":6: face names normal 2, the file has 1"},
        {"obj", p + "vn 0 0 1\nf 1//1 2//x 3//1\n", ":6: expected a normal number, found 'x'"},
        {"obj", p + "vt 0\nvn 0 0 1\nf 1/1/1/1 2 3\n", ":7: a corner with more than three parts; expected vertex/texture/normal"},
        {"obj", "v 0 0 nan\n", ":1: expected a number, found 'nan'"},
        {"obj", "v 0 inf 0\n", ":1: expected a number, found 'inf'"},
        {"obj", "v 0 0 0x1p3\n", ":1: expected a number, found '0x1p3'"},
        {"obj", "v 1e400 0 0\n", ":1: expected a number, found '1e400'"},
        {"obj", "v 0 0 1e39\n", ":1: coordinate 1e+39: expected at most 1e+38 in size"},
        {"obj", "v 1 2\n", ":1: " + v + "2 numbers" + expected},
        {"obj", "v 1 2 3 4 5\n", ":1: " + v + "5 numbers" + expected},
        {"obj", "v 1 2 3 4 5 6 7 8\n", ":1: " + v + "more than 7 numbers" + expected},
        {"obj", "v 1,5 2 3\n", ":1: expected a number, found '1,5'"},
        {"obj", "v 1 2 3 1 0 -1\n", ":1: vertex colour -1: expected 0 to 1"},
        {"obj", "v 1 2 3 1 0 256\n", ":1: vertex colour 256: expected 0 to 1"},
        {"obj", "c 1 0\n", ":1: expected a number, found the end of the line"},
        {"obj", "c 1 0 2\n", ":1: colour 2: expected 0 to 1"},
        {"obj", p + "l 1\n", ":5: a line with 1 point; expected at least 2"},
        {"obj", p + "l 1 2 2\n", ":5: a line from vertex 2 to itself"},
        {"obj", p + "l 1 7\n", ":5: line names vertex 7, the file has 4"},
        {"obj", p + "l 1 4294967297\n", ":5: line names vertex 4294967297, the file has 4"}, // 2^32 + 1 is not 1
        {"obj", p + "l 4294967297 5000000000\n", ":5: line names vertex 4294967297, the file has 4"},
        {"obj", p + "l 9 9\nv 0 0 0\n", ":5: a line from vertex 9 to itself"},
        {"obj", p + "p 0\n", ":5: point names vertex 0; they count from 1"},
        {"obj", std::string("v 1 2 \0 3\n", 10), ":1: expected a number, found '?'"},
    };
}
INSTANTIATE_TEST_SUITE_P(Obj, EveryMalformedFile, testing::ValuesIn(objs()));

std::vector<Malformed> stls()
{
    const std::string begin = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n";
    const std::string binary = written(tetrahedron(), "stl").text;
    std::string promises = binary, not_a_number = binary;
    promises[80] = 9;
    not_a_number.replace(84 + 50 + 12 + 8, 4, std::string("\x00\x00\xc0\x7f", 4)); // the z of the second triangle's first corner
    return {
        {"stl", "", ": is no STL file: shorter than the header of one"},
        {"stl", "soli", ": is no STL file: shorter than the header of one"},
        {"stl", "solid\nendsolid\n", ": holds no triangles"},
        {"stl", std::string(84, '\0'), ": holds no triangles"},
        {"stl", begin, ":5: the file ends inside a facet"},
        {"stl", begin + "endloop\n", ":6: a facet with 2 corners; expected at least 3"},
        {"stl", begin + "vertex 0 nan 0\n", ":6: expected a number, found 'nan'"},
        {"stl", begin + "vertex 0 1\n", ":6: expected a number, found the end of the line"},
        {"stl", begin + "vertex 0 1 1e300\n", ":6: coordinate 1e+300: expected at most 1e+38 in size"},
        {"stl", begin + "facet\n", ":6: expected 'endfacet' first, found 'facet'"},
        {"stl", begin + "edge 1 2 3\n", ":6: expected a word of STL, found 'edge'"},
        {"stl", "solid\nvertex 1 2 3\n", ":2: expected 'outer loop' first, found 'vertex'"},
        {"stl", "solid\nouter loop\n", ":2: expected 'facet' first, found 'outer'"},
        {"stl", promises, ": ends in triangle 5, its header promises 9"},
        {"stl", binary.substr(0, binary.size() - 1), ": ends in triangle 4, its header promises 4"},
        {"stl", binary.substr(0, 90), ": ends in triangle 1, its header promises 4"},
        {"stl", not_a_number, ": triangle 2: coordinate nan: expected at most 1e+38 in size"},
    };
}
INSTANTIATE_TEST_SUITE_P(Stl, EveryMalformedFile, testing::ValuesIn(stls()));

std::vector<Malformed> dlfls()
{
    const std::string v = "DLFL\n#\nv 0 0 0\nv 1 0 0\nv 0 1 0\n#\n";      // lines 1 to 6
    const std::string fv = v + "fv 0\nfv 1\nfv 2\nfv 1\nfv 0\nfv 2\n#\n"; // to 13
    const std::string e = fv + "e 0 3\ne 1 5\ne 2 4\n#\n";                // to 17
    const std::string all = e + "f 0 1 2\nf 3 4 5\n#\n";                  // to 20
    return {
        {"dlfl", "", ": the file ends among its title"},
        {"dlfl", "# DLFL\n", ":1: expected 'DLFL', found '#'"},
        {"dlfl", "OFF\n", ":1: expected 'DLFL', found 'OFF'"},
        {"dlfl", "DLFL\nv 0 0 0\n", ":2: expected 'mtllib' or '#', found 'v'"},
        {"dlfl", v, ":6: the file ends among its corners"},
        {"dlfl", e + "f 0 1 2\n", ":18: the file ends among its faces"},
        {"dlfl", "DLFL\n#\n#\n#\n#\n#\n", ": holds no faces"},
        {"dlfl", "DLFL\n#\nvn 0 0 0\n", ":3: expected 'v x y z', found 'vn'"},
        {"dlfl", "DLFL\n#\nv 0 0\n", ":3: expected a number, found the end of the line"},
        {"dlfl", "DLFL\n#\nv 0 0 -inf\n", ":3: expected a number, found '-inf'"},
        {"dlfl", "DLFL\n#\nv 0 0 1e50\n", ":3: coordinate 1e+50: expected at most 1e+38 in size"},
        {"dlfl", v + "fv 3\n", ":7: corner names vertex 3, there are 3"},
        {"dlfl", v + "fv -1\n", ":7: there is no vertex -1"},
        {"dlfl", v + "fv x\n", ":7: expected the number of a vertex, found 'x'"},
        {"dlfl", fv + "e 0\n", ":14: expected the number of a corner, found the end of the line"},
        {"dlfl", fv + "e 0 6\n", ":14: edge names corner 6, there are 6"},
        {"dlfl", fv + "e 0 0\n", ":14: edge names corner 0 twice"},
        {"dlfl", fv + "e 0 3\ne 1 3\n", ":15: edge names corner 3, which is in edge 0 already"},
        {"dlfl", e + "f\n", ":18: a face without corners"},
        {"dlfl", e + "f 0 1 6\n", ":18: face names corner 6, there are 6"},
        {"dlfl", e + "f 0 1 2\nf 3 4 1\n", ":19: face names corner 1, which is in face 0 already"},
        {"dlfl", e + "f 0 1 1\n", ":18: face names corner 1, which is in face 0 already"},
        {"dlfl", e + "f 0 1 2\n#\n", ": corner 3 is in no face"},
        {"dlfl", fv + "e 0 4\n#\nf 0 1 2\nf 3 4 5\n#\n",
         ": the sides at corners 0 and 4 do not run against each other, as edge 0 says"},
        {"dlfl", all + "druse 2\n", ":21: druse 2: expected 1"},
        {"dlfl", all + "druse 1\ng 1\n", ": 1 groups for 2 faces"},
        {"dlfl", all + "druse 1\ng 1 2 3\n", ":22: more groups than faces; the file has 2"},
        {"dlfl", all + "druse 1\ng 1 -2\n", ":22: there is no group -2"},
        {"dlfl", all + "druse 1\nopen 2\n", ":22: open names face 2, there are 2"},
        {"dlfl", all + "druse 1\nopen 0 1\n", ": edge 0 lies between the open faces 0 and 1"},
        {"dlfl", fv + "#\nf 0 1 2\nf 3 4 5\n#\ndruse 1\nopen 1\n", ": corner 3 of the open face 1 has no edge"},
    };
}
INSTANTIATE_TEST_SUITE_P(Dlfl, EveryMalformedFile, testing::ValuesIn(dlfls()));

std::vector<Malformed> plys()
{
    const std::string title = "ply\nformat ascii 1.0\n";                                                     // lines 1 and 2
    const std::string vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"; // to 6
    const std::string faces = "element face 2\nproperty list uchar int vertex_indices\n";                    // to 8
    const std::string begin = title + vertices + faces + "end_header\n", points = "0 0 0\n1 0 0\n0 1 0\n";   // to 9, to 12
    const std::string grouped = title + vertices + faces + "property int group\nend_header\n" + points;      // to 13
    const std::string coloured = title + vertices + faces +
                                 "property uchar red\nproperty float green\nproperty ushort blue\nend_header\n" + points; // to 15
    const std::string binary =
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty char x\nproperty char y\nproperty "
        "char z\nelement face 1\nproperty list int char vertex_indices\nend_header\n";
    const std::string at = std::to_string(binary.size() + 3 + 4), after = std::to_string(binary.size() + 3 + 4 + 1);
    const std::string p(3, '\0');
    return {
        {"ply", "", ": is no PLY file: it does not begin with 'ply'"},
        {"ply", "plywood\n", ": is no PLY file: it does not begin with 'ply'"},
        {"ply", "ply\n", ": has no 'end_header'"},
        {"ply", title + vertices + faces + "end_header", ": has no 'end_header'"},
        {"ply", "ply\nend_header\n", ": has no 'format'"},
        {"ply", "ply\nformat text 1.0\nend_header\n",
         ":2: expected ascii, binary_little_endian or binary_big_endian, found 'text'"},
        {"ply", "ply\nformat ascii 2.0\nend_header\n", ":2: expected version 1.0, found '2.0'"},
        {"ply", title + "elements vertex 3\nend_header\n", ":3: expected a word of PLY, found 'elements'"},
        {"ply", title + "element\nend_header\n", ":3: expected the name of an element, found the end of the line"},
        {"ply", title + "element vertex\nend_header\n",
         ":3: expected the number of elements called 'vertex', found the end of the line"},
        {"ply", title + "element vertex -3\nend_header\n", ":3: expected the number of elements called 'vertex', found '-3'"},
        {"ply", title + "element vertex 3.5\nend_header\n", ":3: expected the number of elements called 'vertex', found '3.5'"},
        {"ply", title + "element vertex 4000000000\nend_header\n", ":3: 4000000000: expected at most 2147483392"},
        {"ply", title + vertices + vertices + "end_header\n", ":7: there are elements called 'vertex' already"},
        {"ply", title + "property float x\nend_header\n", ":3: expected 'element' first, found 'property'"},
        {"ply", title + "element vertex 3\nproperty long x\nend_header\n", ":4: expected a type of number, found 'long'"},
        {"ply", title + "element vertex 3\nproperty float\nend_header\n",
         ":4: expected the name of a property, found the end of the line"},
        {"ply", title + "element face 3\nproperty list float int i\nend_header\n",
         ":4: expected a type of whole numbers, found 'float'"},
        {"ply", title + vertices + "end_header\n" + points, ": holds no faces"},
        {"ply", title + vertices + "element face 2\nend_header\n" + points, ": has faces without a list of vertex_indices"},
        {"ply", title + "element vertex 1\nproperty float x\nproperty float y\n" + faces + "end_header\n",
         ": has vertices without x, y and z"},
        {"ply", begin + "0 0 0\n1 0 0\n", ": ends in vertex 3 of 3"},
        {"ply", begin + points + "3 0 1 2\n", ": ends in face 2 of 2"},
        {"ply", begin + "0 0\n", ":10: expected a number, found the end of the line"},
        {"ply", begin + "0 0 nan\n", ":10: expected a number, found 'nan'"},
        {"ply", begin + "0 0 0\n0 0 1e39\n", ":11: coordinate 1e+39: expected at most 1e+38 in size"},
        {"ply", begin + "0 0 0 0\n", ":10: expected the end of the line, found '0'"},
        {"ply", begin + points + "2 0 1\n", ":13: a face with 2 corners; expected at least 3"},
        {"ply", begin + points + "0\n", ":13: a face with 0 corners; expected at least 3"},
        {"ply", begin + points + "-1\n", ":13: a list of -1 values; expected 0 to 2147483392"},
        {"ply", begin + points + "3.5 1 2 3\n", ":13: a list of 3.5 values; expected 0 to 2147483392"},
        {"ply", begin + points + "4 0 1 2\n", ":13: expected a number, found the end of the line"},
        {"ply", begin + points + "3 0 1 3\n", ":13: face names vertex 3, the file has 3"},
        {"ply", begin + points + "3 0 1 -1\n", ":13: face names vertex -1, the file has 3"},
        {"ply", begin + points + "3 0 1 1.5\n", ":13: face names vertex 1.5, the file has 3"},
        {"ply", grouped + "3 0 1 2 -2\n", ":14: there is no group -2"},
        {"ply", grouped + "3 0 1 2 3000000000\n", ":14: there is no group 3000000000"},
        {"ply", coloured + "3 0 1 2 256 0 0\n", ":16: colour 256: expected 0 to 255"},
        {"ply", coloured + "3 0 1 2 0 1.5 0\n", ":16: colour 1.5: expected 0 to 1"},
        {"ply", coloured + "3 0 1 2 0 0 -1\n", ":16: colour -1: expected 0 to 65535"},
        {"ply", binary, ": ends in vertex 1 of 1"},
        {"ply", binary + p + std::string("\3\0\0\0\0", 5), ": ends in face 1 of 1"},
        {"ply", binary + p + std::string("\377\377\377\377", 4),
         ": before byte " + at + ": a list of -1 values; expected 0 to 2147483392"},
        {"ply", binary + p + std::string("\3\0\0\0\1", 5), ": before byte " + after + ": face names vertex 1, the file has 1"},
        {"ply", binary + p + std::string("\377\377\377\176\0", 5), ": ends in face 1 of 1"}, // two thousand million corners
    };
}
INSTANTIATE_TEST_SUITE_P(Ply, EveryMalformedFile, testing::ValuesIn(plys()));

std::vector<Malformed> offs()
{
    const std::string points = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n"; // lines 1 to 5
    return {
        {"off", "", ": holds nothing"},
        {"off", "# nothing\n", ": holds nothing"},
        {"off", "OBJ\n", ":1: expected OFF, found 'OBJ'"},
        {"off", "OFF", ": ends before its counts"},
        {"off", "4OFF\n", ":1: '4OFF': expected vertices in three dimensions"},
        {"off", "CnOFF\n", ":1: 'CnOFF': expected vertices in three dimensions"},
        {"off", "OFF BINARY\n", ":1: a binary file; expected one in text"},
        {"off", "OFF\n3\n", ":2: expected a number, found the end of the line"},
        {"off", "OFF\n-3 1 0\n", ":2: -3 vertices; expected 0 to 2147483392"},
        {"off", "OFF\n3 5e9 0\n", ":2: 5000000000 faces; expected 0 to 2147483392"},
        {"off", "OFF\n3.5 1 0\n", ":2: 3.5 vertices; expected 0 to 2147483392"},
        {"off", "OFF\n3 0 0\n", ": holds no faces"},
        {"off", "OFF\n2147483392 1 0\n0 0 0\n", ": ends in vertex 2 of 2147483392"},
        {"off", points, ": ends in face 1 of 1"},
        {"off", "OFF\n3 1 0\n0 0\n", ":3: expected a number, found the end of the line"},
        {"off", "OFF\n3 1 0\n0 0 nan\n", ":3: expected a number, found 'nan'"},
        {"off", "OFF\n3 1 0\n0 0 -1e39\n", ":3: coordinate -1e+39: expected at most 1e+38 in size"},
        {"off", "NOFF\n3 1 0\n0 0 0 1 0\n", ":3: expected a number, found the end of the line"},
        {"off", "OFF\n3 1 0\n0 0 0 1 0\n", ":3: a colour with 2 numbers; expected 3 or 4"},
        {"off", points + "2 0 1\n", ":6: a face with 2 corners; expected at least 3"},
        {"off", points + "-3 0 1 2\n", ":6: -3 corners; expected 0 to 2147483392"},
        {"off", points + "2000000000 0 1 2\n", ":6: expected a number, found the end of the line"},
        {"off", points + "3 0 1 3\n", ":6: face names vertex 3, the file has 3"},
        {"off", points + "3 0 1 -1\n", ":6: face names vertex -1, the file has 3"},
        {"off", points + "3 0 1 2 256 0 0\n", ":6: colour 256: expected 0 to 255"},
        {"off", points + "3 0 1 2 1.5 0 0\n", ":6: colour 1.5: expected 0 to 1"},
        {"off", points + "3 0 1 2 1 2 3 4 5\n", ":6: a colour with 5 numbers; expected 3 or 4"},
        {"off", points + "3 0 1 2 1 2 3 4 5 6 7\n", ":6: a colour with more than 4 numbers"},
    };
}
INSTANTIATE_TEST_SUITE_P(Off, EveryMalformedFile, testing::ValuesIn(offs()));

TEST(MalformedFiles, WhoseFacesAreAllDegenerateHoldNone)
{
    const std::string none = ": holds no faces with three different corners";
    EXPECT_EQ(error_of([&] { read_text(four_points + "f 1 1 2\nf 3 4 4\n", "obj"); }), "test.obj" + none);
    EXPECT_EQ(error_of([&] { read_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n", "off"); }), "test.off" + none);
    EXPECT_EQ(read_text(four_points + "f 1 1 2\nl 1 2\n", "obj").graph->edges.size(), 1u); // but a graph is something
}

TEST(MalformedFiles, SayThatASurfaceIsOneSided)
{
    // A Möbius strip of five triangles on five vertices.
    const std::string strip = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nv 0 0 1\nf 1 2 3\nf 2 3 4\nf 3 4 5\nf 4 5 1\nf 5 1 2\n";
    const std::string error = error_of([&] { read_text(strip, "obj"); });
    EXPECT_EQ(error.substr(0, 33), "test.obj: the surface is one-side") << error;
    EXPECT_EQ(error.find('\n'), std::string::npos);
}

TEST(MissingFiles, AreNamed)
{
    const TemporaryFolder folder;
    const std::string gone = (folder / "gone.obj").string();
    EXPECT_EQ(error_of([&] { read_model(gone); }), gone + ": no such file");
    EXPECT_EQ(error_of([&] { read_model(folder.path(), "obj"); }), folder.path().string() + ": is a folder, not a file");
    put_contents(folder / "a.xyz", "");
    put_contents(folder / "a", "");
    const std::string odd = (folder / "a.xyz").string(), plain = (folder / "a").string();
    EXPECT_EQ(error_of([&] { read_model(odd); }), odd + ": unknown format 'xyz'; expected obj, stl, dlfl, ply, off, glb, gltf, 3mf, pane.json, tile, svg or dxf");
    EXPECT_EQ(error_of([&] { read_model(plain); }),
              plain + ": a name without a format; expected one that ends in obj, stl, dlfl, ply, off, glb, gltf, 3mf, pane.json, tile, svg or dxf");
    EXPECT_EQ(error_of([&] { read_text("", "step"); }),
              "test.step: unknown format 'step'; expected obj, stl, dlfl, ply, off, glb, gltf, 3mf, pane.json, tile, svg or dxf");
}

TEST(Formats, AreKnownInEitherCase)
{
    const TemporaryFolder folder;
    put_contents(folder / "A.OBJ", cube_obj);
    EXPECT_EQ(counts(read_model(folder / "A.OBJ").mesh), (Counts{8, 12, 6}));
    EXPECT_EQ(counts(read_model(folder / "A.OBJ", "Obj").mesh), (Counts{8, 12, 6}));
}

} // namespace
} // namespace druse::test
