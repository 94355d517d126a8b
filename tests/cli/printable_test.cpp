// What Druse writes, as programs that others wrote see it.

#include "cli/program.h"
#include "support/folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace druse {
namespace {

using namespace test;
using Json = nlohmann::json;

/// The number behind a label in what admesh prints.
double number_after(const std::string& text, const std::string& label)
{
    const std::size_t at = text.find(label), colon = text.find_first_not_of(' ', at == text.npos ? at : at + label.size());
    if (colon == text.npos || text[colon] != ':') {
        ADD_FAILURE() << "no '" << label << "' in\n" << text;
        return -1;
    }
    return std::stod(text.substr(colon + 1));
}

/// admesh answers 0 for broken files too, so its words are what counts.
void expect_good_stl(const Folder& folder, const std::string& file, int parts, double volume)
{
    if (!is_installed("admesh")) GTEST_SKIP() << "admesh is not installed";
    const Ended ended = run_program("admesh", {file}, folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(number_after(ended.out, "Total disconnected facets"), 0);
    for (const char* label : {"Facets removed", "Facets added", "Facets reversed", "Degenerate facets", "Edges fixed", "Backwards edges"})
        EXPECT_EQ(number_after(ended.out, label), 0) << label;
    EXPECT_EQ(number_after(ended.out, "Number of parts"), parts);
    EXPECT_NEAR(number_after(ended.out, "Volume"), volume, 1e-4 * volume);
}

Json facts_of(const Folder& folder, const std::string& file) { return Json::parse(druse({"info", file, "--json"}, folder.path()).out); }

double volume_of(const Folder& folder, const std::string& file) { return facts_of(folder, file)["volume"]; }

TEST(Printable, IsTheCubeWhoseSecondGroupGrew)
{
    const Folder folder;
    const Ended ended = druse({"apply", std::string(DRUSE_MODELS) + "/colored_cube.obj", "-c", "extrude.dodecahedral faces=group:2 iterations=2", "-o",
                               "out.stl", "-o", "out.obj"},
                              folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    EXPECT_EQ(folder.listing(), "out.mtl out.obj out.stl");

    // Group 2 is one square: each iteration adds 12 vertices, 20 edges and 8 faces. Groups 1 and 3 (1 + 4 faces) are as they were, the others
    // are new: G = 3, so the first iteration gives 4…12 (4 is the top, which the second replaces), the second 13 (the top) and 14…21.
    const Json facts = facts_of(folder, "out.obj");
    EXPECT_EQ(facts["vertices"], 32);
    EXPECT_EQ(facts["edges"], 52);
    EXPECT_EQ(facts["faces"], 22);
    EXPECT_EQ(facts["watertight"], true);
    std::map<int, int> sizes, expected{{1, 1}, {3, 4}};
    for (int id = 5; id <= 21; ++id) expected[id] = 1;
    for (const auto& [id, group] : facts["groups"].items()) sizes[std::stoi(id)] = group["faces"];
    EXPECT_EQ(sizes, expected);

    expect_good_stl(folder, "out.stl", 1, volume_of(folder, "out.obj"));
    if (is_installed("assimp")) {
        for (const char* file : {"out.stl", "out.obj"}) {
            const Ended assimp = run_program("assimp", {"info", file}, folder.path());
            EXPECT_EQ(assimp.status, 0) << assimp.out;
        }
    }
}

TEST(Printable, IsEveryExtrusionOfASolid)
{
    const Folder folder;
    for (const char* pattern : {"tetrahedral", "cubical", "octahedral", "dodecahedral", "icosahedral", "cuboctahedral", "rhombicuboctahedral"}) {
        SCOPED_TRACE(pattern);
        ASSERT_EQ(druse({"apply", "-c", "make.dodecahedron", "-c", std::string("extrude.") + pattern + " faces=0,5", "-o", "a.stl", "-o", "a.obj"}, folder.path()).status, 0);
        expect_good_stl(folder, "a.stl", 1, volume_of(folder, "a.obj"));
    }
}

TEST(Printable, HasAsManyPartsAsComponents)
{
    const Folder folder;
    ASSERT_EQ(druse({"apply", "-c", "make.cube", "-c", "mesh.transform move=5,0,0", "-c", "make.torus", "-o", "a.stl", "-o", "a.obj"}, folder.path()).status, 0);
    expect_good_stl(folder, "a.stl", 2, volume_of(folder, "a.obj"));
}

struct RindState {
    const char* name;
    std::vector<std::string> commands;
    int parts; // of the solid; admesh counts what hangs together by sides
};

TEST(Printable, IsARindInEveryState)
{
    const Folder folder;
    const RindState states[] = {
        {"a crust", {"make.dodecahedron", "rind.crust thickness=0.2"}, 2},
        {"punched apart", {"make.dodecahedron", "rind.crust thickness=0.2", "rind.punch faces=0,7"}, 1},
        {"punched beside each other", {"make.cube", "rind.crust thickness=0.2", "rind.punch faces=0-2"}, 1},
        {"peeled", {"make.icosahedron", "rind.crust thickness=0.2 uniform=true", "rind.peel faces=0-4,9"}, 1},
        {"peeled to a plate", {"make.cube", "rind.crust", "rind.peel faces=0-4"}, 1},
        {"with columns", {"make.octahedron", "rind.crust", "rind.peel faces=0,2,5,7"}, 1},
        {"with columns cut", {"make.octahedron", "rind.crust", "rind.peel faces=0,2,5,7 pinch=cut"}, 4},
        {"a torus with columns", {"make.torus nu=24 nv=12", "rind.crust thickness=0.1", "rind.peel faces=0,13,26-30"}, 1},
        {"nested", {"make.dodecahedron", "rind.crust thickness=0.2", "rind.peel faces=0,3,7", "rind.nest copies=3 angle=20"}, 4},
        {"piped", {"make.cube", "make.cube", "mesh.transform vertices=8-15 move=0,0,3", "topology.pipe from=5 to=6"}, 1},
        {"handled", {"make.cube", "mesh.transform scale=2", "topology.handle from=0 to=5 segments=6 scale=0.4"}, 1},
        {"two cubes at an edge", {"make.cube", "make.cube", "mesh.transform vertices=8-15 move=1,1,0"}, 2},
    };
    for (const RindState& state : states) {
        SCOPED_TRACE(state.name);
        std::vector<std::string> arguments{"apply"};
        for (const std::string& command : state.commands) arguments.insert(arguments.end(), {"-c", command});
        arguments.insert(arguments.end(), {"-o", "a.stl", "-o", "a.obj", "-o", "a.ply", "-o", "a.dlfl"});
        const Ended ended = druse(arguments, folder.path());
        ASSERT_EQ(ended.status, 0) << ended.err;
        const Json facts = facts_of(folder, "a.dlfl");
        expect_good_stl(folder, "a.stl", state.parts, facts["volume"]);
        // Formats with index lists hold the same surface: what is read again is closed, and has not fallen apart.
        for (const char* file : {"a.obj", "a.ply"}) {
            const Json again = facts_of(folder, file);
            EXPECT_EQ(again["watertight"], true) << file;
            EXPECT_EQ(again["components"], facts["components"]) << file;
            EXPECT_EQ(again["euler"], facts["euler"]) << file;
            if (!is_installed("assimp")) continue;
            const Ended assimp = run_program("assimp", {"info", file}, folder.path());
            EXPECT_EQ(assimp.status, 0) << assimp.out;
            EXPECT_EQ(assimp.out.find("ERROR"), assimp.out.npos) << assimp.out;
        }
    }
}

TEST(Printable, IsTheTileOfTheExample)
{
    const Folder folder;
    const Ended ended = druse({"apply",
                               "-c", "tile.new type=IH79 size=20", "-c", "tile.edge path=0 points=0.333,0.125,0.667,-0.125", "-c", "tile.edge path=1 points=0.25,0.1", "-c", "tile.point_add at=10,4",
                               "-c", "tile.stack mode=shift offset=10,10", "-c", "tile.extrude thickness=5", "-c", "tile.height points=i0 set=2", "-c", "tile.height points=m1 add=0.5", "-c", "tile.solid",
                               "-o", "quad.stl", "-o", "quad.tile", "-o", "quad.obj"},
                              folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    const Json solid = facts_of(folder, "quad.obj");
    EXPECT_EQ(solid["vertices"], 27);
    EXPECT_EQ(solid["edges"], 61);
    EXPECT_EQ(solid["faces"], 36);
    EXPECT_NEAR(double(solid["volume"]), 500, 1e-6);
    const Json tile = facts_of(folder, "quad.tile");
    EXPECT_EQ(tile["type"], "IH79");
    EXPECT_EQ(tile["vertices"], 27); // of the solid that it makes
    EXPECT_EQ(tile["faces"], 36);
    EXPECT_EQ(tile["boundary_edges"], 0);
    EXPECT_EQ(tile["orbits"], 6);
    EXPECT_EQ(tile["aspects"], 4);
    EXPECT_NEAR(double(tile["area"]), 100, 1e-9);
    EXPECT_NEAR(double(tile["volume_expected"]), 500, 1e-9);
    EXPECT_NEAR(double(tile["min_thickness"]), 3.115819, 1e-6);
    expect_good_stl(folder, "quad.stl", 1, 500);
}

TEST(Printable, AreTheTilesOfTheGallery)
{
    const Folder folder;
    for (const auto& [name, tiles] : std::map<std::string, int>{{"bird", 4}, {"fish", 16}, {"whale", 24}}) {
        SCOPED_TRACE(name);
        Ended ended = druse({"apply", std::string(DRUSE_MODELS) + "/" + name + ".tile", "-c", "tile.solid", "-o", "one.stl"}, folder.path());
        ASSERT_EQ(ended.status, 0) << ended.err;
        const double one = facts_of(folder, std::string(DRUSE_MODELS) + "/" + name + ".tile")["volume_expected"];
        expect_good_stl(folder, "one.stl", 1, one);
        ended = druse({"apply", std::string(DRUSE_MODELS) + "/" + name + ".tile", "-c", "tile.assemble nx=2 ny=2 layers=3 clearance=0.3", "-o", "all.stl"}, folder.path());
        ASSERT_EQ(ended.status, 0) << ended.err;
        expect_good_stl(folder, "all.stl", 3 * tiles, volume_of(folder, "all.stl"));
    }
}

} // namespace
} // namespace druse
