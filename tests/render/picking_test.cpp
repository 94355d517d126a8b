#include "render/picking.h"

#include "dlfl/measures.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <random>

namespace druse {
namespace {

using namespace test;

Colour grey(int)
{
    return {204, 204, 204};
}

Camera camera_for(const DrawLists& lists, std::string_view view)
{
    Camera camera;
    camera.resize(640, 480);
    camera.set_angles(*view_from_text(view));
    camera.fit(lists.bounds());
    return camera;
}

Ray toward(const Point& from, const Point& to)
{
    return {from, unit(to - from)};
}

TEST(PickFace, FindsEachFaceOfASolidFromOutsideAndFromWithin)
{
    for (const Mesh& mesh : {cube(), dodecahedron(), icosahedron(), prism(7)}) {
        const DrawLists lists(mesh, grey);
        const Point middle = lists.bounds().center();
        for (const Face f : mesh.faces()) {
            const Point aim = vertex_mean(mesh, f);
            const Point outside = middle + 5.0 * (aim - middle);
            const auto hit = pick_face(lists, toward(outside, middle));
            ASSERT_TRUE(hit);
            EXPECT_EQ(hit->face, f);
            EXPECT_FALSE(hit->from_behind);
            EXPECT_LT(glm::distance(hit->point, aim), 1e-12);
            EXPECT_NEAR(hit->distance, glm::distance(outside, aim), 1e-12);

            const auto from_within = pick_face(lists, toward(middle, outside));
            ASSERT_TRUE(from_within);
            EXPECT_EQ(from_within->face, f);
            EXPECT_TRUE(from_within->from_behind);
        }
    }
}

TEST(PickFace, MissesBesideTheMeshAndBehindTheRay)
{
    const DrawLists lists(cube(), grey);
    const Box box = lists.bounds();
    EXPECT_FALSE(pick_face(lists, toward(box.max + 1.0, box.max + Vector(2, 1, 1))));
    EXPECT_FALSE(pick_face(lists, {box.max + 1.0, unit(Vector(1))}));
    EXPECT_FALSE(pick_face(DrawLists(), {Point(0), Vector(0, 0, 1)}));
    EXPECT_FALSE(pick_face(DrawLists(Graph{{{0, 0, 0}, {1, 0, 0}}, {{0, 1}}}), {Point(0.5, 0, 1), Vector(0, 0, -1)}));
}

TEST(PickFace, GivesTheLowestIdOfFacesThatMeetInThePoint)
{
    for (const Mesh& mesh : {cube(), octahedron(), dodecahedron()}) {
        const DrawLists lists(mesh, grey);
        const Point middle = lists.bounds().center();
        for (const Vertex v : mesh.vertices()) {
            Face lowest;
            for (const Corner c : mesh.around(v)) lowest = std::min(lowest, mesh.face(c));
            const auto hit = pick_face(lists, toward(middle + 3.0 * (mesh.position(v) - middle), middle));
            ASSERT_TRUE(hit) << "no ray slips through a corner";
            EXPECT_EQ(hit->face, lowest);
        }
        for (const Edge e : mesh.edges()) {
            const Point aim = 0.5 * (mesh.position(mesh.ends(e)[0]) + mesh.position(mesh.ends(e)[1]));
            const auto hit = pick_face(lists, toward(middle + 3.0 * (aim - middle), middle));
            ASSERT_TRUE(hit) << "no ray slips between two faces";
            EXPECT_EQ(hit->face, std::min(mesh.faces(e)[0], mesh.faces(e)[1]));
        }
    }
}

TEST(PickFace, GivesTheLowerOfTwoSidesThatLieInOnePlane)
{
    const Mesh mesh = dihedron(5);
    const DrawLists lists(mesh, grey);
    EXPECT_EQ(pick_face(lists, {Point(0, 0, 1), Vector(0, 0, -1)})->face, Face(0));
    const auto below = pick_face(lists, {Point(0, 0, -1), Vector(0, 0, 1)});
    EXPECT_EQ(below->face, Face(0));
    EXPECT_TRUE(below->from_behind);
}

TEST(PickFace, SeesTheHoleOfAnOpenSurface)
{
    const Mesh mesh = open_tube(12);
    const DrawLists lists(mesh, grey);
    const Point middle = lists.bounds().center();
    EXPECT_FALSE(pick_face(lists, {middle + Vector(0, 0, 5), Vector(0, 0, -1)})) << "through both openings";
    const auto inside = pick_face(lists, {middle + Vector(0, 0, 5), unit(Vector(0.38, 0.03, -1))});
    ASSERT_TRUE(inside);
    EXPECT_TRUE(inside->from_behind);
}

TEST(PickFace, AgreesWithEveryTriangleTriedInTurn)
{
    const Mesh mesh = torus(40, 25);
    const DrawLists lists(mesh, grey);
    ASSERT_GT(lists.pick_boxes().size(), 20u);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto direction = [&] { return unit(Vector(number(random), number(random), number(random))); };
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const Point from = 4.0 * direction();
        const Ray ray = toward(from, direction());
        // The slow way, by plane and inside test of each triangle.
        double nearest = 1e300;
        Face expected;
        for (std::uint32_t t = 0; t < lists.triangles().size(); ++t) {
            const Point a = lists.corner(t, 0), b = lists.corner(t, 1), c = lists.corner(t, 2);
            const Vector n = glm::cross(b - a, c - a);
            const double along = glm::dot(n, a - ray.origin) / glm::dot(n, ray.direction);
            const Point p = ray.origin + along * ray.direction;
            const bool inside = glm::dot(glm::cross(b - a, p - a), n) >= 0 && glm::dot(glm::cross(c - b, p - b), n) >= 0 &&
                                glm::dot(glm::cross(a - c, p - c), n) >= 0;
            if (!inside || along < 0 || along >= nearest) continue;
            nearest = along;
            expected = lists.face(t);
        }
        const auto hit = pick_face(lists, ray);
        ASSERT_EQ(hit.has_value(), expected.valid());
        if (!hit) continue;
        ++hits;
        EXPECT_EQ(hit->face, expected);
        EXPECT_NEAR(hit->distance, nearest, 1e-9);
    }
    EXPECT_GT(hits, 300);
}

TEST(PickFace, TellsCopiesFromWhatTheyAreOf)
{
    DrawLists lists(cube(), grey); // of edge 1, about the origin
    lists.set_copies({{0.5, {0, 0, 3}, {}}, {2, {10, 0, 0}, {}}});
    const auto own = pick_face(lists, {{0.1, 0.2, -9}, {0, 0, 1}});
    ASSERT_TRUE(own);
    EXPECT_EQ(own->copy, 0u);
    EXPECT_DOUBLE_EQ(own->distance, 8.5);
    const auto above = pick_face(lists, {{0.1, 0.2, 9}, {0, 0, -1}});
    ASSERT_TRUE(above);
    EXPECT_EQ(above->copy, 1u);
    EXPECT_DOUBLE_EQ(above->distance, 5.75);
    EXPECT_LE(glm::distance(above->point, Point(0.1, 0.2, 3.25)), 1e-12);
    const auto beside_it = pick_face(lists, {{0.4, 0.2, 9}, {0, 0, -1}});
    ASSERT_TRUE(beside_it);
    EXPECT_EQ(beside_it->copy, 0u);
    EXPECT_EQ(beside_it->face, above->face); // that which looks up
    const auto large = pick_face(lists, {{-9, 0.7, 0.1}, {1, 0, 0}});
    ASSERT_TRUE(large);
    EXPECT_EQ(large->copy, 2u);
    EXPECT_DOUBLE_EQ(large->distance, 18);
    lists.set_copies({});
    EXPECT_FALSE(pick_face(lists, {{-9, 0.7, 0.1}, {1, 0, 0}}));
}

TEST(PickFace, WorksFarFromTheOrigin)
{
    Mesh mesh = cube();
    const Vector far(3e6, -2e6, 1e6);
    for (const Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v) + far);
    const DrawLists lists(mesh, grey);
    const Camera camera = camera_for(lists, "iso");
    for (const Face f : mesh.faces()) {
        if (glm::dot(unit_normal(mesh, f), camera.backward()) <= 0) continue;
        const Point2 p = *camera.project(vertex_mean(mesh, f));
        EXPECT_EQ(pick_face(lists, camera.ray(p.x, p.y))->face, f);
    }
}

