#include "ui/smooth_preview.h"

#include "ui/cube_view.h"

#include "ops/smooth_surface.h"
#include "render/picture.h"
#include "support/folder.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace druse::ui {
namespace {

using namespace test;

/// The coloured cube, shown smooth: level 5, so each face became 4⁵ quads.
class SmoothCube : public CubeView {
protected:
    SmoothCube() { turn_on(); }
    void turn_on()
    {
        view.smooth().set_on(true);
        view.smooth().wait();
    }
    void edit(const std::string& command)
    {
        run(command);
        view.smooth().wait();
    }
    Image picture()
    {
        Image image;
        std::thread([&] { image = Studio().picture(view.shown(), view.camera(), {}, view.overlay(), 0); }).join();
        return image;
    }
    static constexpr std::uint32_t parts = 1024;
};

TEST_F(SmoothCube, ShowsTheLimitSurfaceAndLeavesTheMeshAlone)
{
    ASSERT_TRUE(view.shown().is_divided());
    EXPECT_EQ(view.shown().face_limit(), 6 * parts);
    EXPECT_EQ(session.display().counts, (Counts{8, 12, 6}));
    EXPECT_TRUE(session.display().steps.empty());
    // A corner where three edges meet goes to (9 v + 4 Σ neighbours + Σ opposite corners of the faces) / 24.
    const auto near = [&](const Point& p) {
        return std::ranges::any_of(view.shown().positions(), [&](const Point& q) { return glm::distance(p, q) < 1e-12; });
    };
    for (const double side : {-0.5, 0.5}) EXPECT_TRUE(near({side, 0.5, -0.5}));
}

TEST_F(SmoothCube, KeepsTheColoursOfGroups)
{
    for (const Face f : session.mesh()->faces()) {
        const std::vector<Face> of_face = view.smooth().parts(std::vector<Face>{f});
        EXPECT_EQ(of_face.size(), parts);
        for (const Face part : of_face) ASSERT_EQ(view.shown().group(part), session.mesh()->group(f));
    }
    const std::uint64_t shape = view.shown().shape_version();
    edit("group.assign faces=2 id=9");
    edit("group.color id=9 color=#0000ff");
    edit("select.faces faces=4");
    EXPECT_EQ(view.shown().shape_version(), shape) << "colours do not make a surface anew";
    const Face part = view.smooth().parts(std::vector<Face>{Face(2)}).front();
    EXPECT_EQ(view.shown().group(part), 9);
    const auto last = view.shown().triangles()[view.shown().triangles(part).first][2];
    EXPECT_EQ(view.shown().draw_vertices()[last].look & 0xffffffu, 0xff0000u); // blue is the third byte
    EXPECT_EQ(view.shown().selected().size(), parts);
    EXPECT_TRUE(view.shown().is_selected(view.smooth().parts(std::vector<Face>{Face(4)}).back()));
}

TEST_F(SmoothCube, FollowsEdits)
{
    edit("extrude.cubical faces=1");
    EXPECT_EQ(view.shown().face_limit(), 10 * parts);
    session.undo();
    session.wait();
    view.smooth().wait();
    EXPECT_EQ(view.shown().face_limit(), 6 * parts);
    view.smooth().set_on(false);
    EXPECT_FALSE(view.shown().is_divided());
    edit("extrude.cubical faces=1");
    EXPECT_FALSE(view.shown().is_divided());
}

TEST_F(SmoothCube, LooksTheSameWhereItFollowedAVertexThatMoved)
{
    edit("mesh.transform vertices=0 move=0.1,0.2,-0.1");
    edit("mesh.transform vertices=6 scale=1.2");
    Progress progress;
    const SmoothSurface surface(*session.mesh(), progress);
    EXPECT_TRUE(std::ranges::equal(view.shown().positions(), surface.mesh().positions()));
    for (std::uint32_t i = 0; i < view.shown().draw_vertices().size(); ++i)
        ASSERT_EQ(view.shown().smooth_normals()[i], pack_normal(surface.normals()[view.shown().vertex_of(i)]));
}

TEST_F(SmoothCube, SaysInALineWhyAnOpenModelHasNone)
{
    const Folder folder;
    session.open(folder.write("open.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"));
    session.wait();
    view.smooth().wait();
    EXPECT_FALSE(view.shown().is_divided());
    EXPECT_EQ(view.smooth().reason(), "the model is open: 4 boundary edges");
    EXPECT_EQ(session.message().text, "no smooth preview: the model is open: 4 boundary edges");
    EXPECT_EQ(events.back(), "smooth not possible: the model is open: 4 boundary edges");
    session.open(DRUSE_MODELS "/dodecahedron.obj");
    session.wait();
    view.smooth().wait();
    EXPECT_TRUE(view.smooth().reason().empty());
    EXPECT_TRUE(view.shown().is_divided()) << "it stays on";
    session.start_over();
    session.wait();
    view.smooth().wait();
    EXPECT_FALSE(view.shown().is_divided());
}

TEST_F(SmoothCube, ClicksActOnTheFacesAroundIt)
{
    view.hover(at(200, 200, 0));
    EXPECT_EQ(view.overlay().hovered, view.smooth().parts(std::vector<Face>{Face(2)}));
    EXPECT_EQ(std::ranges::count(view.overlay().lines, 0.0, [](const ThickLine& l) { return l.from.y + 1; }), 4) << "the outline of the face, at y = -1";
    const Point2 corner = *view.camera().project({0.95, -1, 0.95}); // no surface there
    click(corner.x, corner.y);
    EXPECT_EQ(last_step(), "select.faces faces=2");
    arm("group.assign");
    session.set("id", "4");
    view.press(at(200, 200));
    EXPECT_EQ(view.overlay().painted.size(), parts);
    view.release(at(200, 200));
    session.wait();
    EXPECT_EQ(last_step(), "group.assign faces=2 id=4");
}

TEST_F(SmoothCube, SelectedEdgesAndVerticesAreThoseOfTheMesh)
{
    run("select.edges edges=0");
    run("select.vertices vertices=3");
    const Overlay overlay = view.overlay();
    EXPECT_TRUE(overlay.edges.empty() && overlay.vertices.empty()) << "they are none of the surface's";
    EXPECT_EQ(overlay.lines.size(), 2u);
}

TEST_F(SmoothCube, LooksAsItDoesInATerminalAndGoesWithoutATrace)
{
    view.look({30, 25});
    const Image shown = picture();
    Progress progress;
    const SmoothSurface surface(*session.mesh(), progress);
    DrawLists lists;
    const GroupColours colours = [&](int group) { return session.display().groups->colour(group); };
    lists.build(surface.mesh(), colours, Division(*session.mesh(), surface.old_face(), surface.normals()));
    EXPECT_TRUE(fresh_picture(lists, view.camera(), {}, view.overlay()) == shown);

    view.smooth().set_on(false);
    const Image plain = picture();
    EXPECT_GT(pixels_apart(plain, shown, 20), 5000);
    EXPECT_TRUE(fresh_picture(DrawLists(*session.mesh(), colours), view.camera(), {}, view.overlay()) == plain);
    turn_on();
    EXPECT_TRUE(picture() == shown);
}

TEST_F(SmoothCube, WhatTakesLongIsTakenOverWhenItIsThere)
{
    view.smooth().set_on(false);
    run("make.torus nu=160 nv=160");
    std::atomic<bool> woken = false;
    view.smooth().wake = [&] { woken = true; };
    view.smooth().set_on(true);
    if (view.smooth().is_computing()) { // it is not on a fast machine
        EXPECT_FALSE(view.shown().is_divided());
        EXPECT_EQ(session.mesh()->face_count(), 6 + 160 * 160u) << "the session is free";
        run("select.faces faces=none");
        while (!woken) std::this_thread::yield();
        view.smooth().finish();
    }
    EXPECT_FALSE(view.smooth().is_computing());
    EXPECT_EQ(view.shown().face_limit(), 4 * (6 + 160 * 160u)) << "100 000 faces are too many for another level";
    view.smooth().wake = nullptr;
}

} // namespace
} // namespace druse::ui
