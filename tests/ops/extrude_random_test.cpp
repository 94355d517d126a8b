// extrude.solid on anything: random solids, bases and sizes, patterns from files, and what is no pattern. Each is sound or an error of
// one line that leaves the mesh as it was.
#include "extrude_bases.h"
#include "ops/solid.h"
#include "ops/solid_pattern.h"
#include "support/folder.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

namespace druse {
namespace {

using namespace test;

/// The same numbers on every machine.
class Dice {
public:
    explicit Dice(std::uint32_t seed) : engine_(seed) {}
    int below(int n) { return static_cast<int>(engine_() % std::uint32_t(n)); }
    int from(int least, int most) { return least + below(most - least + 1); }
    double between(double least, double most) { return least + (most - least) * static_cast<double>(engine_()) / 4294967296.0; }
    template <class T>
    const T& of(const std::vector<T>& list)
    {
        return list[std::size_t(below(int(list.size())))];
    }

private:
    std::mt19937 engine_;
};

/// A polygon without crossings, star-shaped about the origin: regular, uneven or with reflex corners, flat or warped.
Mesh random_base(Dice& dice, int n)
{
    const double uneven = dice.of<double>({0, 0, 0.3, 0.8}), warp = dice.of<double>({0, 0, 0, 0.2}), size = std::pow(10.0, dice.from(-6, 6));
    std::vector<Point> corners;
    for (int i = 0; i < n; ++i) {
        const double a = 2 * std::numbers::pi * (i + dice.between(0, uneven / 2)) / n, r = size * (1 - dice.between(0, uneven));
        corners.emplace_back(r * std::cos(a), r * std::sin(a), size * dice.between(0, warp));
    }
    return two_sided(corners);
}

std::string random_solid(Dice& dice)
{
    std::string name = dice.of(solid_names());
    if (const auto colon = name.find(':'); colon != std::string::npos) {
        const bool any = name.starts_with("prism") || name.starts_with("antiprism");
        name = name.substr(0, colon + 1) + std::to_string(any ? dice.from(3, 12) : name.starts_with("gyroelongated_pyramid") ? dice.from(4, 5) : dice.from(3, 5));
    }
    return name;
}

TEST(RandomExtrusions, AreSoundOrAnErrorOfOneLine)
{
    int built = 0, refused = 0;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        Dice dice(seed);
        const std::string solid = random_solid(dice);
        const Mesh shape = make_solid(solid, 1.0);
        PatternChoice choice;
        choice.base = Face(std::uint32_t(dice.below(int(shape.face_count()))));
        const int turns = read_pattern(shape, choice).turns, sides = shape.valence(*choice.base), m = sides / turns;
        // Mostly what fits, now and then anything.
        const int n = dice.below(8) == 0 ? dice.from(3, 12) : turns == 1 ? sides : m * dice.from(std::max(2, (2 + m) / m), std::max(2, 12 / m));
        const int iterations = dice.of<int>({1, 1, 1, 2, 3});
        Arguments arguments{{"base", fmt::format("face:{}", choice.base->index)}, {"iterations", std::to_string(iterations)}};
        arguments.emplace_back("phase", std::to_string(dice.below(10) == 0 ? dice.below(12) : dice.below(m)));
        arguments.emplace_back("mirror", dice.of<std::string>({"true", "false"}));
        arguments.emplace_back("planar", dice.of<std::string>({"off", "off", "off", "off", "free", "walls"}));
        arguments.emplace_back("groups", dice.of<std::string>({"each", "rows", "keep", "none"}));
        if (dice.below(2) == 0) arguments.emplace_back("angle", fmt::format("{}", dice.between(1, 179)));
        if (dice.below(2) == 0) {
            const int tiers = dice.below(10) == 0 ? dice.from(1, 5) : read_pattern(shape, choice).tiers;
            std::string heights;
            for (int t = 0; t < tiers; ++t) heights += fmt::format("{}{}", t > 0 ? "," : "", dice.between(0.01, 3) * dice.of<int>({1, 1, 1, -1}));
            arguments.emplace_back("heights", heights);
        }
        std::string command = fmt::format("seed {}, n {}: solid={}", seed, n, solid);
        for (const auto& [key, value] : arguments) command += fmt::format(" {}={}", key, value);
        SCOPED_TRACE(command);

        Scene scene;
        scene.mesh = random_base(dice, n);
        const Mesh before = scene.mesh;
        arguments.insert(arguments.end(), {{"solid", solid}, {"faces", "0"}});
        try {
            run_extrusion(scene, "extrude.solid", arguments);
        } catch (const CommandError& e) {
            ++refused;
            EXPECT_EQ(std::string_view(e.what()).find('\n'), std::string_view::npos) << e.what();
            EXPECT_GT(std::string_view(e.what()).size(), 10u);
            EXPECT_TRUE(scene.mesh == before) << "a refused extrusion changed the mesh: " << e.what();
            continue;
        }
        ++built;
        ASSERT_SOUND(scene.mesh);
        EXPECT_EQ(genus(scene.mesh), 0);
        EXPECT_EQ(euler_characteristic(scene.mesh), 2);
        for (const Vertex v : before.vertices()) EXPECT_EQ(scene.mesh.position(v), before.position(v));
        for (const Vertex v : scene.mesh.vertices()) EXPECT_TRUE(std::isfinite(glm::length(scene.mesh.position(v))));
        if (iterations > 1) continue;
        // What a wedge holds, from the numbers of the solid.
        const SolidPattern pattern = read_pattern(shape, choice);
        const int apex = pattern.has_apex ? 1 : 0, w = n / m, around = static_cast<int>(pattern.top.size());
        const int orbits = (int(shape.vertex_count()) - sides - apex) / turns, rows = (int(shape.face_count()) - 1 - (around * turns >= 3 ? 1 : 0)) / turns;
        const int dv = orbits * w + apex, df = rows * w + (around * w >= 3 ? 1 : 0) - 1;
        EXPECT_EQ(counts(scene.mesh), (Counts{std::uint32_t(n + dv), std::uint32_t(n + dv + df), std::uint32_t(2 + df)}));
    }
    EXPECT_GE(built, 600);
    EXPECT_GE(refused, 50);
}

TEST(ConcaveBases, GiveClosedSurfacesForEveryKindOfSolid)
{
    for (const std::string solid : {"tetrahedron", "cube", "octahedron", "dodecahedron", "icosahedron", "truncated_tetrahedron", "cuboctahedron", "truncated_cube",
                                     "truncated_octahedron", "rhombicuboctahedron", "truncated_cuboctahedron", "snub_cube", "icosidodecahedron", "truncated_dodecahedron",
                                     "truncated_icosahedron", "rhombicosidodecahedron", "truncated_icosidodecahedron", "snub_dodecahedron"})
        for (const Mesh& base : {l_shape(), star(4), star(5), star(6)})
            for (const char* planar : {"off", "walls"}) {
                if (planar == std::string("walls") && (solid.starts_with("truncated_i") || solid.starts_with("snub_d"))) continue; // slow to settle
                const Mesh mesh = raised(base, solid, {{"planar", planar}});
                EXPECT_SOUND(mesh) << solid;
                EXPECT_EQ(genus(mesh), 0) << solid;
                if (planar == std::string("off")) {
                    EXPECT_GT(volume(mesh), 0) << solid;
                }
            }
}

TEST(PlanarWalls, StandAtTheirOwnAngles)
{
    // A truncated cube from its octagon: walls of 90° and of 125.26° take turns.
    for (const double tilt : {-20.0, 0.0, 10.0}) {
        const Mesh mesh = raised(dihedron(12), "truncated_cube", {{"planar", "walls"}, {"angle", std::to_string(90 + tilt)}});
        const double own[] = {90 + tilt, 90 + 35.264389682754654 + tilt};
        for (const Corner c : mesh.corners(Face(1))) {
            const Face wall = mesh.face(mesh.opposite(c));
            const double between = std::acos(glm::dot(unit_normal(mesh, wall), Vector(0, 0, -1))) * 180 / std::numbers::pi;
            const bool octagon = mesh.valence(wall) == 8;
            EXPECT_NEAR(180 - between, own[octagon ? 0 : 1], 1e-6);
        }
    }
}

// --- patterns from files ----------------------------------------------------------------------------------------------------------

/// A file whose content is the mesh `given`, and how often it was read.
struct File {
    Folder folder;
    std::filesystem::path path = folder / "pattern.obj";
    Mesh given;
    int reads = 0;

