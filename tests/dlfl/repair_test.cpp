// What a reader may meet: each kind of damage on the smallest shape that shows it, then thousands of random soups.
#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace druse {
namespace {

using namespace test;
using Rings = std::vector<std::vector<std::uint32_t>>;

struct Soup {
    std::vector<Point> points;
    Rings faces;
};

Soup soup_of(const Mesh& mesh)
{
    Soup s;
    for (const Vertex v : mesh.vertices()) s.points.push_back(mesh.position(v));
    s.faces = rings(mesh);
    return s;
}

/// Adds the faces of another soup; its vertices become new ones unless `same` knows better.
void add(Soup& s, const Soup& other, const Vector& by)
{
    const auto first = static_cast<std::uint32_t>(s.points.size());
    for (const Point& p : other.points) s.points.push_back(p + by);
    for (auto f : other.faces) {
        for (auto& v : f) v += first;
        s.faces.push_back(f);
    }
}

/// Makes one vertex of all that lie in the same place.
void weld(Soup& s)
{
    std::vector<std::uint32_t> first(s.points.size());
    std::vector<Point> kept;
    for (std::size_t i = 0; i < s.points.size(); ++i) {
        const auto same = std::find_if(kept.begin(), kept.end(), [&](const Point& p) { return glm::distance(p, s.points[i]) < 1e-9; });
        first[i] = static_cast<std::uint32_t>(same - kept.begin());
        if (same == kept.end()) kept.push_back(s.points[i]);
    }
    s.points = kept;
    for (auto& f : s.faces)
        for (auto& v : f) v = first[v];
}

struct Mended {
    Mesh mesh;
    Repairs repairs;
};

Mended mended(const Soup& s)
{
    MeshBuilder builder;
    for (const Point& p : s.points) builder.add_vertex(p);
    int group = 0;
    for (const auto& f : s.faces) builder.add_face(f, ++group); // the group remembers which polygon it was
    Mended m;
    m.mesh = builder.build(m.repairs);
    EXPECT_SOUND(m.mesh);
    return m;
}

std::vector<double> component_volumes(const Mesh& mesh)
{
    const Components parts = components(mesh);
    std::vector<double> volumes(parts.parts.size());
    for (const Face f : mesh.faces()) {
        const Point mean = vertex_mean(mesh, f);
        for (const Corner c : mesh.corners(f))
            volumes[parts.of_face[f.index]] += glm::dot(mean, glm::cross(mesh.position(c), mesh.position(mesh.next(c)))) / 6;
    }
    return volumes;
}

void turn(std::vector<std::uint32_t>& face) { std::reverse(face.begin() + 1, face.end()); }

// --- winding ------------------------------------------------------------------------------------------------------------------

TEST(Winding, TurnsTheFewerFacesOfAComponent)
{
    for (const Mesh& mesh : {cube(), dodecahedron(), torus(6, 5)})
        for (const std::size_t f : {std::size_t(0), std::size_t(3)}) {
            Soup s = soup_of(mesh);
            turn(s.faces[f]);
            const Mended m = mended(s);
            EXPECT_EQ(m.repairs.faces_turned, 1u);
            EXPECT_EQ(rings(m.mesh), rings(mesh)); // each face starts where it did
            EXPECT_EQ(m.repairs.notes(), std::vector<std::string>{"1 face was wound against its neighbours: turned"});
        }
}

TEST(Winding, LeavesAComponentThatIsInsideOutAsItIs)
{
    Soup s = soup_of(cube());
    for (auto& f : s.faces) turn(f);
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.faces_turned, 0u);
    EXPECT_NEAR(volume(m.mesh), -1.0, 1e-12);
    turn(s.faces[4]); // now the one that is right is the odd one
    EXPECT_NEAR(volume(mended(s).mesh), -1.0, 1e-12);
}

TEST(Winding, OfTwoEqualHalvesKeepsTheOneWithTheFirstFace)
{
    Soup s = soup_of(cube());
    for (const std::size_t f : {3, 4, 5}) turn(s.faces[f]);
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.faces_turned, 3u);
    EXPECT_EQ(rings(m.mesh), rings(cube()));
}

