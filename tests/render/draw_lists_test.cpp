#include "render/draw_lists.h"

#include "dlfl/measures.h"
#include "dlfl/patch.h"
#include "render/picture.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace druse {
namespace {

using namespace test;

Colour by_group(int group)
{
    return colour_from_hsv(0.618 * group, 0.62, 0.93);
}

/// What the lists say must be what the mesh says, whatever they went through.
void expect_same(const DrawLists& lists, const Mesh& mesh, const GroupColours& colours)
{
    std::uint32_t triangles = 0;
    for (const Face f : mesh.faces()) {
        const int sides = mesh.valence(f);
        const DrawLists::Range range = lists.triangles(f);
        ASSERT_EQ(range.count, static_cast<std::uint32_t>(std::max(0, sides - 2)));
        triangles += range.count;
        if (range.count == 0) continue;

        std::multiset<std::pair<std::uint32_t, std::uint32_t>> own, drawn;
        for (const Corner c : mesh.corners(f)) own.insert({mesh.vertex(c).index, mesh.target(c).index});
        for (const auto& [a, b] : lists.sides(f)) drawn.insert({a, b});
        ASSERT_EQ(drawn, own) << "the sides of the triangles that are sides of face " << f.index;

        Vector area(0.0);
        for (std::uint32_t t = range.first; t < range.first + range.count; ++t) {
            ASSERT_EQ(lists.face(t), f);
            area += 0.5 * glm::cross(lists.corner(t, 1) - lists.corner(t, 0), lists.corner(t, 2) - lists.corner(t, 0));
            const DrawVertex& last = lists.draw_vertices()[lists.triangles()[t][2]];
            const Colour c = colours(mesh.group(f));
            ASSERT_EQ(last.look & 0xffffffu, c.red | std::uint32_t(c.green) << 8 | std::uint32_t(c.blue) << 16);
            ASSERT_EQ((last.look & DrawVertex::selected_flag) != 0, lists.is_selected(f));
            ASSERT_EQ(last.normal, pack_normal(unit(area_vector(mesh, f)))) << "each triangle has the polygon's normal";
        }
        ASSERT_LT(glm::distance(area, area_vector(mesh, f)), 1e-12);
    }
    ASSERT_EQ(lists.triangle_count(), triangles);
    std::set<std::uint32_t> lasts;
    std::uint32_t live = 0;
    for (std::uint32_t t = 0; t < lists.triangles().size(); ++t) {
        const DrawLists::Triangle& triangle = lists.triangles()[t];
        if (!lists.face(t).valid()) {
            ASSERT_TRUE(triangle[0] == triangle[1] && triangle[1] == triangle[2]);
            continue;
        }
        ++live;
        ASSERT_TRUE(lasts.insert(triangle[2]).second) << "two triangles end in one draw vertex";
        for (const std::uint32_t d : triangle) {
            const DrawVertex& vertex = lists.draw_vertices()[d];
            const Point p = lists.origin() + Vector(vertex.x, vertex.y, vertex.z);
            ASSERT_LT(glm::distance(p, mesh.position(Vertex(lists.vertex_of(d)))), 1e-5);
        }
    }
    ASSERT_EQ(live, triangles);
    ASSERT_EQ(lists.edge_limit(), mesh.edge_limit());
    for (const Edge e : mesh.edges()) {
        const auto [a, b] = mesh.ends(e);
        ASSERT_EQ(lists.edges()[e.index], (std::array{a.index, b.index}));
        for (const Vertex v : {a, b}) {
            const DrawVertex& vertex = lists.draw_vertices()[lists.draw_vertex_of(v.index)];
            ASSERT_LT(glm::distance(lists.origin() + Vector(vertex.x, vertex.y, vertex.z), mesh.position(v)), 1e-5);
        }
    }
    if (triangles == 0) return;
    Box box;
    for (const Face f : mesh.faces())
        if (mesh.valence(f) >= 3)
            for (const Corner c : mesh.corners(f)) box.add(mesh.position(c));
    ASSERT_EQ(lists.bounds().min, box.min);
    ASSERT_EQ(lists.bounds().max, box.max);
}

class EveryShape : public testing::TestWithParam<NamedShape> {};
INSTANTIATE_TEST_SUITE_P(DrawLists, EveryShape, testing::ValuesIn(all_shapes()), shape_name<testing::TestParamInfo<NamedShape>>);

TEST_P(EveryShape, IsDrawnWithAllItsFacesAndSides)
{
    const Mesh mesh = GetParam().make();
    const DrawLists lists(mesh, by_group);
    expect_same(lists, mesh, by_group);
    EXPECT_EQ(lists.is_closed(), boundary_edge_count(mesh) == 0);
    EXPECT_EQ(lists.boundary_sides().size(), boundary_edge_count(mesh));
}

TEST(DrawLists, ShowOnlyTheSidesBetweenPartsOfDifferentFaces)
{
    // A torus of 8 by 6 squares, as if each 2 by 2 of them had been one.
    const Mesh mesh = torus(8, 6);
    std::vector<std::uint32_t> block(mesh.face_count());
    for (const Face f : mesh.faces()) block[f.index] = (f.index / 6 / 2) * 3 + f.index % 6 / 2;
    DrawLists lists;
    lists.build(mesh, by_group, Division(mesh, block));
    EXPECT_TRUE(lists.is_divided());
    EXPECT_EQ(lists.edges().size(), mesh.edge_count() / 2) << "of four squares in a block the 4 inner sides are gone, and half of 8 are its own";
    std::size_t sides = 0;
    for (const Face f : mesh.faces()) {
        EXPECT_EQ(lists.sides(f).size(), 2u);
        sides += lists.sides(f).size();
    }
    EXPECT_EQ(sides, 2 * lists.edges().size());
    for (const auto& [a, b] : lists.edges()) {
        bool found = false;
        for (const Edge e : mesh.edges()) {
            const auto [v, w] = mesh.ends(e);
            if (v.index != a || w.index != b) continue;
            const auto [f, g] = mesh.faces(e);
            found = block[f.index] != block[g.index];
        }
        EXPECT_TRUE(found);
    }
    EXPECT_FALSE(DrawLists(mesh, by_group).is_divided());
}

TEST(DrawLists, AreShadedByTheNormalsOfADivision)
{
    const Mesh mesh = torus(8, 6);
    std::vector<std::uint32_t> own(mesh.face_count());
    std::iota(own.begin(), own.end(), 0u);
    std::vector<Vector> normals;
    for (const Vertex v : mesh.vertices()) normals.push_back(unit(Vector(std::cos(v.index), std::sin(v.index), 0.5)));
    DrawLists lists;
    lists.build(mesh, by_group, Division(mesh, own, normals));
    const auto expect_normals = [&] {
        ASSERT_EQ(lists.smooth_normals().size(), lists.draw_vertices().size());
        for (std::uint32_t i = 0; i < lists.draw_vertices().size(); ++i) EXPECT_EQ(lists.smooth_normals()[i], pack_normal(normals[lists.vertex_of(i)]));
    };
    expect_normals();
    lists.select(std::vector<Face>{Face(3)});
    lists.recolour(mesh, by_group);
    expect_normals();
}

TEST(DrawLists, KnowTheirShapeFromTheirLooks)
{
    Mesh mesh = torus(8, 6);
    DrawLists lists(mesh, by_group);
    const std::uint64_t shape = lists.shape_version();
    const std::vector<std::uint32_t> normals = lists.smooth_normals();
    lists.select(std::vector<Face>{Face(3)});
    mesh.set_group(Face(5), 2);
    MeshDelta delta;
    delta.regrouped = {Face(5)};
    lists.update(mesh, delta, by_group);
    lists.recolour(mesh, [](int) { return Colour{1, 2, 3}; });
    EXPECT_EQ(lists.shape_version(), shape);
    EXPECT_EQ(lists.smooth_normals(), normals);

    mesh.set_position(Vertex(7), mesh.position(Vertex(7)) + Vector(0.1, 0, 0));
    delta = {};
    delta.vertices = {Vertex(7)};
    lists.update(mesh, delta, by_group);
    EXPECT_NE(lists.shape_version(), shape);
    EXPECT_NE(lists.smooth_normals(), normals);
}

TEST(DrawLists, ShareVerticesAsFarAsTrianglesAllow)
{
    // A torus of quads has as many vertices as faces, hence half as many as triangles; each triangle needs a last one of its own.
    const Mesh mesh = torus(60, 40);
    const DrawLists lists(mesh, by_group);
    EXPECT_EQ(lists.triangle_count(), 2u * 60 * 40);
    EXPECT_EQ(lists.draw_vertices().size(), lists.triangle_count());
}

TEST(DrawLists, HoldTheLinesOfAGraph)
{
    const Graph graph{{{5, 0, 0}, {6, 0, 0}, {6, 1, 0}}, {{0, 1}, {2, 1}}};
    const DrawLists lists(graph);
    EXPECT_FALSE(lists.has_faces());
    EXPECT_TRUE(lists.is_closed());
    EXPECT_EQ(lists.bounds().min, Point(5, 0, 0));
    EXPECT_EQ(lists.bounds().max, Point(6, 1, 0));
    ASSERT_EQ(lists.edge_limit(), 2u);
    EXPECT_EQ(lists.edges()[1], (std::array{2u, 1u}));
    EXPECT_DOUBLE_EQ(lists.mean_edge_length(), 1);
}

TEST(DrawLists, AskForEachColourOnce)
{
    Mesh mesh = torus(30, 20);
    std::map<int, int> asked;
    for (const Face f : mesh.faces()) mesh.set_group(f, static_cast<int>(f.index % 3) * 1000000000);
    const DrawLists lists(mesh, [&](int group) {
        ++asked[group];
        return by_group(group % 7);
    });
    EXPECT_EQ(asked, (std::map<int, int>{{0, 1}, {1000000000, 1}, {2000000000, 1}}));
}

TEST(DrawLists, MarkTheSelectedFacesAndNoOthers)
{
    const Mesh mesh = dodecahedron();
    DrawLists lists(mesh, by_group);
    lists.select(std::array{Face(3), Face(7)});
    expect_same(lists, mesh, by_group);
    lists.select(std::array{Face(7), Face(8), Face(99)});
    for (const Face f : mesh.faces()) EXPECT_EQ(lists.is_selected(f), f == Face(7) || f == Face(8));
    expect_same(lists, mesh, by_group);
    lists.select({});
    for (const Face f : mesh.faces()) EXPECT_FALSE(lists.is_selected(f));
}

TEST(DrawLists, TakeOverColoursAndGroups)
{
    Mesh mesh = cube();
    DrawLists lists(mesh, by_group);
    const std::uint64_t id = lists.id(), version = lists.version();
    mesh.set_group(Face(2), 5);
    lists.recolour(mesh, by_group);
    EXPECT_EQ(lists.group(Face(2)), 5);
    expect_same(lists, mesh, by_group);
    EXPECT_EQ(lists.id(), id);
    EXPECT_GT(lists.version(), version);
}

TEST(DrawLists, FollowALocalEditByTouchingAFewBlocksOnly)
{
    Mesh mesh = torus(200, 100); // 40 000 triangles in 157 blocks
    DrawLists lists(mesh, by_group);
    const std::uint64_t id = lists.id(), before = lists.version();
    mesh.begin_change();
    mesh.insert_edge(mesh.corner(Face(5000)), mesh.corner(Face(5000), 2));
    mesh.set_position(Vertex(7), mesh.position(Vertex(7)) * 1.01);
    const MeshChange change = mesh.end_change();
    lists.update(mesh, difference(mesh, change), by_group);
    expect_same(lists, mesh, by_group);
    EXPECT_EQ(lists.id(), id) << "not built anew";
    for (const auto& versions : {lists.vertex_versions(), lists.triangle_versions(), lists.edge_versions()})
        EXPECT_LE(std::count_if(versions.begin(), versions.end(), [&](std::uint64_t v) { return v > before; }), 8);
}

TEST(DrawLists, FollowMovesOfAllVerticesAsIfDrawnAnew)
{
    Studio studio;
    for (const bool triangles : {true, false}) {
        Mesh mesh = torus(20, 10);
        if (triangles)
            for (std::uint32_t f = 0; f < 200; ++f) mesh.insert_edge(mesh.corner(Face(f)), mesh.corner(Face(f), 2));
        mesh.compact();
        DrawLists lists(mesh, by_group);
        lists.select(std::vector{Face(3)});
        Style style;
        style.edge_method = Style::EdgeMethod::surface;
        const Camera camera = camera_at(lists, "iso");
        studio.picture(lists, camera, style); // is on the card as it was before
        const std::uint64_t id = lists.id(), shape = lists.shape_version();
        MeshDelta delta;
        for (const Vertex v : mesh.vertices()) {
            const Point p = mesh.position(v);
            mesh.set_position(v, {1.5 * p.x + 0.3 * p.y, p.y, p.z + 0.4 * p.x * p.y});
            delta.vertices.push_back(v);
        }
        lists.update(mesh, delta, by_group);
        expect_same(lists, mesh, by_group);
        EXPECT_NEAR(lists.mean_edge_length(), DrawLists(mesh, by_group).mean_edge_length(), 1e-12);
        EXPECT_EQ(lists.id() == id, triangles) << "polygons may have to be cut otherwise";
        EXPECT_GT(lists.shape_version(), shape);
        DrawLists anew(mesh, by_group);
        anew.select(std::vector{Face(3)});
        EXPECT_EQ(pixels_apart(studio.picture(lists, camera, style), studio.picture(anew, camera, style), 2), 0);
        for (const Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v) + Vector(1e6, 0, 0));
        lists.update(mesh, delta, by_group);
        EXPECT_LT(glm::distance(lists.origin(), lists.bounds().center()), 10); // single precision would not do
        EXPECT_TRUE(lists.is_selected(Face(3)));
    }
}

