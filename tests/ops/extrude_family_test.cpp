// extrude.solid gives back the solid on its regular base: told by a checker that knows nothing of patterns, against the vertex
// configurations of the literature.
#include "extrude_bases.h"
#include "ops/solid.h"
#include "ops/solid_pattern.h"
#include "solid_identity.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <tuple>

namespace druse {
namespace {

using namespace test;

struct Known {
    std::string solid;
    std::map<std::string, int> vertices;
};

// Cromwell, Polyhedra (1997), table of the Archimedean solids.
const std::vector<Known> archimedean{
    {"tetrahedron", {{"3.3.3", 4}}},
    {"cube", {{"4.4.4", 8}}},
    {"octahedron", {{"3.3.3.3", 6}}},
    {"dodecahedron", {{"5.5.5", 20}}},
    {"icosahedron", {{"3.3.3.3.3", 12}}},
    {"truncated_tetrahedron", {{"3.6.6", 12}}},
    {"cuboctahedron", {{"3.4.3.4", 12}}},
    {"truncated_cube", {{"3.8.8", 24}}},
    {"truncated_octahedron", {{"4.6.6", 24}}},
    {"rhombicuboctahedron", {{"3.4.4.4", 24}}},
    {"truncated_cuboctahedron", {{"4.6.8", 48}}},
    {"snub_cube", {{"3.3.3.3.4", 24}}},
    {"icosidodecahedron", {{"3.5.3.5", 30}}},
    {"truncated_dodecahedron", {{"3.10.10", 60}}},
    {"truncated_icosahedron", {{"5.6.6", 60}}},
    {"rhombicosidodecahedron", {{"3.4.5.4", 60}}},
    {"truncated_icosidodecahedron", {{"4.6.10", 120}}},
    {"snub_dodecahedron", {{"3.3.3.3.5", 60}}},
};

std::map<std::string, int> around(const std::vector<std::pair<std::vector<int>, int>>& vertices)
{
    std::map<std::string, int> all;
    for (const auto& [faces, count] : vertices) all[configuration(faces)] += count;
    return all;
}

/// Prisms, antiprisms, and what is put together from pyramids, cupolas and the rotunda.
std::vector<Known> families()
{
    std::vector<Known> list;
    const auto add = [&](const std::string& name, int n, const std::vector<std::pair<std::vector<int>, int>>& vertices) {
        list.push_back({name + ":" + std::to_string(n), around(vertices)});
    };
    for (const int n : {3, 4, 5, 6, 7, 8, 10, 12}) add("prism", n, {{{4, 4, n}, 2 * n}});
    for (const int n : {3, 4, 5, 6, 7, 8, 9, 10}) add("antiprism", n, {{{3, 3, 3, n}, 2 * n}});
    for (const int n : {3, 4, 5}) {
        const std::vector<int> tip(std::size_t(n), 3);
        add("pyramid", n, {{{3, 3, n}, n}, {tip, 1}});
        add("bipyramid", n, {{{3, 3, 3, 3}, n}, {tip, 2}});
        add("elongated_pyramid", n, {{{4, 4, n}, n}, {{3, 3, 4, 4}, n}, {tip, 1}});
        if (n > 3) add("gyroelongated_pyramid", n, {{{3, 3, 3, n}, n}, {{3, 3, 3, 3, 3}, n}, {tip, 1}});
        const std::pair lid(std::vector{3, 4, n, 4}, n);
        add("cupola", n, {lid, {{3, 4, 2 * n}, 2 * n}});
        add("elongated_cupola", n, {lid, {{3, 4, 4, 4}, 2 * n}, {{4, 4, 2 * n}, 2 * n}});
        add("gyroelongated_cupola", n, {lid, {{3, 3, 3, 3, 4}, 2 * n}, {{3, 3, 3, 2 * n}, 2 * n}});
        add("orthobicupola", n, {{lid.first, 2 * n}, {{3, 3, 4, 4}, 2 * n}});
        add("gyrobicupola", n, {{lid.first, 2 * n}, {{3, 4, 3, 4}, 2 * n}});
    }
    list.push_back({"rotunda", around({{{3, 5, 3, 5}, 10}, {{3, 5, 10}, 10}})});
    return list;
}

void expect_solid(const Mesh& mesh, const Known& known)
{
    EXPECT_SOUND(mesh);
    const Identity id = identify(mesh);
    EXPECT_EQ(id.vertices, known.vertices);
    EXPECT_LT(id.edge_spread, 1e-12);
    EXPECT_LT(id.out_of_plane, 1e-12);
    EXPECT_GT(id.least_depth, 1e-3);
    if (known.solid == "rhombicuboctahedron") {
        EXPECT_TRUE(id.centrally_symmetric) << "its twin has the same corners";
    }
}

/// Faces that no turn of the solid carries into each other look different from here: one of each kind.
std::vector<Face> kinds(const Mesh& solid)
{
    std::vector<Face> first;
    std::set<std::vector<int>> seen;
    for (const Face f : solid.faces()) {
        // Sides of the face, then of its walls as one goes round from the best start, and of the walls' own walls.
        std::vector<std::vector<int>> walls;
        for (const Corner c : solid.corners(f)) {
            const Corner over = solid.opposite(c);
            walls.push_back({solid.valence(solid.face(over))});
            for (Corner d = solid.next(over); d != over; d = solid.next(d)) walls.back().push_back(solid.valence(solid.face(solid.opposite(d))));
        }
        std::vector<int> key;
        for (std::size_t i = 0; i < walls.size(); ++i) {
            std::rotate(walls.begin(), walls.begin() + 1, walls.end());
            std::vector<int> turned{solid.valence(f)};
            for (const auto& wall : walls) turned.insert(turned.end(), wall.begin(), wall.end());
            key = std::max(key, turned);
        }
        if (seen.insert(key).second) first.push_back(f);
    }
    return first;
}

/// Builds the solid on a regular polygon, from one face of each kind, with every number of turns from `least` on. Returns how many.
int rebuild(const Known& known, int least)
{
    int builds = 0;
    const Mesh solid = make_solid(known.solid, 1.0);
    for (const Face f : kinds(solid)) {
        PatternChoice choice;
        choice.base = f;
        const int largest = read_pattern(solid, choice).turns;
        for (int turns = least; turns <= largest; ++turns) {
            if (largest % turns != 0) continue;
            SCOPED_TRACE(known.solid + " base=face:" + std::to_string(f.index) + " turns=" + std::to_string(turns));
            expect_solid(raised(dihedron(solid.valence(f)), known.solid, {{"base", "face:" + std::to_string(f.index)}, {"turns", std::to_string(turns)}}), known);
            ++builds;
        }
    }
    return builds;
}

TEST(PlatonicAndArchimedeanSolids, RiseFromEveryKindOfTheirFacesThatTurns)
{
    int bases = 0;
    for (const Known& known : archimedean) {
        const Mesh solid = make_solid(known.solid, 1.0);
        for (const Face f : kinds(solid)) {
            PatternChoice choice;
            choice.base = f;
            const SolidPattern pattern = read_pattern(solid, choice);
            if (pattern.turns < 2) continue;
            SCOPED_TRACE(known.solid + " base=face:" + std::to_string(f.index));
            expect_solid(raised(dihedron(pattern.sides), known.solid, {{"base", "face:" + std::to_string(f.index)}}), known);
            ++bases;
        }
    }
    EXPECT_EQ(bases, 35); // the 34 of the table, and the rhombicuboctahedron's squares between two triangles
}

TEST(Families, RiseFromEveryKindOfTheirFacesWithEveryTurn)
{
    int builds = 0;
    for (const Known& known : families()) builds += rebuild(known, 2);
    EXPECT_GE(builds, 80);
}

TEST(Families, RiseFromFacesWithoutATurnToo)
{
    int builds = 0;
    for (const std::vector<Known>& list : {archimedean, families()})
        for (const Known& known : list) {
            const Mesh solid = make_solid(known.solid, 1.0);
            for (const Face f : kinds(solid)) {
                SCOPED_TRACE(known.solid + " base=face:" + std::to_string(f.index));
                expect_solid(raised(dihedron(solid.valence(f)), known.solid, {{"base", "face:" + std::to_string(f.index)}, {"turns", "1"}}), known);
                ++builds;
            }
        }
    EXPECT_GE(builds, 100);
}

TEST(Mirror, TurnsTheSnubSolidsIntoTheirTwins)
{
    for (const std::string name : {"snub_cube", "snub_dodecahedron"}) {
        const Mesh left = raised(dihedron(name == "snub_cube" ? 4 : 5), name), right = raised(dihedron(name == "snub_cube" ? 4 : 5), name, {{"mirror", "true"}});
        expect_solid(right, *std::ranges::find(archimedean, name, &Known::solid));
        // Mirrored in the plane through the base's corner 0 and its axis (y = 0), one is the other and not itself.
        const auto contains = [](const Mesh& mesh, const Point& p) {
            return std::ranges::any_of(mesh.vertices(), [&](Vertex v) { return glm::distance(mesh.position(v), p) < 1e-9; });
        };
        int in_twin = 0, in_itself = 0;
        for (const Vertex v : left.vertices()) {
            const Point p = left.position(v), mirrored(p.x, -p.y, p.z);
            in_twin += contains(right, mirrored);
            in_itself += contains(left, mirrored);
        }
        EXPECT_EQ(in_twin, int(left.vertex_count())) << name;
        EXPECT_LT(in_itself, int(left.vertex_count())) << name;
    }
}

// --- presets --------------------------------------------------------------------------------------------------------------------

const Operator& operator_called(const std::string& name)
{
    static const Registry registry = [] {
        Registry r;
        register_extrude(r);
        return r;
    }();
    return registry.get(name);
}

Arguments arguments_of(const Preset& preset)
{
    Arguments list;
    for (std::istringstream words(preset.arguments); !words.eof();) {
        std::string word;
        words >> word;
        const auto equals = word.find('=');
        list.emplace_back(word.substr(0, equals), word.substr(equals + 1));
    }
    return list;
}

TEST(RegularPresets, OfTheSevenAreTheirSolids)
{
    for (const auto& [name, solid, sides] : std::vector<std::tuple<std::string, std::string, int>>{{"tetrahedral", "tetrahedron", 3},
                                                                                                   {"cubical", "cube", 4},
                                                                                                   {"octahedral", "octahedron", 3},
                                                                                                   {"dodecahedral", "dodecahedron", 5},
                                                                                                   {"icosahedral", "icosahedron", 3},
                                                                                                   {"cuboctahedral", "cuboctahedron", 4},
                                                                                                   {"rhombicuboctahedral", "rhombicuboctahedron", 4}}) {
        SCOPED_TRACE(name);
        const Operator& op = operator_called("extrude." + name);
        ASSERT_FALSE(op.presets.empty());
        EXPECT_EQ(op.presets[0].name, "regular");
        Scene scene;
        scene.mesh = dihedron(sides);
        Arguments arguments = arguments_of(op.presets[0]);
        arguments.emplace_back("faces", "0");
        run_extrusion(scene, op.name, arguments);
        expect_solid(scene.mesh, *std::ranges::find(archimedean, solid, &Known::solid));
    }
}

TEST(RegularPresets, OfAnySolidAreEveryKindOfFaceThatTurns)
{
    const Operator& op = operator_called("extrude.solid");
    EXPECT_EQ(op.presets.size(), 35u);
    std::set<std::tuple<std::string, int, int>> patterns; // solid, sides, turns
    for (const Preset& preset : op.presets) {
        SCOPED_TRACE(preset.name);
        const Arguments arguments = arguments_of(preset);
        const std::string solid = arguments[0].second, base = arguments[1].second;
        PatternChoice choice;
        if (base.starts_with("face:")) choice.base = Face(std::uint32_t(std::stoi(base.substr(5))));
        else choice.sides = std::stoi(base);
        const SolidPattern pattern = read_pattern(make_solid(solid, 1.0), choice);
        EXPECT_TRUE(preset.name.starts_with(solid));
        EXPECT_TRUE(patterns.emplace(solid, pattern.sides, pattern.turns).second) << "twice";
        Scene scene;
        scene.mesh = dihedron(pattern.sides);
        Arguments all = arguments;
        all.emplace_back("faces", "0");
        run_extrusion(scene, op.name, all);
        expect_solid(scene.mesh, *std::ranges::find(archimedean, solid, &Known::solid));
    }
}

TEST(FigurePresets, AreSoundOnEverySideOfABox)
{
    std::set<std::string> figures;
    for (const char* name : {"tetrahedral", "cubical", "octahedral", "dodecahedral", "icosahedral", "cuboctahedral", "rhombicuboctahedral"})
        for (const Preset& preset : operator_called(std::string("extrude.") + name).presets) {
            if (!preset.name.starts_with("fig")) continue;
            figures.insert(preset.name.substr(0, 5));
            Scene scene;
            scene.mesh = cube();
            Arguments arguments = arguments_of(preset);
            arguments.emplace_back("faces", "all");
            run_extrusion(scene, std::string("extrude.") + name, arguments);
            EXPECT_SOUND(scene.mesh) << preset.name;
            EXPECT_EQ(genus(scene.mesh), 0) << preset.name;
        }
    EXPECT_EQ(figures, (std::set<std::string>{"fig24", "fig25", "fig26", "fig27", "fig28"}));
}

} // namespace
} // namespace druse
