// The seven tiered extrusions against the numbers of the literature: counts, the regular solids they are named after, volumes off
// the regular polygon, numbering of vertices, edges, faces and groups, and what they refuse.
#include "extrude_bases.h"
#include "ops/tiered_kernels.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace druse {
namespace {

using namespace test;

Mesh regular(int n)
{
    std::vector<Point> corners;
    const double radius = 0.5 / std::sin(std::numbers::pi / n);
    for (int i = 0; i < n; ++i) corners.emplace_back(radius * std::cos(2 * std::numbers::pi * i / n), radius * std::sin(2 * std::numbers::pi * i / n), 0);
    return two_sided(corners);
}
struct Settings {
    NewGroups groups = NewGroups::each;
    int iterations = 1;
    bool flat = false;
};

template <class Kernel>
std::vector<Face> extrude(Mesh& mesh, std::vector<Face> faces, const Kernel& kernel = {}, const Settings& s = {})
{
    Progress progress;
    return extrude_faces(mesh, std::move(faces), kernel, s.groups, s.iterations, s.flat, progress);
}

using ByName = std::vector<Face> (*)(Mesh&, std::vector<Face>, const Settings&);
template <class Kernel>
std::vector<Face> by_default(Mesh& mesh, std::vector<Face> faces, const Settings& s)
{
    return extrude(mesh, std::move(faces), Kernel(), s);
}
const std::map<std::string, ByName> kernels{
    {"tetrahedral", &by_default<Tetrahedral>},     {"cubical", &by_default<Cubical>},
    {"octahedral", &by_default<Octahedral>},       {"dodecahedral", &by_default<Dodecahedral>},
    {"icosahedral", &by_default<Icosahedral>},     {"cuboctahedral", &by_default<Cuboctahedral>},
    {"rhombicuboctahedral", &by_default<Rhombicuboctahedral>}};

double highest(const Mesh& mesh) { return bounds(mesh).max.z; }

// --- counts -----------------------------------------------------------------------------------------------------------------

struct Growth {
    const char* name;
    int vertices, edges, faces; // a side and iteration; the tetrahedral's are for one vertex, n edges, n − 1 faces
};
const Growth growths[] = {{"cubical", 1, 2, 1},       {"octahedral", 1, 3, 2},    {"dodecahedral", 3, 5, 2},
                          {"icosahedral", 3, 9, 6},   {"cuboctahedral", 2, 5, 3}, {"rhombicuboctahedral", 5, 11, 6}};

class EveryPolygon : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Sides, EveryPolygon, testing::Values(3, 4, 5, 6, 7, 12, 20, 100));

TEST_P(EveryPolygon, GrowsByTheCountsOfTheTable)
{
    const auto n = static_cast<std::uint32_t>(GetParam());
    for (const Growth& g : growths)
        for (std::uint32_t k = 1; k <= 3; ++k) {
            Mesh mesh = regular(GetParam());
            const auto tops = kernels.at(g.name)(mesh, {Face(0)}, {NewGroups::each, int(k), false});
            EXPECT_SOUND(mesh) << g.name;
            EXPECT_EQ(counts(mesh), (Counts{n + k * n * g.vertices, n + k * n * g.edges, 2 + k * n * g.faces})) << g.name;
            EXPECT_EQ(genus(mesh), 0);
            ASSERT_EQ(tops, std::vector{Face(0)});
            EXPECT_EQ(valence(mesh, tops[0]), GetParam());
            EXPECT_EQ(mesh.largest_group(), int(k * (n * g.faces + 1))) << g.name;
        }
    Mesh mesh = regular(GetParam());
    const auto made = extrude<Tetrahedral>(mesh, {Face(0)});
    EXPECT_SOUND(mesh);
    EXPECT_EQ(counts(mesh), (Counts{n + 1, 2 * n, n + 1}));
    EXPECT_EQ(made.size(), n);
}

// --- the regular solids -------------------------------------------------------------------------------------------------------

struct RegularSolid {
    const char* name;
    int base;
    Counts counts;
    double elevation, volume;
};
const double s5 = std::sqrt(5.0);
const RegularSolid solids[] = {
    {"tetrahedral", 3, {4, 6, 4}, 0.816496580928, std::sqrt(2.0) / 12},
    {"cubical", 4, {8, 12, 6}, 1, 1},
    {"octahedral", 3, {6, 12, 8}, 0.816496580928, std::sqrt(2.0) / 3},
    {"dodecahedral", 5, {20, 30, 12}, 2.227032728823, (15 + 7 * s5) / 4},
    {"icosahedral", 3, {12, 30, 20}, 1.511522628152, 5 * (3 + s5) / 12},
    {"cuboctahedral", 4, {12, 24, 14}, 1.414213562373, 5 * std::sqrt(2.0) / 3},
    {"rhombicuboctahedral", 4, {24, 48, 26}, 2.414213562373, 4 + 10 * std::sqrt(2.0) / 3},
};