TEST(DrawLists, DoNotGrowWhileASliderIsDragged)
{
    Mesh mesh = torus(60, 40);
    DrawLists lists(mesh, by_group);
    std::size_t triangles = 0, vertices = 0;
    MeshChange change;
    for (int step = 0; step < 400; ++step) {
        if (step > 0) { // undo the last value
            mesh.exchange(change);
            lists.update(mesh, difference(mesh, change), by_group);
        }
        mesh.begin_change();
        Patch cone(4, 1);
        for (int i = 0; i < 4; ++i) cone.add({i, (i + 1) % 4, 4});
        cone.connect();
        const std::uint32_t tip = mesh.replace_face(Face(77), cone);
        mesh.set_position(Vertex(tip), Point(0, 0, 0.001 * step));
        change = mesh.end_change();
        lists.update(mesh, difference(mesh, change), by_group);
        if (step == 3) {
            triangles = lists.triangles().size();
            vertices = lists.draw_vertices().size();
        }
    }
    expect_same(lists, mesh, by_group);
    EXPECT_EQ(lists.triangles().size(), triangles);
    EXPECT_EQ(lists.draw_vertices().size(), vertices);
}

/// Some edits of a kind that a picture can show: faces are split, joined, raised to a cone, moved, put in groups.
void edit(Mesh& mesh, std::mt19937& random)
{
    const auto pick = [&](std::uint32_t n) { return std::uniform_int_distribution<std::uint32_t>(0, n - 1)(random); };
    std::uniform_real_distribution<double> small(-0.02, 0.02);
    const int edits = 1 + static_cast<int>(pick(6));
    for (int i = 0; i < edits; ++i) {
        switch (pick(5)) {
        case 0: {
            const Face f(pick(mesh.face_limit()));
            const int n = mesh.is_alive(f) ? mesh.valence(f) : 0;
            if (n >= 4)
                mesh.insert_edge(mesh.corner(f, 0),
                                 mesh.corner(f, 2 + static_cast<int>(pick(static_cast<std::uint32_t>(n - 3)))));
            break;
        }
        case 1: {
            const Edge e(pick(mesh.edge_limit()));
            if (mesh.is_alive(e) && !mesh.is_on_boundary(e)) mesh.delete_edge(e, true);
            break;
        }
        case 2: {
            mesh.compact();
            const Face f(pick(mesh.face_limit()));
            const int n = mesh.valence(f);
            if (n < 3) break;
            Point tip = vertex_mean(mesh, f) + 0.05 * unit_normal(mesh, f);
            Patch cone(n, 1);
            for (int k = 0; k < n; ++k) cone.add({k, (k + 1) % n, n});
            cone.connect();
            mesh.set_position(Vertex(mesh.replace_face(f, cone)), tip);
            break;
        }
        case 3: {
            const Vertex v(pick(mesh.vertex_limit()));
            if (mesh.is_alive(v)) mesh.set_position(v, mesh.position(v) + Vector(small(random), small(random), small(random)));
            break;
        }
        default: {
            const Face f(pick(mesh.face_limit()));
            if (mesh.is_alive(f)) mesh.set_group(f, static_cast<int>(pick(5)));
        }
        }
    }
    mesh.compact();
}

