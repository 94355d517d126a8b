// Tiles as files: broken ones end in one line, drawings cut each line once, and solids keep their volume in STL.
#include "io/io_support.h"
#include "tile/layered_facts.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace druse {
namespace {

using TileTree = nlohmann::ordered_json;

LayeredTile quad_tile()
{
    LayeredTile tile = LayeredTile::of_type(79, 20);
    tile.set_path(0, {{0.333, 0.125}, {0.667, -0.125}});
    tile.set_path(1, {{0.25, 0.1}});
    tile.add_point({10, 4});
    tile.constrain(std::array{PointName::corner(0), PointName::interior(0)});
    tile.set_stack({TileStack::Mode::shift, {10, 10}, 0});
    tile.extrude(5);
    tile.set_heights(std::array{tile.find(PointName::interior(0))}, 2);
    return tile;
}

std::string tile_as(const LayeredTile& tile, const std::string& format)
{
    const Mesh none;
    const GroupTable groups;
    return test::written(ModelView{.mesh = none, .groups = groups, .tile = &tile}, format).text;
}

/// What is said about a text; empty: it is read. Anything but an InputError fails the test.
std::string said_about(const std::string& text)
{
    try {
        test::read_text(text, "tile");
    } catch (const InputError& e) {
        const std::string what = e.what();
        EXPECT_TRUE(what.starts_with("test.tile:")) << what;
        EXPECT_EQ(what.find('\n'), std::string::npos) << what;
        return what;
    }
    return "";
}

TEST(BrokenTileFile, EndsInOneLineWhereverItIsCut)
{
    const std::string whole = tile_as(quad_tile(), "tile");
    ASSERT_EQ(said_about(whole), "");
    const std::size_t end = whole.rfind('}');
    for (std::size_t length = 0; length <= end; ++length) EXPECT_NE(said_about(whole.substr(0, length)), "") << length;
}

TEST(BrokenTileFile, EndsInOneLineWhateverIsChanged)
{
    const std::string whole = tile_as(quad_tile(), "tile");
    std::mt19937 random(5);
    for (int round = 0; round < 3000; ++round) {
        std::string text = whole;
        for (unsigned changes = 1 + random() % 3; changes-- > 0;) {
            const std::size_t at = random() % text.size();
            switch (random() % 4) {
            case 0: text[at] = static_cast<char>(random()); break;
            case 1: text.erase(at, 1 + random() % 8); break;
            case 2: text.insert(at, 1, "0123456789-.eE[]{}\",:"[random() % 21]); break;
            default: text.insert(at, text.substr(random() % text.size(), random() % 20)); break;
            }
            if (text.empty()) text = "{";
        }
        said_about(text);
    }
}

TEST(BrokenTileFile, NamesTheKeyWhoseValueIsOfAnotherKind)
{
    const TileTree whole = TileTree::parse(tile_as(quad_tile(), "tile"));
    const std::vector<TileTree> others{nullptr, true, "text", -1e200, TileTree::array(), TileTree::object(), TileTree::array({TileTree::array({TileTree::array()})}),
                                       TileTree::array({nullptr, nullptr}), TileTree::array({1e308, 1e308})};
    for (const auto& [key, value] : whole.items())
        for (const TileTree& other : others) {
            if (other.type() == value.type() && other.size() == 0) continue; // an empty list is a list
            TileTree changed = whole;
            changed[key] = other;
            const std::string said = said_about(changed.dump(1));
            EXPECT_NE(said.find(": " + key), std::string::npos) << key << ": " << other.dump() << " -> " << said;
        }
}

TEST(BrokenTileFile, MayHaveNumbersOfNoUseAndValuesDeepInEachOther)
{
    const std::string whole = tile_as(quad_tile(), "tile");
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = whole;
        EXPECT_NE(text.find(from), std::string::npos) << from;
        return text.replace(text.find(from), from.size(), to);
    };
    for (const char* number : {"NaN", "nan", "Infinity", "-inf", "1e999", "-1e400", "0x10", "1e", "--1"}) EXPECT_NE(said_about(with("20", number)), "") << number;
    EXPECT_NE(said_about(with("\"size\": 20", "\"size\": 1e300")).find("test.tile:6: size"), std::string::npos);
    EXPECT_NE(said_about(with("\"thickness\": 5", "\"thickness\": 1e-999")).find("thickness: expected above 0"), std::string::npos);
    EXPECT_NE(said_about(with("[10, 4]", "[10, 4], [10, 4]")).find("interior: swallows-point"), std::string::npos);
    EXPECT_NE(said_about(std::string(2'000'000, '[')).find("deep"), std::string::npos);
    EXPECT_NE(said_about(with("{ \"format\"", "{ \"view\": " + std::string(100'000, '[') + std::string(100'000, ']') + ", \"format\"")).find("deep"), std::string::npos);
    EXPECT_NE(said_about(with("\"i0\": 2", "\"i4294967296\": 2")), "");
    EXPECT_NE(said_about(with("\"i0\": 2", "\"v0\": 2, \"v99\": 1")).find("heights.v99"), std::string::npos);
    EXPECT_NE(said_about(with("\"i0\": 2", "\"v1\": 2, \"v2\": 1")).find("one orbit have one height"), std::string::npos);
}

TEST(TileDrawing, ForACutterHasEachLineOnce)
{
    LayeredTile tile = quad_tile();
    tile.set_across(3, 2);
    const std::string text = tile_as(tile, "dxf");
    EXPECT_TRUE(text.starts_with("0\nSECTION\n2\nHEADER\n"));
    EXPECT_TRUE(text.ends_with("0\nENDSEC\n0\nEOF\n"));
    std::map<std::string, int> polylines;
    for (std::size_t at = 0; (at = text.find("POLYLINE\n8\n", at)) != std::string::npos; ++at) ++polylines[text.substr(at + 11, text.find('\n', at + 11) - at - 11)];
    // 24 tiles of three edges have 72 of them. Inside a cell of four tiles, all four of the legs at its centre are shared; other edges are where the two copies that have one are both there.
    int shared = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 2; ++j)
            for (int a = 0; a < 4; ++a)
                for (int k = 0; k < 3; ++k) {
                    const TileCopy next = tile.neighbour({a, {i, j}}, k);
                    shared += next.shift.i >= 0 && next.shift.i < 3 && next.shift.j >= 0 && next.shift.j < 2;
                }
    EXPECT_EQ(polylines["CUT"], 72 - shared / 2);
    EXPECT_EQ(polylines["ENGRAVE"], 24);
    EXPECT_NE(test::error_of([&] { test::read_text(text, "dxf"); }).find("written, not read"), std::string::npos);
}

/// The volume inside the triangles of a binary STL file, from its bytes: 80 of a header, a count, and 50 for each triangle.
double volume_of_stl(const std::string& bytes)
{
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, 4);
    EXPECT_EQ(bytes.size(), 84 + 50 * std::size_t(count));
    double sixfold = 0;
    for (std::uint32_t t = 0; t < count; ++t) {
        std::array<float, 12> numbers{};
        std::memcpy(numbers.data(), bytes.data() + 84 + 50 * std::size_t(t), sizeof numbers);
        const auto corner = [&](std::size_t k) { return Point(numbers[3 * k + 3], numbers[3 * k + 4], numbers[3 * k + 5]); };
        sixfold += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
    }
    return sixfold / 6.0;
}

TEST(TileAsStl, HasTheVolumeOfExactArithmetic)
{
    for (const Reference& r : references()) {
        const std::string bytes = test::written(mesh_of(make_solid(straight_tile(r))), "stl").text;
        EXPECT_NEAR(volume_of_stl(bytes), r.volume, 1e-5 * r.volume) << r.name;
    }
    EXPECT_NEAR(volume_of_stl(test::written(mesh_of(make_solid(quad_tile())), "stl").text), 500, 500e-5);
}

} // namespace
} // namespace druse