TEST(Winding, IsSettledForEachComponentAlone)
{
    Soup s = soup_of(cube()), other = s;
    turn(s.faces[1]);
    turn(s.faces[2]);
    for (auto& f : other.faces) turn(f);
    turn(other.faces[0]);
    add(s, other, {3, 0, 0});
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.faces_turned, 3u);
    const auto volumes = component_volumes(m.mesh);
    ASSERT_EQ(volumes.size(), 2u);
    EXPECT_NEAR(volumes[0], 1.0, 1e-12);
    EXPECT_NEAR(volumes[1], -1.0, 1e-12);
}

TEST(Winding, MendsAnyMixtureOnAnyShape)
{
    std::mt19937 random(5);
    for (const Mesh& mesh : {icosahedron(), torus(7, 4), block_with_holes(3), open_grid(6, 5), l_prism()})
        for (int round = 0; round < 20; ++round) {
            Soup s = soup_of(mesh);
            std::uint32_t turned = 0;
            for (auto& f : s.faces)
                if (random() % 3 == 0) {
                    turn(f);
                    ++turned;
                }
            const Mended m = mended(s);
            EXPECT_LE(m.repairs.faces_turned, m.mesh.face_count() / 2);
            EXPECT_EQ(counts(m.mesh), counts(mesh));
            EXPECT_EQ(genus(m.mesh), genus(mesh));
            if (2 * turned < m.mesh.face_count()) {
                EXPECT_EQ(m.repairs.faces_turned, turned);
                EXPECT_EQ(rings(m.mesh), rings(mesh));
            }
        }
}

// --- one-sided surfaces -------------------------------------------------------------------------------------------------------

/// An nu × nv grid of quads whose u direction closes with a twist.
Soup twisted_band(int nu, int nv, bool close_v)
{
    Soup s;
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j) s.points.emplace_back(i, j, 0);
    const auto at = [=](int i, int j) {
        if (close_v) j %= nv;
        if (i == nu) {
            i = 0;
            j = close_v ? (nv - j) % nv : nv - 1 - j;
        }
        return static_cast<std::uint32_t>(i * nv + j);
    };
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j + (close_v ? 0 : 1) < nv; ++j) s.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return s;
}

TEST(OneSided, SurfacesAreRefused)
{
    for (const Soup& s : {twisted_band(5, 2, false), twisted_band(7, 4, false), twisted_band(6, 5, true)}) {
        try {
            mended(s);
            ADD_FAILURE() << "expected a complaint";
        } catch (const CommandError& e) {
            EXPECT_EQ(std::string(e.what()).find("the surface is one-sided (like a Möbius strip): face "), 0u) << e.what();
        }
    }
}

TEST(OneSided, IsAFaceThatMeetsItselfTheSameWay)
{
    EXPECT_THROW(mended({{Point(0), Point(1), Point(2), Point(3)}, {{0, 1, 2, 0, 1, 3}}}), CommandError);
}

// --- vertices -----------------------------------------------------------------------------------------------------------------

TEST(BowTie, CubesThatShareAVertexComeApart)
{
    Soup s = soup_of(cube());
    add(s, soup_of(cube()), {1, 1, 1});
    weld(s);
    ASSERT_EQ(s.points.size(), 15u);
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.vertices_split, 1u);
    EXPECT_EQ(counts(m.mesh), (Counts{16, 24, 12}));
    EXPECT_EQ(components(m.mesh).parts.size(), 2u);
    EXPECT_EQ(m.mesh.position(Vertex(15)), Point(0.5, 0.5, 0.5)); // the new one comes last
    EXPECT_EQ(m.repairs.notes(), std::vector<std::string>{"1 vertex joined surfaces in a point only: split"});
    // Where the first face uses it, the vertex keeps its id.
    EXPECT_EQ(ring(m.mesh, Face(2)), ring(cube(), Face(2)));
}

TEST(BowTie, IsSplitIntoAsManyVerticesAsThereAreFans)
{
    Soup s;
    for (int i = 0; i < 5; ++i) add(s, soup_of(tetrahedron()), {0, 0, 0});
    for (std::uint32_t i = 0; i < 5; ++i)
        for (std::size_t f = 0; f < 4; ++f)
            for (auto& v : s.faces[4 * i + f]) v = v == 4 * i ? 0 : v; // all share vertex 0
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.vertices_split, 1u);
    EXPECT_EQ(m.repairs.loose_vertices, 4u);
    EXPECT_EQ(components(m.mesh).parts.size(), 5u);
    EXPECT_EQ(m.mesh.vertex_count(), 20u);
}

