// topology.pipe and topology.handle: counts, pairings, ids, and what cannot be joined.
#include "ops/handle.h"
#include "ops/pipe.h"
#include "run.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace druse {
namespace {

using namespace test;
using Arguments = std::vector<std::pair<std::string, std::string>>;
constexpr double pi = std::numbers::pi;

/// Two flat polygons, one over the other: face 0 of the lower one looks at face 3 of the upper one.
Mesh facing_polygons(int n, int m, double turn = 0)
{
    Mesh mesh = dihedron(n), upper = dihedron(m);
    for (Point& p : upper.write_positions()) p = {std::cos(turn) * p.x - std::sin(turn) * p.y, std::sin(turn) * p.x + std::cos(turn) * p.y, 1};
    mesh.append(upper);
    return mesh;
}

std::map<int, std::uint32_t> selected_by_sides(const Scene& scene)
{
    std::map<int, std::uint32_t> count;
    for (const Face f : scene.selection->faces) ++count[scene.mesh.valence(f)];
    return count;
}

Arguments between(std::uint32_t from, std::uint32_t to, Arguments more = {})
{
    more.insert(more.begin(), {{"from", std::to_string(from)}, {"to", std::to_string(to)}});
    return more;
}

// --- pipes ------------------------------------------------------------------------------------------------------------------------

class PipeBetweenEqualFaces : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Pipe, PipeBetweenEqualFaces, testing::Values(3, 4, 5, 6, 7, 20));

TEST_P(PipeBetweenEqualFaces, AddsNEdgesAndNMinusTwoFacesAndAHandle)
{
    const int n = GetParam();
    const auto u = static_cast<std::uint32_t>(n);
    Scene scene = scene_of(prism(n));
    run(scene, "topology.pipe", between(0, u + 1));
    EXPECT_SOUND(scene.mesh);
    EXPECT_EQ(counts(scene.mesh), (Counts{2 * u, 4 * u, 2 * u}));
    EXPECT_EQ(genus(scene.mesh), 1);
    EXPECT_NEAR(volume(scene.mesh), 0, 1e-13); // a wall within, where the outer one stands
    EXPECT_EQ(selected_by_sides(scene), (std::map<int, std::uint32_t>{{4, u}}));
    for (const Face f : scene.selection->faces) EXPECT_EQ(scene.mesh.group(f), 1);
}

TEST_P(PipeBetweenEqualFaces, JoinsComponentsAlongTheShortestRungs)
{
    const int n = GetParam();
    const auto u = static_cast<std::uint32_t>(n);
    Scene scene = scene_of(facing_polygons(n, n, 0.3 / n)); // a little turned
    run(scene, "topology.pipe", between(0, 3));
    EXPECT_SOUND(scene.mesh);
    EXPECT_EQ(counts(scene.mesh), (Counts{2 * u, 3 * u, u + 2}));
    EXPECT_EQ(components(scene.mesh).parts.size(), 1u);
    EXPECT_EQ(genus(scene.mesh), 0);
    EXPECT_GT(volume(scene.mesh), 0);
    // Corners lie at one radius, 1 apart in height; the next pairing but one would be 2 sin(π/n) away at least.
    const double chord = 2 * 0.5 / std::sin(pi / n) * std::sin(0.15 / n);
    for (std::uint32_t e = 2 * u; e < 3 * u; ++e) EXPECT_NEAR(length(scene.mesh, Edge(e)), std::hypot(1, chord), 1e-12);
}

TEST(Pipe, NumbersItsWallsFromTheFirstRungTheFreedIdsFirst)
{
    Scene scene = scene_of(facing_polygons(5, 5));
    run(scene, "topology.pipe", between(0, 3, {{"corners", "1,4"}}));
    EXPECT_EQ(ids(scene.selection->faces), (std::vector<std::uint32_t>{0, 3, 4, 5, 6}));
    // Face 3 runs 5, 9, 8, 7, 6: its corner 4 is vertex 6, over vertex 1.
    EXPECT_EQ(ring(scene.mesh, Face(0)), (std::vector<std::uint32_t>{1, 2, 7, 6}));
    EXPECT_EQ(ring(scene.mesh, Face(3)), (std::vector<std::uint32_t>{2, 3, 8, 7}));
    EXPECT_EQ(ring(scene.mesh, Face(6)), (std::vector<std::uint32_t>{0, 1, 6, 5}));
    // The rungs as the walls first use them: at vertex 2, 1, 3, 4 and 0.
    const std::vector<std::uint32_t> at{2, 1, 3, 4, 0};
    for (std::uint32_t k = 0; k < 5; ++k) EXPECT_EQ(std::ranges::min(scene.mesh.ends(Edge(10 + k))), Vertex(at[k]));
}

