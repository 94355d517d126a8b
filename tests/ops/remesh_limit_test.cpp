// Our subdivision against OpenSubdiv's, and limit surfaces against what is known of them.
#include "ops/remesh_limit.h"

#include "dlfl/mesh_tables.h"
#include "ops/remesh_catmull_clark.h"
#include "ops/remesh_loop.h"
#include "ops/smooth_surface.h"
#include "remesh_models.h"

#include <algorithm>
#include <cmath>
#include <random>

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

// --- normals ----------------------------------------------------------------------------------------------------------------------

struct Normals {
    Mesh mesh;
    std::vector<Vector> of; // by vertex
};
Normals with_normals(const Mesh& mesh, const LimitSurface& surface)
{
    Progress progress;
    LimitRefinement refinement(mesh, surface, progress);
    refinement.place_with_normals(mesh.positions());
    const std::vector<Vector> normals = refinement.normals();
    return {std::move(refinement).take(), normals};
}

/// Every vertex a little elsewhere.
Mesh shaken(Mesh mesh, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-0.1, 0.1);
    for (Point& p : mesh.write_positions()) p += Vector(shift(random), shift(random), shift(random));
    return mesh;
}

TEST(LimitNormals, OfQuadsFourAtEachVertexAreThoseOfTheBicubicSpline)
{
    // Uniform cubic B-splines are 1/6, 4/6, 1/6 at a knot, and their slopes −1/2, 0, 1/2; vertices of the first level are those of the mesh.
    const Mesh old = shaken(torus(9, 7), 1);
    const auto [mesh, normals] = with_normals(old, {.level = 1});
    for (const Vertex v : old.vertices()) {
        Point side[4], corner[4]; // across an edge, and across the face after it
        int i = 0;
        for (const Corner c : old.around(v)) {
            side[i] = old.position(old.next(c));
            corner[i++] = old.position(old.next(old.next(c)));
        }
        ASSERT_EQ(i, 4);
        const Vector u = 4.0 * (side[0] - side[2]) + (corner[0] - corner[1]) + (corner[3] - corner[2]);
        const Vector w = 4.0 * (side[1] - side[3]) + (corner[0] - corner[3]) + (corner[1] - corner[2]);
        const Vector expected = unit(glm::cross(u, w));
        const Point place = (16.0 * old.position(v) + 4.0 * (side[0] + side[1] + side[2] + side[3]) + corner[0] + corner[1] + corner[2] + corner[3]) / 36.0;
        EXPECT_LT(glm::distance(normals[v.index], expected), 1e-13);
        EXPECT_LT(glm::distance(mesh.position(v), place), 1e-14);
    }
}

TEST(LimitNormals, AreSquareToTheSurfaceAlsoWhereOtherThanFourEdgesMeet)
{
    // The quads, or triangles, around a vertex shrink towards the tangent plane there: so does their mean normal to the limit normal.
    const auto farthest = [](const Mesh& old, LimitScheme scheme, int level) {
        const auto [mesh, normals] = with_normals(old, {.scheme = scheme, .level = level});
        double most = 0;
        for (const Vertex v : old.vertices()) { // which are extraordinary, if any are
            Vector sum(0.0);
            for (const Corner c : mesh.around(v)) sum += glm::cross(mesh.position(mesh.next(c)) - mesh.position(c), mesh.position(mesh.previous(c)) - mesh.position(c));
            EXPECT_NEAR(glm::length(normals[v.index]), 1, 1e-14);
            most = std::max(most, glm::distance(unit(sum), normals[v.index]));
        }
        return most;
    };
    for (const Mesh& mesh : {cube(), octahedron(), dodecahedron(), prism(7), l_prism()}) {
        const Mesh old = shaken(mesh, 2);
        const double coarse = farthest(old, LimitScheme::catmull_clark, 2), fine = farthest(old, LimitScheme::catmull_clark, 6);
        EXPECT_LT(fine, 0.02);
        EXPECT_LT(fine, 0.5 * coarse + 1e-9);
    }
    for (const Mesh& mesh : {tetrahedron(), octahedron(), icosahedron(), made_of(prism(7), "remesh.triangulate")}) {
        const Mesh old = shaken(mesh, 3);
        const double coarse = farthest(old, LimitScheme::loop, 2), fine = farthest(old, LimitScheme::loop, 6);
        EXPECT_LT(fine, 0.02);
        EXPECT_LT(fine, 0.5 * coarse + 1e-9);
    }
}

TEST(LimitNormals, OfASphereOfManyFacesLookAwayFromItsMiddle)
{
    const Mesh mesh = made_of(icosahedron(), "remesh.subdivide_limit", {{"scheme", "loop"}, {"level", "3"}});
    const auto [finer, normals] = with_normals(mesh, {.level = 1});
    for (const Vertex v : finer.vertices()) EXPECT_GT(glm::dot(normals[v.index], unit(finer.position(v))), 0.99);
}

