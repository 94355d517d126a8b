// rind.crust and rind.nest: where the second surface lies, how thick it may be, and what is said of it.
#include "dlfl/mesh_builder.h"
#include "dlfl/self_intersections.h"
#include "ops/rind.h"
#include "run.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace druse {
namespace {

using namespace test;
using Arguments = std::vector<std::pair<std::string, std::string>>;

Mesh scaled(Mesh mesh, const Vector& factor)
{
    for (Point& p : mesh.write_positions()) p *= factor;
    return mesh;
}

// --- thickness --------------------------------------------------------------------------------------------------------------------

/// The least and the largest thickness of the walls of a crust: how far the corners of a copy lie below the plane of its face.
struct Walls {
    double least = std::numeric_limits<double>::infinity(), most = 0;
};
Walls walls(const Mesh& crust)
{
    Walls w;
    const std::uint32_t faces = crust.face_count() / 2, vertices = crust.vertex_count() / 2;
    for (std::uint32_t f = 0; f < faces; ++f)
        for (const Corner c : crust.corners(Face(f))) {
            const std::uint32_t v = crust.vertex(c).index;
            const double d = glm::dot(crust.position(Vertex(v)) - crust.position(Vertex(vertices + v)), unit_normal(crust, Face(f)));
            w.least = std::min(w.least, d);
            w.most = std::max(w.most, d);
        }
    return w;
}

struct Solid {
    const char* name;
    Mesh (*make)();
    double published; // thickness of the walls, of what is asked for; 0: not the same everywhere
    friend std::ostream& operator<<(std::ostream& out, const Solid& s) { return out << s.name; }
};
Mesh box() { return scaled(cube(), {4, 4, 0.5}); }
Mesh ring() { return torus(12, 8); }
// Of a regular solid the mean normal looks to the corner, so the walls have inradius / circumradius of the thickness.
const double golden = std::sqrt((5 + 2 * std::sqrt(5.0)) / 15);
const Solid solids[] = {{"tetrahedron", tetrahedron, 1.0 / 3},         {"cube", cube, 1 / std::sqrt(3.0)}, {"octahedron", octahedron, 1 / std::sqrt(3.0)},
                        {"dodecahedron", dodecahedron, golden},        {"icosahedron", icosahedron, golden}, {"box", box, 1 / std::sqrt(3.0)},
                        {"l_prism", l_prism, 0},                       {"torus", ring, 0}};

class WallsOf : public testing::TestWithParam<Solid> {};
INSTANTIATE_TEST_SUITE_P(Crust, WallsOf, testing::ValuesIn(solids), [](const auto& parameter) { return std::string(parameter.param.name); });

TEST_P(WallsOf, AreAsThickAsAskedIfUniform)
{
    for (const double thickness : {0.02, 0.001, -0.05}) {
        Scene scene = scene_of(GetParam().make());
        EXPECT_TRUE(notes(scene, "rind.crust", {{"thickness", std::to_string(thickness)}, {"uniform", "true"}}).empty());
        const Walls w = walls(scene.mesh);
        EXPECT_NEAR(w.least, std::abs(thickness), 1e-12);
        EXPECT_NEAR(w.most, std::abs(thickness), 1e-12);
        EXPECT_SOUND(scene.mesh);
    }
}

TEST_P(WallsOf, AreThinnerAsPublished)
{
    Scene scene = scene_of(GetParam().make());
    EXPECT_TRUE(notes(scene, "rind.crust", {{"thickness", "0.02"}}).empty());
    const Walls w = walls(scene.mesh);
    if (GetParam().published > 0) {
        EXPECT_NEAR(w.least / 0.02, GetParam().published, 1e-9);
        EXPECT_NEAR(w.most / 0.02, GetParam().published, 1e-9);
    }
    EXPECT_LT(w.least, 0.02 * 0.99);
    EXPECT_LE(w.most, 0.02 + 1e-12);
}

TEST(Crust, HasTheRatiosOfTheTable)
{
    EXPECT_NEAR(1 / std::sqrt(3.0), 0.5774, 5e-5);
    EXPECT_NEAR(golden, 0.7947, 5e-5);
    const auto farthest = [](const Arguments& arguments) {
        Scene scene = scene_of(scaled(cube(), Vector(2)));
        run(scene, "rind.crust", arguments);
        const Point middle = bounds(scene.mesh).center();
        double most = 0;
        for (std::uint32_t v = 8; v < 16; ++v) most = std::max(most, std::abs(scene.mesh.position(Vertex(v)).x - middle.x));
        return most;
    };
    EXPECT_NEAR(farthest({{"thickness", "0.2"}, {"uniform", "true"}}), 0.8, 1e-12);
    EXPECT_NEAR(farthest({{"thickness", "0.2"}}), 1 - 0.2 / std::sqrt(3.0), 1e-12); // 0.884530
}

TEST(Crust, IsACopyInsideOutUnderEveryFace)
{
    for (const NamedShape& shape : all_shapes()) {
        SCOPED_TRACE(shape.name);
        Mesh mesh = shape.make();
        if (mesh.boundary_count() > 0 || mesh.edge_count() == 0) continue;
        std::uint32_t spheres = 0;
        for (const Vertex v : mesh.vertices()) spheres += mesh.is_point_sphere(v);
        for (const Face f : mesh.faces()) mesh.set_group(f, int(f.index % 3));
        Scene scene = scene_of(mesh);
        run(scene, "rind.crust", {{"guard", "off"}});
        ASSERT_SOUND(scene.mesh);
        const std::uint32_t vertices = mesh.vertex_count() - spheres, faces = mesh.face_count() - spheres;
        EXPECT_EQ(counts(scene.mesh), (Counts{2 * vertices, 2 * mesh.edge_count(), 2 * faces}));
        EXPECT_EQ(genus(scene.mesh), 2 * genus(mesh));
        if (spheres > 0) continue;
        for (std::uint32_t f = 0; f < faces; ++f) {
            std::vector<std::uint32_t> below = test::ring(mesh, Face(f));
            EXPECT_EQ(test::ring(scene.mesh, Face(f)), below);
            std::reverse(below.begin() + 1, below.end());
            for (std::uint32_t& v : below) v += vertices;
            EXPECT_EQ(test::ring(scene.mesh, Face(faces + f)), below);
            EXPECT_EQ(scene.mesh.group(Face(faces + f)), mesh.group(Face(f)));
        }
        EXPECT_EQ(scene.rind.pairs(scene.mesh).size(), faces);
    }
}

TEST(Crust, OfAnOpenSheetIsAClosedPlate)
{
    Scene scene = scene_of(open_grid(3, 2));
    scene.selection.edit().edges = {Edge(0), Edge(5)};
    const std::array ends{scene.mesh.ends(Edge(0)), scene.mesh.ends(Edge(5))};
    run(scene, "rind.crust", {{"thickness", "0.5"}});
    EXPECT_SOUND(scene.mesh);
    EXPECT_EQ(scene.mesh.boundary_count(), 0u);
    EXPECT_EQ(counts(scene.mesh), (Counts{24, 2 * 17 + 10, 12 + 10}));
    EXPECT_NEAR(volume(scene.mesh), 6 * 0.5, 1e-12);
    EXPECT_EQ(genus(scene.mesh), 0);
    EXPECT_EQ(scene.rind.pairs(scene.mesh).size(), 6u);
    for (std::uint32_t f = 12; f < 22; ++f) EXPECT_EQ(scene.mesh.group(Face(f)), 1);
    // What was selected stays selected.
    ASSERT_EQ(scene.selection->edges.size(), 2u);
    for (const auto& [v, w] : ends)
        EXPECT_TRUE(std::ranges::any_of(scene.selection->edges, [&, v = v, w = w](Edge e) { return scene.mesh.ends(e) == std::array{v, w} || scene.mesh.ends(e) == std::array{w, v}; }));
    run(scene, "rind.punch", {{"faces", "0"}});
    EXPECT_EQ(genus(scene.mesh), 1);

    scene = scene_of(open_tube(6));
    run(scene, "rind.crust", {{"thickness", "-0.1"}, {"uniform", "true"}});
    EXPECT_SOUND(scene.mesh);
    EXPECT_EQ(genus(scene.mesh), 1);
    EXPECT_GT(volume(scene.mesh), 0);
}

TEST(Crust, NumbersTheEdgesOfTheCopyAsItsFacesFirstUseThem)
{
    for (const NamedShape& shape : all_shapes()) {
        SCOPED_TRACE(shape.name);
        const Mesh mesh = shape.make();
        if (mesh.edge_count() == 0 || mesh.boundary_count() > 0) continue;
        Scene scene = scene_of(mesh);
        run(scene, "rind.crust", {{"guard", "off"}});
        if (scene.mesh.face_count() != 2 * mesh.face_count()) continue; // it has point spheres
        for (const Edge e : mesh.edges())
            for (const int side : {0, 1}) EXPECT_EQ(scene.mesh.corner(e, side), mesh.corner(e, side));
        std::uint32_t next = mesh.edge_count();
        for (std::uint32_t f = mesh.face_count(); f < scene.mesh.face_count(); ++f)
            for (const Corner c : scene.mesh.corners(Face(f))) {
                if (scene.mesh.edge(c).index < next) continue;
                EXPECT_EQ(scene.mesh.edge(c).index, next++);
                EXPECT_EQ(scene.mesh.corner(scene.mesh.edge(c), 0), c);
            }
        EXPECT_EQ(next, scene.mesh.edge_count());
    }
}

TEST(Crust, MovesTheGivenSurfaceOutwardWhereTheThicknessIsNegative)
{
    const Mesh before = cube();
    Scene scene = scene_of(before);
    run(scene, "rind.crust", {{"thickness", "-0.25"}, {"uniform", "true"}});
    EXPECT_NEAR(bounds(scene.mesh).size().x, 1.5, 1e-12);
    for (std::uint32_t v = 0; v < 8; ++v) EXPECT_EQ(scene.mesh.position(Vertex(8 + v)), before.position(Vertex(v)));
}

TEST(Crust, MayBeScaled)
{
    const Point center(5, 1, -2);
    for (const double scale : {0.5, 3.0}) {
        Scene scene = scene_of(icosahedron());
        const Mesh before = scene.mesh;
        run(scene, "rind.crust", {{"by", "scale"}, {"scale", std::to_string(scale)}, {"center", "5,1,-2"}, {"guard", "off"}});
        const std::uint32_t moved = scale < 1 ? 12 : 0;
        for (std::uint32_t v = 0; v < 12; ++v) {
            EXPECT_LT(glm::distance(scene.mesh.position(Vertex(moved + v)), center + scale * (before.position(Vertex(v)) - center)), 1e-12);
            EXPECT_EQ(scene.mesh.position(Vertex(12 - moved + v)), before.position(Vertex(v)));
        }
    }
}

TEST(Crust, FindsTheCentreByItsName)
{
    // An L of three cubes: the middle of its vertices, of its box and of its volume are three different points.
    const Mesh mesh = l_prism();
    Point mean(0.0);
    for (const Point& p : mesh.positions()) mean += p / double(mesh.vertex_count());
    EXPECT_LT(glm::distance(shape_center(mesh, "vertices"), mean), 1e-12);
    EXPECT_LT(glm::distance(shape_center(mesh, "box"), bounds(mesh).center()), 1e-12);
    const Point corner = bounds(mesh).min, of_volume = shape_center(mesh, "volume") - corner;
    // Cubes at 1/2, 3/2 | 1/2, and 1/2 | 3/2: 5/6 in the two directions of the L, 1/2 in the third.
    EXPECT_NEAR(of_volume.x + of_volume.y + of_volume.z, 5.0 / 6 + 5.0 / 6 + 0.5, 1e-12);
    EXPECT_THROW(shape_center(dihedron(5), "volume"), CommandError);
}

TEST(Crust, RefusesWhatHasNoThickness)
{
    const Scene scene = scene_of(cube());
    EXPECT_EQ(complaint(scene, "rind.crust", {{"thickness", "0"}}), "thickness must not be 0");
    EXPECT_EQ(complaint(scene, "rind.crust", {{"by", "scale"}, {"scale", "1"}}), "scale must not be 1");
    EXPECT_EQ(complaint(Scene(), "rind.crust"), "there is no surface");
    EXPECT_EQ(complaint(scene_of(point_sphere()), "rind.crust"), "there is no surface");
}

TEST(Crust, LeavesPointSpheresOutAndTellsOfFoldedAndLimitedVertices)
{
    Mesh mesh = cube();
    mesh.create_vertex(Point(5, 5, 5));
    Scene scene = scene_of(mesh);
    EXPECT_EQ(notes(scene, "rind.crust", {}), std::vector<std::string>{"1 point sphere is no surface: left out"});
    EXPECT_EQ(counts(scene.mesh), (Counts{16, 24, 12}));
    EXPECT_EQ(scene.rind.pairs(scene.mesh).size(), 6u);

    scene = scene_of(dihedron(5));
    EXPECT_EQ(notes(scene, "rind.crust", {{"guard", "off"}}),
              std::vector<std::string>{"5 vertices are folded flat: moved square to their largest faces"});

    // An edge alone has one face, which has no area.
    scene = scene_of(segment());
    EXPECT_EQ(notes(scene, "rind.crust", {{"guard", "off"}}), std::vector<std::string>{"2 vertices have no face with an area: not moved"});

    // A thin pyramid: at its tip the planes meet far away.
    scene = scene_of(scaled(pyramid(3), {1, 1, 20}));
    const auto said = notes(scene, "rind.crust", {{"guard", "off"}, {"uniform", "true"}, {"limit", "2"}});
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("limited"), std::string::npos);
    for (std::uint32_t v = 0; v < 4; ++v) EXPECT_LT(glm::distance(scene.mesh.position(Vertex(v)), scene.mesh.position(Vertex(4 + v))), 0.2 + 1e-12);
}

