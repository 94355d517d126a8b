#include "cli/program.h"
#include "render/png.h"
#include "support/folder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace druse {
namespace {

using namespace test;
using Json = nlohmann::json;

void expect_error(const std::vector<std::string>& arguments, const std::string& line)
{
    const Ended ended = druse(arguments);
    EXPECT_EQ(ended.status, 2);
    EXPECT_EQ(ended.err, "druse: " + line + "\n");
    EXPECT_EQ(ended.out, "");
}

TEST(Info, PrintsTheFactsOfAModel)
{
    const Ended json = druse({"info", models + "/colored_cube.obj", "--json"});
    EXPECT_EQ(json.status, 0);
    EXPECT_EQ(json.err, "");
    const Json facts = Json::parse(json.out);
    EXPECT_EQ(facts["faces"], 6);
    EXPECT_EQ(facts["watertight"], true);
    EXPECT_EQ(facts["groups"].size(), 3u);
    EXPECT_NEAR(facts["volume"], 8.0, 1e-12); // a cube of side 2

    const Ended text = druse({"info", models + "/colored_cube.obj"});
    EXPECT_NE(text.out.find("\nvolume                 8 mm³\n"), std::string::npos) << text.out;
}

TEST(Info, ReadsStandardInputAndScripts)
{
    const Folder folder;
    folder.write("s.druse", "make.torus\nselect.faces faces=0,1\n");
    const Json facts = Json::parse(druse({"info", "s.druse", "--json"}, folder.path()).out);
    EXPECT_EQ(facts["genus"], 1);
    EXPECT_EQ(facts["selection"]["faces"], Json({0, 1}));
    const Json piped = Json::parse(druse({"info", "-", "--format", "druse", "--json"}, folder.path(), "make.cube\n").out);
    EXPECT_EQ(piped["faces"], 6);
}

TEST(Info, LooksForSelfIntersectionsWhenAsked)
{
    const Folder folder;
    folder.write("s.druse", "make.cube\nmesh.transform move=0.5,0.375,0.25\nmake.cube\n");
    EXPECT_TRUE(Json::parse(druse({"info", "s.druse", "--json"}, folder.path()).out)["self_intersections"].is_null());
    const Json crossed = Json::parse(druse({"info", "s.druse", "--json", "--check"}, folder.path()).out);
    EXPECT_EQ(crossed["components"], 2);
    EXPECT_GT(crossed["self_intersections"], 0);
    EXPECT_EQ(Json::parse(druse({"info", models + "/cube.obj", "--json", "--check"}).out)["self_intersections"], 0);
    EXPECT_NE(druse({"info", models + "/cube.obj", "--check"}).out.find("\nself-intersections     none\n"), std::string::npos);
}

TEST(Info, SaysWhatIsWrong)
{
    expect_error({"info"}, "info: FILE is required");
    expect_error({"info", "none.obj"}, "none.obj: no such file");
    expect_error({"info", models}, models + ": is a folder, not a file");
}

TEST(Ops, ListsOperatorsInThreeForms)
{
    EXPECT_NE(druse({"ops"}).out.find("\n  extrude.dodecahedral "), std::string::npos);
    const Json all = Json::parse(druse({"ops", "--json"}).out);
    EXPECT_GT(all.size(), 50u);
    EXPECT_EQ(Json::parse(druse({"ops", "dodecahedral", "--json"}).out)["name"], "extrude.dodecahedral");
    EXPECT_TRUE(druse({"ops", "--markdown"}).out.starts_with("# Operators\n"));
    expect_error({"ops", "--json", "--markdown"}, "ops: --json and --markdown: expected one of the two");
    expect_error({"ops", "make.cub"}, "unknown operator 'make.cub'; did you mean 'make.cube'?");
}

TEST(Render, DrawsAPicture)
{
    const Folder folder;
    const Ended ended = druse({"render", models + "/colored_cube.obj", "-o", "a.png", "--size", "64x48", "--view", "-30,20", "--edges", "--groups"}, folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err; // OSMesa is a package that the tests need
    const std::string png = folder.read("a.png");
    ASSERT_GT(png.size(), 24u);
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(static_cast<unsigned char>(png[19]), 64); // the width is the last byte of a big-endian number
    EXPECT_EQ(static_cast<unsigned char>(png[23]), 48);
    const Ended piped = druse({"render", models + "/colored_cube.obj", "-o", "-", "--size", "64x48", "--view", "-30,20", "--edges", "--groups"});
    EXPECT_EQ(piped.out, png);
}

/// By how much the colours of two pictures of one size differ, on average: 255 from black to white.
double difference(const Image& a, const Image& b)
{
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        sum += std::abs(a.pixels[i].red - b.pixels[i].red) + std::abs(a.pixels[i].green - b.pixels[i].green) + std::abs(a.pixels[i].blue - b.pixels[i].blue);
    return sum / (3.0 * double(a.pixels.size()));
}

TEST(Render, DrawsTheSurfaceThatSubdivisionGoesTo)
{
    const Folder folder;
    const std::vector<std::string> as{"-o", "a.png", "--size", "96x72", "--view", "-30,20", "--groups"};
    const auto picture = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), as.begin(), as.end());
        const Ended ended = druse(arguments, folder.path());
        EXPECT_EQ(ended.status, 0) << ended.err;
        return read_png((folder.path() / "a.png").string());
    };
    const Image smooth = picture({"render", models + "/colored_cube.obj", "--smooth"});
    // As the operator makes it, at the level that the preview chooses for a cube. That knows no normals of the surface, only of its faces.
    druse({"apply", models + "/colored_cube.obj", "-c", "remesh.subdivide_limit level=5", "-o", "limit.obj"}, folder.path());
    EXPECT_LT(difference(smooth, picture({"render", "limit.obj", "--shading", "smooth"})), 1.0);
    EXPECT_GT(difference(smooth, picture({"render", models + "/colored_cube.obj", "--shading", "smooth"})), 10.0);

    const std::string open = folder.write("open.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n").string();
    expect_error({"render", open, "-o", "a.png", "--smooth"}, "render: --smooth: the model is open: 3 boundary edges");
}