TEST(PickEdge, FindsASideOfTheFaceUnderThePointerWithin8Pixels)
{
    const Mesh mesh = cube();
    const DrawLists lists(mesh, grey);
    for (const bool parallel : {false, true}) {
        Camera camera = camera_for(lists, "iso");
        camera.set_parallel(parallel);
        camera.fit(lists.bounds());
        int seen = 0;
        for (const Edge e : mesh.edges()) {
            const Point a = mesh.position(mesh.ends(e)[0]), b = mesh.position(mesh.ends(e)[1]);
            const auto [f, g] = mesh.faces(e);
            // Both faces are seen: the edge lies in front, not on the outline.
            if (glm::dot(unit_normal(mesh, f), camera.backward()) <= 0 || glm::dot(unit_normal(mesh, g), camera.backward()) <= 0)
                continue;
            ++seen;
            const Point2 p = *camera.project(a), q = *camera.project(b), middle = 0.5 * (p + q);
            const Point2 across = glm::normalize(Point2(q.y - p.y, p.x - q.x));
            for (const double away : {-7.5, 0.0, 7.5}) {
                const Point2 at = middle + away * across;
                EXPECT_EQ(pick_edge(lists, camera, at.x, at.y), std::optional(e));
            }
            const Point2 at = middle + 9.0 * across;
            EXPECT_FALSE(pick_edge(lists, camera, at.x, at.y));
        }
        EXPECT_EQ(seen, 3);
    }
}