// --- the guard --------------------------------------------------------------------------------------------------------------------

struct Limit {
    const char* name;
    Mesh (*make)();
    double published, uniform;
    friend std::ostream& operator<<(std::ostream& out, const Limit& l) { return out << l.name; }
};
const Limit limits[] = {
    {"cube_of_side_2", [] { return scaled(cube(), Vector(2)); }, 1.7321, 1.0},
    {"octahedron_of_circumradius_1", [] { return scaled(octahedron(), Vector(std::numbers::sqrt2)); }, 1.0, 0.5774},
    {"icosahedron_of_edge_2", [] { return scaled(icosahedron(), Vector(2)); }, 1.9021, 1.5115},
    {"box", box, 0.4330, 0.25},
    {"l_prism", l_prism, 0.8660, 0.5},
};
class SafeThickness : public testing::TestWithParam<Limit> {};
INSTANTIATE_TEST_SUITE_P(Guard, SafeThickness, testing::ValuesIn(limits), [](const auto& parameter) { return std::string(parameter.param.name); });

TEST_P(SafeThickness, IsThatOfTheTable)
{
    const Mesh mesh = GetParam().make();
    Progress progress;
    EXPECT_NEAR(safe_thickness(mesh, crust_offsets(mesh, false, 4), false, progress) / 0.95, GetParam().published, 5e-5);
    EXPECT_NEAR(safe_thickness(mesh, crust_offsets(mesh, true, 4), false, progress) / 0.95, GetParam().uniform, 5e-5);
}