TEST(DrawLists, FollowRandomEditsAndUndoToTheSamePicture)
{
    Studio studio;
    for (unsigned seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        Mesh mesh = seed % 3 == 0 ? open_grid(9, 8) : torus(24, 16);
        DrawLists lists(mesh, by_group);
        const Camera camera = camera_at(lists, "iso");
        std::vector<MeshChange> done;
        for (int step = 0; step < 30; ++step) {
            if (step % 4 == 3 && !done.empty()) {
                mesh.exchange(done.back());
                lists.update(mesh, difference(mesh, done.back()), by_group);
                done.pop_back();
            } else {
                mesh.begin_change();
                edit(mesh, random);
                done.push_back(mesh.end_change());
                ASSERT_SOUND(mesh);
                lists.update(mesh, difference(mesh, done.back()), by_group);
            }
            ASSERT_NO_FATAL_FAILURE(expect_same(lists, mesh, by_group)) << "step " << step;
        }
        Style style;
        style.edge_method = seed % 2 ? Style::EdgeMethod::surface : Style::EdgeMethod::lines;
        const Image followed = studio.picture(lists, camera, style);
        const Image anew = studio.picture(DrawLists(mesh, by_group), camera, style);
        // Triangles may start at another corner, and then round a shade differently; nothing else may differ.
        EXPECT_EQ(pixels_apart(followed, anew, 2), 0);
    }
}