TEST(BowTie, OfOneSurfaceIsSplitWithoutTearingIt)
{
    // Two opposite corners of a torus pinched into one.
    Soup s = soup_of(torus(8, 6));
    for (auto& f : s.faces)
        for (auto& v : f) v = v == 27 ? 0 : v;
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.vertices_split, 1u);
    EXPECT_EQ(m.repairs.loose_vertices, 1u);
    EXPECT_EQ(counts(m.mesh), (Counts{48, 96, 48}));
    EXPECT_EQ(genus(m.mesh), 1);
}

TEST(LooseVertices, AreLeftOutAndTheRestMovesUp)
{
    Soup s = soup_of(cube());
    s.points.insert(s.points.begin() + 3, Point(7, 7, 7));
    s.points.push_back(Point(8, 8, 8));
    for (auto& f : s.faces)
        for (auto& v : f) v += v >= 3 ? 1 : 0;
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.loose_vertices, 2u);
    EXPECT_EQ(rings(m.mesh), rings(cube()));
    EXPECT_TRUE(std::ranges::equal(m.mesh.positions(), cube().positions()));
    EXPECT_EQ(m.repairs.notes(), std::vector<std::string>{"2 vertices belong to no face: left out"});
}

// --- crowded edges ------------------------------------------------------------------------------------------------------------

TEST(CrowdedEdge, CubesThatShareAnEdgeComeApartIntoCubes)
{
    std::mt19937 random(3);
    for (int round = 0; round < 50; ++round) { // in any order, and from any start
        Soup s = soup_of(cube());
        add(s, soup_of(cube()), {1, 1, 0});
        weld(s);
        ASSERT_EQ(s.points.size(), 14u);
        if (round > 0) {
            std::shuffle(s.faces.begin(), s.faces.end(), random);
            for (auto& f : s.faces) std::rotate(f.begin(), f.begin() + static_cast<std::ptrdiff_t>(random() % 4), f.end());
        }
        const Mended m = mended(s);
        EXPECT_EQ(m.repairs.edges_split, 1u);
        EXPECT_EQ(m.repairs.vertices_split, 0u); // they came apart with the edge
        EXPECT_EQ(m.repairs.boundary_edges, 0u);
        EXPECT_EQ(counts(m.mesh), (Counts{16, 24, 12}));
        const auto volumes = component_volumes(m.mesh);
        ASSERT_EQ(volumes.size(), 2u);
        EXPECT_NEAR(volumes[0], 1.0, 1e-12);
        EXPECT_NEAR(volumes[1], 1.0, 1e-12);
        EXPECT_EQ(m.repairs.notes(), std::vector<std::string>{"1 edge had three or more faces: split into pairs"});
    }
}

TEST(CrowdedEdge, ThreeWedgesAboutOneEdgeComeApart)
{
    // Triangular prisms of 40 degrees about the z axis, at 0, 120 and 240 degrees: six faces at one edge.
    Soup s;
    for (int k = 0; k < 3; ++k) {
        Soup wedge;
        for (const double z : {0.0, 1.0}) {
            wedge.points.emplace_back(0, 0, z);
            for (const double degrees : {120.0 * k, 120.0 * k + 40})
                wedge.points.emplace_back(std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180), z);
        }
        wedge.faces = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
        add(s, wedge, {});
    }
    weld(s);
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.edges_split, 1u);
    EXPECT_EQ(counts(m.mesh), (Counts{18, 27, 15}));
    for (const double v : component_volumes(m.mesh)) EXPECT_NEAR(v, 0.5 * std::sin(40 * M_PI / 180), 1e-12);
}

TEST(CrowdedEdge, BlocksWithACommonWallComeApart)
{
    // A wall between two rooms, given twice, once for each room: four faces at each of its edges, two of them at one angle.
    Soup s = soup_of(cube());
    add(s, soup_of(cube()), {1, 0, 0});
    weld(s);
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.edges_split, 4u);
    EXPECT_EQ(counts(m.mesh), (Counts{16, 24, 12}));
    for (const double v : component_volumes(m.mesh)) EXPECT_NEAR(v, 1.0, 1e-12);
}