TEST_P(SafeThickness, IsSafeAndALittleMoreIsSaid)
{
    for (const bool uniform : {false, true}) {
        const double most = uniform ? GetParam().uniform : GetParam().published;
        const Arguments arguments{{"uniform", uniform ? "true" : "false"}};
        const auto with = [&](double thickness, const char* guard) {
            Arguments all = arguments;
            all.emplace_back("thickness", number_text(thickness));
            all.emplace_back("guard", guard);
            return all;
        };
        Scene scene = scene_of(GetParam().make());
        EXPECT_TRUE(notes(scene, "rind.crust", with(0.94 * most, "warn")).empty());
        Progress progress;
        EXPECT_EQ(self_intersections(scene.mesh, progress).pairs, 0u);
        EXPECT_GT(volume(scene.mesh), 0);

        const Scene fresh = scene_of(GetParam().make());
        scene = fresh;
        const auto said = notes(scene, "rind.crust", with(1.05 * most, "warn"));
        ASSERT_EQ(said.size(), 1u);
        EXPECT_NE(said[0].find(" is more than the safe "), std::string::npos) << said[0];
        EXPECT_NE(complaint(fresh, "rind.crust", with(1.05 * most, "error")).find(" is more than the safe "), std::string::npos);

        scene = fresh;
        const auto reduced = notes(scene, "rind.crust", with(1.05 * most, "limit"));
        ASSERT_EQ(reduced.size(), 1u);
        EXPECT_EQ(reduced[0].substr(0, 30), "thickness reduced to the safe ");
        EXPECT_EQ(self_intersections(scene.mesh, progress).pairs, 0u);

        scene = fresh;
        EXPECT_TRUE(notes(scene, "rind.crust", with(1.05 * most, "off")).empty());
    }
}