    explicit File(Mesh mesh) : given(std::move(mesh)) { write("one"); }
    void write(const std::string& text) { folder.write("pattern.obj", text); }
    Mesh raise(Mesh base, Arguments more = {})
    {
        Scene scene;
        scene.mesh = std::move(base);
        more.insert(more.end(), {{"solid", path.string()}, {"faces", "0"}});
        run_extrusion(scene, "extrude.solid", more, [this](const std::filesystem::path& asked) {
            EXPECT_EQ(asked, path);
            ++reads;
            return given;
        });
        return std::move(scene.mesh);
    }
    std::string refuses(Arguments more = {})
    {
        try {
            raise(dihedron(6), std::move(more));
        } catch (const CommandError& e) {
            return e.what();
        }
        return "(built)";
    }
};

/// Coordinates with so many digits after the point, as many programs write them.
Mesh rounded(Mesh mesh, double digits)
{
    const double unit = std::pow(10.0, -digits);
    for (const Vertex v : mesh.vertices()) mesh.set_position(v, glm::round(mesh.position(v) / unit) * unit);
    return mesh;
}

TEST(PatternsFromFiles, AreThoseOfTheBuiltInSolids)
{
    for (const char* solid : {"truncated_octahedron", "snub_cube", "icosidodecahedron", "cupola:4", "pyramid:5"})
        for (const double digits : {6.0, 5.0}) {
            File file(rounded(make_solid(solid, 1.0), digits));
            const Mesh from_file = file.raise(dihedron(8)), own = raised(dihedron(8), solid);
            EXPECT_EQ(rings(from_file), rings(own)) << solid;
            for (const Vertex v : own.vertices()) EXPECT_LT(glm::distance(from_file.position(v), own.position(v)), 1e-3) << solid;
        }
}

TEST(PatternsFromFiles, AreReadOnceUntilTheFileChanges)
{
    File file(make_solid("cube", 1.0));
    EXPECT_EQ(file.raise(dihedron(4)).face_count(), 6u);
    EXPECT_EQ(file.raise(dihedron(4), {{"angle", "80"}}).face_count(), 6u);
    EXPECT_EQ(file.reads, 1);
    EXPECT_EQ(file.raise(dihedron(4), {{"turns", "2"}}).face_count(), 6u); // another pattern of the same file
    EXPECT_EQ(file.reads, 2);
    file.given = make_solid("cuboctahedron", 1.0);
    file.write("another text");
    EXPECT_EQ(file.raise(dihedron(4)).face_count(), 14u);
    EXPECT_EQ(file.reads, 3);
}

TEST(PatternsFromFiles, NeedNotBeConvexButStarShaped)
{
    // A star's prism: its concave face carries the solid, five-fold, with two edges to a wedge.
    Scene prism;
    prism.mesh = star();
    run_extrusion(prism, "extrude.cubical", {{"faces", "0"}});
    File file(prism.mesh);
    const Mesh mesh = file.raise(dihedron(6));
    EXPECT_SOUND(mesh);
    EXPECT_EQ(counts(mesh), (Counts{12, 18, 8}));
    const Mesh again = file.raise(star());
    EXPECT_EQ(counts(again), (Counts{20, 30, 12}));
    // What is a step of the wedge in the star is one on every star like it.
    EXPECT_NEAR(volume(again) / volume(prism.mesh), 1.0, 1e-9);
}

TEST(PatternsFromFiles, AreRefusedInOneLineWhereTheyAreNoSolid)
{
    const auto reason = [](Mesh mesh, Arguments more = {}) { return File(std::move(mesh)).refuses(std::move(more)); };
    EXPECT_EQ(reason(torus(4, 4)), "the solid must be closed, in one piece and without holes through it");
    EXPECT_EQ(reason(two_cubes()), "the solid must be closed, in one piece and without holes through it");
    EXPECT_EQ(reason(Mesh()), "the solid must be closed, in one piece and without holes through it");
    EXPECT_EQ(reason(open_grid(2, 2)), "the solid is open");
    EXPECT_EQ(reason(cube_with_antenna()), "face 0 of the solid passes vertex 0 twice");
    EXPECT_EQ(reason(three_lunes()), "face 0 of the solid has 2 corners");
    EXPECT_EQ(reason(make_solid("cube", 1.0), {{"base", "5"}}), "the solid has no face with 5 sides");
    EXPECT_EQ(reason(make_solid("cube", 1.0), {{"base", "face:6"}}), "the solid has no face 6");
    EXPECT_EQ(reason(make_solid("cube", 1.0), {{"turns", "3"}}), "turns=3: expected a divisor of 4");
    EXPECT_EQ(reason(make_solid("cube", 1.0), {{"phase", "1"}}), "phase=1: expected 0 to 0");
    EXPECT_EQ(reason(make_solid("cube", 1.0), {{"turns", "1"}}), "this pattern needs exactly 4 edges; face 0 has 6");
    const auto on = [](const Mesh& mesh, const Point& center) {
        for (const Face f : mesh.faces())
            if (glm::distance(vertex_mean(mesh, f), center) < 1e-9) return Arguments{{"base", "face:" + std::to_string(f.index)}};
        return Arguments{};
    };
    // The step of a stair, and the foot of a C, whose axis leaves the solid, comes in again and leaves it for good.
    const Mesh stair = voxels({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}});
    EXPECT_EQ(reason(stair, on(stair, {1.5, 0.5, 1})), "the solid reaches below its base face");
    const Mesh c = voxels({{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 2}, {1, 0, 3}, {0, 0, 3}});
    EXPECT_EQ(reason(c, on(c, {0.5, 0.5, 0})), "the solid wraps round its axis");
}