class EverySolid : public testing::TestWithParam<RegularSolid> {};
INSTANTIATE_TEST_SUITE_P(Seven, EverySolid, testing::ValuesIn(solids), [](const auto& solid) { return std::string(solid.param.name); });

TEST_P(EverySolid, RisesFromItsRegularPolygonToTwelveDigits)
{
    const RegularSolid& solid = GetParam();
    Mesh mesh = regular(solid.base);
    kernels.at(solid.name)(mesh, {Face(0)}, {});
    EXPECT_SOUND(mesh);
    EXPECT_EQ(counts(mesh), solid.counts);
    EXPECT_LT(edge_lengths(mesh).relative_spread(), 1e-12);
    EXPECT_NEAR(edge_lengths(mesh).mean, 1.0, 1e-12);
    EXPECT_LT(flatness(mesh), 1e-12);
    EXPECT_NEAR(volume(mesh), solid.volume, 1e-11);
    EXPECT_NEAR(highest(mesh), solid.elevation, 1e-11);
    // All vertices at one distance from the centre.
    const Point center = bounds(mesh).center();
    Point mean(0.0);
    for (const Vertex v : mesh.vertices()) mean += mesh.position(v) / double(mesh.vertex_count());
    double least = 1e300, most = 0;
    for (const Vertex v : mesh.vertices()) {
        least = std::min(least, glm::distance(mesh.position(v), mean));
        most = std::max(most, glm::distance(mesh.position(v), mean));
    }
    EXPECT_LT((most - least) / most, 1e-12) << center.z;
}

TEST_P(EverySolid, IsTheSameOnAPolygonOfAnySizeAndPlace)
{
    const RegularSolid& solid = GetParam();
    Mesh mesh = regular(solid.base);
    const Vector x = glm::normalize(Vector(1, 2, -0.5)), z = glm::normalize(glm::cross(x, Vector(0.3, -1, 2))), y = glm::cross(z, x);
    for (const Vertex v : mesh.vertices()) {
        const Point p = 250.0 * mesh.position(v);
        mesh.set_position(v, Point(40, -7, 900) + p.x * x + p.y * y + p.z * z);
    }
    kernels.at(solid.name)(mesh, {Face(0)}, {});
    EXPECT_LT(edge_lengths(mesh).relative_spread(), 1e-12);
    EXPECT_LT(flatness(mesh), 1e-12);
    EXPECT_NEAR(volume(mesh) / (solid.volume * 250.0 * 250.0 * 250.0), 1.0, 1e-12);
}

TEST_P(EverySolid, KeepsItsShapeWithAFlatTop)
{
    const RegularSolid& solid = GetParam();
    if (std::string(solid.name) == "tetrahedral") return; // has no top
    Mesh plain = regular(solid.base), flat = regular(solid.base);
    kernels.at(solid.name)(plain, {Face(0)}, {});
    kernels.at(solid.name)(flat, {Face(0)}, {NewGroups::each, 1, true});
    for (const Vertex v : plain.vertices()) EXPECT_LT(glm::distance(plain.position(v), flat.position(v)), 1e-14);
}

TEST(TierElevations, AreThoseOfTheRegularSolidsWithEdgeOne)
{
    const auto elevations = [](const Mesh& mesh) {
        std::vector<double> z;
        for (const Vertex v : mesh.vertices()) z.push_back(mesh.position(v).z);
        std::ranges::sort(z);
        z.erase(std::unique(z.begin(), z.end(), [](double a, double b) { return std::abs(a - b) < 1e-9; }), z.end());
        return z;
    };
    const std::map<std::pair<std::string, int>, std::vector<double>> expected{
        {{"dodecahedral", 5}, {0, 0.850650808352, 1.376381920471, 2.227032728823}},
        {{"icosahedral", 3}, {0, 0.577350269190, 0.934172358963, 1.511522628152}},
        {{"cuboctahedral", 4}, {0, 0.707106781187, 1.414213562373}},
        {{"rhombicuboctahedral", 4}, {0, 0.707106781187, 1.707106781187, 2.414213562373}}};
    for (const auto& [which, tiers] : expected) {
        Mesh mesh = regular(which.second);
        kernels.at(which.first)(mesh, {Face(0)}, {});
        const auto z = elevations(mesh);
        ASSERT_EQ(z.size(), tiers.size()) << which.first;
        for (std::size_t i = 0; i < z.size(); ++i) EXPECT_NEAR(z[i], tiers[i], 1e-11) << which.first;
    }
}