TEST(Guard, SeesAShellThatIsTurnedInsideOutWithoutCrossing)
{
    Scene scene = scene_of(scaled(cube(), Vector(2)));
    EXPECT_EQ(notes(scene, "rind.crust", {{"thickness", "1.05"}, {"uniform", "true"}}),
              std::vector<std::string>{"thickness 1.05 is more than the safe 0.95: 1 surface is turned inside out"});
    Progress progress;
    EXPECT_EQ(self_intersections(scene.mesh, progress).pairs, 0u);
}

TEST(Guard, SaysNothingOfAnyThicknessThatIsSafe)
{
    const Scene cube_of_two = scene_of(scaled(cube(), Vector(2)));
    for (int i = 1; i < 95; ++i) {
        Scene scene = cube_of_two;
        EXPECT_TRUE(notes(scene, "rind.crust", {{"thickness", number_text(0.01 * i)}, {"uniform", "true"}}).empty()) << i;
    }
}

TEST(Guard, TakesHalfOfWhatIsSafeByItself)
{
    Scene scene = scene_of(scaled(cube(), Vector(2)));
    EXPECT_EQ(notes(scene, "rind.crust", {{"thickness", "auto"}, {"uniform", "true"}}), std::vector<std::string>{"thickness 0.475"});
    EXPECT_NEAR(walls(scene.mesh).least, 0.475, 1e-12);
    EXPECT_EQ(complaint(scene_of(open_grid(2, 2)), "rind.crust", {{"thickness", "auto"}}), "thickness=auto: the surface sets no limit to go by");
    EXPECT_EQ(complaint(scene_of(dihedron(4)), "rind.crust", {{"thickness", "auto"}}), "thickness=auto: no thickness is safe: face 0 meets the opposite wall");
}