TEST(PatternsFromFiles, StandOnTheFaceThatTurnsMostHoweverManyThereAre)
{
    // Five thousand squares that turn twice, and two lids that turn five thousand times.
    File file(prism(5000));
    EXPECT_EQ(counts(file.raise(dihedron(7))), (Counts{14, 21, 9}));
    EXPECT_EQ(counts(file.raise(dihedron(4), {{"base", "4"}, {"planar", "off"}})), (Counts{10'000, 15'000, 5'002}));
    // Far more turns than digits of an azimuth in a file would tell apart.
    File round(prism(64'000));
    EXPECT_EQ(counts(round.raise(dihedron(5), {{"base", "face:0"}})), (Counts{10, 15, 7}));
}

TEST(PatternsFromFiles, AreSoundOrRefusedForEveryShapeAndFace)
{
    int built = 0;
    for (const NamedShape& shape : all_shapes()) {
        File file(shape.make());
        const Mesh& solid = file.given;
        for (std::uint32_t f = 0; f < std::min(solid.face_limit(), 40u); ++f)
            for (const char* turns : {"1", ""}) {
                SCOPED_TRACE(fmt::format("{} face {} turns {}", shape.name, f, turns));
                Arguments arguments{{"base", fmt::format("face:{}", f)}, {"planar", "off"}};
                if (*turns) arguments.emplace_back("turns", turns);
                for (const int n : {solid.valence(Face(f)), 4, 6}) {
                    if (n < 3) continue;
                    try {
                        const Mesh mesh = file.raise(dihedron(n), arguments);
                        EXPECT_SOUND(mesh);
                        EXPECT_EQ(genus(mesh), 0);
                        ++built;
                    } catch (const CommandError& e) {
                        EXPECT_EQ(std::string_view(e.what()).find('\n'), std::string_view::npos);
                    }
                }
            }
    }
    EXPECT_GT(built, 50);
}

TEST(ExtrudeSolid, SelectsTheTopsWhereOnlySomeFacesGetOne)
{
    // A cupola ends in a triangle over six edges, but in an edge over four.
    Scene scene;
    scene.mesh = prism(6);
    run_extrusion(scene, "extrude.solid", {{"faces", "1,7"}, {"solid", "cupola:3"}, {"base", "6"}, {"planar", "off"}});
    EXPECT_EQ(scene.selection->faces, std::vector<Face>{Face(7)});
    run_extrusion(scene, "extrude.solid", {{"faces", "2"}, {"solid", "cupola:3"}, {"base", "6"}, {"planar", "off"}});
    EXPECT_EQ(scene.selection->faces.size(), 4u); // no top: the two squares and two triangles
}

TEST(PatternsFromFiles, ThatWouldMeetThemselvesOnFewEdgesAreRefused)
{
    // A cupola over a hexagon with a prism on its triangle: on four edges that prism would stand on two.
    Scene tower;
    tower.mesh = raised(dihedron(6), "cupola:3", {{"base", "6"}});
    run_extrusion(tower, "extrude.cubical", {{"faces", "0"}});
    File file(tower.mesh);
    EXPECT_EQ(counts(file.raise(dihedron(8), {{"base", "6"}})), (Counts{16, 28, 14}));
    try {
        file.raise(dihedron(4), {{"base", "6"}});
        FAIL() << "a prism stands on a face with two sides";
    } catch (const CommandError& e) {
        EXPECT_STREQ(e.what(), "this pattern meets itself on so few edges; face 0 has 4, the solid's has 6");
    }
}

} // namespace
} // namespace druse