TEST(CrowdedEdge, AConcaveFaceLeavesItInTheRightDirection)
{
    // An L beside a cube that touches its inner edge from across: the mean of the L's corners lies on the wrong side there.
    Soup s = soup_of(l_prism());
    Soup block = soup_of(cube());
    add(s, block, {1.5, 1.5, 0.5}); // fills the notch but for nothing: shares the inner edge and two walls
    weld(s);
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.boundary_edges, 0u);
    double sum = 0;
    for (const double v : component_volumes(m.mesh)) {
        EXPECT_GT(v, 0);
        sum += v;
    }
    EXPECT_NEAR(sum, 4.0, 1e-12);
}

TEST(CrowdedEdge, WithAnOddFaceLeavesItAsAnOpenSheet)
{
    // A cube with a square fin on one of its edges: three faces there, then with two fins: four.
    Soup s = soup_of(cube());
    const auto edge = s.faces[5];
    const auto fin = [&](double out) {
        const auto n = static_cast<std::uint32_t>(s.points.size());
        s.points.push_back(s.points[edge[1]] + Vector(out, -1, 1));
        s.points.push_back(s.points[edge[0]] + Vector(out, -1, 1));
        s.faces.push_back({edge[0], edge[1], n, n + 1});
    };
    for (const std::uint32_t fins : {1u, 2u, 3u}) {
        fin(0.1 * fins);
        const Mended m = mended(s);
        EXPECT_EQ(m.repairs.edges_split, 1u);
        EXPECT_EQ(m.repairs.boundary_edges, 4 * fins); // all fins run one way, so none finds a mate
        EXPECT_EQ(m.repairs.boundary_loops, fins);
        EXPECT_NEAR(component_volumes(m.mesh)[0], 1.0, 1e-12);
    }
}

TEST(CrowdedEdge, ComesApartEvenIfTheSolidsWereWoundAgainstEachOther)
{
    Soup s = soup_of(cube()), other = s;
    for (auto& f : other.faces) turn(f);
    turn(other.faces[0]);
    add(s, other, {1, 1, 0});
    weld(s);
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.faces_turned, 1u);
    EXPECT_EQ(m.repairs.boundary_edges, 0u);
    EXPECT_EQ(components(m.mesh).parts.size(), 2u);
}

TEST(DuplicateFaces, BecomeASheetOfTheirOwn)
{
    for (std::size_t f = 0; f < 6; ++f)
        for (std::size_t start = 0; start < 4; ++start) {
            Soup s = soup_of(warped_cube());
            auto copy = s.faces[f];
            std::rotate(copy.begin(), copy.begin() + static_cast<std::ptrdiff_t>(start), copy.end());
            s.faces.push_back(copy);
            const Mended m = mended(s);
            EXPECT_EQ(m.repairs.edges_split, 4u);
            EXPECT_EQ(m.repairs.boundary_edges, 4u);
            EXPECT_EQ(m.repairs.boundary_loops, 1u);
            EXPECT_EQ(components(m.mesh).parts.size(), 2u);
            EXPECT_EQ(counts(m.mesh), (Counts{12, 16, 7}));
        }
}

TEST(DuplicateFaces, OfALoneTriangleMakeItTwoSided)
{
    const Mended m = mended({{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}, {1, 2, 0}}});
    EXPECT_EQ(counts(m.mesh), (Counts{3, 3, 2}));
    EXPECT_EQ(m.repairs.faces_turned, 1u);
    EXPECT_EQ(m.mesh.boundary_count(), 0u);
}

// --- openings -----------------------------------------------------------------------------------------------------------------

TEST(Opening, IsClosedByOneBoundaryFacePerLoop)
{
    Soup s = soup_of(cube());
    s.faces.erase(s.faces.begin() + 5);
    s.faces.erase(s.faces.begin());
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.boundary_edges, 8u);
    EXPECT_EQ(m.repairs.boundary_loops, 2u);
    EXPECT_EQ(m.mesh.boundary_count(), 2u);
    EXPECT_EQ(counts(m.mesh), (Counts{8, 12, 4}));
    EXPECT_EQ(boundary_edge_count(m.mesh), 8u);
    EXPECT_EQ(genus(m.mesh), 0);
    EXPECT_EQ(m.repairs.notes(), std::vector<std::string>{"the surface is open: 8 boundary edges in 2 loops"});
    for (const Face f : m.mesh.boundary_faces()) EXPECT_EQ(valence(m.mesh, f), 4);
}

