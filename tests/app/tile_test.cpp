// Layered tiles as a document keeps them: through commands, refusals, undo, files and facts.
#include "app/documents.h"
#include "app/info.h"
#include "app/registry.h"
#include "app/save.h"
#include "io/output.h"
#include "support/folder.h"
#include "support/mesh_checks.h"
#include "tile/layered_facts.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace druse {
namespace {

using namespace test;
using FactsJson = nlohmann::json;

const LayeredTile& tile_in(const Document& document) { return std::get<LayeredTile>(*document.scene().source); }

Document with_tile(std::initializer_list<const char*> commands)
{
    Document document(all_operators());
    for (const char* command : commands) EXPECT_EQ(complaint(document, command), "") << command;
    return document;
}

/// The quad of the reference.
Document quad()
{
    return with_tile({"tile.new type=IH79 size=20", "tile.edge path=0 points=0.333,0.125,0.667,-0.125", "tile.edge path=1 points=0.25,0.1", "tile.point_add at=10,4",
                      "tile.stack mode=shift offset=10,10", "tile.extrude thickness=5", "tile.height points=i0 set=2", "tile.height points=m1 add=0.5", "tile.solid"});
}

TEST(TileInDocument, MakesTheQuadOfTheReference)
{
    const Document document = quad();
    const LayeredTile& tile = tile_in(document);
    EXPECT_EQ(tile.outline_count(), 10);
    EXPECT_EQ(tile.outline().orbits, 6);
    EXPECT_NEAR(tile.area(), 100, 1e-9);
    const TileSolid solid = make_solid(tile);
    EXPECT_EQ(disk_counts(solid.top), (std::array{11, 10, 10}));
    EXPECT_EQ(disk_counts(solid.bottom), (std::array{16, 16, 14}));
    EXPECT_NEAR(solid.thinnest.thickness, 3.115819, 1e-6);
    const Mesh& mesh = document.scene().mesh;
    EXPECT_EQ(counts(mesh), (Counts{27, 61, 36}));
    EXPECT_NEAR(volume(mesh), 500, 500e-9);

    const FactsJson info = FactsJson::parse(info_json(document.scene(), "quad.tile"))["tile"];
    EXPECT_EQ(info["type"], "IH79");
    EXPECT_EQ(info["aspects"], 4);
    EXPECT_EQ(info["orbits"], 6);
    EXPECT_NEAR(info["volume_expected"], 500, 1e-9);
    EXPECT_NEAR(info["min_thickness"], 3.115819, 1e-6);
}

TEST(TileInDocument, IsToldOfAsTheSolidThatItMakes)
{
    const auto told = [](std::initializer_list<const char*> commands) { return FactsJson::parse(info_json(with_tile(commands).scene(), "a.tile")); };
    const FactsJson flat = told({"tile.new type=IH79 size=20"});
    EXPECT_EQ(flat["kind"], "layered");
    EXPECT_TRUE(flat["vertices"].is_null() && flat["genus"].is_null() && flat["bbox"].is_null());
    EXPECT_NEAR(flat["area"], 100, 1e-9);
    const FactsJson solid = told({"tile.new type=IH79 size=20", "tile.edge path=0 points=0.333,0.125,0.667,-0.125", "tile.edge path=1 points=0.25,0.1", "tile.point_add at=10,4",
                                  "tile.stack mode=shift offset=10,10", "tile.extrude thickness=5", "tile.height points=i0 set=2", "tile.height points=m1 add=0.5"});
    EXPECT_EQ(solid["kind"], "layered");
    EXPECT_EQ((std::array<int, 3>{solid["vertices"], solid["edges"], solid["faces"]}), (std::array{27, 61, 36}));
    EXPECT_EQ(solid["genus"], 0);
    EXPECT_EQ(solid["watertight"], true);
    EXPECT_NEAR(solid["volume"], 500, 1e-9);
    EXPECT_NEAR(solid["volume_expected"], 500, 1e-9);
    EXPECT_NEAR(solid["area"], 100, 1e-9); // of the tile
}

TEST(TileInDocument, RefusesWhatWouldFillNoSpaceAndStaysAsItWas)
{
    struct Case {
        const char *type, *command, *complaint;
    };
    for (const Case& c : {Case{"IH79", "tile.stack mode=shift offset=5,5", "tile.stack: offset-not-isohedral: offset 5,5 of IH79: the nearest that is isohedral is 10,10"},
                          Case{"IH31", "tile.stack mode=shift offset=10,0", "tile.stack: offset-not-isohedral: offset 10,0 of IH31: the nearest that is isohedral is 0,0"},
                          Case{"IH79", "tile.edge path=0 points=0.2,0.9,0.8,-0.9", "tile.edge: boundary-crosses"},
                          Case{"IH79", "tile.edge path=1 points=0.7,0.1", "tile.edge: half-path"},
                          Case{"IH79", "tile.corner corner=0 to=1,1", "tile.corner: fixed"},
                          Case{"IH79", "tile.height points=i0 set=1", "tile.height: phase"},
                          Case{"IH79", "tile.solid", "tile.solid: phase"},
                          Case{"IH41", "tile.param index=0 value=0", "tile.param: flat-corner"},
                          Case{"IH41", "tile.param index=0", "tile.param: index=0 is given without value="},
                          Case{"IH79", "tile.edge_move point=m1 to=1,1", "tile.edge_move: fixed"},
                          Case{"IH79", "tile.point_move point=i3 to=1,1", "tile.point_move: no-such-point"}}) {
        Document document(all_operators());
        document.apply(std::string("tile.new size=20 type=") + c.type);
        const TileDesign before = tile_in(document).design();
        const std::string found = complaint(document, c.command);
        EXPECT_TRUE(found.starts_with(c.complaint)) << c.command << " -> " << found;
        EXPECT_TRUE(tile_in(document).design() == before);
    }
    Document pierced = with_tile({"tile.new type=IH41 size=10", "tile.point_add at=5,5", "tile.stack mode=shift offset=5,5", "tile.extrude thickness=1", "tile.height points=i0 set=3"});
    EXPECT_TRUE(complaint(pierced, "tile.solid").starts_with("tile.solid: top-under-bottom"));
}

TEST(TileInDocument, KeepsHeightsThroughEditsOfThePlane)
{
    Document document = with_tile({"tile.new type=IH41 size=10", "tile.edge path=0 points=0.5,0.1", "tile.point_add at=5,5", "tile.point_add at=3,7", "tile.extrude thickness=4",
                                   "tile.height points=i1 set=2", "tile.height points=e0:1 set=1"});
    document.apply("tile.edge_add at=2,-0.5");
    EXPECT_EQ(tile_in(document).height(tile_in(document).find(PointName::parse("e0:2"))), 1);
    EXPECT_NE(tile_in(document).height(tile_in(document).find(PointName::parse("e0:1"))), 0) << "a new point takes the height of the surface";
    document.apply("tile.point_remove point=i0");
    EXPECT_EQ(tile_in(document).height(tile_in(document).find(PointName::interior(0))), 2);
    document.apply("tile.edge_remove point=e0:1");
    EXPECT_EQ(tile_in(document).height(tile_in(document).find(PointName::parse("e0:1"))), 1);
    document.apply("tile.height points=outline add=0.25");
    EXPECT_EQ(tile_in(document).height(0), 0.25);
    document.apply("document.undo");
    EXPECT_EQ(tile_in(document).height(0), 0);
}

TEST(TileInDocument, KeepsHeightsOfTheSamePlacesInAnotherType)
{
    // An S edge becomes a J edge: its middle and its second half are points like others then.
    Document document = with_tile({"tile.new type=IH79 size=20", "tile.edge path=1 points=0.25,0.1", "tile.extrude thickness=5", "tile.height points=v0 set=0.25", "tile.height points=m1 set=0.5",
                                   "tile.height points=e1:1 set=0.75"});
    const auto height = [&](const char* name) { return tile_in(document).height(tile_in(document).find(PointName::parse(name))); };
    EXPECT_EQ(document.apply("tile.type type=IH41").notes, std::vector<std::string>{"1 point cannot stay as high as it is in IH41: v1"}) << "its corners are one orbit";
    EXPECT_EQ(height("v0"), 0.25);
    EXPECT_EQ(height("e1:1"), 0.75);
    EXPECT_EQ(height("e1:2"), 0.5);
    EXPECT_EQ(height("e1:3"), 0.75);

    document.apply("tile.height points=e1:3 set=1");
    EXPECT_EQ(document.apply("tile.type type=IH79").notes, std::vector<std::string>{"1 point cannot stay as high as it is in IH79: e1:3"});
    EXPECT_EQ(height("v0"), 0.25);
    EXPECT_EQ(height("e1:1"), 0.75);
    EXPECT_EQ(height("m1"), 0.5);
}

TEST(TileSolid, SaysWhichOfItsSolidsThereAre)
{
    Document document = quad();
    EXPECT_EQ(complaint(document, "tile.solid member=4"), "tile.solid: member=4: this stack has 1 solid, 0");
    EXPECT_EQ(complaint(document, "tile.solid aspect=4"), "tile.solid: aspect=4: IH79 has 4 aspects, 0 to 3");
    document.apply("tile.stack mode=free offset=5,5");
    EXPECT_EQ(complaint(document, "tile.solid member=4"), "tile.solid: member=4: this stack has 4 solids, 0 to 3");
}

std::string saved(const Document& document, const Folder& folder, const char* name)
{
    OutputSet output;
    write_document(document, output, folder.path() / name);
    output.commit();
    return folder.read(name);
}

Document opened(const std::filesystem::path& path)
{
    Document document(all_operators());
    Progress progress;
    document.open(path, progress);
    return document;
}

TEST(TileFile, ComesBackToTheByte)
{
    const Folder folder;
    Document document = quad();
    document.apply("tile.constrain from=v0 to=i0");
    const std::string first = saved(document, folder, "a.tile");
    const Document again = opened(folder.path() / "a.tile");
    EXPECT_TRUE(tile_in(again).surface().points == tile_in(document).surface().points);
    EXPECT_EQ(saved(again, folder, "b.tile"), first);

    // What is not ours stays, where it is.
    std::string other = first;
    other.insert(other.find("\"interior\""), "\"view\": {\"zoom\": 0.5, \"colors\": [\"#cc3333\", \"#eeeeee\", \"#3366cc\"]},\n  ");
    folder.write("c.tile", other);
    EXPECT_EQ(saved(opened(folder.path() / "c.tile"), folder, "d.tile"), other);

    EXPECT_EQ(saved(document, folder, "e.svg").substr(0, 4), "<svg");
}

TEST(TileFile, HasItsFirstBytesAgainWhenEverythingIsUndone)
{
    const Folder folder;
    Document document = quad();
    const std::string first = saved(document, folder, "a.tile");
    const std::vector<const char*> commands{"tile.edge_add at=5,5.5", "tile.edge_move point=e0:1 uv=0.2,0.1", "tile.point_add at=9,6", "tile.constrain from=i0 to=i1", "tile.refine max_area=4",
                                            "tile.height_dome height=1", "tile.height_ridge path=i0,i1 height=-0.3 width=1", "tile.height_smooth times=3",
                                            "tile.stack mode=mirror axis=45", "tile.extrude thickness=7", "tile.assemble layers=1", "tile.frame size=30 rotation=10"};
    for (const char* command : commands) EXPECT_EQ(complaint(document, command), "") << command;
    EXPECT_NE(saved(document, folder, "b.tile"), first);
    document.apply("document.undo steps=" + std::to_string(commands.size()));
    EXPECT_EQ(saved(document, folder, "c.tile"), first);
}

TEST(TileRelief, IsShapedByToolsAndByPictures)
{
    Document document = with_tile({"tile.new type=IH41 size=10", "tile.refine max_area=2"});
    EXPECT_TRUE(complaint(document, "tile.height_dome").starts_with("tile.height_dome: phase"));
    const std::string picture = std::string("image=") + DRUSE_MODELS + "/ripples.png";
    EXPECT_TRUE(complaint(document, "tile.height_image " + picture).starts_with("tile.height_image: phase"));
    document.apply("tile.extrude thickness=4");
    const auto heights = [&] {
        std::vector<double> all;
        for (int i = 0; i < tile_in(document).point_count(); ++i) all.push_back(tile_in(document).height(i));
        return all;
    };
    document.apply("tile.height_image low=1 high=3 " + picture);
    const std::vector<double> waves = heights();
    EXPECT_GE(std::ranges::min(waves), 1.0);
    EXPECT_LE(std::ranges::max(waves), 3.0);
    EXPECT_GT(std::ranges::max(waves) - std::ranges::min(waves), 0.5);
    document.apply("tile.height_smooth times=200 amount=1");
    EXPECT_LT(std::ranges::max(heights()) - std::ranges::min(heights()), 0.5 * (std::ranges::max(waves) - std::ranges::min(waves)));
    document.apply("tile.height_ridge line=2,2,8,8 height=1 width=3 points=interior");
    document.apply("tile.solid min_thickness=0.1");
    EXPECT_NEAR(volume(document.scene().mesh), 400, 1e-9);
    EXPECT_EQ(document.apply("tile.height_ridge line=5.0123,4.9871 width=1e-6").notes.size(), 1u);
    EXPECT_TRUE(complaint(document, "tile.height_image image=none.png").find("none.png: no such file") != std::string::npos);
    EXPECT_NE(complaint(document, std::string("tile.height_image image=") + DRUSE_MODELS + "/cube.obj"), "");
}

TEST(TileRelief, MissesPointsWhereNoneAreSelected)
{
    Document document = quad();
    document.apply("select.vertices vertices=none");
    const auto before = tile_in(document).design();
    for (const char* command : {"tile.height add=1", "tile.height set=1", "tile.height_dome height=1", "tile.height_smooth", "tile.height_ridge path=i0"})
        EXPECT_TRUE(complaint(document, std::string(command) + " points=selected").ends_with(": points=selected: no points of the tile are selected")) << command;
    EXPECT_EQ(tile_in(document).design(), before);
    EXPECT_EQ(complaint(document, "tile.height add=1 points=none"), "");
    EXPECT_EQ(tile_in(document).design(), before);
    document.apply("select.vertices vertices=26"); // of the bottom
    EXPECT_NE(complaint(document, "tile.height add=1 points=selected"), "");
    document.apply("select.vertices vertices=10,26");
    document.apply("tile.height add=1 points=selected");
    EXPECT_EQ(tile_in(document).height(10), 3);
}

TEST(TileSolids, SayWhereTheReliefIsTooSteepForTheJoint)
{
    Document document(all_operators());
    for (const char* command : {"tile.new type=IH41 size=10", "tile.edge path=0 points=.2,.1,.5,-.05", "tile.point_add at=.8,5", "tile.stack mode=shift offset=.4,0", "tile.extrude thickness=6",
                                "tile.height points=i0 set=4"})
        document.apply(command);
    const auto steep = document.apply("tile.solid clearance=.6").notes;
    ASSERT_FALSE(steep.empty());
    EXPECT_TRUE(steep[0].ends_with("where the relief is steeper than 75 degrees: joints are narrower than 0.6 there, as tile.check tells")) << steep[0];
    document.apply("tile.height points=i0 set=1");
    EXPECT_EQ(document.apply("tile.solid clearance=.6").notes, std::vector<std::string>());
    EXPECT_EQ(complaint(document, "tile.solid member=1 aspect=1").substr(0, 11), "tile.solid:");
}

TEST(TileRefine, KeepsTheOutlineAndSaysHowManyPointsAreTooMany)
{
    Document document = quad();
    document.apply("tile.refine min_angle=0 max_area=0.25");
    const LayeredTile& tile = tile_in(document);
    EXPECT_EQ(tile.outline_count(), 10);
    EXPECT_GE(tile.surface().triangles.size(), 400u); // of an area of 100
    for (const auto& t : tile.surface().triangles) {
        const Point2 u = tile.position(int(t[1])) - tile.position(int(t[0])), w = tile.position(int(t[2])) - tile.position(int(t[0]));
        EXPECT_LE(u.x * w.y - u.y * w.x, 0.5 + 1e-12);
    }
    const std::string complaint_of = complaint(document, "tile.refine max_area=1e-9");
    EXPECT_TRUE(complaint_of.starts_with("tile.refine: range: max_area=1e-09: it takes 5e+10 points and more, and 1000000 are the most")) << complaint_of;
}

TEST(TileFile, SaysLineAndKeyOfWhatIsWrong)
{
    const Folder folder;
    const std::string good = saved(quad(), folder, "a.tile");
    struct Case {
        const char *from, *to, *complaint;
    };
    for (const Case& c : {Case{"\"version\": 1", "\"version\": 2", "2: version: "}, Case{"\"IH79\"", "\"IH19\"", "5: type: IH19"}, Case{"\"size\": 20", "\"size\": -1", "6: size: "},
                          Case{"0.333", "\"a\"", "10: paths[0].points[0][0]: expected a number"}, Case{"[0.25, 0.1]", "[0.75, 0.1]", "10: paths[1].points: half-path"},
                          Case{"[10, 4]", "[10, 400]", "11: interior: swallows-point"}, Case{"\"m1\"", "\"m7\"", "14: heights.m7: no-such-point"},
                          Case{"\"i0\"", "\"i9\"", "14: heights.i9: no-such-point"},
                          Case{"\"mode\": \"shift\"", "\"mode\": \"shaft\"", "15: stack.mode: "}, Case{"[10, 10]", "[5, 5]", "15: stack.offset: offset-not-isohedral"},
                          Case{"\"rotation\": 0", "\"rotation\": 1000", "7: rotation: expected -360 to 360 degrees"},
                          Case{"\"mode\": \"shift\"", "\"mode\": \"column\"", "15: stack.offset: mode=column does not use it"},
                          Case{"[10, 10]", "[10, 10], \"axis\": 5", "15: stack.axis: mode=shift does not use it"},
                          Case{"\"shift\", \"offset\": [10, 10]", "\"mirror\", \"axis\": 361", "15: stack.axis: expected -360 to 360 degrees"},
                          Case{"\"kind\": \"layered\",", "", "1: kind: is missing"}, Case{"\"params\": []", "\"params\": [1]", "9: params: IH79 has no parameters"}}) {
        std::string bad = good;
        ASSERT_NE(bad.find(c.from), std::string::npos) << c.from;
        bad.replace(bad.find(c.from), std::string(c.from).size(), c.to);
        folder.write("bad.tile", bad);
        try {
            opened(folder.path() / "bad.tile");
            ADD_FAILURE() << "is read: " << c.to;
        } catch (const std::exception& e) {
            EXPECT_NE(std::string(e.what()).find("bad.tile:" + std::string(c.complaint)), std::string::npos) << e.what();
        }
    }
}

TEST(TileAssembly, IsManyTilesWithTheVolumeOfThemAll)
{
    Document document = quad();
    document.apply("tile.assemble nx=2 ny=2 layers=3 color=type");
    EXPECT_NEAR(volume(document.scene().mesh), 2 * 2 * 4 * 3 * 500.0, 1e-6);
    EXPECT_EQ(document.scene().mesh.face_count(), 48 * 36);
}

TEST(TileAssembly, PutsMirroredLayersOverTheFirst)
{
    for (const char* type : {"IH79", "IH31", "IH01"}) {
        const auto box = [type](const char* layers) {
            Document document = with_tile({});
            document.apply(std::string("tile.new type=") + type + " size=10");
            document.apply("tile.stack mode=mirror axis=0");
            document.apply("tile.extrude thickness=4");
            document.apply(std::string("tile.assemble nx=3 ny=3 layers=") + layers);
            EXPECT_NEAR(volume(document.scene().mesh), 9 * tile_in(document).type().aspects() * tile_in(document).area() * 4 * (layers[0] - '0'), 1e-6);
            return bounds(document.scene().mesh).size();
        };
        const Vector one = box("1"), two = box("2");
        EXPECT_LT(two.x, 1.5 * one.x) << type;
        EXPECT_LT(two.y, 1.5 * one.y) << type;
        EXPECT_NEAR(two.z, 2 * one.z, 1e-9);
    }
}

TEST(TileSolid, WithClearanceLeavesJointsThatWide)
{
    Document document = quad();
    const FactsJson found = FactsJson::parse(document.apply("tile.check clearance=0.3 strict=true").output);
    EXPECT_EQ(found["faults"], FactsJson::array());
    EXPECT_GE(double(found["clearance"]), 0.3 - 1e-6 * 20);
    EXPECT_LT(double(found["volume_left"]), 500);
}

} // namespace
} // namespace druse
