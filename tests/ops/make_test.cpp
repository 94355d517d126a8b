// make.*: counts, regularity, and the order of ids that the window and scripts rely on.
#include "ops/make.h"

#include "dlfl/mesh_builder.h"
#include "ops/solid.h"
#include "run.h"
#include "support/mesh_checks.h"

#include <cmath>
#include <numbers>
#include <set>

namespace druse {
namespace {

using namespace test;
using Ring = std::vector<std::uint32_t>;
constexpr double pi = std::numbers::pi, phi = std::numbers::phi;

Mesh made(const char* name, const std::vector<std::pair<std::string, std::string>>& arguments = {})
{
    Scene scene;
    run(scene, name, arguments);
    return scene.mesh;
}

/// Centred, outside out, sound, and as a reader of its faces would number it.
void expect_well_made(const Mesh& mesh)
{
    ASSERT_SOUND(mesh);
    EXPECT_TRUE(edges_are_numbered_by_first_use(mesh));
    Point mean(0.0);
    for (const Point& p : mesh.positions()) mean += p / double(mesh.vertex_count());
    EXPECT_LT(glm::length(mean), 1e-12 * bounds(mesh).diagonal());
    for (const Face f : mesh.faces()) EXPECT_EQ(mesh.group(f), 0);
    MeshBuilder builder;
    for (const Point& p : mesh.positions()) builder.add_vertex(p);
    for (const Face f : mesh.faces()) builder.add_face(ring(mesh, f));
    EXPECT_TRUE(builder.build() == mesh);
}

// --- regular_solids -----------------------------------------------------------------------------------------------------------------------

struct Known {
    const char* name;
    Counts counts;
    std::map<int, int> faces; // how many with so many sides
    double volume;            // with edges of length 1; 0: not in the tables
    friend std::ostream& operator<<(std::ostream& out, const Known& k) { return out << k.name; }
};

// Volumes: Coxeter 1973 and Johnson 1966, in closed form.
const double root2 = std::sqrt(2.0), root3 = std::sqrt(3.0), root5 = std::sqrt(5.0);
const std::vector<Known> regular_solids{
    {"tetrahedron", {4, 6, 4}, {{3, 4}}, root2 / 12},
    {"cube", {8, 12, 6}, {{4, 6}}, 1},
    {"octahedron", {6, 12, 8}, {{3, 8}}, root2 / 3},
    {"dodecahedron", {20, 30, 12}, {{5, 12}}, (15 + 7 * root5) / 4},
    {"icosahedron", {12, 30, 20}, {{3, 20}}, 5 * (3 + root5) / 12},
    {"truncated_tetrahedron", {12, 18, 8}, {{3, 4}, {6, 4}}, 23 * root2 / 12},
    {"cuboctahedron", {12, 24, 14}, {{3, 8}, {4, 6}}, 5 * root2 / 3},
    {"truncated_cube", {24, 36, 14}, {{3, 8}, {8, 6}}, (21 + 14 * root2) / 3},
    {"truncated_octahedron", {24, 36, 14}, {{4, 6}, {6, 8}}, 8 * root2},
    {"rhombicuboctahedron", {24, 48, 26}, {{3, 8}, {4, 18}}, (12 + 10 * root2) / 3},
    {"truncated_cuboctahedron", {48, 72, 26}, {{4, 12}, {6, 8}, {8, 6}}, 22 + 14 * root2},
    {"snub_cube", {24, 60, 38}, {{3, 32}, {4, 6}}, 7.889477399975390},
    {"icosidodecahedron", {30, 60, 32}, {{3, 20}, {5, 12}}, (45 + 17 * root5) / 6},
    {"truncated_dodecahedron", {60, 90, 32}, {{3, 20}, {10, 12}}, 5 * (99 + 47 * root5) / 12},
    {"truncated_icosahedron", {60, 90, 32}, {{5, 12}, {6, 20}}, (125 + 43 * root5) / 4},
    {"rhombicosidodecahedron", {60, 120, 62}, {{3, 20}, {4, 30}, {5, 12}}, (60 + 29 * root5) / 3},
    {"truncated_icosidodecahedron", {120, 180, 62}, {{4, 30}, {6, 20}, {10, 12}}, 95 + 50 * root5},
    {"snub_dodecahedron", {60, 150, 92}, {{3, 80}, {5, 12}}, 37.616649962733363},
    {"prism:3", {6, 9, 5}, {{3, 2}, {4, 3}}, root3 / 4},
    {"prism:100", {200, 300, 102}, {{4, 100}, {100, 2}}, 25 / std::tan(pi / 100)},
    {"antiprism:3", {6, 12, 8}, {{3, 8}}, root2 / 3},
    {"antiprism:100", {200, 400, 202}, {{3, 200}, {100, 2}}, 0},
    {"pyramid:3", {4, 6, 4}, {{3, 4}}, root2 / 12},
    {"pyramid:4", {5, 8, 5}, {{3, 4}, {4, 1}}, root2 / 6},
    {"pyramid:5", {6, 10, 6}, {{3, 5}, {5, 1}}, (5 + root5) / 24},
    {"cupola:3", {9, 15, 8}, {{3, 4}, {4, 3}, {6, 1}}, 5 / (3 * root2)},
    {"cupola:4", {12, 20, 10}, {{3, 4}, {4, 5}, {8, 1}}, 1 + 2 * root2 / 3},
    {"cupola:5", {15, 25, 12}, {{3, 5}, {4, 5}, {5, 1}, {10, 1}}, (5 + 4 * root5) / 6},
    {"rotunda", {20, 35, 17}, {{3, 10}, {5, 6}, {10, 1}}, (45 + 17 * root5) / 12},
    {"bipyramid:3", {5, 9, 6}, {{3, 6}}, root2 / 6},
    {"bipyramid:4", {6, 12, 8}, {{3, 8}}, root2 / 3},
    {"bipyramid:5", {7, 15, 10}, {{3, 10}}, (5 + root5) / 12},
    {"elongated_pyramid:3", {7, 12, 7}, {{3, 4}, {4, 3}}, root3 / 4 + root2 / 12},
    {"elongated_pyramid:4", {9, 16, 9}, {{3, 4}, {4, 5}}, 1 + root2 / 6},
    {"elongated_pyramid:5", {11, 20, 11}, {{3, 5}, {4, 5}, {5, 1}}, 0},
    {"gyroelongated_pyramid:4", {9, 20, 13}, {{3, 12}, {4, 1}}, 0},
    {"gyroelongated_pyramid:5", {11, 25, 16}, {{3, 15}, {5, 1}}, (25 + 9 * root5) / 24},
    {"elongated_cupola:3", {15, 27, 14}, {{3, 4}, {4, 9}, {6, 1}}, 5 * root2 / 6 + 3 * root3 / 2},
    {"elongated_cupola:4", {20, 36, 18}, {{3, 4}, {4, 13}, {8, 1}}, 3 + 8 * root2 / 3},
    {"elongated_cupola:5", {25, 45, 22}, {{3, 5}, {4, 15}, {5, 1}, {10, 1}}, 0},
    {"gyroelongated_cupola:3", {15, 33, 20}, {{3, 16}, {4, 3}, {6, 1}}, 0},
    {"gyroelongated_cupola:4", {20, 44, 26}, {{3, 20}, {4, 5}, {8, 1}}, 0},
    {"gyroelongated_cupola:5", {25, 55, 32}, {{3, 25}, {4, 5}, {5, 1}, {10, 1}}, 0},
    {"orthobicupola:3", {12, 24, 14}, {{3, 8}, {4, 6}}, 5 * root2 / 3},
    {"orthobicupola:4", {16, 32, 18}, {{3, 8}, {4, 10}}, 2 + 4 * root2 / 3},
    {"orthobicupola:5", {20, 40, 22}, {{3, 10}, {4, 10}, {5, 2}}, (5 + 4 * root5) / 3},
    {"gyrobicupola:3", {12, 24, 14}, {{3, 8}, {4, 6}}, 5 * root2 / 3},
    {"gyrobicupola:4", {16, 32, 18}, {{3, 8}, {4, 10}}, 2 + 4 * root2 / 3},
    {"gyrobicupola:5", {20, 40, 22}, {{3, 10}, {4, 10}, {5, 2}}, (5 + 4 * root5) / 3},
};

class EveryBuiltInSolid : public testing::TestWithParam<Known> {};
INSTANTIATE_TEST_SUITE_P(Make, EveryBuiltInSolid, testing::ValuesIn(regular_solids), [](const auto& p) {
    std::string name = p.param.name;
    std::ranges::replace(name, ':', '_');
    return name;
});

TEST_P(EveryBuiltInSolid, HasRegularFacesAndUnitEdges)
{
    const Known& known = GetParam();
    const Mesh mesh = make_solid(known.name, 1);
    expect_well_made(mesh);
    EXPECT_EQ(counts(mesh), known.counts);
    std::map<int, int> faces;
    for (const Face f : mesh.faces()) {
        const int n = mesh.valence(f);
        ++faces[n];
        // Regular: unit sides, flat, and the area of the regular n-gon.
        EXPECT_NEAR(area(mesh, f), n / (4 * std::tan(pi / n)), 1e-14 * n * n);
        EXPECT_GT(glm::dot(unit_normal(mesh, f), vertex_mean(mesh, f)), 0.0);
    }
    EXPECT_EQ(faces, known.faces);
    for (const Edge e : mesh.edges()) EXPECT_NEAR(length(mesh, e), 1, mesh.vertex_count() < 200 ? 3e-15 : 2e-14);
    EXPECT_LT(flatness(mesh), 1e-14 * mesh.vertex_count());
    if (known.volume > 0) {
        EXPECT_NEAR(volume(mesh), known.volume, 1e-13 * known.volume);
    }
}

TEST(MakeSolid, KnowsNoOthersThanTheseAndTheirFamilies)
{
    std::set<std::string> tested, named;
    for (const Known& k : regular_solids) tested.insert(std::string(k.name).substr(0, std::string(k.name).find(':')));
    for (const std::string& name : solid_names()) named.insert(name.substr(0, name.find(':')));
    EXPECT_EQ(tested, named);
}

TEST(MakeSolid, NumbersFromTheBottomUpAndRoundFromX)
{
    // The cube: bottom, the sides that look to +x, +y, −x, −y, and the top.
    const Mesh mesh = make_solid("cube", 1);
    const std::vector<Vector> looks{{0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    for (const Face f : mesh.faces()) EXPECT_EQ(unit_normal(mesh, f), looks[f.index]);
    EXPECT_EQ(mesh.position(Vertex(0)), Point(0.5, 0.5, -0.5));
    EXPECT_EQ(mesh.position(Vertex(3)), Point(0.5, -0.5, -0.5));
    EXPECT_EQ(mesh.position(Vertex(4)), Point(0.5, 0.5, 0.5));
    EXPECT_EQ(ring(mesh, Face(5)), (Ring{4, 5, 6, 7}));
}

TEST(MakeSolid, SaysWhatItCannotMake)
{
    const auto refuses = [](const char* name) { return complaint({}, "make.solid", {{"name", name}}); };
    EXPECT_EQ(refuses("snub_cub"), "name=snub_cub: there is no such solid; did you mean 'snub_cube'?");
    EXPECT_EQ(refuses("pyramid:6"), "name=pyramid:6: expected pyramid:N with N 3 to 5");
    EXPECT_EQ(refuses("gyroelongated_pyramid:3"), "name=gyroelongated_pyramid:3: expected gyroelongated_pyramid:N with N 4 to 5");
    EXPECT_EQ(refuses("prism"), "name=prism: expected prism:N with N 3 to 100");
    EXPECT_EQ(refuses("prism:-4"), "name=prism:-4: expected prism:N with N 3 to 100");
    EXPECT_EQ(refuses("prism:101"), "name=prism:101: expected prism:N with N 3 to 100");
    EXPECT_EQ(refuses("cube:3"), "name=cube:3: expected cube without a number");
    EXPECT_EQ(refuses("xyzzy").substr(0, 28), "name=xyzzy: expected tetrahe");
}

TEST(Make, OffersTheFivePlatonicSolidsByName)
{
    for (const char* name : {"tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron"}) {
        const Mesh mesh = made((std::string("make.") + name).c_str(), {{"size", "2.5"}});
        EXPECT_TRUE(mesh == make_solid(name, 2.5));
        EXPECT_NEAR(edge_lengths(mesh).longest, 2.5, 5e-15);
    }
}

// --- polygons, prisms, grids -----------------------------------------------------------------------------------------------------

class EveryRegularPolygon : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Make, EveryRegularPolygon, testing::Values(3, 4, 5, 6, 7, 20, 10000));

TEST_P(EveryRegularPolygon, HasTwoSidesAndItsFirstVertexOnX)
{
    const int n = GetParam();
    const Mesh mesh = make_polygon(n, 2);
    const auto m = static_cast<std::uint32_t>(n);
    expect_well_made(mesh);
    EXPECT_EQ(counts(mesh), (Counts{m, m, 2}));
    EXPECT_NEAR(unit_normal(mesh, Face(0)).z, 1, 1e-15);
    EXPECT_NEAR(unit_normal(mesh, Face(1)).z, -1, 1e-15);
    EXPECT_NEAR(mesh.position(Vertex(0)).x, 1 / std::sin(pi / n), 1e-12 * n);
    EXPECT_EQ(mesh.position(Vertex(0)).y, 0);
    EXPECT_EQ(ring(mesh, Face(1))[0], 0u);
    EXPECT_EQ(ring(mesh, Face(1))[1], m - 1);
    EXPECT_NEAR(edge_lengths(mesh).shortest, 2, 1e-15 * n + 1e-15);
    EXPECT_NEAR(edge_lengths(mesh).longest, 2, 1e-15 * n + 1e-15);
}

TEST_P(EveryRegularPolygon, StandsUpAsAPrismAndAnAntiprism)
{
    const int n = GetParam();
    const auto m = static_cast<std::uint32_t>(n);
    const Mesh prism = make_prism(n, 1), antiprism = make_antiprism(n, 1);
    expect_well_made(prism);
    expect_well_made(antiprism);
    EXPECT_EQ(counts(prism), (Counts{2 * m, 3 * m, m + 2}));
    EXPECT_EQ(counts(antiprism), (Counts{2 * m, 4 * m, 2 * m + 2}));
    for (const Mesh* mesh : {&prism, &antiprism}) {
        EXPECT_NEAR(edge_lengths(*mesh).shortest, 1, 1e-15 * n + 1e-15);
        EXPECT_NEAR(edge_lengths(*mesh).longest, 1, 1e-15 * n + 1e-15);
        EXPECT_GT(volume(*mesh), 0);
        EXPECT_NEAR(unit_normal(*mesh, Face(0)).z, -1, 1e-15);
        EXPECT_NEAR(unit_normal(*mesh, Face(mesh->face_count() - 1)).z, 1, 1e-15);
    }
    EXPECT_NEAR(volume(prism), n / (4 * std::tan(pi / n)), 1e-9 * n * n);
}

TEST(MakePolygon, PutsMultiplesOfThirtyDegreesWhereTheyBelong)
{
    const Mesh mesh = make_polygon(12, 1);
    EXPECT_EQ(mesh.position(Vertex(3)).x, 0);
    EXPECT_EQ(mesh.position(Vertex(6)).y, 0);
    EXPECT_EQ(mesh.position(Vertex(2)).x * 2, mesh.position(Vertex(0)).x);
    for (std::uint32_t i = 0; i < 12; ++i) EXPECT_EQ(mesh.position(Vertex(i)), -mesh.position(Vertex((i + 6) % 12)));
}

TEST(MakeGrid, CountsSquaresRowByRowFromLeastYThenLeastX)
{
    const Mesh mesh = made("make.grid", {{"nx", "3"}, {"ny", "2"}, {"size", "2"}});
    expect_well_made(mesh);
    EXPECT_EQ(counts(mesh), (Counts{12, 17, 7}));
    EXPECT_EQ(vertex_mean(mesh, Face(0)), Point(-2, -1, 0));
    EXPECT_EQ(vertex_mean(mesh, Face(1)), Point(0, -1, 0));
    EXPECT_EQ(vertex_mean(mesh, Face(3)), Point(-2, 1, 0));
    for (std::uint32_t f = 0; f < 6; ++f) EXPECT_EQ(area_vector(mesh, Face(f)), Vector(0, 0, 4));
    EXPECT_EQ(mesh.valence(Face(6)), 10);
    EXPECT_EQ(area_vector(mesh, Face(6)), Vector(0, 0, -24));
    EXPECT_EQ(ring(mesh, Face(0)), (Ring{0, 1, 5, 4}));
    EXPECT_EQ(ring(mesh, Face(6)), (Ring{0, 4, 8, 9, 10, 11, 7, 3, 2, 1}));
}

TEST(MakeGrid, OfOneSquareAndOfOneRowCloses)
{
    for (const auto& [nx, ny] : {std::pair(1, 1), std::pair(1, 5), std::pair(5, 1), std::pair(2, 2)}) {
        Progress progress;
        expect_well_made(make_grid(nx, ny, 1, progress));
    }
}

TEST(MakeTorus, IsOneOfQuadsWithAHole)
{
    for (const auto& [nu, nv] : {std::pair(3, 3), std::pair(24, 12), std::pair(5, 9)}) {
        Progress progress;
        const Mesh mesh = make_torus(nu, nv, 2, 0.5, progress);
        expect_well_made(mesh);
        const auto n = static_cast<std::uint32_t>(nu * nv);
        EXPECT_EQ(counts(mesh), (Counts{n, 2 * n, n}));
        EXPECT_EQ(genus(mesh), 1);
        EXPECT_GT(volume(mesh), 0);
        EXPECT_EQ(mesh.position(Vertex(0)), Point(2.5, 0, 0));
    }
    // Pappus: 2π²Rr², from below.
    Progress progress;
    EXPECT_NEAR(volume(make_torus(400, 400, 2, 0.5, progress)), 2 * pi * pi * 2 * 0.25, 1e-3);
}

TEST(MakeSphere, IsBandsOfQuadsBetweenPoles)
{
    for (const auto& [nu, nv] : {std::pair(3, 2), std::pair(3, 3), std::pair(24, 12), std::pair(7, 4)}) {
        Progress progress;
        const Mesh mesh = make_sphere(nu, nv, 2, progress);
        expect_well_made(mesh);
        const auto n = static_cast<std::uint32_t>(nu), bands = static_cast<std::uint32_t>(nv);
        EXPECT_EQ(counts(mesh), (Counts{n * (bands - 1) + 2, n * (2 * bands - 1), n * bands}));
        EXPECT_EQ(genus(mesh), 0);
        for (const Point& p : mesh.positions()) EXPECT_NEAR(glm::length(p), 2, 1e-15 * 4);
        EXPECT_EQ(mesh.position(Vertex(0)), Point(0, 0, -2));
        EXPECT_EQ(mesh.position(Vertex(mesh.vertex_count() - 1)), Point(0, 0, 2));
        EXPECT_EQ(mesh.valence(Face(0)), 3);
        EXPECT_EQ(mesh.valence(Face(mesh.face_count() - 1)), 3);
        EXPECT_GT(volume(mesh), 0);
    }
    Progress progress;
    EXPECT_NEAR(volume(make_sphere(400, 200, 1, progress)), 4 * pi / 3, 1e-3);
}

TEST(MakeGeodesic, CutsEachFaceOfTheIcosahedronIntoFrequencySquaredTriangles)
{
    for (const std::uint32_t f : {1u, 2u, 3u, 4u, 7u, 128u}) {
        const Mesh mesh = made("make.geodesic", {{"frequency", std::to_string(f)}, {"radius", "3"}});
        EXPECT_EQ(counts(mesh), (Counts{10 * f * f + 2, 30 * f * f, 20 * f * f}));
        ASSERT_SOUND(mesh);
        EXPECT_EQ(genus(mesh), 0);
        for (const Point& p : mesh.positions()) EXPECT_NEAR(glm::length(p), 3, 3e-15);
        std::map<int, std::uint32_t> valences;
        for (const Vertex v : mesh.vertices()) ++valences[mesh.valence(v)];
        EXPECT_EQ(valences[5], 12u);
        EXPECT_EQ(valences[5] + valences[6], mesh.vertex_count());
        if (f < 10) {
            expect_well_made(mesh);
            EXPECT_GT(volume(mesh), 0);
            EXPECT_LT(edge_lengths(mesh).relative_spread(), 0.35);
        }
    }
}

// --- in a scene -------------------------------------------------------------------------------------------------------------------

TEST(Make, AddsToWhatIsThereAndSelectsTheNewFaces)
{
    Scene scene;
    run(scene, "make.cube");
    EXPECT_EQ(ids(scene.selection->faces), (Ring{0, 1, 2, 3, 4, 5}));
    scene.selection.edit().edges = {Edge(3)};
    run(scene, "make.tetrahedron");
    EXPECT_EQ(ids(scene.selection->faces), (Ring{6, 7, 8, 9}));
    EXPECT_EQ(ids(scene.selection->edges), Ring{3}); // what survives stays selected
    EXPECT_EQ(counts(scene.mesh), (Counts{12, 18, 10}));
    EXPECT_EQ(components(scene.mesh).parts.size(), 2u);
    EXPECT_SOUND(scene.mesh);
    run(scene, "make.grid", {{"nx", "2"}, {"ny", "2"}});
    EXPECT_EQ(ids(scene.selection->faces), (Ring{10, 11, 12, 13, 14}));
    EXPECT_SOUND(scene.mesh);
}

TEST(Make, RefusesWhatIsOutOfRange)
{
    const auto refuses = [](const char* name, const char* key, const char* value) { return complaint({}, name, {{key, value}}); };
    EXPECT_EQ(refuses("make.cube", "size", "0"), "expected above 0 model units");
    EXPECT_EQ(refuses("make.cube", "size", "1e999"), "expected above 0 model units");
    EXPECT_EQ(refuses("make.polygon", "n", "2"), "expected 3 to 10000 (an integer)");
    EXPECT_EQ(refuses("make.grid", "nx", "4097"), "expected 1 to 4096 (an integer)");
    EXPECT_EQ(refuses("make.torus", "nu", "2"), "expected 3 to 4096 (an integer)");
    EXPECT_EQ(refuses("make.torus", "minor", "1"), "minor=1: expected less than major=1");
    EXPECT_EQ(refuses("make.geodesic", "frequency", "129"), "expected 1 to 128 (an integer)");
    EXPECT_EQ(refuses("make.dodecahedron", "size", "1.7e308"), "the shape is too large: it reaches beyond 1e+38");
}

TEST(Make, CanBeStopped)
{
    Progress progress;
    progress.cancel();
    EXPECT_THROW(make_grid(10, 10, 1, progress), Cancelled);
    EXPECT_THROW(make_torus(10, 10, 2, 1, progress), Cancelled);
    EXPECT_THROW(make_sphere(10, 10, 1, progress), Cancelled);
}

} // namespace
} // namespace druse