/// A cube as a crust of which the faces 0 to k are peeled: what is left is a solid with rims of 45 degrees.
Mesh peeled_cube(int k)
{
    Scene scene = scene_of(cube());
    run(scene, "rind.crust", {{"guard", "off"}});
    run(scene, "rind.peel", {{"faces", "0-" + std::to_string(k)}});
    return scene.mesh;
}

TEST(Guard, TakesNoThicknessWhereARimIsSoSharpThatItsNormalLooksPastAFace)
{
    // Five faces peeled leave a convex frustum. At its large face, n = (0, 0, -1), two walls of 45 degrees meet, (1, 0, 1)/√2 and (0, 1, 1)/√2:
    // the sum of the three looks up by √2 − 1.
    Progress progress;
    for (const int k : {4, 2}) {
        const Mesh mesh = peeled_cube(k);
        const CrustOffsets offsets = crust_offsets(mesh, false, 4);
        for (const bool outward : {false, true}) {
            const ThicknessLimit limit = thickness_limit(mesh, offsets, outward, progress);
            EXPECT_EQ(limit.safe, 0);
            EXPECT_EQ(limit.by, ThicknessLimit::By::stuck);
            double least = 1;
            for (const Corner c : mesh.around(limit.vertex))
                least = std::min(least, glm::dot(offsets.outward[limit.vertex.index], unit_normal(mesh, mesh.face(c))));
            EXPECT_LE(least, 1e-9);
        }
        // It is as the guard says: thin as it may be, that crust meets itself.
        Scene scene = scene_of(mesh);
        run(scene, "rind.crust", {{"thickness", "0.00001"}, {"guard", "off"}});
        EXPECT_GT(self_intersections(scene.mesh, progress).pairs, 0u);
        // With the corrected offsets every face of the frustum moves inward, and only then is it said.
        Scene uniform = scene_of(mesh);
        const bool helps = complaint(uniform, "rind.crust", {{"thickness", "auto"}, {"uniform", "true"}, {"guard", "error"}}) == "(none)";
        EXPECT_TRUE(helps || k == 2);
        const std::string why = "no thickness is safe: " + thickness_limit(mesh, offsets, false, progress).text() + (helps ? "; try uniform=true" : "");
        EXPECT_NE(why.find(" sinks below some of its faces only"), std::string::npos);
        EXPECT_EQ(complaint(scene_of(mesh), "rind.crust", {{"thickness", "auto"}}), "thickness=auto: " + why);
        EXPECT_EQ(complaint(scene_of(mesh), "rind.crust", {{"thickness", "0.001"}, {"guard", "limit"}}), why);
        EXPECT_EQ(complaint(scene_of(mesh), "rind.crust", {{"thickness", "0.001"}, {"guard", "error"}}), why);
    }
}