TEST(Pipe, TurnsOnByTheShift)
{
    for (int shift = -7; shift <= 7; ++shift) {
        Scene scene = scene_of(facing_polygons(5, 5));
        run(scene, "topology.pipe", between(0, 3, {{"shift", std::to_string(shift)}}));
        EXPECT_SOUND(scene.mesh);
        EXPECT_EQ(counts(scene.mesh), (Counts{10, 15, 7}));
        // Without it vertex i is joined to 5 + i.
        const auto other = static_cast<std::uint32_t>(((shift % 5) + 5) % 5);
        bool found = false;
        for (const Corner c : scene.mesh.around(Vertex(0))) found |= scene.mesh.target(c) == Vertex(5 + other);
        EXPECT_TRUE(found) << shift;
    }
}

struct Unlike {
    int n, m;
    friend std::ostream& operator<<(std::ostream& out, const Unlike& u) { return out << u.n << " and " << u.m; }
};
class PipeBetweenUnlikeFaces : public testing::TestWithParam<Unlike> {};
INSTANTIATE_TEST_SUITE_P(Pipe, PipeBetweenUnlikeFaces,
                         testing::Values(Unlike{6, 4}, Unlike{4, 6}, Unlike{12, 5}, Unlike{3, 4}, Unlike{20, 3}, Unlike{7, 6}));

TEST_P(PipeBetweenUnlikeFaces, MixesQuadsAndTriangles)
{
    const auto [n, m] = GetParam();
    Scene scene = scene_of(facing_polygons(n, m));
    const auto fewer = static_cast<std::uint32_t>(std::min(n, m)), more = static_cast<std::uint32_t>(std::max(n, m));
    run(scene, "topology.pipe", between(0, 3));
    EXPECT_SOUND(scene.mesh);
    EXPECT_EQ(counts(scene.mesh), (Counts{fewer + more, fewer + 2 * more, 2 + more}));
    EXPECT_EQ(selected_by_sides(scene), (std::map<int, std::uint32_t>{{3, more - fewer}, {4, fewer}}));
    EXPECT_EQ(genus(scene.mesh), 0);
    EXPECT_GT(volume(scene.mesh), 0);
}

TEST_P(PipeBetweenUnlikeFaces, SplitsTheLongestSidesUntilTheyAreEqual)
{
    const auto [n, m] = GetParam();
    Scene scene = scene_of(facing_polygons(n, m));
    const auto fewer = static_cast<std::uint32_t>(std::min(n, m)), more = static_cast<std::uint32_t>(std::max(n, m));
    run(scene, "topology.pipe", between(0, 3, {{"unequal", "split"}}));
    EXPECT_SOUND(scene.mesh);
    EXPECT_EQ(counts(scene.mesh), (Counts{2 * more, 3 * more, 2 + more}));
    EXPECT_EQ(selected_by_sides(scene), (std::map<int, std::uint32_t>{{4, more}}));
    const Face neighbour(n < m ? 1 : 2); // of the split face
    EXPECT_EQ(scene.mesh.valence(neighbour), int(more));
    EXPECT_EQ(genus(scene.mesh), 0);
    EXPECT_TRUE(fewer < more);
}

