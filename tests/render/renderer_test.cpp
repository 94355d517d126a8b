#include "render/renderer.h"

#include "dlfl/measures.h"
#include "dlfl/mesh_builder.h"
#include "render/picture.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace druse {
namespace {

using namespace test;

const Colour blue{0x2b, 0x73, 0xff}, red{0xe5, 0x48, 0x4d}, amber{0xe8, 0xa3, 0x3d}, edge_colour{0x14, 0x15, 0x1a};

/// Bright colours that no two groups share; group 0 is white.
Colour vivid(int group)
{
    static constexpr Colour colours[] = {{255, 255, 255}, {250, 60, 60},  {60, 220, 60}, {90, 90, 250},
                                         {240, 200, 40},  {50, 220, 220}, {230, 70, 220}};
    return colours[group % 7];
}

Style plain()
{
    Style style;
    style.edges = false;
    style.background_top = style.background_bottom = {10, 20, 30};
    return style;
}

Mesh coloured(Mesh mesh)
{
    for (const Face f : mesh.faces()) mesh.set_group(f, 1 + static_cast<int>(f.index % 6));
    return mesh;
}

bool is_seen(const Mesh& mesh, Face f, const Camera& camera)
{
    return glm::dot(unit_normal(mesh, f), camera.eye() - vertex_mean(mesh, f)) > 1e-9;
}

int count(const Image& image, Colour c, int tolerance)
{
    return static_cast<int>(
        std::count_if(image.pixels.begin(), image.pixels.end(), [&](Pixel p) { return is_near(p, c, tolerance); }));
}

class RendererTest : public testing::Test {
protected:
    void TearDown() override { EXPECT_EQ(studio.renderer.error(), 0u) << "OpenGL noted an error"; }
    Studio studio;
};

TEST_F(RendererTest, DrawsEveryVisibleFaceInTheColourOfItsGroup)
{
    for (const Mesh& mesh : {coloured(cube()), coloured(dodecahedron()), coloured(icosahedron())}) {
        const DrawLists lists(mesh, vivid);
        for (const char* view : {"iso", "front", "top", "bottom", "200,-30"})
            for (const bool parallel : {false, true}) {
                Camera camera = camera_at(lists, view);
                camera.set_parallel(parallel);
                camera.fit(lists.bounds());
                for (const auto shading : {Style::Shading::flat, Style::Shading::smooth}) {
                    Style style = plain();
                    style.shading = shading;
                    const Image image = studio.picture(lists, camera, style);
                    int seen = 0;
                    for (const Face f : mesh.faces()) {
                        if (parallel ? glm::dot(unit_normal(mesh, f), camera.backward()) < 0.05 : !is_seen(mesh, f, camera))
                            continue;
                        ++seen;
                        const Pixel p = pixel_at(image, camera, vertex_mean(mesh, f));
                        EXPECT_TRUE(is_shade_of(p, vivid(mesh.group(f)))) << view << ", face " << f.index;
                    }
                    EXPECT_GE(seen, 1);
                }
            }
    }
}

TEST_F(RendererTest, ShowsNoDiagonalOfAFaceHoweverWarpedItIs)
{
    for (const Mesh& mesh :
         {coloured(cube()), coloured(warped_cube()), coloured(dented_cube()), coloured(l_prism()), coloured(prism(9))}) {
        const DrawLists lists(mesh, vivid);
        for (const char* view : {"iso", "60,20"}) {
            const Camera camera = camera_at(lists, view);
            const Image image = studio.picture(lists, camera, plain());
            std::set<std::array<int, 3>> colours;
            for (const Pixel& p : image.pixels) colours.insert({p.red, p.green, p.blue});
            EXPECT_LE(colours.size(), mesh.face_count() + 1) << "one colour for each face, and the background";
            EXPECT_GE(colours.size(), 3u);
        }
    }
}

TEST_F(RendererTest, DrawsTheSidesOfFacesButNotTheirDiagonals)
{
    for (const Mesh& mesh : {coloured(cube()), coloured(warped_cube())}) {
        const DrawLists lists(mesh, vivid);
        const Camera camera = camera_at(lists, "iso");
        for (const auto method : {Style::EdgeMethod::surface, Style::EdgeMethod::lines}) {
            Style style = plain();
            style.edges = true;
            style.edge_method = method;
            const Image image = studio.picture(lists, camera, style);
            int edges = 0;
            for (const Edge e : mesh.edges()) {
                if (!is_seen(mesh, mesh.faces(e)[0], camera) || !is_seen(mesh, mesh.faces(e)[1], camera)) continue;
                ++edges;
                for (const double t : {0.25, 0.5, 0.75}) {
                    // A line one pixel wide lies in the pixel of its point or in the next.
                    const Point2 at =
                        *camera.project(glm::mix(mesh.position(mesh.ends(e)[0]), mesh.position(mesh.ends(e)[1]), t));
                    int darkest = 999;
                    for (int dy = -1; dy <= 1; ++dy)
                        for (int dx = -1; dx <= 1; ++dx) {
                            const Pixel p = image.at(static_cast<int>(at.x) + dx, static_cast<int>(at.y) + dy);
                            darkest = std::min(darkest, p.red + p.green + p.blue);
                        }
                    EXPECT_LT(darkest, 130) << "edge " << e.index;
                }
            }
            EXPECT_EQ(edges, 3);
            for (const Face f : mesh.faces()) {
                if (!is_seen(mesh, f, camera)) continue;
                EXPECT_TRUE(is_shade_of(pixel_at(image, camera, vertex_mean(mesh, f)), vivid(mesh.group(f))))
                    << "face " << f.index;
                for (const auto& [i, j] : {std::pair(0, 2), std::pair(1, 3)}) {
                    const Point a = mesh.position(mesh.corner(f, i)), b = mesh.position(mesh.corner(f, j));
                    for (const double t : {0.3, 0.5, 0.7})
                        EXPECT_TRUE(is_shade_of(pixel_at(image, camera, glm::mix(a, b, t)), vivid(mesh.group(f))));
                }
            }
        }
    }
}

TEST_F(RendererTest, OutlinesAPressedFaceOverEverything)
{
    const Mesh mesh = coloured(cube());
    const DrawLists lists(mesh, vivid);
    const Camera camera = camera_at(lists, "iso");
    const Image before = studio.picture(lists, camera);
    EXPECT_EQ(count(before, blue, 8), 0);
    for (const Face f : mesh.faces()) {
        Overlay overlay;
        overlay.pressed = {f};
        const Image image = studio.picture(lists, camera, {}, overlay);
        for (const Corner c : mesh.corners(f)) {
            const Point middle = 0.5 * (mesh.position(c) + mesh.position(mesh.next(c)));
            EXPECT_TRUE(is_near(pixel_at(image, camera, middle), blue, 8)) << "face " << f.index << ", seen or hidden";
        }
        const Pixel tinted = pixel_at(image, camera, vertex_mean(mesh, f)), bare = pixel_at(before, camera, vertex_mean(mesh, f));
        if (is_seen(mesh, f, camera))
            EXPECT_FALSE(tinted == bare);
        else
            EXPECT_TRUE(tinted == bare);
    }
    EXPECT_TRUE(studio.picture(lists, camera) == before) << "released, nothing is left of it";
}

TEST_F(RendererTest, DrawsAnOutlineThreePixelsWide)
{
    const Mesh mesh = cube();
    const DrawLists lists(mesh, vivid);
    const Camera camera = camera_at(lists, "front");
    Overlay overlay;
    for (const Face f : mesh.faces())
        if (unit_normal(mesh, f).y < -0.5) overlay.pressed = {f};
    const Image image = studio.picture(lists, camera, plain(), overlay);
    const Box box = lists.bounds();
    const Point2 side = *camera.project({box.min.x, box.min.y, box.center().z});
    double cover = 0; // of blue across the left side of the square, in pixels
    for (int x = static_cast<int>(side.x) - 8; x < static_cast<int>(side.x) + 8; ++x) {
        const Pixel p = image.at(x, static_cast<int>(side.y));
        cover += is_near(p, blue, 3) ? 1.0 : p.blue > p.red + 60 && x < side.x ? (p.blue - 30) / 225.0 : 0.0;
    }
    EXPECT_GE(cover, 2.0);
    EXPECT_LE(cover, 4.0);
}

TEST_F(RendererTest, MarksFailedFacesInRedAndBoundariesInAmber)
{
    const Mesh mesh = open_tube(6);
    const DrawLists lists(mesh, vivid);
    const Camera camera = camera_at(lists, "10,30");
    const Image image = studio.picture(lists, camera);
    EXPECT_GT(count(image, amber, 12), 100);
    EXPECT_EQ(count(image, red, 8), 0);
    Overlay overlay;
    overlay.failed = {Face(0)};
    EXPECT_GT(count(studio.picture(lists, camera, {}, overlay), red, 8), 50);
    const DrawLists closed(prism(6), vivid);
    EXPECT_EQ(count(studio.picture(closed, camera_at(closed, "10,30")), amber, 12), 0);
}

TEST_F(RendererTest, TintsSelectedFacesAndDotsSelectedVertices)
{
    const Mesh mesh = cube();
    DrawLists lists(mesh, vivid);
    const Camera camera = camera_at(lists, "iso");
    const Image before = studio.picture(lists, camera, plain());
    Face seen, other;
    for (const Face f : mesh.faces())
        if (is_seen(mesh, f, camera)) (seen.valid() ? other : seen) = f;
    lists.select(std::array{seen});
    const Image selected = studio.picture(lists, camera, plain());
    const Pixel p = pixel_at(selected, camera, vertex_mean(mesh, seen));
    EXPECT_GT(p.blue, p.red + 30) << "white turned bluish";
    EXPECT_TRUE(pixel_at(selected, camera, vertex_mean(mesh, other)) == pixel_at(before, camera, vertex_mean(mesh, other)));

    lists.select({});
    Overlay overlay;
    for (const Vertex v : mesh.vertices()) overlay.vertices.push_back(v);
    for (const Edge e : mesh.edges()) overlay.edges.push_back(e);
    const Image dotted = studio.picture(lists, camera, plain(), overlay);
    Point nearest = mesh.position(Vertex(0));
    for (const Vertex v : mesh.vertices())
        if (glm::distance(mesh.position(v), camera.eye()) < glm::distance(nearest, camera.eye())) nearest = mesh.position(v);
    EXPECT_TRUE(is_near(pixel_at(dotted, camera, nearest), blue, 3));
}

TEST_F(RendererTest, FillsTheBackground)
{
    const DrawLists nothing;
    Camera camera;
    camera.resize(64, 200);
    const Image gradient = studio.picture(nothing, camera);
    for (int x = 0; x < 64; ++x) {
        EXPECT_TRUE(is_near(gradient.at(x, 0), {0x2e, 0x31, 0x36}, 1));
        EXPECT_TRUE(is_near(gradient.at(x, 199), {0x1e, 0x20, 0x23}, 1));
        EXPECT_TRUE(gradient.at(x, 100) == gradient.at(0, 100)) << "it runs from top to bottom only";
    }
    const Image solid = studio.picture(nothing, camera, plain());
    EXPECT_TRUE(std::all_of(solid.pixels.begin(), solid.pixels.end(), [](Pixel p) { return p == Pixel{10, 20, 30, 255}; }));
}

TEST_F(RendererTest, LeavesATransparentBackgroundEmptyAndItsRimClean)
{
    const Mesh mesh = coloured(cube());
    const DrawLists lists(mesh, [](int) { return Colour{200, 100, 50}; });
    const Camera camera = camera_at(lists, "iso");
    Style style = plain();
    style.transparent_background = true;
    for (const int samples : {0, 4}) {
        const Image image = studio.picture(lists, camera, style, {}, samples);
        EXPECT_TRUE(image.at(0, 0) == (Pixel{0, 0, 0, 0}));
        EXPECT_TRUE(image.at(319, 239) == (Pixel{0, 0, 0, 0}));
        EXPECT_EQ(image.at(160, 120).alpha, 255);
        int between = 0;
        for (const Pixel& p : image.pixels) {
            between += p.alpha != 0 && p.alpha != 255;
            if (p.alpha == 0) continue;
            EXPECT_NEAR(p.red, 2.0 * p.green, 8) << "no background is mixed in";
            EXPECT_GT(p.red, 60);
        }
        if (samples == 0)
            EXPECT_EQ(between, 0);
        else
            EXPECT_GT(between, 100);
    }
}

TEST_F(RendererTest, ShowsTheInsideOfAnOpenSurfaceAndOfAClosedOneOnlyWhenAsked)
{
    const Mesh tube = open_tube(12);
    const DrawLists lists(tube, vivid);
    const Camera camera = camera_at(lists, "0,35");
    const Image image = studio.picture(lists, camera, plain());
    // The far wall is seen from its inside, over the near rim.
    const Box box = lists.bounds();
    EXPECT_FALSE(is_near(pixel_at(image, camera, {0, box.max.y - 1e-6, box.max.z - 0.3 * box.size().z}), {10, 20, 30}, 3));

    const DrawLists closed(cube(), vivid);
    Camera inside = camera_at(closed, "front");
    inside.set_target(closed.bounds().center() + Vector(0, 5, 0));
    inside.set_distance(5); // the eye is in the middle of the cube
    Style style = plain();
    EXPECT_TRUE(is_near(studio.picture(closed, inside, style).at(160, 120), {10, 20, 30}, 0));
    style.back_faces = true;
    EXPECT_FALSE(is_near(studio.picture(closed, inside, style).at(160, 120), {10, 20, 30}, 3));
}

TEST_F(RendererTest, LetsFacesShowWhatIsBehindThemAndWireframesEverything)
{
    const Mesh mesh = coloured(cube());
    const DrawLists lists(mesh, vivid);
    const Camera camera = camera_at(lists, "iso");
    Style style = plain();
    style.see_through = true;
    const Image through = studio.picture(lists, camera, style);
    EXPECT_FALSE(is_near(through.at(160, 120), {10, 20, 30}, 3));
    EXPECT_FALSE(through == studio.picture(lists, camera, plain()));
    style = plain();
    style.wireframe = true;
    const Image wires = studio.picture(lists, camera, style);
    EXPECT_GT(count(wires, {0xc8, 0xcc, 0xd4}, 3), 500);
    for (const Face f : mesh.faces())
        if (is_seen(mesh, f, camera)) {
            // Not on the line to a corner, along which hidden edges are seen in this view.
            const Corner c = mesh.corner(f);
            const Point p = glm::mix(vertex_mean(mesh, f), 0.5 * (mesh.position(c) + mesh.position(mesh.next(c))), 0.5);
            EXPECT_TRUE(is_near(pixel_at(wires, camera, p), {10, 20, 30}, 0)) << "nothing between the edges";
        }
}

TEST_F(RendererTest, DrawsAGraphAsLines)
{
    const DrawLists lists(Graph{{{0, 0, 0}, {4, 0, 0}, {4, 0, 3}}, {{0, 1}, {1, 2}}});
    const Camera camera = camera_at(lists, "front");
    const Image image = studio.picture(lists, camera, plain());
    EXPECT_GT(count(image, {0xc8, 0xcc, 0xd4}, 3), 200);
    Style white = plain();
    white.background_top = white.background_bottom = {255, 255, 255};
    EXPECT_GT(count(studio.picture(lists, camera, white), edge_colour, 3), 200) << "dark lines on a bright ground";
}

TEST_F(RendererTest, DoesNotJitterFarFromTheOrigin)
{
    const Mesh here = coloured(dodecahedron());
    Mesh there = here;
    // So far that single precision would move the vertices by a quarter.
    const Vector far(4194304, -2097152, 1048576);
    for (const Vertex v : there.vertices()) there.set_position(v, there.position(v) + far);
    const DrawLists near_lists(here, vivid), far_lists(there, vivid);
    const Image a = studio.picture(near_lists, camera_at(near_lists, "iso"));
    const Image b = studio.picture(far_lists, camera_at(far_lists, "iso"));
    EXPECT_LE(pixels_apart(a, b, 2), 20);
}

TEST_F(RendererTest, FadesEdgesThatAreTooShortToTellApart)
{
    const Mesh mesh = torus(200, 150);
    const DrawLists lists(mesh, vivid);
    Camera camera = camera_at(lists, "iso", 160, 120);
    Style with = plain(), without = plain();
    with.edges = true;
    EXPECT_TRUE(studio.picture(lists, camera, with) == studio.picture(lists, camera, without));
    with.fade_edges = false;
    EXPECT_FALSE(studio.picture(lists, camera, with) == studio.picture(lists, camera, without)) << "unless asked not to";
    with.fade_edges = true;
    camera.zoom(8, 80, 60);
    EXPECT_FALSE(studio.picture(lists, camera, with) == studio.picture(lists, camera, without)) << "nearby they are seen";
}

TEST_F(RendererTest, GivesTheSameBytesWheneverItIsRepeated)
{
    const Mesh mesh = coloured(torus(30, 20));
    const DrawLists lists(mesh, vivid);
    const Camera camera = camera_at(lists, "iso");
    Overlay overlay;
    overlay.pressed = {Face(40)};
    const Image first = studio.picture(lists, camera, {}, overlay, 4);
    studio.picture(lists, camera_at(lists, "top", 100, 90));
    EXPECT_TRUE(studio.picture(lists, camera, {}, overlay, 4) == first);
    EXPECT_TRUE(fresh_picture(DrawLists(mesh, vivid), camera, {}, overlay, 4) == first);
}

TEST_F(RendererTest, DrawsEveryShapeInEveryStyle)
{
    for (const NamedShape& shape : all_shapes()) {
        SCOPED_TRACE(shape.name);
        const Mesh mesh = shape.make();
        const DrawLists lists(mesh, vivid);
        const Camera camera = camera_at(lists, "iso", 80, 60);
        for (int bits = 0; bits < 64; ++bits) {
            Style style;
            style.shading = bits & 1 ? Style::Shading::smooth : Style::Shading::flat;
            style.edges = bits & 2;
            style.wireframe = bits & 4;
            style.see_through = bits & 8;
            style.back_faces = bits & 16;
            style.edge_method = bits & 32 ? Style::EdgeMethod::lines : Style::EdgeMethod::surface;
            studio.picture(lists, camera, style);
        }
    }
}

TEST_F(RendererTest, ShowsItsPictureInAnotherFramebuffer)
{
    Camera camera;
    camera.resize(16, 16); // the size of an off-screen context's own framebuffer
    for (const int samples : {0, 4}) {
        studio.renderer.draw(DrawLists(cube(), vivid), camera, {}, {}, samples);
        studio.renderer.present(0);
        EXPECT_EQ(studio.renderer.error(), 0u);
    }
}

TEST_F(RendererTest, ShowsPaintedFacesAsIfTheirGroupHadThatColour)
{
    const Mesh mesh = coloured(torus(12, 8));
    Overlay overlay;
    overlay.painted = {Face(3), Face(4), Face(5), Face(40), Face(41), Face(77)};
    overlay.paint = {30, 200, 120};
    Mesh painted = mesh;
    for (const Face f : overlay.painted) painted.set_group(f, 99);
    DrawLists lists(mesh, vivid), expected(painted, [&](int group) { return group == 99 ? overlay.paint : vivid(group); });
    lists.select(std::vector<Face>{Face(41)});
    expected.select(std::vector<Face>{Face(41)});
    const Camera camera = camera_at(lists, "iso");
    for (int bits = 0; bits < 8; ++bits) {
        Style style = plain();
        style.shading = bits & 1 ? Style::Shading::smooth : Style::Shading::flat;
        style.edges = bits & 2;
        style.edge_method = bits & 4 ? Style::EdgeMethod::lines : Style::EdgeMethod::surface;
        for (const int samples : {0, 4}) {
            const Image before = studio.picture(lists, camera, style, {}, samples), image = studio.picture(lists, camera, style, overlay, samples);
            EXPECT_FALSE(image == before) << bits;
            EXPECT_TRUE(image == studio.picture(expected, camera, style, {}, samples)) << bits;
        }
    }
}

TEST_F(RendererTest, DrawsCopiesAsIfTheyWereInTheMesh)
{
    const Mesh mesh = coloured(torus(12, 8));
    const std::vector<DrawLists::Copy> copies{{0.5, {2, 1, 0}, {30, 200, 120}}, {1.5, {-4, 0, -2}, {200, 30, 120}}};
    MeshBuilder builder;
    for (std::size_t k = 0; k <= copies.size(); ++k) {
        for (const Vertex v : mesh.vertices()) builder.add_vertex(k == 0 ? mesh.position(v) : copies[k - 1].at(mesh.position(v)));
        for (const Face f : mesh.faces()) {
            std::vector<std::uint32_t> face;
            for (const Corner c : mesh.corners(f)) face.push_back(mesh.vertex(c).index + std::uint32_t(k) * mesh.vertex_count());
            builder.add_face(face, k == 0 ? mesh.group(f) : 99 + int(k));
        }
    }
    const DrawLists expected(builder.build(), [&](int group) { return group > 99 ? copies[std::size_t(group) - 100].colour : vivid(group); });
    DrawLists lists(mesh, vivid);
    lists.set_copies(copies);
    EXPECT_LE(glm::distance(lists.with_copies(lists.bounds()).min, expected.bounds().min), 1e-12);
    EXPECT_LE(glm::distance(lists.with_copies(lists.bounds()).max, expected.bounds().max), 1e-12);
    const Camera camera = camera_at(expected, "iso");
    for (int bits = 0; bits < 4; ++bits) {
        Style style = plain();
        style.shading = bits & 1 ? Style::Shading::smooth : Style::Shading::flat;
        style.wireframe = bits & 2;
        style.fade_edges = false;
        const Image image = studio.picture(lists, camera, style);
        EXPECT_LE(pixels_apart(image, studio.picture(expected, camera, style), 8), 40) << bits; // of 76800: where sides round to another pixel
    }
    // Edges are those of the mesh alone.
    for (const Style::EdgeMethod method : {Style::EdgeMethod::lines, Style::EdgeMethod::surface}) {
        Style style = plain();
        style.edges = true;
        style.fade_edges = false;
        style.edge_method = method;
        const DrawLists alone(mesh, vivid);
        const auto edges = [&](const DrawLists& of) { return count(studio.picture(of, camera, style), edge_colour, 2); };
        EXPECT_GT(edges(alone), 100);
        EXPECT_LE(edges(lists), edges(alone)); // a copy may be before it
        EXPECT_GT(edges(lists), edges(alone) / 2);
    }
    // They are drawn anew when they alone change.
    const Image before = studio.picture(lists, camera, plain());
    lists.set_copies({copies[0]});
    EXPECT_GT(pixels_apart(before, studio.picture(lists, camera, plain()), 8), 1000);
}

TEST_F(RendererTest, DrawsOutlinesAroundADividedMeshWhole)
{
    // A small cube that stands for a large one.
    Mesh small = cube();
    for (const Vertex v : small.vertices()) small.set_position(v, 0.1 * small.position(v));
    DrawLists lists;
    lists.build(small, vivid, Division(cube(), {0, 1, 2, 3, 4, 5}));
    const Mesh large = cube();
    const DrawLists whole(large, vivid);
    const Camera camera = camera_at(whole, "iso");
    Overlay overlay;
    for (const Edge e : large.edges()) {
        const auto [a, b] = large.ends(e);
        overlay.lines.push_back({large.position(a), large.position(b), overlay.highlight, 3, 1});
    }
    const Image image = studio.picture(lists, camera, plain(), overlay);
    for (const Edge e : large.edges()) {
        const auto [a, b] = large.ends(e);
        EXPECT_TRUE(is_near(pixel_at(image, camera, glm::mix(large.position(a), large.position(b), 0.3)), blue, 8)) << e.index;
    }
}

TEST_F(RendererTest, IsDestroyedInPeaceAfterItsContext)
{
    std::thread([] {
        std::optional<Renderer> renderer;
        {
            const OffscreenContext context;
            renderer.emplace(context.loader());
            renderer->draw(DrawLists(cube(), vivid), Camera(), {}, {}, 0);
            renderer->forget_context();
        }
        const OffscreenContext next;
        Renderer other(next.loader()); // its objects have the names that the old ones had
        const DrawLists lists(cube(), vivid);
        other.draw(lists, camera_at(lists, "iso"), {}, {}, 0);
        const Image before = other.read_image();
        renderer.reset();
        other.draw(lists, camera_at(lists, "top"), {}, {}, 0);
        other.draw(lists, camera_at(lists, "iso"), {}, {}, 0);
        EXPECT_TRUE(other.read_image() == before);
    }).join();
}

TEST_F(RendererTest, KnowsASoftwareDriver)
{
    EXPECT_TRUE(studio.renderer.is_software()) << studio.renderer.driver();
}

} // namespace
} // namespace druse
