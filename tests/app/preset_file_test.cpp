#include "app/preset_file.h"

#include "app/registry.h"
#include "dlfl/errors.h"
#include "support/folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace druse {
namespace {

class Presets : public testing::Test {
protected:
    Presets() : file(folder / "settings/presets") {}
    std::string text() const { return folder.read("settings/presets"); }
    static const Operator& op(const char* name) { return all_operators().get(name); }

    const test::Folder folder;
    const std::filesystem::path file; // not there yet, nor is its folder
};

TEST_F(Presets, AreKeptFromOneDayToTheNext)
{
    {
        PresetFile presets(file);
        EXPECT_TRUE(presets.of(op("extrude.cubical")).empty());
        presets.store(op("extrude.cubical"), {"spike", "angle=60 heights=3"});
        presets.store(op("extrude.cubical"), {"low and wide", "angle=120"});
        presets.store(op("extrude.octahedral"), {"spike", "heights=4"});
        presets.store(op("extrude.cubical"), {"spike", "angle=61"});
    }
    EXPECT_EQ(text(), "extrude.cubical preset=spike angle=61\nextrude.cubical preset=\"low and wide\" angle=120\n"
                      "extrude.octahedral preset=spike heights=4\n");
    PresetFile presets(file);
    const auto of = presets.of(op("extrude.cubical"));
    ASSERT_EQ(of.size(), 2u);
    EXPECT_EQ(of[1].name, "low and wide");
    EXPECT_EQ(of[1].arguments, "angle=120");
    presets.forget(op("extrude.cubical"), "spike");
    presets.forget(op("extrude.cubical"), "spike"); // gone already
    EXPECT_EQ(PresetFile(file).of(op("extrude.cubical")).size(), 1u);
    EXPECT_EQ(PresetFile(file).of(op("extrude.octahedral")).size(), 1u);
}

TEST_F(Presets, LinesThatAreNotUnderstoodStayAsTheyAre)
{
    std::filesystem::create_directories(file.parent_path());
    const std::string foreign = "# mine\nextrude.cubical preset=\"open\n\nextrude.cubical angle=3\nfuture.operator preset=a b=c\n";
    std::ofstream(file) << foreign;
    PresetFile presets(file);
    EXPECT_TRUE(presets.of(op("extrude.cubical")).empty());
    presets.store(op("extrude.cubical"), {"plain", ""});
    EXPECT_EQ(text(), foreign + "extrude.cubical preset=plain\n");
}

TEST_F(Presets, StandForTheirValuesInACommand)
{
    PresetFile presets;
    presets.store(op("extrude.cubical"), {"spike", "angle=60 heights=3"});
    const auto expanded = [&](const char* command) { return presets.expand(all_operators(), command); };
    EXPECT_EQ(expanded("extrude.cubical faces=all preset=spike"), "extrude.cubical faces=all angle=60 heights=3");
    EXPECT_EQ(expanded("cubical angle=70 preset=spike"), "cubical angle=70 heights=3");
    for (const char* other : {"extrude.octahedral preset=spike", "extrude.cubical preset=none", "extrude.cubical faces=1", "no.such preset=spike", "# a comment", "", "a \"b"})
        EXPECT_EQ(expanded(other), other);
}

TEST_F(Presets, NeedANameOfTheirOwn)
{
    PresetFile presets;
    EXPECT_THROW(presets.store(op("extrude.cubical"), {"", "angle=60"}), CommandError);
    Operator shipped = op("extrude.cubical");
    shipped.presets.push_back({"regular", ""});
    EXPECT_THROW(presets.store(shipped, {"regular", "angle=60"}), CommandError);
    EXPECT_TRUE(presets.of(shipped).empty());
}

} // namespace
} // namespace druse
