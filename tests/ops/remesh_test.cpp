// Remeshing against the counts, the order of elements and the positions of its sources, each written out here a second time the
// plain way.
#include "remesh_models.h"

#include "dlfl/mesh_builder.h"
#include "ops/remesh_catmull_clark.h"
#include "ops/remesh_checkerboard.h"
#include "ops/remesh_doo_sabin.h"

#include <cmath>
#include <numbers>
#include <set>

#include <sched.h>

namespace druse {
namespace {

using namespace test;
class EveryRemeshedModel : public testing::TestWithParam<Input> {};
INSTANTIATE_TEST_SUITE_P(Remesh, EveryRemeshedModel, testing::ValuesIn(remeshed_models), shape_name<testing::TestParamInfo<Input>>);

// --- Catmull-Clark --------------------------------------------------------------------------------------------------------------

TEST_P(EveryRemeshedModel, GetsTheQuadsOfCatmullAndClarkInTheirOrder)
{
    const Mesh old = GetParam().make(), mesh = once<CatmullClark>(old);
    const Lists was(old);
    EXPECT_EQ(counts(mesh), (Counts{was.V + was.E + was.F, 4 * was.E, 2 * was.E}));
    Rings expected;
    for (const Face f : old.faces())
        for (const Corner c : old.corners(f))
            expected.push_back({was.v(c), was.V + was.e(c), was.V + was.E + f.index, was.V + was.e(old.previous(c))});
    EXPECT_EQ(rings(mesh), expected);
    expect_genus_and_volume_kept(old, mesh);
    EXPECT_EQ(groups(mesh), std::vector<int>(2 * was.E, 1));
}

TEST_P(EveryRemeshedModel, IsMovedAsCatmullAndClarkSay)
{
    const Mesh old = GetParam().make(), mesh = once<CatmullClark>(old);
    const Lists was(old);
    const auto at = [&](std::uint32_t v) { return mesh.position(Vertex(v)); };
    for (const Face f : old.faces()) EXPECT_LT(glm::distance(at(was.V + was.E + f.index), vertex_mean(old, f)), 1e-12);
    for (const Edge e : old.edges()) {
        const auto [v, w] = old.ends(e);
        const auto [f, g] = old.faces(e);
        const Point expected = (old.position(v) + old.position(w) + vertex_mean(old, f) + vertex_mean(old, g)) / 4.0;
        EXPECT_LT(glm::distance(at(was.V + e.index), expected), 1e-12);
    }
    for (const Vertex v : old.vertices()) {
        Point q(0.0), r(0.0);
        const double m = old.valence(v);
        for (const Corner c : old.around(v)) {
            q += vertex_mean(old, old.face(c)) / m;
            r += 0.5 * (old.position(c) + old.position(old.target(c))) / m;
        }
        EXPECT_LT(glm::distance(at(v.index), (q + 2.0 * r + (m - 3) * old.position(v)) / m), 1e-12);
    }
}

TEST(CatmullClark, MovesTheCubeOfSideTwoToNinthsAndQuarters)
{
    Scene scene = scene_of(Mesh());
    run(scene, "make.cube", {{"size", "2"}});
    run(scene, "remesh.catmull_clark");
    int ninths = 0, quarters = 0, ones = 0;
    for (const Point& p : scene.mesh.positions()) {
        const Vector a = glm::abs(p);
        std::multiset<double> sizes{std::round(a.x * 36), std::round(a.y * 36), std::round(a.z * 36)};
        if (sizes == std::multiset<double>{20, 20, 20}) ++ninths;     // (5/9, 5/9, 5/9)
        else if (sizes == std::multiset<double>{0, 27, 27}) ++quarters; // (0, 3/4, 3/4)
        else if (sizes == std::multiset<double>{0, 0, 36}) ++ones;
        for (const double x : {a.x, a.y, a.z}) EXPECT_NEAR(x * 36, std::round(x * 36), 1e-13);
    }
    EXPECT_EQ(ninths, 8);
    EXPECT_EQ(quarters, 12);
    EXPECT_EQ(ones, 6);
}

TEST(CatmullClark, WithoutSmoothingLeavesVerticesAndHalvesEdges)
{
    const Mesh old = dodecahedron(), mesh = once(old, CatmullClark{false});
    for (const Vertex v : old.vertices()) EXPECT_EQ(mesh.position(v), old.position(v));
    for (const Edge e : old.edges()) {
        const auto [v, w] = old.ends(e);
        EXPECT_LT(glm::distance(mesh.position(Vertex(20 + e.index)), 0.5 * (old.position(v) + old.position(w))), 1e-15);
    }
    EXPECT_NEAR(volume(mesh), volume(old), 1e-12);
}

TEST(CatmullClark, TakesValenceTwo)
{
    const Mesh mesh = once<CatmullClark>(dihedron(5));
    EXPECT_EQ(counts(mesh), (Counts{5 + 5 + 2, 20, 10}));
    EXPECT_SOUND(mesh);
    EXPECT_EQ(genus(mesh), 0);
}

// --- Doo-Sabin -------------------------------------------------------------------------------------------------------------------

TEST_P(EveryRemeshedModel, GetsTheFacesOfDooAndSabinInTheirOrder)
{
    const Mesh old = GetParam().make(), mesh = once<DooSabin>(old);
    const Lists was(old);
    EXPECT_EQ(counts(mesh), (Counts{2 * was.E, 4 * was.E, was.V + was.E + was.F}));
    Rings expected;
    std::vector<int> expected_groups;
    for (const Face f : old.faces()) {
        Ring ring;
        for (const Corner c : old.corners(f)) ring.push_back(was.k(c));
        expected.push_back(ring);
        expected_groups.push_back(1);
    }
    for (const Edge e : old.edges()) {
        // From v to w, the ends of the edge's first side, with the faces f to its left and g to its right: v in f, v in g, w in g, w in f.
        const Corner a = old.corner(e, 0), b = old.corner(e, 1);
        expected.push_back({was.k(a), was.k(old.next(b)), was.k(b), was.k(old.next(a))});
        expected_groups.push_back(2);
    }
    for (const Vertex v : old.vertices()) {
        Ring ring;
        for (const Corner c : was.around(v)) ring.push_back(was.k(c));
        expected.push_back(ring);
        expected_groups.push_back(3);
    }
    EXPECT_EQ(rings(mesh), expected);
    EXPECT_EQ(groups(mesh), expected_groups);
    expect_genus_and_volume_kept(old, mesh);
    for (const Vertex v : mesh.vertices()) EXPECT_EQ(mesh.valence(v), 4);
}

TEST_P(EveryRemeshedModel, IsWeightedAsDooAndSabinSay)
{
    const Mesh old = GetParam().make(), mesh = once<DooSabin>(old);
    const Lists was(old);
    for (const Face f : old.faces()) {
        const int n = old.valence(f);
        for (int i = 0; i < n; ++i) {
            Point expected(0.0);
            for (int j = 0; j < n; ++j) {
                const double w = i == j ? 0.25 + 5.0 / (4 * n) : (3 + 2 * std::cos(2 * std::numbers::pi * (i - j) / n)) / (4 * n);
                expected += w * old.position(old.corner(f, j));
            }
            EXPECT_LT(glm::distance(mesh.position(Vertex(was.k(old.corner(f, i)))), expected), 1e-12);
        }
    }
}

TEST(DooSabin, HalvesTheSidesOfASquare)
{
    // 9/16 + 3/16 − 3/16 − 1/16 = 1/2
    const Mesh mesh = once<DooSabin>(cube());
    for (const Point& p : mesh.positions()) {
        const Vector a = glm::abs(p);
        const double sorted[] = {std::min({a.x, a.y, a.z}), a.x + a.y + a.z - std::min({a.x, a.y, a.z}) - std::max({a.x, a.y, a.z}), std::max({a.x, a.y, a.z})};
        EXPECT_NEAR(sorted[0], 0.25, 1e-15);
        EXPECT_NEAR(sorted[1], 0.25, 1e-15);
        EXPECT_NEAR(sorted[2], 0.5, 1e-15);
    }
}

TEST(DooSabin, WeighsAFaceOfManySidesInTimeThatFollowsItsSides)
{
    Scene scene;
    run(scene, "make.prism", {{"n", "10000"}});
    const Mesh mesh = once<DooSabin>(scene.mesh);
    EXPECT_EQ(counts(mesh), (Counts{60000, 120000, 20000 + 30000 + 10002}));
    // On a regular polygon W has the eigenvalue 1/2 on the first harmonic: the lid shrinks to half.
    const double radius = glm::length(Point2(scene.mesh.position(Vertex(0))));
    EXPECT_NEAR(glm::length(Point2(mesh.position(mesh.corner(Face(0))))), radius / 2, 1e-9);
}

// --- checkerboard ------------------------------------------------------------------------------------------------------------------

TEST_P(EveryRemeshedModel, GetsTheFramesOfTheCheckerboardInTheirOrder)
{
    const Mesh old = GetParam().make(), mesh = once<Checkerboard>(old);
    const Lists was(old);
    EXPECT_EQ(counts(mesh), (Counts{was.V + 4 * was.E, 9 * was.E, was.F + 4 * was.E}));
    const auto near = [&](Corner c) { return was.V + 2 * was.e(c) + was.s(c); }; // on the side of c, near its vertex
    const auto inner = [&](Corner c) { return was.V + 2 * was.E + was.k(c); };
    Rings expected;
    std::vector<int> expected_groups;
    for (const Face f : old.faces()) {
        Ring ring;
        for (const Corner c : old.corners(f)) ring.push_back(inner(c));
        expected.push_back(ring);
        expected_groups.push_back(1);
        for (const Corner c : old.corners(f)) {
            const Corner before = old.previous(c);
            expected.push_back({was.v(c), near(c), inner(c), near(old.opposite(before))});
            expected.push_back({near(c), near(old.opposite(c)), inner(old.next(c)), inner(c)});
            expected_groups.insert(expected_groups.end(), 2, 2);
        }
    }
    EXPECT_EQ(rings(mesh), expected);
    EXPECT_EQ(groups(mesh), expected_groups);
    expect_genus_and_volume_kept(old, mesh);
}

TEST(Checkerboard, CutsTheSquaresOfACubeIntoNineEqualOnes)
{
    const Mesh mesh = once<Checkerboard>(cube());
    EXPECT_EQ(counts(mesh), (Counts{8 + 48, 108, 54}));
    std::map<int, int> in_group;
    for (const Face f : mesh.faces()) {
        ++in_group[mesh.group(f)];
        EXPECT_NEAR(area(mesh, f), 1.0 / 9, 1e-14);
    }
    EXPECT_EQ(in_group, (std::map<int, int>{{1, 6}, {2, 48}}));
    EXPECT_LT(edge_lengths(mesh).relative_spread(), 1e-13);
    EXPECT_LT(flatness(mesh), 1e-14);
    EXPECT_NEAR(volume(mesh), 1.0, 1e-14);
}

TEST(Checkerboard, StaysInsideAConcaveFaceAndInItsPlane)
{
    // The L's reflex corner is (1, 1) with neighbours (2, 1) and (1, 2): its inner point is (1, 1) − t((1, 0) + (0, 1)).
    const Mesh old = l_prism(), mesh = once(old, Checkerboard{0.25});
    EXPECT_LT(flatness(mesh), 1e-14);
    EXPECT_NEAR(surface_area(mesh), surface_area(old), 1e-12);
    bool found = false;
    for (const Point& p : mesh.positions()) found = found || glm::distance(p, Point(0.75, 0.75, 1)) < 1e-14;
    EXPECT_TRUE(found);
    for (const Face f : mesh.faces()) EXPECT_GT(area(mesh, f), 0.01);
}

TEST(Checkerboard, TakesAStraightCornerForAConvexOneWhateverItsLastDigits)
{
    // A square whose lower side has a corner at 0.3, a little above or below the line.
    for (const double y : {0.0, 1e-17, -1e-17}) {
        MeshBuilder builder;
        for (const Point& p : {Point(0, 0, 0), Point(0.3, y, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)}) builder.add_vertex(p);
        builder.add_face(Ring{0, 1, 2, 3, 4});
        builder.add_face(Ring{0, 4, 3, 2, 1});
        const Mesh mesh = once(builder.build(), Checkerboard{0.25});
        EXPECT_NEAR(mesh.position(Vertex(5 + 10 + 1)).x, 0.3 + 0.25 * (0.7 - 0.3), 1e-15);
    }
}

// --- groups, iterations, refusals --------------------------------------------------------------------------------------------------

TEST(RemeshGroups, AreKeptFromTheFaceInsideOrTheLowestOneThatTouches)
{
    Mesh old = cube();
    for (const Face f : old.faces()) old.set_group(f, 10 + int(f.index));
    const Mesh mesh = once<DooSabin>(old, {}, RemeshGroups::keep);
    std::vector<int> expected{10, 11, 12, 13, 14, 15};
    for (const Edge e : old.edges()) expected.push_back(10 + int(std::min(old.faces(e)[0].index, old.faces(e)[1].index)));
    for (const Vertex v : old.vertices()) {
        int lowest = 99;
        for (const Corner c : old.around(v)) lowest = std::min(lowest, 10 + int(old.face(c).index));
        expected.push_back(lowest);
    }
    EXPECT_EQ(groups(mesh), expected);

    std::vector<int> inside;
    for (int f = 0; f < 6; ++f) inside.insert(inside.end(), 9, 10 + f);
    EXPECT_EQ(groups(once<Checkerboard>(old, {}, RemeshGroups::keep)), inside);
    EXPECT_EQ(groups(once<Checkerboard>(old, {}, RemeshGroups::none)), std::vector<int>(54, 0));
}

TEST(Remesh, ThreeTimesIsTheThirdOfOnce)
{
    Scene scene = scene_of(edited_torus());
    run(scene, "remesh.doo_sabin", {{"iterations", "3"}, {"groups", "keep"}});
    Mesh mesh = edited_torus();
    for (int i = 0; i < 3; ++i) mesh = once<DooSabin>(mesh, {}, RemeshGroups::keep);
    EXPECT_TRUE(scene.mesh == mesh);
}

TEST(Remesh, GivesWhatAReaderWouldMakeOfTheSameFaces)
{
    for (const Mesh& mesh : {once<CatmullClark>(torus(7, 5)), once<DooSabin>(edited_torus()), once<Checkerboard>(block_with_holes(2))}) {
        MeshBuilder builder;
        for (const Point& p : mesh.positions()) builder.add_vertex(p);
        for (const Face f : mesh.faces()) builder.add_face(ring(mesh, f), mesh.group(f));
        EXPECT_TRUE(builder.build() == mesh);
    }
}

/// What a mesh becomes where there is one processor only, so that nothing is done side by side.
template <class Kernel>
Mesh once_on_one_processor(const Mesh& mesh)
{
    cpu_set_t before, one;
    sched_getaffinity(0, sizeof before, &before);
    CPU_ZERO(&one);
    CPU_SET(sched_getcpu(), &one);
    sched_setaffinity(0, sizeof one, &one);
    Mesh result = once<Kernel>(mesh);
    sched_setaffinity(0, sizeof before, &before);
    return result;
}

TEST(Remesh, IsTheSameOnOneProcessorAsOnSeveral)
{
    const Mesh old = torus(160, 110);
    ASSERT_GT(old.corner_limit(), remesh::worth_a_thread);
    EXPECT_TRUE(once<CatmullClark>(old) == once_on_one_processor<CatmullClark>(old));
    EXPECT_TRUE(once<DooSabin>(old) == once_on_one_processor<DooSabin>(old));
}

TEST(Remesh, LeavesNothingSelected)
{
    Scene scene = scene_of(cube());
    scene.selection.edit() = {{Face(1)}, {Edge(2)}, {Vertex(3)}};
    run(scene, "remesh.checkerboard");
    EXPECT_EQ(*scene.selection, Selection());
}

TEST(Remesh, OfNothingIsNothing)
{
    Scene scene;
    run(scene, "remesh.catmull_clark", {{"iterations", "20"}});
    EXPECT_EQ(counts(scene.mesh), Counts());
}

TEST(Remesh, SaysWhatItCannotUse)
{
    EXPECT_EQ(complaint(scene_of(open_grid(3, 2)), "remesh.catmull_clark"), "the model is open: 10 boundary edges");
    EXPECT_EQ(complaint(scene_of(point_sphere()), "remesh.catmull_clark"), "vertex 0 has valence 0");
    EXPECT_EQ(complaint(scene_of(cube_with_antenna()), "remesh.checkerboard"), "vertex 8 has valence 1");
    EXPECT_EQ(complaint(scene_of(dihedron(5)), "remesh.doo_sabin"), "vertex 0 has valence 2");
    EXPECT_EQ(complaint(scene_of(cube_with_parallel_edges()), "remesh.doo_sabin"), "face 6 has 2 sides");
    EXPECT_EQ(complaint(scene_of(cube_with_loop()), "remesh.doo_sabin"), "face 6 has 1 side");
    Mesh far = cube();
    far.set_position(Vertex(3), Point(1e300, 0, 0));
    EXPECT_EQ(complaint(scene_of(far), "remesh.doo_sabin"), "coordinates beyond 1e290 are too large");
}

TEST(Remesh, RefusesMoreThanTwentyMillionEdgesBeforeItStarts)
{
    EXPECT_EQ(complaint(scene_of(cube()), "remesh.catmull_clark", {{"iterations", "12"}}), "would make 201326592 edges, more than 20 million");
    EXPECT_EQ(complaint(scene_of(cube()), "remesh.checkerboard", {{"iterations", "20"}}), "would make 145891985508683145612 edges, more than 20 million");
    EXPECT_EQ(complaint(scene_of(cube_with_antenna()), "remesh.doo_sabin", {{"iterations", "20"}}).substr(0, 10), "would make");
}

TEST(Remesh, ChecksItsParameters)
{
    const auto refuses = [](const char* key, const char* value) { return complaint(scene_of(cube()), "remesh.checkerboard", {{key, value}}); };
    EXPECT_EQ(refuses("t", "0.5"), "expected between 0 and 0.5, both excluded");
    EXPECT_EQ(refuses("t", "0"), "expected between 0 and 0.5, both excluded");
    EXPECT_EQ(refuses("iterations", "21"), "expected 1 to 20 (an integer)");
    EXPECT_EQ(refuses("groups", "each"), "expected absolute, keep or none");
}

TEST(Remesh, CanBeStopped)
{
    Progress progress;
    progress.cancel();
    EXPECT_THROW(remeshed(cube(), CatmullClark(), 1, RemeshGroups::none, progress), Cancelled);
}

// --- what schemes say -----------------------------------------------------------------------------------------------------------

using namespace remesh;

TEST(RemeshScheme, FindsWhichSidesMeetForEveryKindOfPolygon)
{
    // Truncation: a 2n-gon in each face, an m-gon on each vertex.
    constexpr Scheme truncate = [] {
        Scheme s;
        s.face = polygon(1, side_point, side_point(across));
        s.vertex = polygon(2, side_point);
        return s;
    }();
    static_assert(find_links(truncate).complete && growth(truncate) == 3);
    // Two triangles on each edge, between its ends and the face points: root 3.
    constexpr Scheme root3 = [] {
        Scheme s;
        s.side[0] = polygon(1, old_vertex, face_point(across), face_point);
        return s;
    }();
    static_assert(find_links(root3).complete && growth(root3) == 3);
    // Conway's gyro.
    constexpr Scheme gyro = [] {
        Scheme s;
        s.corner[0] = polygon(1, old_vertex(on), side_point(on), face_point, side_point, side_point(across));
        return s;
    }();
    static_assert(find_links(gyro).complete && growth(gyro) == 5);
    // The same without its last vertex has sides that meet nothing.
    constexpr Scheme torn = [] {
        Scheme s;
        s.corner[0] = polygon(1, old_vertex(on), side_point(on), face_point, side_point);
        return s;
    }();
    static_assert(!find_links(torn).complete);
    SUCCEED();
}

} // namespace
} // namespace druse