// --- off the regular polygon ----------------------------------------------------------------------------------------------------

struct Block {
    const char* name;
    const char* base;
    Counts counts;
    double volume, top;
};
const Block blocks[] = {
    {"tetrahedral", "hex", {7, 12, 7}, 0.707106781, 0.816496581},
    {"tetrahedral", "L", {7, 12, 7}, 1.088662108, 1.088662108},
    {"cubical", "irregular", {10, 15, 7}, 9.156877604, 1.831375521},
    {"octahedral", "hex", {12, 24, 14}, 2.592724864, 0.816496581},
    {"octahedral", "L", {12, 24, 14}, 4.082663525, 1.088662108},
    {"octahedral", "irregular", {10, 20, 12}, 9.744764907, 1.495311851},
    {"dodecahedral", "hex", {24, 36, 14}, 11.574662719, 2.320695348},
    {"dodecahedral", "L", {24, 36, 14}, 16.596897514, 3.156893389},
    {"dodecahedral", "irregular", {20, 30, 12}, 44.662527948, 4.244771853},
    {"dodecahedral", "star", {40, 60, 22}, 32.742920220, 2.530875640},
    {"icosahedral", "hex", {24, 60, 38}, 7.205922497, 1.522949629},
    {"icosahedral", "irregular", {20, 50, 32}, 27.713877818, 2.786097691},
    {"cuboctahedral", "hex", {18, 36, 20}, 6.067127210, 1.369100639},
    {"cuboctahedral", "L", {18, 36, 20}, 8.602796076, 1.871057108},
    {"rhombicuboctahedral", "hex", {36, 72, 38}, 15.426362054, 2.414213562},
    {"rhombicuboctahedral", "L", {36, 72, 38}, 30.312368816, 3.218951416},
    {"rhombicuboctahedral", "star", {60, 120, 62}, 64.077629947, 3.645642521},
};

TEST(OffTheRegularPolygon, VolumesAndElevationsAreThoseOfTheTable)
{
    const std::map<std::string, Mesh (*)()> bases{
        {"hex", [] { return regular(6); }}, {"L", &l_shape}, {"irregular", &irregular}, {"star", [] { return star(); }}};
    for (const Block& block : blocks) {
        SCOPED_TRACE(std::string(block.name) + " on " + block.base);
        Mesh mesh = bases.at(block.base)();
        kernels.at(block.name)(mesh, {Face(0)}, {});
        EXPECT_SOUND(mesh);
        EXPECT_EQ(counts(mesh), block.counts);
        EXPECT_NEAR(volume(mesh), block.volume, 1e-9);
        EXPECT_NEAR(highest(mesh), block.top, 1e-9);
    }
}

TEST(Cubical, WallsStandAtTheAngleOnConvexStraightAndReflexCorners)
{
    // An L with a straight corner halfway along its first side.
    const auto base = [] { return two_sided({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}); };
    for (const double angle : {60.0, 90.0, 110.0}) {
        Mesh mesh = base();
        Cubical kernel;
        kernel.angle = angle;
        kernel.heights = {0.3};
        extrude(mesh, {Face(0)}, kernel);
        EXPECT_SOUND(mesh);
        for (std::uint32_t f = 2; f < mesh.face_limit(); ++f) {
            EXPECT_LT(nonplanarity(mesh, Face(f)), 1e-13);
            // Interior dihedral: 180° minus the angle between the outward normals of wall and floor.
            const double between = std::acos(glm::dot(unit_normal(mesh, Face(f)), Vector(0, 0, -1)));
            EXPECT_NEAR(180.0 - between * 180.0 / std::numbers::pi, angle, 1e-9);
        }
    }
}

TEST(Dodecahedral, BothRowsAreFlatOnRegularPolygons)
{
    for (int n = 3; n <= 20; ++n) {
        Mesh mesh = regular(n);
        extrude<Dodecahedral>(mesh, {Face(0)});
        EXPECT_LT(flatness(mesh), 1e-12) << n;
    }
}