TEST(Render, DrawsTheFlatTilingOfATile)
{
    const Folder folder;
    // A tiling by squares of edge 10: 3 by 3 places, 30 mm that fill 96 of 100 pixels.
    ASSERT_EQ(druse({"apply", "-c", "tile.new type=IH41 size=10", "-c", "tile.colors colors=#ff0000,#00ff00,#0000ff", "-o", "a.tile"}, folder.path()).status, 0);
    const Ended ended = druse({"render", "a.tile", "--flat", "-o", "a.png", "--size", "200x100", "--background", "#ffff00"}, folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err;
    const Image image = read_png((folder.path() / "a.png").string());
    ASSERT_EQ(image.width, 200);
    ASSERT_EQ(image.height, 100);
    EXPECT_EQ(image.at(30, 50), (Pixel{255, 255, 0, 255})); // beside them
    EXPECT_EQ(image.at(100, 0), (Pixel{255, 255, 0, 255}));
    EXPECT_EQ(image.at(84, 50), (Pixel{128, 0, 0, 255})); // half of it is the line between two
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            const Pixel p = image.at(68 + 32 * column, 18 + 32 * row);
            EXPECT_EQ(p.red + p.green + p.blue, 255);
            EXPECT_FALSE(p == image.at(68 + 32 * ((column + 1) % 2), 18 + 32 * row)) << "neighbours differ";
        }
    expect_error({"render", models + "/colored_cube.obj", "--flat", "-o", "a.png"}, "the document holds no tile; tile.new makes one");
    expect_error({"render", models + "/bird.tile", "--flat", "--edges", "-o", "a.png"}, "render: --flat excludes --edges");
}

TEST(Render, DrawsAGraph)
{
    const Folder folder;
    const Ended ended = druse({"render", models + "/body_centred_cell.obj", "-o", "a.png", "--size", "64x48"}, folder.path());
    ASSERT_EQ(ended.status, 0) << ended.err; // OSMesa is a package that the tests need
    EXPECT_EQ(folder.listing(), "a.png");
}

TEST(Render, SaysWhatIsWrong)
{
    const std::string cube = models + "/cube.obj";
    expect_error({"render", cube}, "render: --output is required");
    expect_error({"render", cube, "-o", "a.jpg"}, "render: -o a.jpg: expected a name that ends in .png");
    expect_error({"render", cube, "-o", "a.png", "--size", "0x5"}, "render: --size 0x5: expected WxH, 1 to 8192 pixels each and at most 33554432 in all");
    expect_error({"render", cube, "-o", "a.png", "--view", "up"},
                 "render: --view up: expected iso, front, back, left, right, top, bottom or AZ,EL with EL from -90 to 90");
    expect_error({"render", cube, "-o", "a.png", "--background", "red"}, "render: --background red: expected a colour #rrggbb");
    expect_error({"render", cube, "-o", "a.png", "--background", "#ffffff", "--transparent"}, "render: --transparent and --background: expected one of the two");
    expect_error({"render", cube, "-o", "a.png", "--shading", "phong"}, "render: --shading phong: expected flat or smooth");
    expect_error({"render", cube, "-o", "a.png", "--size", "8x8", "--size", "9x9"}, "render: --size is given more than once");
    expect_error({"render", cube, "-o"}, "render: --output needs a value");
    expect_error({"render", "none.obj", "-o", "A.PNG"}, "none.obj: no such file");
}

TEST(Program, HelpsAndTellsItsVersion)
{
    EXPECT_TRUE(druse({"--version"}).out.starts_with("druse "));
    for (const char* command : {"apply", "info", "render", "ops"}) {
        const Ended help = druse({command, "--help"});
        EXPECT_EQ(help.status, 0);
        EXPECT_NE(help.out.find(std::string("Usage: druse ") + command), std::string::npos) << help.out;
        EXPECT_NE(druse({"--help"}).out.find(command), std::string::npos);
    }
}

TEST(Program, SaysWhatIsWrongWithItsUse)
{
    expect_error({"--bogus"}, "unknown option '--bogus'");
    expect_error({"--ui-scale", "3"}, "--ui-scale 3: expected 1, 1.25, 1.5 or 2");
    expect_error({"info", "x.obj", "--format", "obj"}, "info: --format obj: goes with -, but no standard stream is read or written");
    expect_error({"apply", "x.obj", "-o=y.obj"}, "'-o=y.obj': expected '-o y.obj'");
    expect_error({"frob", "x"}, "unknown command 'frob'; expected apply, info, render or ops");
    expect_error({"aply", "x"}, "unknown command 'aply'; did you mean 'apply'?");
    expect_error({"x.obj", "info", "y.obj"}, "expected everything behind 'info'");
}

TEST(Program, SaysThatItNeedsADisplayForItsWindow)
{
    const Ended ended = run_program("env", {"-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", DRUSE_PROGRAM, models + "/cube.obj"});
    EXPECT_EQ(ended.status, 3);
    EXPECT_TRUE(ended.err.starts_with("druse: ")) << ended.err;
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 1) << ended.err;
}

} // namespace
} // namespace druse