TEST(Pipe, LeavesGroupsAndStartsOfFacesBesideASplitSide)
{
    Scene scene = scene_of(prism(5));
    Mesh& mesh = scene.mesh;
    mesh.append(dihedron(9));
    for (const Face f : mesh.faces()) mesh.set_group(f, int(f.index) + 1);
    for (std::uint32_t f = 1; f <= 5; ++f) mesh.set_start(mesh.corner(Face(f), int(f) % 4));
    std::vector<Vertex> starts;
    for (std::uint32_t f = 1; f <= 5; ++f) starts.push_back(mesh.vertex(mesh.corner(Face(f))));
    run(scene, "topology.pipe", between(6, 8, {{"unequal", "split"}, {"corners", "2,0"}}));
    EXPECT_SOUND(mesh);
    EXPECT_EQ(counts(mesh), (Counts{10 + 9 + 4, 15 + 9 + 4 + 9, 9 + 7}));
    for (std::uint32_t f = 1; f <= 5; ++f) {
        EXPECT_EQ(mesh.group(Face(f)), int(f) + 1);
        EXPECT_EQ(mesh.vertex(mesh.corner(Face(f))), starts[f - 1]);
    }
}

TEST(Pipe, RefusesWhatCannotBeJoinedAndChangesNothing)
{
    const Scene cube_scene = scene_of(cube());
    const auto refusal = [&](const Arguments& arguments) { return complaint(cube_scene, "topology.pipe", arguments); };
    EXPECT_EQ(refusal(between(2, 2)), "from and to are the same face 2");
    EXPECT_EQ(refusal(between(2, 6)), "there is no face 6: the faces are 0 to 5");
    const Mesh solid = cube();
    for (const Face f : solid.faces())
        for (const Face g : solid.faces()) {
            std::vector<std::uint32_t> of_f = ring(solid, f), shared;
            for (const std::uint32_t v : ring(solid, g))
                if (std::ranges::find(of_f, v) != of_f.end()) shared.push_back(v);
            if (f == g || shared.empty()) continue;
            EXPECT_EQ(refusal(between(f.index, g.index)), fmt::format("faces {} and {} share vertex {}", f.index, g.index, shared[0]));
        }
    const Scene unlike = scene_of(facing_polygons(4, 6));
    EXPECT_EQ(complaint(unlike, "topology.pipe", between(0, 3, {{"unequal", "error"}})), "face 0 has 4 sides, face 3 has 6 (unequal=error)");
    EXPECT_EQ(complaint(unlike, "topology.pipe", between(0, 3, {{"shift", "1"}})), "shift=1: face 0 has 4 sides, face 3 has 6");
    EXPECT_EQ(complaint(unlike, "topology.pipe", between(0, 3, {{"shift", "1"}, {"unequal", "split"}})), "shift=1: face 0 has 4 sides, face 3 has 6");
    EXPECT_EQ(complaint(unlike, "topology.pipe", between(0, 3, {{"corners", "0,6"}})), "corners: face 3 has corners 0 to 5, not 6");
    EXPECT_EQ(complaint(scene_of(cube_with_antenna()), "topology.pipe", between(0, 5)).substr(0, 14), "face 0 visits ");
    EXPECT_EQ(complaint(scene_of(three_lunes()), "topology.pipe", between(0, 1)), "face 0 has 2 sides");
}

TEST(Pipe, PreviewsTheRungsItMakes)
{
    Scene scene = scene_of(facing_polygons(7, 4));
    PipeEnds ends;
    ends.from.id = 0;
    ends.to.id = 3;
    Progress progress;
    std::vector<double> shown, made;
    for (const auto& [a, b] : preview_pipe(scene.mesh, ends, progress)) shown.push_back(glm::distance(a, b));
    run(scene, "topology.pipe", between(0, 3));
    for (std::uint32_t e = 11; e < scene.mesh.edge_limit(); ++e) made.push_back(length(scene.mesh, Edge(e)));
    std::ranges::sort(shown);
    std::ranges::sort(made);
    EXPECT_EQ(shown, made);
    EXPECT_EQ(shown.size(), 7u);
}

TEST(Pipe, MayHaveSeveralSegments)
{
    Scene scene = scene_of(facing_polygons(5, 5));
    run(scene, "topology.pipe", between(0, 3, {{"segments", "4"}}));
    EXPECT_SOUND(scene.mesh);
    EXPECT_EQ(counts(scene.mesh), (Counts{10 + 5 * 3, 10 + 5 * 7, 4 + 5 * 4 - 2}));
    EXPECT_NEAR(volume(scene.mesh), 5 / (4 * std::tan(pi / 5)), 1e-12); // a prism of height 1
}

