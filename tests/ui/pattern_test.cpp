#include "ui/pattern.h"
#include "ui/pictures.h"
#include "ui/solid_gallery.h"

#include "app/registry.h"
#include "ops/solid.h"
#include "support/mesh_checks.h"

#include <gtest/gtest.h>

#include <set>

namespace druse::ui {
namespace {

Counts pattern(const char* name)
{
    const auto mesh = pattern_of(all_operators().get(name));
    return mesh ? mesh->counts() : Counts();
}

TEST(Patterns, TheSevenExtrusionsAreKnownByTheirSolids)
{
    EXPECT_EQ(pattern("extrude.tetrahedral"), (Counts{4, 6, 4}));
    EXPECT_EQ(pattern("extrude.cubical"), (Counts{8, 12, 6}));
    EXPECT_EQ(pattern("extrude.octahedral"), (Counts{6, 12, 8}));
    EXPECT_EQ(pattern("extrude.dodecahedral"), (Counts{20, 30, 12}));
    EXPECT_EQ(pattern("extrude.icosahedral"), (Counts{12, 30, 20}));
    EXPECT_EQ(pattern("extrude.cuboctahedral"), (Counts{12, 24, 14}));
    EXPECT_EQ(pattern("extrude.rhombicuboctahedral"), (Counts{24, 48, 26}));
}

TEST(Patterns, EveryExtrusionHasOneAndNothingElseHas)
{
    for (const Operator& op : all_operators().operators()) EXPECT_EQ(pattern_of(op).has_value(), op.family() == "extrude") << op.name;
}

TEST(Patterns, ThatOfASolidIsTheSolid)
{
    const Operator& op = all_operators().get("extrude.solid");
    EXPECT_EQ(pattern_of(op, "snub_cube")->counts(), (Counts{24, 60, 38}));
    EXPECT_FALSE(pattern_of(op, "solid.obj"));
    EXPECT_FALSE(pattern_of(op, "snub_cub"));
}

TEST(Gallery, ShowsEveryKindOfSolidOnce)
{
    const auto names = gallery_solids();
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    for (const std::string& name : names) EXPECT_EQ(euler_characteristic(make_solid(name, 1)), 2) << name;
    for (const std::string& kind : solid_names()) {
        const std::string start = kind.substr(0, kind.find("N"));
        EXPECT_TRUE(std::any_of(names.begin(), names.end(), [&](const std::string& n) { return n.starts_with(start); })) << kind;
    }
}

TEST(Pictures, AShrunkPixelIsTheMeanOfThoseItStandsFor)
{
    Image image(2, 4);
    image.pixels.assign(8, {0, 0, 0, 0});
    image.at(0, 0) = {200, 100, 0, 255};
    image.at(1, 1) = {100, 0, 0, 255};
    const Image small = shrunk(image, 2);
    ASSERT_EQ(small.width, 1);
    ASSERT_EQ(small.height, 2);
    EXPECT_EQ(small.at(0, 0), (Pixel{150, 50, 0, 128})); // what is not there has no colour
    EXPECT_EQ(small.at(0, 1), (Pixel{0, 0, 0, 0}));
}

} // namespace
} // namespace druse::ui