TEST(PickEdge, FindsTheOutlineFromBesideTheMesh)
{
    const Mesh mesh = cube();
    const DrawLists lists(mesh, grey);
    const Camera camera = camera_for(lists, "front");
    // In the front view the outline is that of the near face: four edges, 12 in all with the far ones and those between.
    const Point2 right = *camera.project({lists.bounds().max.x, lists.bounds().min.y, lists.bounds().center().z});
    const auto edge = pick_edge(lists, camera, right.x + 5, right.y);
    ASSERT_TRUE(edge);
    for (const Vertex v : mesh.ends(*edge)) {
        EXPECT_DOUBLE_EQ(mesh.position(v).x, lists.bounds().max.x);
        EXPECT_DOUBLE_EQ(mesh.position(v).y, lists.bounds().min.y);
    }
    EXPECT_FALSE(pick_edge(lists, camera, right.x + 9, right.y));
}

TEST(PickEdge, FindsTheEdgesOfAGraph)
{
    const DrawLists lists(Graph{{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, {{0, 1}, {1, 2}}});
    const Camera camera = camera_for(lists, "front");
    const Point2 p = *camera.project({0.5, 0, 0});
    EXPECT_EQ(pick_edge(lists, camera, p.x, p.y + 3), std::optional(Edge(0)));
    const Point2 corner = *camera.project({1, 0, 1});
    EXPECT_EQ(pick_vertex(lists, camera, corner.x + 2, corner.y), std::optional(Vertex(2)));
}

TEST(PickVertex, FindsACornerWithin8PixelsAndNoneBeyond)
{
    const Mesh mesh = octahedron();
    const DrawLists lists(mesh, grey);
    const Camera camera = camera_for(lists, "20,15");
    for (const Vertex v : mesh.vertices()) {
        if (glm::dot(mesh.position(v) - lists.bounds().center(), camera.backward()) < 0.1) continue;
        const Point2 p = *camera.project(mesh.position(v));
        EXPECT_EQ(pick_vertex(lists, camera, p.x + 5, p.y + 5), std::optional(v));
        EXPECT_FALSE(pick_vertex(lists, camera, p.x + 7, p.y + 7)) << "9.9 pixels away";
    }
}

} // namespace
} // namespace druse
