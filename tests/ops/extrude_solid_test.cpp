// extrude.solid against the table of Platonic and Archimedean patterns and the volumes worked out for other bases.
#include "extrude_bases.h"
#include "ops/solid.h"
#include "ops/solid_pattern.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace druse {
namespace {

using namespace test;

Mesh built(Mesh base, const std::string& solid, int sides, Arguments more = {})
{
    if (sides > 0) more.emplace_back("base", std::to_string(sides));
    return raised(std::move(base), solid, std::move(more));
}

struct Row {
    const char* solid;
    int p, k, m, tiers;
    double angle;
    int orbits, rows, top; // top corners a wedge, 0: an apex
};
const Row table[] = {
    {"tetrahedron", 3, 3, 1, 1, 70.528779365509, 0, 1, 0},
    {"cube", 4, 4, 1, 1, 90, 1, 1, 1},
    {"octahedron", 3, 3, 1, 1, 109.471220634491, 1, 2, 1},
    {"dodecahedron", 5, 5, 1, 3, 116.565051177078, 3, 2, 1},
    {"icosahedron", 3, 3, 1, 3, 138.189685104221, 3, 6, 1},
    {"truncated_tetrahedron", 3, 3, 1, 2, 109.471220634491, 3, 2, 2},
    {"truncated_tetrahedron", 6, 3, 2, 2, 70.528779365509, 2, 2, 1},
    {"cuboctahedron", 3, 3, 1, 2, 125.264389682755, 3, 4, 1},
    {"cuboctahedron", 4, 4, 1, 2, 125.264389682755, 2, 3, 1},
    {"truncated_cube", 3, 3, 1, 5, 125.264389682755, 7, 4, 1},
    {"truncated_cube", 8, 4, 2, 3, 90, 4, 3, 2},
    {"truncated_octahedron", 4, 4, 1, 4, 125.264389682755, 5, 3, 1},
    {"truncated_octahedron", 6, 3, 2, 3, 109.471220634491, 6, 4, 2},
    {"rhombicuboctahedron", 3, 3, 1, 5, 144.735610317245, 7, 8, 1},
    {"rhombicuboctahedron", 4, 4, 1, 3, 135, 5, 6, 1},
    {"truncated_cuboctahedron", 4, 2, 2, 9, 135, 22, 12, 2},
    {"truncated_cuboctahedron", 6, 3, 2, 7, 125.264389682755, 14, 8, 2},
    {"truncated_cuboctahedron", 8, 4, 2, 5, 125.264389682755, 10, 6, 2},
    {"snub_cube", 3, 3, 1, 7, 153.234587713420, 7, 12, 1},
    {"snub_cube", 4, 4, 1, 5, 142.983430073505, 5, 9, 1},
    {"icosidodecahedron", 3, 3, 1, 6, 142.622631859350, 9, 10, 1},
    {"icosidodecahedron", 5, 5, 1, 4, 142.622631859350, 5, 6, 1},
    {"truncated_dodecahedron", 3, 3, 1, 11, 142.622631859350, 19, 10, 1},
    {"truncated_dodecahedron", 10, 5, 2, 7, 116.565051177078, 10, 6, 2},
    {"truncated_icosahedron", 5, 5, 1, 7, 142.622631859350, 11, 6, 1},
    {"truncated_icosahedron", 6, 3, 2, 11, 138.189685104221, 18, 10, 2},
    {"rhombicosidodecahedron", 3, 3, 1, 9, 159.094842552111, 19, 20, 1},
    {"rhombicosidodecahedron", 4, 2, 2, 12, 148.282525588539, 28, 30, 2},
    {"rhombicosidodecahedron", 5, 5, 1, 7, 148.282525588539, 11, 12, 1},
    {"truncated_icosidodecahedron", 4, 2, 2, 23, 148.282525588539, 58, 30, 2},
    {"truncated_icosidodecahedron", 6, 3, 2, 17, 142.622631859350, 38, 20, 2},
    {"truncated_icosidodecahedron", 10, 5, 2, 11, 142.622631859350, 22, 12, 2},
    {"snub_dodecahedron", 3, 3, 1, 19, 164.175366056034, 19, 30, 1},
    {"snub_dodecahedron", 5, 5, 1, 11, 152.929920275835, 11, 18, 1},
};

class EveryPattern : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(Archimedean, EveryPattern, testing::ValuesIn(table),
                         [](const auto& row) { return std::string(row.param.solid) + "_" + std::to_string(row.param.p); });

SolidPattern pattern_of(const Row& row)
{
    PatternChoice choice;
    choice.sides = row.p;
    return read_pattern(make_solid(row.solid, 1.0), choice);
}

TEST_P(EveryPattern, IsReadAsTheTableSays)
{
    const Row& row = GetParam();
    const SolidPattern pattern = pattern_of(row);
    EXPECT_EQ(pattern.sides, row.p);
    EXPECT_EQ(pattern.turns, row.k);
    EXPECT_EQ(pattern.edges, row.m);
    EXPECT_EQ(pattern.tiers, row.tiers);
    EXPECT_NEAR(pattern.wall_angles[0] * 180 / std::numbers::pi, row.angle, 1e-9);
    EXPECT_EQ(int(pattern.orbits.size()) - pattern.has_apex, row.orbits);
    EXPECT_EQ(int(pattern.rows.size()), row.rows);
    EXPECT_EQ(int(pattern.top.size()), row.top);
    EXPECT_EQ(pattern.has_apex, row.top == 0);
}

TEST_P(EveryPattern, GivesBackTheSolidOnItsRegularBase)
{
    const Row& row = GetParam();
    const Mesh solid = make_solid(row.solid, 1.0);
    const Mesh mesh = built(dihedron(row.p), row.solid, row.p);
    EXPECT_SOUND(mesh);
    EXPECT_EQ(counts(mesh), counts(solid));
    EXPECT_LT(edge_lengths(mesh).relative_spread(), 1e-12);
    EXPECT_LT(flatness(mesh), 1e-12);
    EXPECT_NEAR(volume(mesh) / volume(solid), 1.0, 1e-12);
}

TEST_P(EveryPattern, GoesRoundEveryPolygonItsWedgesFit)
{
    const Row& row = GetParam();
    const int apex = row.top == 0 ? 1 : 0;
    for (int n = 3; n <= 12; ++n) {
        if (n % row.m != 0 || n / row.m < 2) continue;
        const int w = n / row.m, top = row.top * w >= 3 ? 1 : 0;
        const Mesh mesh = built(dihedron(n), row.solid, row.p, {{"planar", "off"}});
        EXPECT_SOUND(mesh);
        const int dv = row.orbits * w + apex, df = row.rows * w + top - 1;
        EXPECT_EQ(counts(mesh), (Counts{std::uint32_t(n + dv), std::uint32_t(n + dv + df), std::uint32_t(2 + df)})) << n;
        EXPECT_EQ(genus(mesh), 0);
        EXPECT_EQ(mesh.largest_group(), df + 1);
        EXPECT_GT(volume(mesh), 0) << n;
    }
    if (6 % row.m == 0) {
        const Mesh mesh = built(l_shape(), row.solid, row.p, {{"planar", "off"}});
        EXPECT_SOUND(mesh);
        EXPECT_EQ(genus(mesh), 0);
    }
}

struct Volume {
    const char* solid;
    int p, n; // n = 0: the L
    Counts counts;
    double off, free;
};
const Volume volumes[] = {
    {"truncated_cube", 8, 6, {18, 27, 11}, 6.982691161, 7.22057},
    {"truncated_cube", 8, 12, {36, 54, 20}, 31.437569479, 30.05527},
    {"truncated_tetrahedron", 6, 12, {24, 36, 14}, 16.121327319, 15.30177},
    {"truncated_tetrahedron", 6, 0, {12, 18, 8}, 3.681419914, 3.02756},
    {"snub_cube", 4, 6, {36, 90, 56}, 13.274536180, 13.27403},
    {"icosidodecahedron", 5, 6, {36, 72, 38}, 17.899341576, 17.71367},
    {"truncated_icosahedron", 5, 12, {144, 216, 74}, 130.994988734, 129.55034},
    {"rhombicosidodecahedron", 5, 6, {72, 144, 74}, 48.816141072, 48.82811},
    {"dodecahedron", 5, 0, {24, 36, 14}, 18.870411050, 18.02302},
};

TEST(OffTheRegularBase, VolumesAreThoseOfTheTable)
{
    for (const Volume& v : volumes) {
        SCOPED_TRACE(std::string(v.solid) + " " + std::to_string(v.n));
        const auto base = [&] { return v.n > 0 ? dihedron(v.n) : l_shape(); };
        const Mesh off = built(base(), v.solid, v.p, {{"planar", "off"}});
        EXPECT_EQ(counts(off), v.counts);
        EXPECT_NEAR(volume(off), v.off, 1e-9);
        const Mesh free = built(base(), v.solid, v.p);
        EXPECT_NEAR(volume(free), v.free, 5e-6);
    }
}

// --- the seven ----------------------------------------------------------------------------------------------------------------

const std::vector<std::tuple<std::string, std::string, int>> seven{
    {"tetrahedral", "tetrahedron", 3},   {"cubical", "cube", 4},          {"octahedral", "octahedron", 3},
    {"dodecahedral", "dodecahedron", 5}, {"icosahedral", "icosahedron", 3}, {"cuboctahedral", "cuboctahedron", 4},
    {"rhombicuboctahedral", "rhombicuboctahedron", 4}};

TEST(TheSeven, ComeOutWithTheSameNumbering)
{
    for (const auto& [name, solid, p] : seven)
        for (const int n : {3, 4, 5, 6, 9}) {
            Scene one, other;
            one.mesh = dihedron(n);
            other.mesh = dihedron(n);
            run_extrusion(one, "extrude." + name, {{"faces", "0"}});
            run_extrusion(other, "extrude.solid", {{"faces", "0"}, {"solid", solid}, {"base", std::to_string(p)}});
            EXPECT_EQ(rings(one.mesh), rings(other.mesh)) << name << " " << n;
            for (const Edge e : one.mesh.edges()) EXPECT_EQ(one.mesh.ends(e), other.mesh.ends(e)) << name << " " << n;
            for (const Face f : one.mesh.faces()) EXPECT_EQ(one.mesh.group(f), other.mesh.group(f)) << name << " " << n;
        }
}

TEST(TheSeven, StandInTheSamePlacesOnEveryFlatBaseWhereTheyShould)
{
    for (const auto& [name, solid, p] : seven) {
        if (name == "dodecahedral" || name == "icosahedral" || name == "cuboctahedral") continue; // these differ off the ideal polygon
        Scene one, other;
        one.mesh = irregular();
        other.mesh = irregular();
        run_extrusion(one, "extrude." + name, {{"faces", "0"}});
        run_extrusion(other, "extrude.solid", {{"faces", "0"}, {"solid", solid}, {"base", std::to_string(p)}, {"planar", "off"}});
        for (const Vertex v : one.mesh.vertices()) EXPECT_LT(glm::distance(one.mesh.position(v), other.mesh.position(v)), 1e-12) << name;
    }
}

// --- TopMod's other extrusions ------------------------------------------------------------------------------------------------

TEST(OtherExtrusions, GrowByTheirCounts)
{
    for (const std::uint32_t n : {3u, 4u, 7u}) {
        const auto extruded = [n](const std::string& name, Arguments more = {}) {
            Scene scene;
            scene.mesh = dihedron(int(n));
            more.emplace_back("faces", "0");
            run_extrusion(scene, name, more);
            EXPECT_SOUND(scene.mesh);
            EXPECT_EQ(genus(scene.mesh), 0);
            return counts(scene.mesh);
        };
        EXPECT_EQ(extruded("extrude.stellate"), (Counts{n + 1, 2 * n, n + 1}));
        EXPECT_EQ(extruded("extrude.double_stellate"), (Counts{2 * n + 1, 5 * n, 3 * n + 1}));
        EXPECT_EQ(extruded("extrude.doo_sabin", {{"iterations", "3"}}), (Counts{4 * n, 7 * n, 3 * n + 2}));
        EXPECT_EQ(extruded("extrude.dome"), (Counts{6 * n + 1, 12 * n, 6 * n + 1}));
    }
}

TEST(OtherExtrusions, StandWhereTheirFormulasSay)
{
    const auto extruded = [](const std::string& name, Arguments more = {}) {
        Scene scene;
        scene.mesh = two_sided({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
        more.emplace_back("faces", "0");
        run_extrusion(scene, name, more);
        return std::move(scene.mesh);
    };
    EXPECT_EQ(extruded("extrude.stellate", {{"height", "0.5"}}).position(Vertex(4)), Point(1, 1, 1));
    const Mesh folded = extruded("extrude.double_stellate");
    EXPECT_LT(glm::distance(folded.position(Vertex(4)), Point(1, 1.0 / 3, 0)), 1e-15);
    EXPECT_EQ(folded.position(Vertex(8)), Point(1, 1, 2));
    // Doo–Sabin on a square: weights 9/16, 3/16, 1/16, 3/16, so corner (0,0) goes to (1/2, 1/2).
    const Mesh block = extruded("extrude.doo_sabin", {{"height", "2"}, {"scale", "2"}});
    EXPECT_LT(glm::distance(block.position(Vertex(4)), Point(0, 0, 4)), 1e-14);
    // Half a twist puts the corners on the middles of the edges first.
    EXPECT_LT(glm::distance(extruded("extrude.doo_sabin", {{"twist", "0.5"}}).position(Vertex(4)), Point(1, 0.5, 2)), 1e-14);
    // The dome's steps rise .3 .18 .1 .05 .025 and its tip .01, in edges of length 2.
    EXPECT_NEAR(bounds(extruded("extrude.dome")).max.z, 2 * 0.665, 1e-14);
}

} // namespace
} // namespace druse
