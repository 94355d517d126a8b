// Our subdivision against OpenSubdiv's, and limit surfaces against what is known of them.
#include "ops/remesh_limit.h"

#include "ops/remesh_catmull_clark.h"
#include "ops/remesh_loop.h"
#include "ops/smooth_surface.h"
#include "remesh_models.h"

#include <algorithm>
#include <cmath>

namespace druse {
namespace {

using namespace test;

Mesh limit(const Mesh& mesh, LimitSurface surface)
{
    Progress progress;
    return limit_surface(mesh, surface, progress);
}

void expect_same_points(const Mesh& a, const Mesh& b, double tolerance)
{
    ASSERT_EQ(counts(a), counts(b));
    EXPECT_EQ(rings(a), rings(b));
    for (const Vertex v : a.vertices()) ASSERT_LT(glm::distance(a.position(v), b.position(v)), tolerance) << "vertex " << v.index;
}

TEST(RemeshLimit, AgreesWithCatmullAndClarkOnEveryModelAfterThreeLevels)
{
    for (const Input& input : remeshed_models) {
        SCOPED_TRACE(input.name);
        const Mesh old = input.make();
        expect_same_points(made_of(old, "remesh.catmull_clark", {{"iterations", "3"}}), limit(old, {.level = 3, .to_limit = false}), 1e-12);
    }
}

TEST(RemeshLimit, AgreesWithLoopOnEveryModelOfTrianglesAfterThreeLevels)
{
    for (const Input& input : remeshed_models) {
        SCOPED_TRACE(input.name);
        const Mesh old = made_of(input.make(), "remesh.triangulate");
        expect_same_points(made_of(old, "remesh.loop", {{"iterations", "3"}}), limit(old, {.scheme = LimitScheme::loop, .level = 3, .to_limit = false}), 1e-12);
    }
}

TEST(RemeshLimit, IsWhereFurtherLevelsLead)
{
    // A vertex of one level is a vertex of all that follow; what is left to go shrinks to a quarter with each.
    for (const LimitScheme scheme : {LimitScheme::catmull_clark, LimitScheme::loop}) {
        const Mesh old = icosahedron(), at_limit = limit(old, {.scheme = scheme, .level = 1}), further = limit(old, {.scheme = scheme, .level = 5, .to_limit = false});
        for (const Vertex v : at_limit.vertices()) EXPECT_LT(glm::distance(at_limit.position(v), further.position(v)), 2e-3);
        const Mesh limit_further = limit(old, {.scheme = scheme, .level = 4});
        for (const Vertex v : at_limit.vertices()) EXPECT_LT(glm::distance(at_limit.position(v), limit_further.position(v)), 1e-12);
    }
}

TEST(RemeshLimit, HalvesTheDistanceOfTheCubesCorners)
{
    // Limit of a vertex of valence m after one level (Halstead, Kass & DeRose 1993): (m² v + 4 Σ e + Σ f)/(m (m + 5)), with e and f its neighbours and
    // the corners opposite it in the quads. For the cube of side 2 one level gives v = (5/9, 5/9, 5/9), e = (0, 3/4, 3/4), f = (1, 0, 0)…:
    // (9·5/9 + 4·2·3/4 + 1)/(3·8) = 12/24.
    Scene scene;
    run(scene, "make.cube", {{"size", "2"}});
    run(scene, "remesh.subdivide_limit", {{"level", "1"}});
    for (std::uint32_t v = 0; v < 8; ++v)
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(std::abs(scene.mesh.position(Vertex(v))[i]), 0.5, 1e-14);
}

TEST(RemeshLimit, LeavesACubeOfSharpEdgesACube)
{
    const Mesh mesh = made_of(cube(), "remesh.subdivide_limit", {{"crease", "all"}, {"level", "3"}});
    EXPECT_NEAR(volume(mesh), 1.0, 0.02); // faces are flat, edges stay, though corners of three sharp edges hold too
    EXPECT_NEAR(bounds(mesh).size().x, 1.0, 1e-12);
    const double smooth = volume(made_of(cube(), "remesh.subdivide_limit", {{"level", "3"}}));
    const double half = volume(made_of(cube(), "remesh.subdivide_limit", {{"crease", "all"}, {"sharpness", "1"}, {"level", "3"}}));
    EXPECT_LT(smooth, half);
    EXPECT_LT(half, volume(mesh));
    // Four edges round the lid make a sharp rim in the plane of the lid.
    const Mesh rim = made_of(cube(), "remesh.subdivide_limit", {{"crease", "0~1+1~2+2~3+0~3"}, {"level", "3"}});
    EXPECT_SOUND(rim);
}

TEST(RemeshLimit, KeepsGroupsAndNumbersAsTheSchemesDo)
{
    Mesh old = edited_torus();
    for (const Face f : old.faces()) old.set_group(f, 1 + int(f.index));
    const Mesh mesh = made_of(old, "remesh.subdivide_limit", {{"level", "1"}});
    const Mesh divided = made_of(old, "remesh.linear", {{"groups", "keep"}});
    EXPECT_EQ(rings(mesh), rings(divided));
    EXPECT_EQ(groups(mesh), groups(divided));
    EXPECT_EQ(groups(made_of(old, "remesh.subdivide_limit", {{"groups", "none"}})), std::vector<int>(8 * old.edge_count(), 0));
}

TEST(RemeshLimit, OfNothingIsNothing) { EXPECT_EQ(counts(made_of(Mesh(), "remesh.subdivide_limit")), Counts()); }

TEST(RemeshLimit, SaysWhatItCannotUse)
{
    EXPECT_EQ(complaint(scene_of(cube()), "remesh.subdivide_limit", {{"scheme", "loop"}}), "face 0 has 4 sides; scheme=loop wants triangles");
    EXPECT_EQ(complaint(scene_of(open_grid(3, 2)), "remesh.subdivide_limit"), "the model is open: 10 boundary edges");
    Scene many;
    run(many, "make.cube");
    run(many, "remesh.linear", {{"iterations", "4"}});
    EXPECT_EQ(complaint(std::move(many), "remesh.subdivide_limit", {{"level", "8"}}), "would make 201326592 edges, more than 20 million"); // 12·4¹²
}

TEST(SmoothSurface, KnowsWhichFaceEachPartIsOf)
{
    for (Mesh mesh : {cube(), l_prism(), torus(20, 9), prism(50)}) {
        for (const Face f : mesh.faces()) mesh.set_group(f, 1 + int(f.index));
        Progress progress;
        const SmoothSurface surface = smooth_surface(mesh, progress);
        ASSERT_EQ(surface.old_face.size(), surface.mesh.face_count());
        const std::size_t faces = surface.mesh.face_count();
        EXPECT_LE(faces, 100'000u);
        EXPECT_TRUE(4 * faces > 100'000 || faces == 2 * mesh.edge_count() * 256) << "as fine as may be, up to level 5";
        for (const Face part : surface.mesh.faces()) ASSERT_EQ(surface.mesh.group(part), 1 + int(surface.old_face[part.index]));
        EXPECT_TRUE(std::ranges::is_sorted(surface.old_face));
    }
}

TEST(SmoothSurface, OfAModelOfVeryManyFacesHasNoMoreOfThem)
{
    const Mesh mesh = l_prism();
    Progress progress;
    const SmoothSurface surface = smooth_surface(mesh, progress, 10);
    EXPECT_EQ(rings(surface.mesh), rings(mesh));
    EXPECT_EQ(surface.old_face, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
    const Mesh fine = limit(mesh, {.level = 2});
    for (const Vertex v : mesh.vertices()) EXPECT_LT(glm::distance(surface.mesh.position(v), fine.position(v)), 1e-12);
    EXPECT_LT(bounds(surface.mesh).size().x, 0.9 * bounds(mesh).size().x);
}

} // namespace
} // namespace druse
