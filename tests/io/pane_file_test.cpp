// Pane files: the same bytes when they are written again, and one line for whatever is wrong with one.
#include "dlfl/errors.h"
#include "io/output.h"
#include "io/read.h"
#include "support/folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace druse {
namespace {

using test::Folder;
using PaneJson = nlohmann::ordered_json;

Pane crossed_pane()
{
    Pane pane(std::vector<Point2>{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, std::vector<std::vector<Point2>>{{{2, 2}, {2, 4}, {4, 2}}}, {0.0, {}});
    const PointId gone = pane.add({8, 8});
    pane.add({0.1 + 0.2, 1.0 / 3});
    pane.constrain_line(std::array{Point2(1, 6), Point2(9, 5)});
    pane.constrain_line(std::array{Point2(6, 3), Point2(7, 9), Point2(3, 9)});
    pane.remove(gone);
    pane.lock(std::array{PointId(1), PointId(8)});
    return pane;
}

std::string written(const Pane& pane)
{
    const Folder folder;
    const Mesh mesh;
    const GroupTable groups;
    OutputSet output;
    output.write({.mesh = mesh, .groups = groups, .pane = &pane}, folder / "x.pane.json");
    output.commit();
    return folder.read("x.pane.json");
}

Model read_text(const std::string& text)
{
    ByteSource source = ByteSource::memory(text, "x.pane.json");
    return read_model(source, "pane.json");
}

std::string complaint_about(const std::string& text)
{
    try {
        read_text(text);
    } catch (const InputError& e) {
        return e.what();
    }
    return "";
}

TEST(PaneFile, HoldsWhatItsPageSays)
{
    const PaneJson j = PaneJson::parse(written(crossed_pane()));
    std::vector<std::string> keys;
    for (const auto& [key, value] : j.items()) keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"format", "version", "points", "boundary", "constraints", "triangles", "ids", "segments", "locked", "crossings", "snap", "weld", "next"}));
    EXPECT_EQ(j["format"], "druse-pane");
    EXPECT_EQ(j["version"], 1);
    ASSERT_EQ(j["points"].size(), 14u); // 4 and 3 of loops, 1, 2 and 3 of lines, a crossing
    EXPECT_EQ(j["points"][7], PaneJson({0.30000000000000004, 0.3333333333333333}));
    EXPECT_EQ(j["ids"][7], 8); // point 7 was removed
    EXPECT_EQ(j["boundary"], PaneJson::parse("[[0,1,2,3],[4,5,6]]"));
    EXPECT_EQ(j["locked"], PaneJson({1, 7}));
    EXPECT_EQ(j["next"], PaneJson({15, 2}));
    EXPECT_EQ(j["snap"], 0.0);
    EXPECT_EQ(j["weld"], 1e-8);
    EXPECT_EQ(j["segments"].size(), 2u);
    EXPECT_EQ(j["segments"][0][0], 0);
    EXPECT_EQ(j["triangles"].size(), 21u); // 2·7 + 7 + 2·1 − 2
    for (const auto& t : j["triangles"]) EXPECT_LT(t[0], std::min(t[1], t[2]));
    EXPECT_TRUE(std::is_sorted(j["triangles"].begin(), j["triangles"].end()));
    EXPECT_TRUE(std::is_sorted(j["constraints"].begin(), j["constraints"].end()));
    for (const auto& c : j["constraints"]) EXPECT_LT(c[0], c[1]);
    EXPECT_EQ(j["constraints"].size(), 5u); // the first segment in 2 pieces, the second in 3
}

TEST(PaneFile, IsWrittenTheSameAgain)
{
    const Pane pane = crossed_pane();
    const std::string text = written(pane);
    const Model model = read_text(text);
    ASSERT_TRUE(model.pane);
    EXPECT_EQ(model.notes, std::vector<std::string>());
    EXPECT_TRUE(*model.pane == pane);
    EXPECT_EQ(written(*model.pane), text);
    EXPECT_EQ(written(*read_text(PaneJson::parse(text).dump(3)).pane), text); // however its lines are broken
    Pane far(std::vector<Point2>{{-0.0, -1e150}, {1e150, -0.0}, {1e22, 123456789012345678.0}});
    EXPECT_EQ(written(*read_text(written(far)).pane), written(far));
    EXPECT_NE(written(far).find("[-0.0,-1e+150]"), std::string::npos);
}

