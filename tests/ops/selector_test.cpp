// Selectors: what commands mean by faces=, edges= and vertices=.
#include "ops/selector.h"

#include "dlfl/measures.h"
#include "run.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace druse {
namespace {

using namespace test;
using Ids = std::vector<std::uint32_t>;

template <class H = Face>
Ids chosen(const Scene& scene, const char* text)
{
    return ids(Selector<H>::parse(text).resolve(scene));
}
template <class H = Face>
std::string refused(const Scene& scene, const char* text)
{
    try {
        Selector<H>::parse(text).resolve(scene);
    } catch (const CommandError& e) {
        return e.what();
    }
    return "(none)";
}

TEST(FaceSelector, TakesIdsRangesAndSums)
{
    const Scene scene = scene_of(cube());
    EXPECT_EQ(chosen(scene, "all"), (Ids{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(chosen(scene, "none"), Ids());
    EXPECT_EQ(chosen(scene, "4,0,2-3"), (Ids{0, 2, 3, 4}));
    EXPECT_EQ(chosen(scene, "5+1,5+none+0-1"), (Ids{0, 1, 5}));
    EXPECT_EQ(chosen(scene, "1-4,0-2,2,3-5,1-4"), (Ids{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(chosen(scene, "all+all+all+0-5+all+2"), (Ids{0, 1, 2, 3, 4, 5}));
}

TEST(FaceSelector, TakesGroupsSidesComponentsAndNormals)
{
    Scene scene = scene_of(test::prism(6));
    scene.mesh.append(test::cube());
    for (const Face f : scene.mesh.faces()) scene.mesh.set_group(f, f.index % 3);
    EXPECT_EQ(chosen(scene, "group:2"), (Ids{2, 5, 8, 11}));
    EXPECT_EQ(chosen(scene, "group:0+group:1").size(), 10u);
    EXPECT_EQ(chosen(scene, "sides:6"), (Ids{0, 7}));
    EXPECT_EQ(chosen(scene, "sides:5"), Ids());
    EXPECT_EQ(chosen(scene, "component:1"), (Ids{8, 9, 10, 11, 12, 13}));
    for (const char* up : {"normal:0,0,2,0", "normal:0,0,1e200,0", "normal:0,0,1e-200,0"}) EXPECT_EQ(chosen(scene, up), (Ids{7, 13}));
    EXPECT_EQ(chosen(scene, "normal:0,0,-1,0.5"), (Ids{0, 8}));
    EXPECT_EQ(chosen(scene, "normal:0,0,1,90").size(), 12u);
    EXPECT_EQ(refused(scene, "group:9"), "no face has group 9");
    EXPECT_EQ(refused(scene, "component:2"), "there is no component 2: the mesh has 2");
}

TEST(FaceSelector, TakesTheSelection)
{
    Scene scene = scene_of(cube());
    EXPECT_EQ(refused(scene, "selected"), "no faces are selected");
    scene.selection.edit().faces = {Face(1), Face(4)};
    EXPECT_EQ(chosen(scene, "selected+0"), (Ids{0, 1, 4}));
    EXPECT_EQ(ids(FaceSelector().resolve(scene)), (Ids{1, 4})); // the default
}

TEST(FaceSelector, SaysWhatIsNotThere)
{
    const Scene scene = scene_of(cube());
    EXPECT_EQ(refused(scene, "6"), "there is no face 6: the faces are 0 to 5");
    EXPECT_EQ(refused(scene, "2-4294967295"), "there is no face 6: the faces are 0 to 5");
    EXPECT_EQ(refused(Scene(), "0"), "there is no face 0: the mesh has no faces");
    EXPECT_EQ(refused(scene, "4-2"), "expected face ids that ascend, found 4-2");
    EXPECT_EQ(refused(scene, "normal:0,0,0,5"), "expected normal:x,y,z,angle with a direction and an angle of 0 to 180 degrees");
    for (const char* text : {"", "+", "all+", "one", "1,,2", "1-", "-1", "1-2-3", "group:", "group:x", "valence:3", "4~9", "normal:1,2,3", "0 1"})
        EXPECT_EQ(refused(scene, text),
                  "expected all, none, selected, ids like 0,4,7-9, group:3, sides:5, component:0, normal:x,y,z,angle, strut:4 or ball:9, joined by +")
            << text;
}

TEST(EdgeSelector, TakesEndVertices)
{
    const Scene scene = scene_of(cube());
    const auto [a, b] = scene.mesh.ends(Edge(7));
    const std::string text = std::to_string(b.index) + "~" + std::to_string(a.index);
    EXPECT_EQ(chosen<Edge>(scene, text.c_str()), Ids{7});
    EXPECT_EQ(chosen<Edge>(scene, ("0,3+" + text).c_str()), (Ids{0, 3, 7}));
    EXPECT_EQ(chosen<Edge>(scene_of(three_lunes()), "1~0"), Ids{0}); // the lowest of three
    EXPECT_EQ(refused<Edge>(scene, "0~6"), "no edge joins vertices 0 and 6");
    EXPECT_EQ(refused<Edge>(scene, "0~8"), "there is no vertex 8: the vertices are 0 to 7");
    EXPECT_EQ(refused<Edge>(scene_of(point_sphere()), "0~0"), "no edge joins vertices 0 and 0");
    for (const char* text2 : {"4~", "~4", "4~9~1", "valence:3", "group:1"})
        EXPECT_EQ(refused<Edge>(scene, text2), "expected all, none, selected, ids like 0,4,7-9 or end vertices like 4~9, joined by +") << text2;
}

TEST(VertexSelector, TakesValences)
{
    const Scene scene = scene_of(pyramid(7));
    EXPECT_EQ(chosen<Vertex>(scene, "valence:7"), Ids{7});
    EXPECT_EQ(chosen<Vertex>(scene_of(point_sphere()), "valence:0"), Ids{0});
    EXPECT_EQ(refused<Vertex>(scene, "sides:3"), "expected all, none, selected, ids like 0,4,7-9 or valence:3, joined by +");
}

TEST(Selector, WritesWhatItReads)
{
    for (const char* text : {"all", "none", "selected", "0,4,7-9", "group:3+sides:5", "component:0", "normal:0,0.5,-1,15", "selected+3"})
        EXPECT_EQ(FaceSelector::parse(text).text(), text);
    EXPECT_EQ(EdgeSelector::parse("4~9,2~3+7").text(), "4~9,2~3+7");
    EXPECT_EQ(VertexSelector::parse("valence:3").text(), "valence:3");
    EXPECT_EQ(FaceSelector::of({Face(2), Face(3), Face(4), Face(9)}).text(), "2-4,9");
    EXPECT_EQ(FaceSelector::of({}).text(), "none");
}

TEST(Selector, IgnoresOpenBoundaries)
{
    const Scene scene = scene_of(open_grid(3, 2));
    EXPECT_EQ(chosen(scene, "all").size(), 6u);
    EXPECT_EQ(chosen(scene, "sides:10"), Ids());
    EXPECT_EQ(chosen(scene, "component:0").size(), 6u);
}

TEST(Ids, NameOneElement)
{
    const Mesh mesh = cube();
    EXPECT_EQ(FaceId{3}.resolve(mesh), Face(3));
    EXPECT_EQ(VertexId{3}.resolve(mesh), Vertex(3));
    EXPECT_EQ((CornerId{3, 2}.resolve(mesh)), mesh.corner(Face(3), 2));
    EXPECT_THROW(FaceId{6}.resolve(mesh), CommandError);
    EXPECT_THROW((CornerId{3, 4}.resolve(mesh)), CommandError);
    EXPECT_THROW((EdgeId{0, 6}.resolve(mesh)), CommandError);
    EXPECT_THROW((EdgeId{12}.resolve(mesh)), CommandError);
}

} // namespace
} // namespace druse