TEST(FlatTop, LiesInOnePlaneOnAnIrregularBase)
{
    for (const auto& [name, run] : kernels) {
        if (name == "tetrahedral") continue;
        Mesh mesh = irregular();
        run(mesh, {Face(0)}, {NewGroups::each, 2, true});
        EXPECT_SOUND(mesh);
        EXPECT_LT(nonplanarity(mesh, Face(0)), 1e-12 * highest(mesh)) << name;
    }
}

TEST(NegativeHeights, BuildIntoTheModel)
{
    Mesh mesh = cube();
    const double before = volume(mesh);
    Cubical kernel;
    kernel.heights = {-0.5};
    extrude(mesh, {Face(3)}, kernel);
    EXPECT_SOUND(mesh);
    EXPECT_NEAR(volume(mesh), before / 2, 1e-14);
}

// --- numbering ------------------------------------------------------------------------------------------------------------------

using Rings = std::vector<std::vector<std::uint32_t>>;

TEST(Numbering, TopKeepsTheIdAndRowsAreAppendedFromTheStartCorner)
{
    Mesh mesh = two_sided({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    mesh.set_start(mesh.corner(Face(0), 1));
    extrude<Cubical>(mesh, {Face(0)});
    EXPECT_EQ(rings(mesh), (Rings{{4, 5, 6, 7}, {0, 3, 2, 1}, {1, 2, 5, 4}, {2, 3, 6, 5}, {3, 0, 7, 6}, {0, 1, 4, 7}}));
    // Edges: first those of the top, then as the walls first use them.
    const std::vector<std::pair<std::uint32_t, std::uint32_t>> expected{{4, 5}, {5, 6}, {6, 7}, {7, 4}, {2, 5}, {4, 1}, {3, 6}, {0, 7}};
    for (std::size_t k = 0; k < expected.size(); ++k) {
        const auto [a, b] = mesh.ends(Edge(static_cast<std::uint32_t>(4 + k)));
        EXPECT_EQ(std::pair(a.index, b.index), expected[k]) << "edge " << 4 + k;
    }
}

TEST(Numbering, OfTheRowsIsThatOfTheirFigures)
{
    const std::map<std::string, Rings> expected{
        {"tetrahedral", {{0, 1, 3}, {0, 2, 1}, {1, 2, 3}, {2, 0, 3}}},
        {"octahedral", {{3, 4, 5}, {0, 2, 1}, {0, 1, 3}, {1, 2, 4}, {2, 0, 5}, {0, 3, 5}, {1, 4, 3}, {2, 5, 4}}},
        // a 3 4 5, c 6 7 8, e 9 10 11
        {"dodecahedral", {{9, 10, 11}, {0, 2, 1}, {0, 1, 4, 6, 3}, {1, 2, 5, 7, 4}, {2, 0, 3, 8, 5}, {3, 6, 9, 11, 8}, {4, 7, 10, 9, 6}, {5, 8, 11, 10, 7}}},
        // a 3 4 5, c 6 7 8, t 9 10 11
        {"icosahedral", {{9, 10, 11}, {0, 2, 1}, {0, 1, 3}, {1, 2, 4}, {2, 0, 5}, {0, 3, 6}, {1, 4, 7}, {2, 5, 8}, {1, 7, 3}, {2, 8, 4}, {0, 6, 5},
                         {3, 9, 6}, {4, 10, 7}, {5, 11, 8}, {3, 7, 9}, {4, 8, 10}, {5, 6, 11}, {6, 9, 11}, {7, 10, 9}, {8, 11, 10}}},
        // a 3 4 5, c 6 7 8
        {"cuboctahedral", {{6, 7, 8}, {0, 2, 1}, {0, 1, 3}, {1, 2, 4}, {2, 0, 5}, {0, 3, 6, 5}, {1, 4, 7, 3}, {2, 5, 8, 4}, {3, 7, 6}, {4, 8, 7}, {5, 6, 8}}},
        // p q 3 4, 5 6, 7 8; P Q 9 10, 11 12, 13 14; t 15 16 17
        {"rhombicuboctahedral", {{15, 16, 17}, {0, 2, 1}, {0, 1, 4, 3}, {1, 2, 6, 5}, {2, 0, 8, 7}, {0, 3, 8}, {1, 5, 4}, {2, 7, 6}, {8, 3, 9, 14}, {4, 5, 11, 10},
                                 {6, 7, 13, 12}, {3, 4, 10, 9}, {5, 6, 12, 11}, {7, 8, 14, 13}, {14, 9, 15}, {10, 11, 16}, {12, 13, 17}, {9, 10, 16, 15}, {11, 12, 17, 16}, {13, 14, 15, 17}}},
    };
    for (const auto& [name, faces] : expected) {
        Mesh mesh = regular(3);
        const auto made = kernels.at(name)(mesh, {Face(0)}, {});
        EXPECT_EQ(rings(mesh), faces) << name;
        if (name == "tetrahedral") {
            EXPECT_EQ(made, (std::vector{Face(0), Face(2), Face(3)}));
        }
    }
}

TEST(Numbering, OfSeveralFacesGoesFaceByFaceAndEachGetsItsOwnWalls)
{
    Mesh mesh = cube();
    extrude<Cubical>(mesh, {Face(1), Face(2)});
    EXPECT_SOUND(mesh);
    EXPECT_EQ(counts(mesh), (Counts{16, 28, 14}));
    EXPECT_EQ(ring(mesh, Face(1)), (std::vector<std::uint32_t>{8, 9, 10, 11}));
    EXPECT_EQ(ring(mesh, Face(2)), (std::vector<std::uint32_t>{12, 13, 14, 15}));
    EXPECT_EQ(ring(mesh, Face(6))[3], 8u);
    EXPECT_EQ(ring(mesh, Face(10))[3], 12u);
}

// --- groups ---------------------------------------------------------------------------------------------------------------------

std::vector<int> groups_of(const Mesh& mesh)
{
    std::vector<int> groups;
    for (const Face f : mesh.faces()) groups.push_back(mesh.group(f));
    return groups;
}

TEST(NewGroupIds, AscendFromTheLargestOneTopFirst)
{
    Mesh mesh = cube();
    mesh.set_group(Face(0), 10);
    extrude<Cubical>(mesh, {Face(4)});
    EXPECT_EQ(groups_of(mesh), (std::vector{10, 0, 0, 0, 11, 0, 12, 13, 14, 15}));
}

TEST(NewGroupIds, AreTheSameForAllFacesOfAGroupAndGoOnWithTheNextGroup)
{
    // Ungrouped faces come first, as one group; the square and the pentagon of group 2 share ids as far as they go.
    Mesh mesh = prism(5);
    mesh.set_group(Face(0), 2); // pentagon
    mesh.set_group(Face(1), 2); // square
    mesh.set_group(Face(2), 1);
    extrude<Octahedral>(mesh, {Face(0), Face(1), Face(2), Face(3)});
    EXPECT_SOUND(mesh);
    // Largest id 2. Group 0 (face 3): 3 … 11. Group 1 (face 2): 12 … 20. Group 2: 21 … 31.
    EXPECT_EQ(mesh.group(Face(3)), 3);
    EXPECT_EQ(mesh.group(Face(2)), 12);
    EXPECT_EQ(mesh.group(Face(0)), 21);
    EXPECT_EQ(mesh.group(Face(1)), 21);
    const auto all = groups_of(mesh);
    EXPECT_EQ(std::vector(all.begin() + 7, all.begin() + 17), (std::vector{22, 23, 24, 25, 26, 27, 28, 29, 30, 31}));
    EXPECT_EQ(std::vector(all.begin() + 17, all.begin() + 25), (std::vector{22, 23, 24, 25, 26, 27, 28, 29}));
    EXPECT_EQ(std::vector(all.begin() + 25, all.begin() + 33), (std::vector{13, 14, 15, 16, 17, 18, 19, 20}));
    EXPECT_EQ(std::vector(all.begin() + 33, all.end()), (std::vector{4, 5, 6, 7, 8, 9, 10, 11}));
}

TEST(NewGroupIds, FollowTheirRule)
{
    const auto run = [](NewGroups rule, int iterations) {
        Mesh mesh = cube();
        mesh.set_group(Face(1), 4);
        extrude<Octahedral>(mesh, {Face(1)}, {}, {rule, iterations, false});
        return groups_of(mesh);
    };
    EXPECT_EQ(run(NewGroups::rows, 1), (std::vector{0, 5, 0, 0, 0, 0, 6, 6, 6, 6, 7, 7, 7, 7}));
    EXPECT_EQ(run(NewGroups::keep, 1), (std::vector{0, 4, 0, 0, 0, 0, 4, 4, 4, 4, 4, 4, 4, 4}));
    EXPECT_EQ(run(NewGroups::none, 1), (std::vector{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(run(NewGroups::rows, 2), (std::vector{0, 8, 0, 0, 0, 0, 6, 6, 6, 6, 7, 7, 7, 7, 9, 9, 9, 9, 10, 10, 10, 10}));
    Mesh mesh = cube();
    extrude<Tetrahedral>(mesh, {Face(2)});
    EXPECT_EQ(groups_of(mesh), (std::vector{0, 0, 1, 0, 0, 0, 2, 3, 4}));
}

TEST(GroupedFaces, AreExtrudedTogetherButForGroupZero)
{
    Scene scene;
    scene.mesh = cube();
    for (const std::uint32_t f : {1u, 3u, 5u}) scene.mesh.set_group(Face(f), 7);
    ExtrusionScope scope;
    scope.faces = FaceSelector::parse("3");
    EXPECT_EQ(collect_faces(scene, scope), (std::vector{Face(1), Face(3), Face(5)}));
    scope.grouped = false;
    EXPECT_EQ(collect_faces(scene, scope), (std::vector{Face(3)}));
    scope.grouped = true;
    scope.faces = FaceSelector::parse("0");
    EXPECT_EQ(collect_faces(scene, scope), (std::vector{Face(0)}));
}

// --- strange bases --------------------------------------------------------------------------------------------------------------

TEST(StrangeBases, GiveSoundMeshesOrAReason)
{
    for (const auto& [name, run] : kernels)
        for (const NamedShape& shape : all_shapes()) {
            Mesh mesh = shape.make();
            const std::int64_t euler = euler_characteristic(mesh);
            const Mesh before = mesh;
            std::vector<Face> faces;
            for (const Face f : mesh.faces()) faces.push_back(f);
            try {
                run(mesh, faces, {});
                EXPECT_SOUND(mesh) << name << " on " << shape.name;
                EXPECT_EQ(euler_characteristic(mesh), euler) << name << " on " << shape.name;
            } catch (const CommandError& e) {
                EXPECT_TRUE(std::string_view(e.what()).starts_with("face ")) << e.what();
                EXPECT_TRUE(mesh == before) << "a refused extrusion changed the mesh";
            }
        }
}

std::string refusal(Mesh mesh, const char* name, Face f, bool flat = false)
{
    try {
        kernels.at(name)(mesh, {f}, {NewGroups::each, 1, flat});
    } catch (const CommandError& e) {
        return e.what();
    }
    return "";
}

TEST(DegenerateBases, AreRefusedWithTheReason)
{
    EXPECT_EQ(refusal(three_lunes(), "cubical", Face(1)), "face 1: has 2 corners");
    EXPECT_EQ(refusal(two_sided({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), "octahedral", Face(0)), "face 0: has no area");
    EXPECT_EQ(refusal(two_sided({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}), "octahedral", Face(0)), "face 0: edge 1 has no length");
    // A spike of no width: the boundary folds back at its tip.
    const auto spiked = [] { return two_sided({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 1, 0}, {-1, 1, 0}, {0, 1, 0}}); };
    for (const char* name : {"cubical", "dodecahedral", "rhombicuboctahedral"})
        EXPECT_EQ(refusal(spiked(), name, Face(0)), "face 0: folds back at corner 5") << name;
    for (const char* name : {"tetrahedral", "octahedral", "icosahedral", "cuboctahedral"}) EXPECT_EQ(refusal(spiked(), name, Face(0)), "") << name;
}

TEST(FlatTop, IsRefusedWhereATierRunsLevel)
{
    Mesh mesh = two_sided({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    Octahedral kernel;
    kernel.angle = 179.99999;
    try {
        extrude(mesh, {Face(0)}, kernel, {NewGroups::each, 1, true});
        FAIL() << "a level tier was made flat";
    } catch (const CommandError& e) {
        EXPECT_STREQ(e.what(), "face 0: cannot flatten: tier 1 runs level");
    }
}

TEST(Cancelling, LeavesTheMeshAsItWas)
{
    Mesh mesh = torus(20, 20);
    const Mesh before = mesh;
    std::vector<Face> faces;
    for (const Face f : mesh.faces()) faces.push_back(f);
    Progress progress;
    progress.cancel();
    EXPECT_THROW(extrude_faces(mesh, faces, Cubical(), NewGroups::each, 1, false, progress), Cancelled);
    EXPECT_TRUE(mesh == before);
}

} // namespace
} // namespace druse