TEST(DrawLists, ReachTheGraphicsCardBlockByBlock)
{
    // A renderer that saw every state in between has copied only what changed; another one copies everything.
    Studio studio;
    std::mt19937 random(99);
    Mesh mesh = torus(40, 20);
    DrawLists lists(mesh, by_group);
    const Camera camera = camera_at(lists, "20,40");
    for (int step = 0; step < 25; ++step) {
        mesh.begin_change();
        edit(mesh, random);
        lists.update(mesh, difference(mesh, mesh.end_change()), by_group);
        lists.select(std::array{Face(static_cast<std::uint32_t>(step))});
        Style style;
        style.shading = step % 5 == 4 ? Style::Shading::smooth : Style::Shading::flat;
        const Image followed = studio.picture(lists, camera, style);
        ASSERT_TRUE(followed == fresh_picture(lists, camera, style)) << "step " << step;
    }
}

TEST(MeshDelta, IsEmptyWhereValuesWereWrittenButNotChanged)
{
    Mesh mesh = cube();
    mesh.begin_change();
    mesh.set_position(Vertex(0), mesh.position(Vertex(0)));
    mesh.set_group(Face(0), mesh.group(Face(0)));
    const MeshDelta delta = difference(mesh, mesh.end_change());
    EXPECT_FALSE(delta.whole);
    EXPECT_TRUE(delta.vertices.empty() && delta.edges.empty() && delta.faces.empty() && delta.regrouped.empty());
}

TEST(MeshDelta, NamesWhatASplitFaceTouches)
{
    Mesh mesh = cube();
    mesh.begin_change();
    mesh.insert_edge(mesh.corner(Face(4), 0), mesh.corner(Face(4), 2));
    const MeshDelta delta = difference(mesh, mesh.end_change());
    EXPECT_EQ(delta.faces, (std::vector{Face(4), Face(6)}));
    EXPECT_TRUE(delta.vertices.empty());
    EXPECT_TRUE(std::find(delta.edges.begin(), delta.edges.end(), Edge(12)) != delta.edges.end());
}

TEST(MeshDelta, IsEverythingWhereTheMeshWasReplaced)
{
    Mesh mesh = cube();
    DrawLists lists(mesh, by_group);
    mesh.begin_change();
    mesh.replace_with(dodecahedron());
    const MeshDelta delta = difference(mesh, mesh.end_change());
    EXPECT_TRUE(delta.whole);
    lists.update(mesh, delta, by_group);
    expect_same(lists, mesh, by_group);
}

} // namespace
} // namespace druse