TEST(Guard, LetsAVertexLeadPastAFaceOfItsOwnWhereNothingCrosses)
{
    // The feet of steep pyramids lie in clefts: their offsets lead past a face, but below others that stand between.
    Scene scene = scene_of(cube());
    run(scene, "remesh.truncate");
    run(scene, "remesh.stellate", {{"height", "1.8"}});
    EXPECT_EQ(notes(scene, "rind.crust", {{"uniform", "true"}, {"thickness", "auto"}, {"guard", "error"}}).size(), 1u);
    Progress progress;
    EXPECT_EQ(self_intersections(scene.mesh, progress).pairs, 0u);

    // Of a warped face the triangles count: here one of them looks where the face does not, and the mean normal leads out of it.
    scene = scene_of(Mesh());
    run(scene, "make.torus", {{"nu", "6"}, {"nv", "5"}});
    run(scene, "extrude.tetrahedral", {{"faces", "0,2"}, {"heights", "2"}});
    run(scene, "remesh.dual");
    ASSERT_EQ(self_intersections(scene.mesh, progress).pairs, 0u);
    EXPECT_EQ(complaint(scene, "rind.crust", {{"thickness", "auto"}}).substr(0, 45), "thickness=auto: no thickness is safe: vertex ");

    // Outward it is well, whatever it is inward.
    scene = scene_of(tetrahedron());
    run(scene, "extrude.cubical", {{"faces", "all"}, {"heights", "1.14665"}});
    run(scene, "remesh.triangulate");
    EXPECT_TRUE(notes(scene, "rind.crust", {{"thickness", "-0.01"}, {"guard", "error"}}).empty());
    EXPECT_EQ(self_intersections(scene.mesh, progress).pairs, 0u);
}

TEST(Guard, NamesWhatIsTheTrouble)
{
    // The large walls of a plate meet long before its corners turn over.
    const std::string plate = complaint(scene_of(box()), "rind.crust", {{"thickness", "0.3"}, {"uniform", "true"}, {"guard", "error"}});
    EXPECT_EQ(plate.substr(0, 44), "thickness 0.3 is more than the safe 0.2375: ");
    EXPECT_NE(plate.find(" meets the opposite wall"), std::string::npos) << plate;
    const std::string turned = complaint(scene_of(octahedron()), "rind.crust", {{"thickness", "5"}, {"guard", "error"}});
    EXPECT_NE(turned.find(": face 0 turns over at vertex "), std::string::npos) << turned;
    // The surface crosses itself, and does so with a crust as well.
    Mesh two = cube(), other = cube();
    for (Point& p : other.write_positions()) p += Vector(0.5, 0.3, 0.2);
    two.append(other);
    const std::string said = complaint(scene_of(two), "rind.crust", {{"thickness", "0.001"}, {"uniform", "true"}, {"guard", "error"}});
    EXPECT_NE(said.find(" pairs of triangles cross; look at face "), std::string::npos) << said;
}

TEST(Guard, ThinsAThicknessOfItsOwnUntilNoEdgesCross)
{
    // A block with two hollows, wedges that stand edge over edge at right angles, 0.02 apart: of no vertex and no centre the ray meets the other
    // one's edge.
    MeshBuilder builder;
    const auto wedge = [&](const Vector& along, double tip, double foot) {
        const Vector across(along.y, -along.x, 0);
        std::vector<std::uint32_t> v;
        for (const double side : {-1.0, 1.0}) {
            v.push_back(builder.add_vertex(Point(0, 0, tip) + 3 * side * along));
            v.push_back(builder.add_vertex(Point(0, 0, foot) + 3 * side * along - 2.0 * across));
            v.push_back(builder.add_vertex(Point(0, 0, foot) + 3 * side * along + 2.0 * across));
        }
        const bool up = tip > foot;
        const auto add = [&](std::vector<std::uint32_t> ring) {
            if (up) std::reverse(ring.begin(), ring.end());
            builder.add_face(ring);
        };
        add({v[0], v[2], v[1]});
        add({v[3], v[4], v[5]});
        add({v[0], v[1], v[4], v[3]});
        add({v[0], v[3], v[5], v[2]});
        add({v[1], v[2], v[5], v[4]});
    };
    wedge(Vector(1, 0, 0), 0.01, 3);
    wedge(Vector(0, 1, 0), -0.01, -3);
    Repairs repairs;
    Mesh wedges = builder.build(repairs);
    if (volume(wedges) > 0) wedges.reverse_components(std::vector<Face>{Face(0), Face(5)});
    ASSERT_NEAR(volume(wedges), -2 * 0.5 * 4 * 2.99 * 6, 1e-9);
    wedges.append(scaled(cube(), Vector(20)));
    Progress progress;
    for (const bool uniform : {false, true}) {
        const double safe = safe_thickness(wedges, crust_offsets(wedges, uniform, 4), false, progress);
        ASSERT_GT(safe, 0.1); // for all that corners and centres tell
        Scene scene = scene_of(wedges);
        const auto said = notes(scene, "rind.crust", {{"thickness", "auto"}, {"uniform", uniform ? "true" : "false"}});
        ASSERT_EQ(said.size(), 1u);
        EXPECT_NE(said[0].find(": a thicker one crosses itself"), std::string::npos) << said[0];
        EXPECT_EQ(self_intersections(scene.mesh, progress).pairs, 0u);

        for (const double part : {0.5, 2.0}) { // of what seems safe
            Scene limited = scene_of(wedges);
            const auto reduced = notes(limited, "rind.crust", {{"thickness", number_text(part * safe)}, {"uniform", uniform ? "true" : "false"}, {"guard", "limit"}});
            ASSERT_EQ(reduced.size(), 1u);
            EXPECT_TRUE(reduced[0].starts_with("thickness reduced to ") && reduced[0].ends_with(": a thicker one crosses itself")) << reduced[0];
            EXPECT_EQ(self_intersections(limited.mesh, progress).pairs, 0u);
        }
    }
}