TEST(Opening, WhereTwoLoopsMeetInAVertexTheVertexIsSplit)
{
    // Two missing squares of a grid that touch in a corner: the surface there is two fans.
    Soup s = soup_of(open_grid(4, 4));
    s.faces.erase(s.faces.begin() + 10);
    s.faces.erase(s.faces.begin() + 5);
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.vertices_split, 1u);
    EXPECT_EQ(m.repairs.boundary_loops, 2u); // the border, and one around both holes
    EXPECT_EQ(m.repairs.boundary_edges, 16u + 8u);
    EXPECT_EQ(counts(m.mesh), (Counts{26, 40, 14}));
}

TEST(Opening, OfALoneTriangleIsItsOtherSide)
{
    const Mended m = mended({{Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0)}, {{0, 1, 2}}});
    EXPECT_EQ(m.repairs.boundary_edges, 3u);
    EXPECT_EQ(ring(m.mesh, Face::boundary(0)).size(), 3u);
    EXPECT_EQ(m.repairs.notes(), std::vector<std::string>{"the surface is open: 3 boundary edges in 1 loop"});
}

TEST(Opening, IsNotSeenByCountsRangesOrBounds)
{
    const Mended m = mended(soup_of(open_tube(5)));
    std::uint32_t faces = 0;
    for (const Face f : m.mesh.faces()) faces += f.is_boundary() ? 100 : 1;
    EXPECT_EQ(faces, 5u);
    EXPECT_EQ(euler_characteristic(m.mesh), 0);
}

TEST(Opening, GoesAroundAVertexThatThreeFansShareWithAClosedOne)
{
    // Two open fans and a tetrahedron at one vertex.
    Soup s = soup_of(tetrahedron());
    for (int k = 0; k < 2; ++k) {
        const auto n = static_cast<std::uint32_t>(s.points.size());
        for (int i = 0; i < 3; ++i) s.points.emplace_back(5 + i, k, i * i);
        s.faces.push_back({0, n, n + 1});
        s.faces.push_back({0, n + 1, n + 2});
    }
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.vertices_split, 1u);
    EXPECT_EQ(m.repairs.boundary_loops, 2u);
    EXPECT_EQ(components(m.mesh).parts.size(), 3u);
}

// --- degenerate polygons --------------------------------------------------------------------------------------------------------

TEST(Repetition, OfAVertexInAFaceIsLeftOut)
{
    Soup s = soup_of(cube());
    s.faces[2].insert(s.faces[2].begin() + 1, 2, s.faces[2][1]);
    s.faces[3].push_back(s.faces[3][0]);
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.sides_dropped, 3u);
    EXPECT_EQ(m.repairs.faces_dropped, 0u);
    EXPECT_EQ(rings(m.mesh), rings(cube()));
    EXPECT_EQ(m.repairs.notes(), std::vector<std::string>{"3 sides of faces ran from a vertex to itself: left out"});
}

TEST(Repetition, ThatLeavesFewerThanThreeCornersTakesTheFaceAway)
{
    Soup s = soup_of(cube());
    const auto n = static_cast<std::uint32_t>(s.points.size());
    s.points.push_back(Point(9));
    s.faces.insert(s.faces.begin() + 1, {{n, n, n}, {0, 0, 1}});
    s.faces.push_back({3, 3});
    const Mended m = mended(s);
    EXPECT_EQ(m.repairs.sides_dropped, 2u + 1u + 1u);
    EXPECT_EQ(m.repairs.faces_dropped, 3u);
    EXPECT_EQ(m.repairs.loose_vertices, 1u);
    EXPECT_EQ(rings(m.mesh), rings(cube()));
    EXPECT_EQ(m.mesh.group(Face(1)), 4); // groups stay with their faces
}

TEST(Repetition, OfAnEdgeInOneFaceIsKeptIfItRunsBothWays)
{
    // A square whose border goes in along a spike and out again.
    const Mended m = mended({{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0), Point(.5, .5, 0)}, {{0, 4, 0, 1, 2, 3}}});
    EXPECT_EQ(counts(m.mesh), (Counts{5, 5, 1}));
    EXPECT_EQ(m.repairs.boundary_edges, 4u);
}

// --- anything -----------------------------------------------------------------------------------------------------------------