// --- pairings ---------------------------------------------------------------------------------------------------------------------

double squares(std::span<const Point> from, std::span<const Point> to, const std::vector<Rung>& rungs)
{
    double sum = 0;
    for (const Rung& r : rungs) {
        const Vector d = from[std::size_t(r.from)] - to[std::size_t(r.to)];
        sum += glm::dot(d, d);
    }
    return sum;
}

/// The least sum of all bands between n points and m ≤ n, tried one by one.
double least_of_all(std::span<const Point> from, std::span<const Point> to)
{
    const auto n = static_cast<int>(from.size()), m = static_cast<int>(to.size());
    double least = std::numeric_limits<double>::infinity();
    for (int start = 0; start < m; ++start) {
        std::vector<Rung> rungs;
        const std::function<void(int, int)> go = [&](int i, int j) { // rung i is at place j; in all it goes round once
            rungs.push_back({i, ((start - j) % m + m) % m});
            if (i + 1 == n) {
                if (j == m || j + 1 == m) least = std::min(least, squares(from, to, rungs));
            } else {
                go(i + 1, j);
                if (j < m) go(i + 1, j + 1);
            }
            rungs.pop_back();
        };
        go(0, 0);
    }
    return least;
}

TEST(Pairing, FindsTheLeastOfAllBands)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-1, 1);
    Progress progress;
    for (int trial = 0; trial < 60; ++trial) {
        const int m = 3 + trial % 3, n = m + 1 + trial % 4;
        std::vector<Point> from, to;
        for (int i = 0; i < n; ++i) from.emplace_back(place(random), place(random), place(random));
        for (int i = 0; i < m; ++i) to.emplace_back(place(random), place(random), place(random));
        const double least = least_of_all(from, to);
        const auto rungs = pair_corners(from, to, {}, progress), other = pair_corners(to, from, {}, progress);
        EXPECT_NEAR(squares(from, to, rungs), least, 1e-12 * least);
        EXPECT_NEAR(squares(to, from, other), least, 1e-12 * least);
        EXPECT_EQ(rungs.size(), std::size_t(n));
    }
}

TEST(Pairing, OfRegularPolygonsTakesTheTurnNearestToTheClosestPair)
{
    // Turned by half a side, two pairings are equally good. The first of the closest pairs is corner 0 of the one and 0 of the other.
    for (int n = 3; n <= 12; ++n) {
        std::vector<Point> from, to;
        for (int i = 0; i < n; ++i) {
            from.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0);
            to.emplace_back(std::cos(2 * pi * (0.5 - i) / n), std::sin(2 * pi * (0.5 - i) / n), 1);
        }
        Progress progress;
        const auto rungs = pair_corners(from, to, {}, progress);
        for (int i = 0; i < n; ++i) EXPECT_EQ(rungs[std::size_t(i)], (Rung{i, (n - i) % n})) << n;
    }
}

TEST(Pairing, FollowsFacesOfManyThousandCorners)
{
    const int n = 3000, m = 2000; // more than all starts can be tried of
    std::vector<Point> from, to;
    for (int i = 0; i < n; ++i) from.emplace_back(std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 0);
    for (int j = 0; j < m; ++j) to.emplace_back(std::cos(-2 * pi * j / m), std::sin(-2 * pi * j / m), 1);
    Progress progress;
    const auto rungs = pair_corners(from, to, {}, progress);
    ASSERT_EQ(rungs.size(), std::size_t(n));
    for (const Rung& r : rungs) EXPECT_LT(glm::distance(from[std::size_t(r.from)], to[std::size_t(r.to)]), 1.00001);
}

// --- handles ----------------------------------------------------------------------------------------------------------------------