TEST(Guard, FindsNoCrossingsInThinCrustsOfWarpedFaces)
{
    // Pentagons and larger faces, whose corners are moved a little in all directions.
    std::mt19937 random(5);
    Progress progress;
    for (const auto& make : {dodecahedron, +[] { return prism(7); }, +[] { return prism(12); }})
        for (int round = 0; round < 20; ++round) {
            Mesh mesh = make();
            for (Point& p : mesh.write_positions())
                for (int k = 0; k < 3; ++k) p[k] += 0.1 * (double(random()) / 4294967296.0 - 0.5);
            if (self_intersections(mesh, progress).pairs > 0) continue;
            for (const char* thickness : {"0.001", "-0.001"})
                EXPECT_EQ(complaint(scene_of(mesh), "rind.crust", {{"thickness", thickness}, {"guard", "error"}}), "(none)") << round;
        }
}

TEST(Guard, AsksFromTheCentresOfFaces)
{
    // A cube of side 3 about the origin, and in it one of side 1, moved: of the vertices of the large one none looks at the small one, and of
    // its face centres one does first.
    Mesh mesh = scaled(cube(), Vector(3)), small = cube();
    for (Point& p : small.write_positions()) p += Vector(0.2, 0.3, 0.1);
    mesh.append(small);
    // From (0, 1.5, 0), down by 1/√3 for each unit of thickness, to y = 0.8, which comes to meet it.
    const double nearest = 0.5 * (1.5 - 0.8) * std::sqrt(3.0);
    Progress progress;
    const double safe = safe_thickness(mesh, crust_offsets(mesh, false, 4), false, progress);
    EXPECT_NEAR(safe, 0.95 * nearest, 1e-9);
    // Where only thinner crusts matter, no more is asked.
    EXPECT_EQ(safe_thickness(mesh, crust_offsets(mesh, false, 4), false, progress, 0.9 * safe), std::numeric_limits<double>::infinity());
    EXPECT_EQ(safe_thickness(mesh, crust_offsets(mesh, false, 4), false, progress, 1.1 * safe), safe);
}

TEST(Guard, DoesNotTakeRoundingForCrossings)
{
    // A slab whose top has seven corners along one side, where flat stones stand on it: after it moved, these are on a line but for rounding.
    MeshBuilder builder;
    const std::vector<double> along{0, 0.7, 1.3, 2.1, 2.2, 3.7, 4.1, 5};
    std::vector<std::uint32_t> edge, over;
    for (const double x : along) edge.push_back(builder.add_vertex({x, 0.1 * x, 0}));
    for (const double x : along) over.push_back(builder.add_vertex({x, 0.1 * x, 1.5}));
    const std::uint32_t a = builder.add_vertex({0, 3, 0}), b = builder.add_vertex({5, 3.5, 0}), c = builder.add_vertex({0, 3, 1.5}), d = builder.add_vertex({5, 3.5, 1.5});
    std::vector<std::uint32_t> below(edge.rbegin(), edge.rend()), above(over);
    below.insert(below.end(), {a, b});
    above.insert(above.end(), {d, c});
    builder.add_face(below);
    builder.add_face(above);
    for (std::size_t i = 0; i + 1 < along.size(); ++i) builder.add_face(std::array{edge[i], edge[i + 1], over[i + 1], over[i]});
    builder.add_face(std::array{edge.back(), b, d, over.back()});
    builder.add_face(std::array{b, a, c, d});
    builder.add_face(std::array{a, edge[0], over[0], c});
    Repairs repairs;
    const Mesh slab = builder.build(repairs);
    ASSERT_EQ(genus(slab), 0);
    for (int i = 1; i <= 40; ++i) {
        Scene scene = scene_of(slab);
        EXPECT_TRUE(notes(scene, "rind.crust", {{"thickness", std::to_string(0.0137 * i)}}).empty()) << i;
    }
}