TEST(LimitNormals, AtCreasesAreTheMeanOfTheFacesAround)
{
    LimitSurface surface{.level = 3};
    const Mesh box = cube();
    for (const Edge e : box.edges()) surface.creases.push_back(e);
    const auto [mesh, normals] = with_normals(box, surface);
    for (const Vertex v : mesh.vertices()) {
        const Point p = mesh.position(v);
        Vector expected(0.0); // of a cube: the sum of the normals of the faces that a point lies in
        for (int i = 0; i < 3; ++i)
            if (std::abs(p[i]) > 0.5 - 1e-9) expected[i] = std::copysign(1.0, p[i]);
        EXPECT_LT(glm::distance(normals[v.index], unit(expected)), 1e-9) << p.x << ' ' << p.y << ' ' << p.z;
    }
}

TEST(LimitNormals, AreThereWhereTheTangentsHaveNoArea)
{
    // A flat mesh folded on itself, whose rim has no tangent plane of its own, and one that is a single point.
    for (const double size : {1.0, 0.0}) {
        Mesh flat = dihedron(5);
        for (Point& p : flat.write_positions()) p *= size;
        const auto [mesh, normals] = with_normals(flat, {.level = 2});
        for (const Vector& n : normals) EXPECT_TRUE(n == Vector(0.0) || std::abs(glm::length(n) - 1) < 1e-12);
        EXPECT_EQ(normals.size(), mesh.vertex_limit());
    }
}

TEST(LimitRefinement, MovesItsPointsWithThoseOfTheMeshToTheBit)
{
    Progress progress;
    for (const LimitScheme scheme : {LimitScheme::catmull_clark, LimitScheme::loop}) {
        const Mesh old = scheme == LimitScheme::loop ? with_turned_starts(icosahedron()) : edited_torus();
        const LimitSurface surface{.scheme = scheme, .level = 2, .creases = {Edge(3), Edge(4)}, .sharpness = 1.5};
        LimitRefinement refinement(old, surface, progress);
        for (const unsigned seed : {4u, 5u, 6u}) {
            const Mesh moved = shaken(old, seed);
            if (seed == 5) refinement.place_with_normals(moved.positions());
            else refinement.place(moved.positions());
            EXPECT_TRUE(refinement.mesh() == limit_surface(moved, surface, progress));
        }
    }
}

// --- as a preview shows it --------------------------------------------------------------------------------------------------------

TEST(SmoothSurface, KnowsWhichFaceEachPartIsOf)
{
    for (Mesh mesh : {cube(), l_prism(), torus(20, 9), prism(50)}) {
        for (const Face f : mesh.faces()) mesh.set_group(f, 1 + int(f.index));
        Progress progress;
        const SmoothSurface surface(mesh, progress);
        ASSERT_EQ(surface.old_face().size(), surface.mesh().face_count());
        const std::size_t faces = surface.mesh().face_count();
        EXPECT_LE(faces, 100'000u);
        EXPECT_TRUE(4 * faces > 100'000 || faces == 2 * mesh.edge_count() * 256) << "as fine as may be, up to level 5";
        for (const Face part : surface.mesh().faces()) ASSERT_EQ(surface.mesh().group(part), 1 + int(surface.old_face()[part.index]));
        EXPECT_TRUE(std::ranges::is_sorted(surface.old_face()));
    }
}

TEST(SmoothSurface, FollowsAMeshAsIfMadeAnew)
{
    Progress progress;
    for (const std::size_t most_faces : {std::size_t(1'000'000), std::size_t(10)}) {
        SmoothSurface surface(most_faces);
        const auto expect_as_new = [&](const Mesh& mesh) {
            surface.follow(mesh, progress);
            const SmoothSurface fresh(mesh, progress, most_faces);
            EXPECT_TRUE(surface.mesh() == fresh.mesh());
            EXPECT_EQ(surface.old_face(), fresh.old_face());
            EXPECT_EQ(surface.normals(), fresh.normals());
        };
        Mesh mesh = l_prism();
        expect_as_new(mesh);
        const Corner* const connectivity = MeshTables::view(surface.mesh()).next.data();
        for (const unsigned seed : {7u, 8u}) expect_as_new(shaken(mesh, seed));
        EXPECT_EQ(MeshTables::view(surface.mesh()).next.data(), connectivity) << "nothing but positions is made";
        mesh.set_group(Face(3), 5);
        expect_as_new(mesh);
        mesh.insert_edge(mesh.corner(Face(2), 0), mesh.corner(Face(2), 2));
        expect_as_new(mesh);
        EXPECT_THROW(surface.follow(open_grid(3, 2), progress), CommandError);
        expect_as_new(mesh);
        expect_as_new(cube());
    }
}

TEST(SmoothSurface, OfAModelOfVeryManyFacesHasNoMoreOfThem)
{
    const Mesh mesh = l_prism();
    Progress progress;
    const SmoothSurface surface(mesh, progress, 10);
    EXPECT_EQ(rings(surface.mesh()), rings(mesh));
    EXPECT_EQ(surface.old_face(), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
    const Mesh fine = limit(mesh, {.level = 2});
    for (const Vertex v : mesh.vertices()) EXPECT_LT(glm::distance(surface.mesh().position(v), fine.position(v)), 1e-12);
    EXPECT_LT(bounds(surface.mesh()).size().x, 0.9 * bounds(mesh).size().x);
}

} // namespace
} // namespace druse
