#include "render/still.h"

#include "render/picture.h"
#include "render/png.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace druse {
namespace {

using namespace test;

Colour by_group(int group)
{
    return group == 0 ? Colour{204, 204, 204} : colour_from_hsv(0.618 * group, 0.62, 0.93);
}

Mesh in_colours(Mesh mesh)
{
    for (const Face f : mesh.faces()) mesh.set_group(f, static_cast<int>(f.index % 4));
    return mesh;
}

/// Compares with a picture of tests/data/render: at most 0.1 % of the pixels may differ by more than 5 steps of 255. On a
/// mismatch the new picture and the difference are kept in the temporary folder to look at.
void expect_like(const Image& image, const std::string& name)
{
    const std::string kept = testing::TempDir() + "druse_" + name;
    const std::string golden = std::string(DRUSE_TEST_DATA) + "/render/" + name + ".png";
    if (!std::filesystem::exists(golden)) {
        write_png(kept + ".png", image);
        FAIL() << golden << " is missing; the picture is in " << kept << ".png";
    }
    const Image expected = read_png(golden);
    ASSERT_EQ(image.width, expected.width);
    ASSERT_EQ(image.height, expected.height);
    Image difference(image.width, image.height);
    int differ = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Pixel a = image.pixels[i], b = expected.pixels[i];
        const int most = std::max(
            {std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue), std::abs(a.alpha - b.alpha)});
        const auto shown = static_cast<std::uint8_t>(most > 5 ? 255 : most * 20);
        difference.pixels[i] = {shown, shown, shown, 255};
        differ += most > 5;
    }
    if (differ * 1000 <= image.width * image.height) return;
    write_png(kept + ".png", image);
    write_png(kept + "_difference.png", difference);
    FAIL() << differ << " pixels differ: see " << kept << ".png and " << kept << "_difference.png";
}

TEST(Still, LooksAsItDid)
{
    StillOptions options;
    options.width = 200;
    options.height = 150;
    options.groups = options.edges = true;
    expect_like(draw_still(in_colours(dodecahedron()), by_group, options), "dodecahedron");
    options.view = *view_from_text("30,40");
    options.shading = Style::Shading::smooth;
    options.transparent = true;
    expect_like(draw_still(in_colours(torus(24, 12)), by_group, options), "torus");
    options = {};
    options.width = 150;
    options.height = 120;
    options.edges = options.parallel = true;
    expect_like(draw_still(open_tube(9), by_group, options), "tube");
}

TEST(Still, FillsTheFrameAsTheInterfaceSays)
{
    const Image image = draw_still(cube(), by_group, {});
    EXPECT_EQ(image.width, 1280);
    EXPECT_EQ(image.height, 800);
    EXPECT_TRUE(is_near(image.at(0, 0), {0x2e, 0x31, 0x36}, 1));
    EXPECT_TRUE(is_near(image.at(1279, 799), {0x1e, 0x20, 0x23}, 1));
    EXPECT_TRUE(is_shade_of(image.at(640, 300), {204, 204, 204}));
}

TEST(Still, ColoursGroupsOnlyWhenAsked)
{
    Mesh mesh = cube();
    for (const Face f : mesh.faces()) mesh.set_group(f, 1);
    StillOptions options;
    EXPECT_TRUE(is_shade_of(draw_still(mesh, by_group, options).at(640, 300), by_group(0)));
    options.groups = true;
    EXPECT_TRUE(is_shade_of(draw_still(mesh, by_group, options).at(640, 300), by_group(1)));
}

TEST(Still, TakesItsBackgroundAndTransparency)
{
    StillOptions options;
    options.background = Colour{1, 2, 3};
    EXPECT_TRUE(draw_still(cube(), by_group, options).at(0, 0) == (Pixel{1, 2, 3, 255}));
    options.transparent = true;
    EXPECT_EQ(draw_still(cube(), by_group, options).at(0, 0).alpha, 0);
}

TEST(Still, GivesTheSameFileWheneverItIsRepeated)
{
    StillOptions options;
    options.width = 320;
    options.height = 200;
    options.edges = true;
    const Mesh mesh = torus(40, 20);
    EXPECT_EQ(encode_png(draw_still(mesh, by_group, options)), encode_png(draw_still(mesh, by_group, options)));
}

TEST(Still, DrawsGraphsAndEmptyDocuments)
{
    StillOptions options;
    options.width = 100;
    options.height = 80;
    const Graph graph{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1}, {0, 2}, {0, 3}}};
    const Image lines = draw_still(graph, options), nothing = draw_still(Mesh(), by_group, options);
    EXPECT_FALSE(lines == nothing);
    EXPECT_TRUE(draw_still(Graph(), options) == nothing);
}

TEST(Still, LeavesTheCallersThreadToOtherContexts)
{
    Studio studio;
    const DrawLists lists(cube(), by_group);
    const Camera camera = camera_at(lists, "iso");
    const Image before = studio.picture(lists, camera);
    draw_still(torus(20, 10), by_group, {});
    EXPECT_TRUE(studio.picture(lists, camera_at(lists, "top")) != before);
    EXPECT_TRUE(studio.picture(lists, camera) == before);
}

} // namespace
} // namespace druse