TEST(Guard, LooksOutwardForACrustThatGrowsOutward)
{
    // Two cubes, a gap apart: outward they meet in the middle of it.
    const Mesh mesh = two_cubes();
    Progress progress;
    double gap = std::numeric_limits<double>::infinity();
    for (const Vertex v : mesh.vertices())
        for (const Vertex w : mesh.vertices())
            if (v.index < 8 && w.index >= 8) gap = std::min(gap, glm::distance(mesh.position(v), mesh.position(w)));
    EXPECT_NEAR(safe_thickness(mesh, crust_offsets(mesh, true, 4), true, progress), 0.95 * 0.5 * gap, 1e-12);
    EXPECT_NEAR(safe_thickness(mesh, crust_offsets(mesh, true, 4), false, progress), 0.95 * 0.5, 1e-12);
}

// --- nests ------------------------------------------------------------------------------------------------------------------------

TEST(Nest, PutsTurnedCopiesInsideEachOther)
{
    Scene scene = scene_of(icosahedron());
    const double outer = std::sin(2 * std::numbers::pi / 5);
    run(scene, "rind.crust", {{"thickness", "0.1"}});
    run(scene, "rind.peel", {{"faces", "0,5,11"}});
    const Counts one = counts(scene.mesh);
    const std::int64_t one_genus = genus(scene.mesh);
    const Mesh before = scene.mesh;
    run(scene, "rind.nest", {{"copies", "3"}, {"center", "box"}});
    EXPECT_SOUND(scene.mesh);
    EXPECT_EQ(counts(scene.mesh), (Counts{4 * one.vertices, 4 * one.edges, 4 * one.faces}));
    EXPECT_EQ(components(scene.mesh).parts.size(), 4u);
    EXPECT_EQ(genus(scene.mesh), 4 * one_genus);
    EXPECT_EQ(scene.rind.pairs(scene.mesh).size(), 17u); // the copies have none
    Progress progress;
    EXPECT_EQ(self_intersections(scene.mesh, progress).pairs, 0u);
    const double ratio = length(scene.mesh, Edge(one.edges)) / length(scene.mesh, Edge(0));
    EXPECT_NEAR(ratio, 0.95 * (outer - 0.1) * golden / outer, 1e-9); // the inner surface is an icosahedron, 0.1 smaller in circumradius
    for (std::uint32_t v = 0; v < one.vertices; ++v) {
        const Vector d = before.position(Vertex(v)) - bounds(before).center(), e = scene.mesh.position(Vertex(one.vertices + v)) - bounds(before).center();
        EXPECT_NEAR(glm::length(e), ratio * glm::length(d), 1e-9);
        const Vector axis = glm::normalize(Vector(1, 1, 0.3));
        EXPECT_NEAR(glm::dot(e, axis), ratio * glm::dot(d, axis), 1e-9);
        const Vector across = d - glm::dot(d, axis) * axis, turned = e - glm::dot(e, axis) * axis;
        EXPECT_NEAR(glm::dot(across, turned), std::cos(std::numbers::pi / 6) * glm::length(across) * glm::length(turned), 1e-9);
    }
}

TEST(Nest, WarnsWhereACopyDoesNotFit)
{
    Scene scene = scene_of(cube());
    EXPECT_TRUE(notes(scene, "rind.nest", {{"ratio", "0.57"}}).empty()); // below 1/√3
    scene = scene_of(cube());
    EXPECT_TRUE(notes(scene, "rind.nest", {{"ratio", "0.9"}, {"angle", "0"}}).empty()); // a larger one, but it does not cross
    scene = scene_of(cube());
    const auto said = notes(scene, "rind.nest", {{"ratio", "0.9"}});
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0].substr(0, 59), "ratio 0.9 is more than the 0.57735 that fits however it is ") << said[0];
    EXPECT_EQ(complaint(scene_of(cube()), "rind.nest", {{"center", "0,0,0"}}), "(none)");
    const Point corner = cube().position(Vertex(0));
    const std::string at = number_text(corner.x) + "," + number_text(corner.y) + "," + number_text(corner.z);
    EXPECT_EQ(complaint(scene_of(cube()), "rind.nest", {{"center", at}}), "ratio=auto: the center lies in the surface; give a ratio");
    EXPECT_EQ(complaint(scene_of(cube()), "rind.nest", {{"axis", "0,0,0"}}), "axis=0,0,0: expected a direction, not 0");
}

} // namespace
} // namespace druse