TEST(Soup, WhereEveryVertexMeetsEveryOtherDoesNotHang)
{
    // K(n, n): each of n² edges has two faces, then four. No order of vertices keeps the lists of edges short.
    for (const bool half : {true, false}) {
        constexpr std::uint32_t n = 600;
        MeshBuilder builder;
        for (std::uint32_t v = 0; v < 2 * n; ++v) builder.add_vertex(Point(v % n, v / n, (v * 7919) % 101));
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = 0; j < n; ++j) {
                const std::uint32_t a = i, b = n + j, c = (i + 1) % n, d = n + (j + 1) % n;
                if (!half || (i + j) % 2 == 0) builder.add_face(std::vector<std::uint32_t>{a, b, c, d});
            }
        Repairs repairs;
        try {
            EXPECT_SOUND(builder.build(repairs));
        } catch (const CommandError&) {
        }
    }
}

TEST(Soup, OfOneTriangleManyTimesDoesNotHang)
{
    MeshBuilder builder;
    for (int i = 0; i < 3; ++i) builder.add_vertex(Point(i, i * i, 0));
    for (int i = 0; i < 20000; ++i) builder.add_face(i % 2 == 0 ? std::vector<std::uint32_t>{0, 1, 2} : std::vector<std::uint32_t>{0, 2, 1});
    Repairs repairs;
    const Mesh mesh = builder.build(repairs);
    EXPECT_SOUND(mesh);
    EXPECT_EQ(repairs.edges_split, 3u);
    EXPECT_EQ(mesh.face_count(), 20000u);
}

class RandomSoups : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Seeds, RandomSoups, testing::Range(0, 40));

TEST_P(RandomSoups, EndAsSoundMeshesOrOneSidedSurfaces)
{
    int sound = 0, refused = 0;
    for (int k = 0; k < 500; ++k) {
        const unsigned seed = static_cast<unsigned>(GetParam() * 1000 + k);
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        const std::uint32_t vertices = 1 + random() % 9, faces = random() % 12;
        Soup s;
        for (std::uint32_t v = 0; v < vertices; ++v) s.points.emplace_back(random() % 3, random() % 3, random() % 3); // often in one place
        for (std::uint32_t f = 0; f < faces; ++f) {
            std::vector<std::uint32_t> polygon(1 + random() % 6);
            for (auto& v : polygon) v = static_cast<std::uint32_t>(random() % vertices);
            s.faces.push_back(polygon);
        }
        try {
            const Mended m = mended(s);
            ++sound;
            ASSERT_EQ(m.mesh.face_count() + m.repairs.faces_dropped, faces);
            ASSERT_EQ(m.mesh.boundary_count(), m.repairs.boundary_loops);
            ASSERT_EQ(boundary_edge_count(m.mesh), m.repairs.boundary_edges);
            for (const std::int64_t g : facts(m.mesh).component_genus) ASSERT_GE(g, 0);
            // What came out needs no mending but its openings.
            const Mended again = mended(soup_of(m.mesh));
            if (facts(m.mesh).parallel_edges == 0) {
                ASSERT_EQ(rings(again.mesh), rings(m.mesh));
            }
        } catch (const CommandError&) {
            ++refused;
        }
    }
    EXPECT_GT(sound, 50);
    EXPECT_GT(refused, 0);
}

TEST_P(RandomSoups, MadeFromShapesLoseNothing)
{
    std::mt19937 random(static_cast<unsigned>(GetParam()));
    for (const NamedShape& shape : all_shapes()) {
        SCOPED_TRACE(shape.name);
        Soup s = soup_of(shape.make());
        if (s.faces.empty()) continue;
        for (int damage = static_cast<int>(random() % 6); damage > 0; --damage) {
            auto& face = s.faces[random() % s.faces.size()];
            switch (random() % 5) {
            case 0: turn(face); break;
            case 1: s.faces.push_back(face); break;
            case 2: face[random() % face.size()] = static_cast<std::uint32_t>(random() % s.points.size()); break;
            case 3: face.insert(face.begin(), face.back()); break;
            case 4: std::swap(face, s.faces.back()); break;
            }
        }
        try {
            const Mended m = mended(s);
            EXPECT_EQ(m.mesh.face_count() + m.repairs.faces_dropped, s.faces.size());
        } catch (const CommandError&) {
        }
    }
}

} // namespace
} // namespace druse