TEST(Handle, HasTheCountsOfItsPipes)
{
    for (const int segments : {1, 2, 3, 8, 40}) {
        Scene scene = scene_of(two_cubes());
        const auto s = static_cast<std::uint32_t>(segments);
        run(scene, "topology.handle", between(2, 10, {{"segments", std::to_string(segments)}}));
        EXPECT_SOUND(scene.mesh);
        EXPECT_EQ(counts(scene.mesh), (Counts{16 + 4 * (s - 1), 24 + 4 * (2 * s - 1), 12 + 4 * s - 2}));
        EXPECT_EQ(components(scene.mesh).parts.size(), 1u);
        EXPECT_EQ(scene.selection->faces.size(), 4 * s);
    }
}

TEST(Handle, PreviewsTheRungsItMakes)
{
    Scene scene = scene_of(two_cubes());
    PipeEnds ends;
    ends.from.id = 2;
    ends.to.id = 10;
    HandleShape shape;
    shape.segments = 3;
    Progress progress;
    std::vector<double> shown, made;
    for (const auto& [a, b] : preview_handle(scene.mesh, ends, shape, progress)) shown.push_back(glm::distance(a, b));
    run(scene, "topology.handle", between(2, 10, {{"segments", "3"}}));
    for (const Face f : scene.selection->faces) { // the side of each wall that is its first rung
        const Corner start = scene.mesh.corner(f);
        made.push_back(length(scene.mesh, scene.mesh.edge(scene.mesh.previous(start))));
    }
    std::ranges::sort(shown);
    std::ranges::sort(made);
    ASSERT_EQ(shown.size(), 12u);
    for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(shown[i], made[i], 1e-12);
}

TEST(Handle, BetweenUnlikeFacesHasRingsOfTheLargerOne)
{
    for (const auto& [n, m] : {std::pair(6, 4), std::pair(4, 6)}) {
        Scene scene = scene_of(facing_polygons(n, m));
        run(scene, "topology.handle", between(0, 3, {{"segments", "3"}}));
        EXPECT_SOUND(scene.mesh);
        EXPECT_EQ(counts(scene.mesh), (Counts{10 + 12, 10 + 6 * 5, 4 + 6 * 3 - 2}));
        EXPECT_EQ(selected_by_sides(scene), (std::map<int, std::uint32_t>{{3, 2}, {4, 16}}));
        EXPECT_GT(volume(scene.mesh), 0);
    }
}

TEST(Handle, NumbersItsBandsOneAfterTheOther)
{
    // The walls take the ids that are free by then, else the next ones: the first band that of the first face, the last one that of the second.
    Scene scene = scene_of(cube());
    run(scene, "topology.handle", between(0, 5, {{"segments", "3"}}));
    std::array<std::vector<std::uint32_t>, 3> band; // a wall starts on the ring before it: of the cube, vertices 8-11, and 12-15
    for (const Face f : scene.selection->faces) {
        const std::uint32_t start = ring(scene.mesh, f)[0];
        band[start < 8 ? 0 : start < 12 ? 1 : 2].push_back(f.index);
    }
    EXPECT_EQ(band[0], (std::vector<std::uint32_t>{0, 6, 7, 8}));
    EXPECT_EQ(band[1], (std::vector<std::uint32_t>{9, 10, 11, 12}));
    EXPECT_EQ(band[2], (std::vector<std::uint32_t>{5, 13, 14, 15}));
}

TEST(Handle, GoesThroughTheSolidWhereFacesLookAwayFromEachOther)
{
    Scene scene = scene_of(cube());
    const Face top = first_face(scene.mesh);
    Face bottom;
    for (const Face f : scene.mesh.faces())
        if (glm::dot(unit_normal(scene.mesh, f), unit_normal(scene.mesh, top)) < -0.5) bottom = f;
    run(scene, "topology.handle", between(top.index, bottom.index, {{"segments", "5"}, {"scale", "0.5"}}));
    EXPECT_EQ(genus(scene.mesh), 1);
    // A straight hole that narrows: all new vertices lie inside the cube.
    const Box box = bounds(cube());
    for (const Point& p : scene.mesh.positions()) {
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(p, box.min - 1e-12)));
        EXPECT_TRUE(glm::all(glm::lessThanEqual(p, box.max + 1e-12)));
    }
    const double v = volume(scene.mesh);
    EXPECT_GT(v, 0);
    EXPECT_LT(v, 1);
}

