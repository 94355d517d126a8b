// How a tile is drawn: the picture behind it and the colours of the tiling, by commands and in files.
#include "app/documents.h"
#include "app/registry.h"
#include "app/save.h"
#include "io/output.h"
#include "support/folder.h"
#include "tile/tile_look.h"

#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>
#include <string>

namespace druse {
namespace {

using namespace test;

TileLook look_in(const Document& document) { return look(std::get<LayeredTile>(*document.scene().source).design()); }

std::string text_of(const std::filesystem::path& file)
{
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

void save(const Document& document, const std::filesystem::path& file)
{
    OutputSet output;
    write_document(document, output, file);
    output.commit();
}

TEST(TileLook, LaysAPictureBehindTheTileAndTakesItAway)
{
    Document document(all_operators());
    document.apply("tile.new type=IH41 size=20");
    EXPECT_EQ(complaint(document, "tile.trace opacity=0.4"), "tile.trace: image= is needed: the tile has no picture yet");
    Progress progress;
    document.apply("tile.trace image=bird.png", progress, "/pictures");
    ASSERT_TRUE(look_in(document).trace);
    EXPECT_EQ(look_in(document).trace->image, "/pictures/bird.png");
    EXPECT_EQ(look_in(document).trace->place, (std::array<double, 6>{20, 0, 0, 0, 20, 0})) << "as wide as the square";
    document.apply("tile.trace place=10,0,5,0,10,5 opacity=0.25");
    EXPECT_EQ(look_in(document).trace->opacity, 0.25);
    document.apply("tile.frame size=40");
    EXPECT_EQ(look_in(document).trace->place, (std::array<double, 6>{20, 0, 10, 0, 20, 10})) << "it grows along";
    EXPECT_EQ(complaint(document, "tile.trace place=1,2,0,2,4,0"), "tile.trace: the picture would have no area");
    document.apply("tile.trace on=false");
    EXPECT_FALSE(look_in(document).trace);
    document.apply("document.undo");
    EXPECT_TRUE(look_in(document).trace);
}

TEST(TileLook, IsInTheFileWithPicturesNamedFromThere)
{
    const Folder folder;
    Document document(all_operators());
    Progress progress;
    document.apply("tile.new type=IH79 size=20");
    document.apply("tile.trace image=bird.png place=1,0,0,0,1,0", progress, std::filesystem::path(folder / "a.tile").parent_path());
    document.apply("tile.colors colors=#102030,#405060,#708090");
    save(document, folder / "a.tile");
    const auto json = nlohmann::json::parse(text_of(folder / "a.tile"));
    EXPECT_EQ(json["view"]["trace"]["image"], "bird.png");
    EXPECT_EQ(json["view"]["trace"]["place"], (std::vector<double>{1, 0, 0, 0, 1, 0}));
    EXPECT_EQ(json["view"]["colors"], (std::vector<std::string>{"#102030", "#405060", "#708090"}));

    Document again(all_operators());
    again.open(folder / "a.tile", progress);
    EXPECT_EQ(look_in(again), look_in(document));
    save(again, folder / "b.tile");
    EXPECT_EQ(text_of(folder / "a.tile"), text_of(folder / "b.tile"));
    save(again, folder / "a.svg");
    EXPECT_NE(text_of(folder / "a.svg").find("#102030"), std::string::npos);
}

TEST(TileLook, RefusesFilesThatSayItWrongly)
{
    const Folder folder;
    const auto complaint_about = [&](const std::string& view) {
        std::ofstream(folder / "wrong.tile") << "{ \"format\": \"druse-tile\", \"version\": 1, \"kind\": \"layered\", \"type\": \"IH41\", \"size\": 1,\n\"view\": " + view + "}";
        Document document(all_operators());
        Progress progress;
        try {
            document.open(folder / "wrong.tile", progress);
        } catch (const InputError& e) {
            const std::string text = e.what();
            return text.substr(text.find("wrong.tile") + 10);
        }
        return std::string();
    };
    EXPECT_EQ(complaint_about("3"), ":2: view: expected an object");
    EXPECT_EQ(complaint_about(R"({"trace": {"opacity": 1}})"), ":2: view.trace.image: expected a name of a file");
    EXPECT_EQ(complaint_about(R"({"trace": {"image": "a.png", "opacity": 2}})"), ":2: view.trace.opacity: expected 0 to 1");
    EXPECT_EQ(complaint_about(R"({"trace": {"image": "a.png", "place": [0,0,0,0,0,0]}})"), ":2: view.trace.place: the picture would have no area");
    EXPECT_EQ(complaint_about(R"({"colors": ["#102030", "#405060", "red"]})"), ":2: view.colors[2]: expected a colour as \"#cc3333\"");
    EXPECT_EQ(complaint_about(R"({"colors": ["#102030", "#405060", "#708090"], "more": 1})"), "");
}

} // namespace
} // namespace druse