TEST(PaneFile, IsKnownByItsDoubleExtension)
{
    const Folder folder;
    const std::string text = written(crossed_pane());
    EXPECT_TRUE(read_model(folder.write("a.pane.json", text)).pane);
    EXPECT_TRUE(read_model(folder.write("A.PANE.JSON", text)).pane);
    EXPECT_THROW(read_model(folder.write("a.json", text)), InputError);
    EXPECT_THROW(read_model(folder.write("pane.json", text)), InputError); // a name without that extension
}

TEST(PaneFile, SaysWhichTrianglesAreMadeAnew)
{
    PaneJson j = PaneJson::parse(written(crossed_pane()));
    std::swap(j["triangles"][0], j["triangles"][1]);
    EXPECT_EQ(read_text(j.dump()).notes, std::vector<std::string>{"the triangles in the file were not those of its points and segments; they are made anew"});
    j.erase("triangles");
    j["constraints"].erase(0);
    EXPECT_EQ(read_text(j.dump()).notes.size(), 2u);
    j["remarks"] = {{"by", {"somebody", nullptr, true, {{1.5}}}}}; // what it does not know it passes over
    EXPECT_TRUE(read_text(j.dump()).pane);
}

TEST(PaneFile, IsRefusedWithLineAndPlace)
{
    const std::string good = written(crossed_pane());
    const auto lines_to = [&](std::string_view key) { return 1 + std::count(good.begin(), good.begin() + long(good.find(key)), '\n'); };
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const auto at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    };
    const auto expect = [&](const std::string& text, const std::string& key, const std::string& what) {
        EXPECT_EQ(complaint_about(text), key.empty() ? "x.pane.json" + what : fmt::format("x.pane.json:{}{}", lines_to("\"" + key + "\""), what));
    };
    expect(with("druse-pane", "druse-pain"), "format", ": format: expected \"druse-pane\"");
    expect(with("\"version\":1", "\"version\":2"), "version", ": version: expected version 1");
    expect(with("\"version\":1", "\"version\":1.0"), "version", ": version: expected version 1");
    expect(with("[[0,0],", "[[0,0,0],"), "points", ": points[0][2]: expected 2 items");
    expect(with("[[0,0],", "[[0],"), "points", ": points[0]: expected 2 items, found 1");
    expect(with("[[0,0],", "[0,[0,0],"), "points", ": points[0]: expected a list, found a number");
    expect(with("[[0,0],", "[[0,null],"), "points", ": points[0][1]: expected a number, found null");
    expect(with("[[0,0],", "[[0,\"0\"],"), "points", ": points[0][1]: expected a number, found a text");
    expect(with("[[0,0],", "[[0,[0]],"), "points", ": points[0][1]: expected a number, found a list");
    expect(with("[[0,0],", "[[0,1e999],"), "points", ": points[0][1]: a number that is too large");
    expect(with("[[0,0],", "[[0,NaN],"), "points", ": is no JSON from here on");
    expect(with("[[0,1,2,3],", "[[0,1,2,14],"), "boundary", ": boundary[0][3]: expected a whole number below 14, found 14");
    expect(with("[[0,1,2,3],", "[[0,1,2,-3],"), "boundary", ": boundary[0][3]: expected a whole number, 0 or more");
    expect(with("[[0,1,2,3],", "[[0,1,2,1.5],"), "boundary", ": boundary[0][3]: expected a whole number, 0 or more");
    expect(with("\"segments\":[[0,[", "\"segments\":[[[0],["), "segments", ": segments[0][0]: expected a whole number, found a list");
    expect(with("\"segments\":[[0,[", "\"segments\":[[0,0,["), "segments", ": segments[0][1]: expected a list, found a number");
    expect(with("\"segments\":[[0,[", "\"segments\":[[0,[99,"), "segments", ": segments[0][1][0]: expected a whole number below 14, found 99");
    expect(with("\"locked\":[1,", "\"locked\":[1,14,"), "locked", ": locked[1]: expected a whole number below 14, found 14");
    expect(with("\"next\":[15,2]", "\"next\":[15]"), "next", ": next: expected 2 numbers");
    expect(with("\"next\":[15,2]", "\"next\":[15,2,3]"), "next", ": next[2]: expected 2 items");
    expect(with("\"next\":[15,2]", "\"next\":[4294967294,2]"), "next", ": next: expected at most 16778112 for 14 points");
    expect(with("\"snap\":0", "\"snap\":0,\"snap\":0"), "snap", ": snap: is given twice");
    expect(with("\"snap\":0", "\"snap\":-1"), "snap", ": snap: range: snap -1 and weld 1e-08: expected 0 to 1e150, weld at least 1e-140");
    const std::string free_point = "[0.30000000000000004,0.3333333333333333]";
    const char* const near = ": coincides: another point is nearer than weld, or it is on the boundary without being of it";
    expect(with("[[0,0],", "[[1e200,0],"), "points", ": points[0]: range: coordinates go to 1e150");
    expect(with("[2,2]", "[12,2]"), "boundary", ": boundary[1]: boundary-crosses: the line from point 1 to point 2 would cross that from point 4 to point 6");
    expect(with(free_point, "[30,0.25]"), "points", ": points[7]: outside: (30, 0.25) is outside the boundary");
    expect(with(free_point, "[2.5,2.5]"), "points", ": points[7]: outside: (2.5, 2.5) is outside the boundary"); // in the hole
    expect(with(free_point, "[5,0]"), "points", std::string(": points[7]") + near);
    expect(with(free_point, "[9,5]"), "points", std::string(": points[9]") + near);
    expect(with("\"ids\":[0,1,", "\"ids\":[1,0,"), "ids", ": ids[1]: no-such-point: ids ascend");
    expect(with("\"ids\":[0,1,", "\"ids\":[0,"), "ids", ": ids: no-such-point: 13 ids of 14 points");
    expect(with("\"next\":[15,2]", "\"next\":[14,2]"), "next", ": next: no-such-point: point 14 is there already");
    expect(with("\"segments\":[[0,[", "\"segments\":[[1,["), "segments", ": segments[1]: no-such-segment: segment 1 is out of order, or has no length");
    expect(with("\"crossings\":[13]", "\"crossings\":[3]"), "crossings", ": crossings[0]: boundary-touches: point number 3 is of the boundary, not a crossing");
    expect(with("\"weld\":1e-08", "\"weld\":0"), "weld", ": weld: range: snap 0 and weld 0: expected 0 to 1e150, weld at least 1e-140");
    expect(with("\"locked\"", "\"looked\""), "next", ": \"locked\" is missing");
    expect("[1]", "", ":1: expected an object of JSON");
    expect("{\"points\":" + std::string(100000, '['), "", ":1: points[0][0]: expected a number, found a list");
    expect("{\"other\":" + std::string(100000, '['), "", ":1: lists in lists, more than 64 deep");
    for (std::size_t end = 0; end < good.size() - 2; end += 7) {
        const std::string said = complaint_about(good.substr(0, end));
        EXPECT_FALSE(said.empty()) << end;
        EXPECT_EQ(said.find('\n'), std::string::npos);
    }
}

TEST(PaneFile, EndsInOneLineHoweverItIsChanged)
{
    const std::string good = written(crossed_pane());
    std::uint32_t random = 1;
    const auto next = [&] { return (random = random * 1664525u + 1013904223u) >> 8; };
    int read = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string text = good;
        for (std::uint32_t k = 0; k <= next() % 3; ++k) {
            static constexpr char pieces[] = "0123456789.-e[],{}\":";
            text[next() % text.size()] = pieces[next() % (sizeof pieces - 1)];
        }
        try {
            read_text(text);
            ++read;
        } catch (const InputError& e) {
            EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
        }
    }
    EXPECT_GT(read, 0);
}

} // namespace
} // namespace druse