TEST(Handle, ReachesItsScaleInTheMiddleAndKeepsTheFaces)
{
    for (const double scale : {0.25, 1.0, 3.0}) {
        Scene scene = scene_of(facing_polygons(6, 6));
        run(scene, "topology.handle", between(0, 3, {{"segments", "2"}, {"scale", fmt::format("{}", scale)}, {"twist", "3"}}));
        ASSERT_EQ(scene.mesh.vertex_count(), 18u);
        for (std::uint32_t v = 12; v < 18; ++v) {
            const Point p = scene.mesh.position(Vertex(v));
            EXPECT_NEAR(std::hypot(p.x, p.y), scale, 1e-12); // the faces have circumradius 1
            EXPECT_NEAR(p.z, 0.5, 1e-12);
        }
    }
}

TEST(Handle, LeavesAndArrivesAlongTheNormals)
{
    // From the top of one cube to the top of the other: up, over, and down again.
    Scene scene = scene_of(two_cubes());
    std::vector<std::uint32_t> tops;
    for (const Face f : scene.mesh.faces())
        if (unit_normal(scene.mesh, f).z > 0.9) tops.push_back(f.index);
    ASSERT_EQ(tops.size(), 2u);
    const double ceiling = bounds(scene.mesh).max.z;
    const double distance = glm::distance(vertex_mean(scene.mesh, Face(tops[0])), vertex_mean(scene.mesh, Face(tops[1])));
    run(scene, "topology.handle", between(tops[0], tops[1], {{"segments", "16"}, {"weight", "2"}, {"weight2", "2"}}));
    EXPECT_SOUND(scene.mesh);
    // In its middle the curve lies 2 · 2d/8 over both faces, and the ring reaches half an edge to either side of it.
    EXPECT_NEAR(bounds(scene.mesh).max.z, ceiling + 0.5 * distance + 0.5, 1e-9);
}

TEST(Handle, TurnsItsFramesAsLittleAsItCan)
{
    // A frame carried along a curve in a plane keeps the direction square to the plane: half of the ring's sides stay parallel to it.
    Scene scene = scene_of(two_cubes());
    std::vector<std::uint32_t> tops;
    for (const Face f : scene.mesh.faces())
        if (unit_normal(scene.mesh, f).z > 0.9) tops.push_back(f.index);
    const Vector along = glm::normalize(vertex_mean(scene.mesh, Face(tops[1])) - vertex_mean(scene.mesh, Face(tops[0]))), square = glm::cross(along, Vector(0, 0, 1));
    run(scene, "topology.handle", between(tops[0], tops[1], {{"segments", "12"}}));
    for (std::uint32_t v = 16; v < scene.mesh.vertex_count(); ++v)
        EXPECT_NEAR(std::abs(glm::dot(scene.mesh.position(Vertex(v)) - scene.mesh.position(Vertex(16 + (v - 16) % 4)), square)), 0, 1e-9);
}

TEST(Handle, SaysWhereItBendsTooTightly)
{
    Scene scene = scene_of(two_cubes());
    std::vector<std::uint32_t> tops;
    for (const Face f : scene.mesh.faces())
        if (unit_normal(scene.mesh, f).z > 0.9) tops.push_back(f.index);
    EXPECT_TRUE(notes(scene, "topology.handle", between(tops[0], tops[1], {{"weight", "3"}, {"weight2", "3"}, {"scale", "0.3"}})).empty());
    scene = scene_of(two_cubes());
    const auto said = notes(scene, "topology.handle", between(tops[0], tops[1], {{"segments", "30"}, {"weight", "0.1"}, {"weight2", "0.1"}, {"scale", "4"}}));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].substr(0, 52), "the handle bends more tightly than it is wide at sta") << said[0];
}

TEST(Handle, RefusesFacesWithTheSameCentre)
{
    Mesh mesh = dihedron(4);
    mesh.append(dihedron(4));
    EXPECT_EQ(complaint(scene_of(mesh), "topology.handle", between(0, 3)), "the two faces have the same centre");
    EXPECT_EQ(complaint(scene_of(cube()), "topology.handle", between(0, 1, {{"segments", "1"}})).substr(0, 21), "faces 0 and 1 share v");
}

} // namespace
} // namespace druse
