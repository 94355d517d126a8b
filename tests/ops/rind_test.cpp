// rind.punch and rind.peel: the counts of every order of openings, and what stays as it was.
#include "ops/pipe.h"
#include "ops/rind.h"
#include "run.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace druse {
namespace {

using namespace test;
using Arguments = std::vector<std::pair<std::string, std::string>>;

Scene crust_of(Mesh mesh)
{
    Scene scene = scene_of(std::move(mesh));
    run(scene, "rind.crust", {{"guard", "off"}, {"thickness", "0.05"}});
    return scene;
}

std::vector<std::string> open(Scene& scene, const char* name, const std::vector<Face>& faces, Arguments more = {})
{
    const Operator& op = ops_registry().get(name);
    const auto parameters = op.make();
    more.emplace_back("faces", FaceSelector::of(faces).text());
    for (const auto& [key, value] : more) op.find(key)->set(parameters.get(), value);
    Progress progress;
    Context context{.progress = progress};
    op.run(scene, parameters.get(), context);
    settle(scene);
    return context.notes;
}

// --- which faces ------------------------------------------------------------------------------------------------------------------

std::vector<Face> looking(const Mesh& mesh, const std::vector<Vector>& directions)
{
    std::vector<Face> list;
    for (const Vector& d : directions)
        for (const Face f : mesh.faces())
            if (glm::dot(unit_normal(mesh, f), d) > 0.99) list.push_back(f);
    std::ranges::sort(list);
    return list;
}

std::vector<Face> all_faces(const Mesh& mesh)
{
    std::vector<Face> list;
    for (const Face f : mesh.faces()) list.push_back(f);
    return list;
}

/// Every second face, no two of them with a common edge. Precondition: an even number of edges at each vertex.
std::vector<Face> alternate(const Mesh& mesh)
{
    std::vector<int> colour(mesh.face_limit(), 0);
    colour[0] = 1;
    std::vector<Face> reached{Face(0)}, list;
    for (std::size_t i = 0; i < reached.size(); ++i) {
        if (colour[reached[i].index] == 1) list.push_back(reached[i]);
        for (const Corner c : mesh.corners(reached[i])) {
            const Face across = mesh.face(mesh.opposite(c));
            if (colour[across.index] != 0) continue;
            colour[across.index] = -colour[reached[i].index];
            reached.push_back(across);
        }
    }
    std::ranges::sort(list);
    return list;
}

std::vector<Face> around_first_vertex(const Mesh& mesh)
{
    std::vector<Face> list;
    for (const Corner c : mesh.around(Vertex(0))) list.push_back(mesh.face(c));
    std::ranges::sort(list);
    return list;
}

const Vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
std::vector<Face> one(const Mesh&) { return {Face(0)}; }
std::vector<Face> opposite(const Mesh& m) { return looking(m, {z, -z}); }
std::vector<Face> adjacent(const Mesh& m) { return looking(m, {x, z}); }
std::vector<Face> row_of_three(const Mesh& m) { return looking(m, {x, z, -x}); }
std::vector<Face> corner_of_three(const Mesh& m) { return looking(m, {x, y, z}); }
std::vector<Face> ring_of_four(const Mesh& m) { return looking(m, {x, y, -x, -y}); }
std::vector<Face> all_but_one(const Mesh& m) { return looking(m, {x, y, z, -x, -y}); }
std::vector<Face> three_apart(const Mesh&) { return {Face(0), Face(7), Face(14)}; }
std::vector<Face> tube_ring(const Mesh&) { return {Face(0), Face(1), Face(2), Face(3), Face(4)}; }
std::vector<Face> long_ring(const Mesh&) { return {Face(2), Face(7), Face(12), Face(17)}; }
std::vector<Face> torus_neighbours(const Mesh&) { return {Face(6), Face(7)}; }
Mesh torus_of_twenty() { return torus(4, 5); }

// --- the table of section 6 ---------------------------------------------------------------------------------------------------------

struct Reference {
    const char* name;
    Mesh (*make)();
    const char* op;
    std::vector<Face> (*faces)(const Mesh&);
    Counts counts;
    std::size_t components;
    std::int64_t genus;
    bool cut = false;
    friend std::ostream& operator<<(std::ostream& out, const Reference& r) { return out << r.name; }
};
const Reference references[] = {
    {"cube_punch_1", cube, "rind.punch", one, {16, 28, 14}, 1, 0},
    {"cube_punch_2_opposite", cube, "rind.punch", opposite, {16, 32, 16}, 1, 1},
    {"cube_punch_2_adjacent", cube, "rind.punch", adjacent, {16, 32, 16}, 1, 1},
    {"cube_punch_6", cube, "rind.punch", all_faces, {16, 48, 24}, 1, 5},
    {"cube_peel_1", cube, "rind.peel", one, {16, 28, 14}, 1, 0},
    {"cube_peel_2_opposite", cube, "rind.peel", opposite, {16, 32, 16}, 1, 1},
    {"cube_peel_2_adjacent", cube, "rind.peel", adjacent, {16, 28, 14}, 1, 0},
    {"cube_peel_3_in_a_row", cube, "rind.peel", row_of_three, {16, 28, 14}, 1, 0},
    {"cube_peel_3_around_a_vertex", cube, "rind.peel", corner_of_three, {14, 24, 12}, 1, 0},
    {"cube_peel_a_ring_of_4", cube, "rind.peel", ring_of_four, {16, 24, 12}, 2, 0},
    {"cube_peel_5", cube, "rind.peel", all_but_one, {8, 12, 6}, 1, 0},
    {"octahedron_punch_4_alternate", octahedron, "rind.punch", alternate, {12, 36, 20}, 1, 3},
    {"octahedron_peel_4_alternate_keep", octahedron, "rind.peel", alternate, {12, 36, 20}, 1, 3},
    {"octahedron_peel_4_alternate_cut", octahedron, "rind.peel", alternate, {24, 36, 20}, 4, 0, true},
    {"icosahedron_peel_5_around_a_vertex", icosahedron, "rind.peel", around_first_vertex, {22, 55, 35}, 1, 0},
    {"icosahedron_punch_20", icosahedron, "rind.punch", all_faces, {24, 120, 60}, 1, 19},
    {"dodecahedron_punch_12", dodecahedron, "rind.punch", all_faces, {40, 120, 60}, 1, 11},
    {"torus_punch_1", torus_of_twenty, "rind.punch", one, {40, 84, 42}, 1, 2},
    {"torus_punch_3", torus_of_twenty, "rind.punch", three_apart, {40, 92, 46}, 1, 4},
    {"torus_peel_a_ring_of_5", torus_of_twenty, "rind.peel", tube_ring, {40, 80, 40}, 1, 1},
    {"torus_peel_a_ring_of_4", torus_of_twenty, "rind.peel", long_ring, {40, 80, 40}, 1, 1},
    {"torus_peel_2_adjacent", torus_of_twenty, "rind.peel", torus_neighbours, {40, 84, 42}, 1, 2},
};

class ReferenceTable : public testing::TestWithParam<Reference> {};
INSTANTIATE_TEST_SUITE_P(Rind, ReferenceTable, testing::ValuesIn(references), [](const auto& parameter) { return std::string(parameter.param.name); });

TEST_P(ReferenceTable, HasTheseCounts)
{
    const Reference& r = GetParam();
    const Mesh mesh = r.make();
    const std::vector<Face> faces = r.faces(mesh);
    Scene scene = crust_of(mesh);
    EXPECT_EQ(counts(scene.mesh), (Counts{2 * mesh.vertex_count(), 2 * mesh.edge_count(), 2 * mesh.face_count()}));
    EXPECT_EQ(components(scene.mesh).parts.size(), 2u);
    open(scene, r.op, faces, r.cut ? Arguments{{"pinch", "cut"}} : Arguments());
    ASSERT_SOUND(scene.mesh);
    EXPECT_EQ(counts(scene.mesh), r.counts);
    EXPECT_EQ(components(scene.mesh).parts.size(), r.components);
    EXPECT_EQ(genus(scene.mesh), r.genus);
    // The walls are selected and one new group; each is a quad.
    EXPECT_FALSE(scene.selection->faces.empty());
    for (const Face f : scene.mesh.faces()) EXPECT_EQ(scene.mesh.group(f) == 1, std::ranges::binary_search(scene.selection->faces, f));
    for (const Face f : scene.selection->faces) EXPECT_EQ(scene.mesh.valence(f), 4);
}

TEST(Peel, TellsOfPinchedColumns)
{
    Scene scene = crust_of(octahedron());
    EXPECT_EQ(open(scene, "rind.peel", alternate(octahedron())), std::vector<std::string>{"6 pinched columns"});
    EXPECT_EQ(facts(scene.mesh).parallel_edges, 6u); // two at each vertex, one of them beside another
    scene = crust_of(octahedron());
    EXPECT_TRUE(open(scene, "rind.peel", alternate(octahedron()), {{"pinch", "cut"}}).empty());
    EXPECT_EQ(facts(scene.mesh).parallel_edges, 0u);
    EXPECT_GT(volume(scene.mesh), 0);
}

TEST(Punch, LeavesWallsWithoutThicknessBetweenNeighbours)
{
    Scene scene = crust_of(cube());
    open(scene, "rind.punch", adjacent(cube()));
    EXPECT_EQ(facts(scene.mesh).zero_thickness_walls, 1u);
    scene = crust_of(cube());
    open(scene, "rind.punch", all_faces(cube()));
    EXPECT_EQ(facts(scene.mesh).zero_thickness_walls, 12u);
    // A peel takes away those around its face, whichever way the neighbours were opened.
    scene = crust_of(cube());
    open(scene, "rind.punch", looking(cube(), {x, -x, y, -y}));
    open(scene, "rind.peel", looking(cube(), {z}));
    EXPECT_EQ(facts(scene.mesh).zero_thickness_walls, 4u);
    EXPECT_SOUND(scene.mesh);
}

// --- every order --------------------------------------------------------------------------------------------------------------------

/// CreatePipe, and then step 4 as it is written: the walls whose two faces are beside both edges go, side after side.
void peel_step_by_step(Mesh& mesh, const std::array<Corner, 2>& pair)
{
    std::vector<std::array<Edge, 2>> sides;
    Corner outer = pair[0], inner = pair[1];
    do {
        inner = mesh.previous(inner);
        sides.push_back({mesh.edge(outer), mesh.edge(inner)});
        outer = mesh.next(outer);
    } while (outer != pair[0]);
    std::vector<Face> walls;
    Opener(mesh).punch(pair, walls);
    for (const auto& [e, below] : sides) {
        if (!mesh.is_alive(e) || !mesh.is_alive(below)) continue;
        auto faces = mesh.faces(e), faces_below = mesh.faces(below);
        std::ranges::sort(faces);
        std::ranges::sort(faces_below);
        if (faces != faces_below) continue;
        std::vector<Edge> boundary;
        for (const Corner c : mesh.corners(faces[0])) boundary.push_back(mesh.edge(c));
        for (const Edge b : boundary)
            if (mesh.is_alive(b)) mesh.delete_edge(b, true);
    }
}

/// How many runs of consecutive faces of a set lie around a vertex; nothing if all are in it.
std::optional<std::uint32_t> runs(const Mesh& mesh, Vertex v, const std::set<Face>& set)
{
    std::uint32_t count = 0, inside = 0, all = 0;
    for (const Corner c : mesh.around(v)) {
        const bool in = set.contains(mesh.face(c)), before = set.contains(mesh.face(mesh.rotate(c)));
        count += in && !before;
        inside += in;
        ++all;
    }
    if (inside == all) return std::nullopt;
    return count;
}

struct Expected {
    Counts counts;
    std::uint32_t vertices_cut = 0;
};
Expected peeled(const Mesh& m, const std::set<Face>& open)
{
    Expected e;
    std::uint32_t within = 0, border = 0, closed_vertices = 0, columns = 0;
    for (const Edge edge : m.edges()) {
        const auto [a, b] = m.faces(edge);
        const int sides = int(open.contains(a)) + int(open.contains(b));
        within += sides == 2;
        border += sides == 1;
    }
    for (const Vertex v : m.vertices())
        if (const auto w = runs(m, v, open)) {
            ++closed_vertices;
            columns += *w;
            e.vertices_cut += 2 * std::max(1u, *w);
        }
    e.counts = {2 * closed_vertices, 2 * (m.edge_count() - within) + columns, 2 * (m.face_count() - std::uint32_t(open.size())) + border};
    return e;
}

class EveryOrder : public testing::TestWithParam<NamedShape> {};
const NamedShape rounds[] = {{"tetrahedron", tetrahedron}, {"cube", cube}, {"octahedron", octahedron}, {"dodecahedron", dodecahedron},
                             {"icosahedron", icosahedron}, {"torus_4_5", torus_of_twenty}, {"torus_3_7", [] { return torus(3, 7); }},
                             {"genus_3", [] { return block_with_holes(3); }}};
INSTANTIATE_TEST_SUITE_P(Rind, EveryOrder, testing::ValuesIn(rounds), shape_name<testing::TestParamInfo<NamedShape>>);
constexpr int trials = 250; // of each shape: 2000 in all

std::vector<Face> shuffled(const Mesh& mesh, std::mt19937& random)
{
    std::vector<Face> faces = all_faces(mesh);
    std::ranges::shuffle(faces, random);
    faces.resize(1 + random() % (faces.size() - 1));
    return faces;
}

TEST_P(EveryOrder, OfPeelsGivesTheCountsOfTheFormula)
{
    const Mesh mesh = GetParam().make();
    const Scene start = crust_of(mesh);
    for (unsigned seed = 0; seed < unsigned(trials); ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        Mesh now = start.mesh, step_by_step = start.mesh;
        std::vector<Face> walls;
        std::set<Face> opened;
        for (const Face f : shuffled(mesh, random)) {
            // Face ids are kept apart from what the openings do to them: the table is the one of the beginning.
            const Face asked = random() % 2 == 0 ? f : Face(f.index + mesh.face_limit());
            Opener(now).peel(*start.rind.find(now, asked), walls);
            peel_step_by_step(step_by_step, *start.rind.find(step_by_step, asked));
            opened.insert(f);
            ASSERT_EQ(counts(now), peeled(mesh, opened).counts);
            ASSERT_EQ(counts(step_by_step), counts(now));
        }
        ASSERT_SOUND(now);
        std::map<int, int> sides, sides_step_by_step;
        for (const Face f : now.faces()) ++sides[now.valence(f)];
        for (const Face f : step_by_step.faces()) ++sides_step_by_step[step_by_step.valence(f)];
        EXPECT_EQ(sides, sides_step_by_step);
        EXPECT_EQ(facts(now).zero_thickness_walls, facts(step_by_step).zero_thickness_walls);
        EXPECT_EQ(facts(now).component_genus.size(), facts(step_by_step).component_genus.size());
    }
}

TEST_P(EveryOrder, OfPunchesAndPeelsKeepsTheEulerCharacteristic)
{
    const Mesh mesh = GetParam().make();
    const Scene start = crust_of(mesh);
    const std::int64_t chi = euler_characteristic(mesh);
    for (unsigned seed = 0; seed < unsigned(trials); ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        Mesh now = start.mesh;
        std::vector<Face> walls;
        std::set<Face> opened;
        std::int64_t taken = 0, sides = 0; // walls
        bool peeled_any = false;
        for (const Face f : shuffled(mesh, random)) {
            const auto pair = *start.rind.find(now, f);
            if (random() % 2 == 0) {
                Opener(now).punch(pair, walls);
                sides += mesh.valence(f);
            } else {
                Opener(now).peel(pair, walls);
                peeled_any = true;
                for (const Corner c : mesh.corners(f)) taken += opened.contains(mesh.face(mesh.opposite(c)));
            }
            opened.insert(f);
            // A pipe takes 2 from χ, a wall that goes gives 2 back, and a rung that goes with both its ends takes 2.
            const std::int64_t vertices_gone = 2 * std::int64_t(mesh.vertex_count()) - now.vertex_count();
            ASSERT_EQ(euler_characteristic(now), 2 * chi - 2 * std::int64_t(opened.size()) + 2 * taken - vertices_gone);
            if (!peeled_any) {
                ASSERT_EQ(genus(now), 2 * (2 - chi) / 2 + std::int64_t(opened.size()) - 1);
            }
        }
        ASSERT_SOUND(now);
        if (!peeled_any) {
            const auto e = static_cast<std::int64_t>(now.edge_count()), f = static_cast<std::int64_t>(now.face_count());
            EXPECT_EQ(e, 2 * std::int64_t(mesh.edge_count()) + sides);
            EXPECT_EQ(f, 2 * std::int64_t(mesh.face_count()) - 2 * std::int64_t(opened.size()) + sides);
        }
    }
}

TEST_P(EveryOrder, CutAtItsColumnsIsAnOrdinaryManifold)
{
    const Mesh mesh = GetParam().make();
    const Scene start = crust_of(mesh);
    for (unsigned seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        std::vector<Face> faces = shuffled(mesh, random);
        std::ranges::sort(faces);
        Scene scene = start;
        open(scene, "rind.peel", faces, {{"pinch", "cut"}});
        ASSERT_SOUND(scene.mesh);
        const Expected e = peeled(mesh, {faces.begin(), faces.end()});
        EXPECT_EQ(counts(scene.mesh), (Counts{e.vertices_cut, e.counts.edges, e.counts.faces}));
        EXPECT_EQ(facts(scene.mesh).parallel_edges, 0u);
        // What is still closed can be opened afterwards.
        EXPECT_EQ(scene.rind.pairs(scene.mesh).size(), mesh.face_count() - faces.size());
    }
}

TEST_P(EveryOrder, LeavesOpenableWhatIsNotOpen)
{
    // Through the operators, one command a face: ids close up, and the table follows.
    const Mesh mesh = GetParam().make();
    Scene scene = crust_of(mesh);
    std::mt19937 random(1);
    for (std::size_t left = mesh.face_count(); left > 1; --left) {
        const auto pairs = scene.rind.pairs(scene.mesh);
        ASSERT_EQ(pairs.size(), left);
        const Rind::Pair& pair = pairs[random() % left];
        open(scene, "rind.peel", {random() % 2 == 0 ? pair.first : pair.second});
        ASSERT_SOUND(scene.mesh);
        ASSERT_FALSE(scene.mesh.has_holes());
    }
    const Rind::Pair last = scene.rind.pairs(scene.mesh)[0];
    EXPECT_EQ(complaint(scene, "rind.peel", {{"faces", std::to_string(last.first.index)}}), "would remove the whole surface");
}

TEST(Peel, KeepsGroupsAndStartsOfTheFacesThatStay)
{
    Mesh mesh = icosahedron();
    for (const Face f : mesh.faces()) mesh.set_group(f, int(f.index) + 1);
    Scene scene = crust_of(mesh);
    for (const std::uint32_t f : {0u, 1u, 2u, 7u, 3u, 4u}) {
        // Vertices do not move: their places name a face.
        const auto key = [&](Face g) { return std::pair(vertex_mean(scene.mesh, g), scene.mesh.position(scene.mesh.corner(g))); };
        const auto less = [](const auto& a, const auto& b) {
            return std::tie(a.first.x, a.first.y, a.first.z, a.second.x, a.second.y, a.second.z) < std::tie(b.first.x, b.first.y, b.first.z, b.second.x, b.second.y, b.second.z);
        };
        std::map<std::pair<Point, Point>, std::multiset<int>, decltype(less)> before(less), after(less);
        for (const Face g : scene.mesh.faces()) before[key(g)].insert(scene.mesh.group(g));
        const auto pairs = scene.rind.pairs(scene.mesh);
        const auto wanted = std::ranges::find_if(pairs, [&](const Rind::Pair& p) { return scene.mesh.group(p.first) == int(f) + 1; });
        open(scene, "rind.peel", {wanted->first});
        const int walls = scene.mesh.group(scene.selection->faces[0]);
        for (const Face g : scene.mesh.faces())
            if (scene.mesh.group(g) != walls) after[key(g)].insert(scene.mesh.group(g));
        for (const auto& [place, groups] : after) EXPECT_EQ(before[place], groups);
    }
}

// --- what is said, and refused --------------------------------------------------------------------------------------------------------

TEST(Punch, IgnoresFacesThatBelongToNoRind)
{
    Scene scene = crust_of(cube());
    EXPECT_TRUE(open(scene, "rind.punch", {Face(2)}).empty());
    EXPECT_EQ(open(scene, "rind.punch", {Face(2), Face(3)}), std::vector<std::string>{"1 face is not part of a rind: ignored"});
    EXPECT_EQ(open(scene, "rind.punch", {Face(2), Face(3), Face(4)}), std::vector<std::string>{"2 faces are not part of a rind: ignored"});
    EXPECT_EQ(counts(scene.mesh), (Counts{16, 36, 18}));
    EXPECT_EQ(complaint(scene, "rind.punch", {{"faces", "2-3"}}), "faces 2-3: none of them is part of a rind");
    EXPECT_EQ(complaint(scene, "rind.punch", {{"faces", "2"}}), "face 2 is not part of a rind");
    EXPECT_EQ(complaint(scene, "rind.peel", {{"faces", "12-14"}}), "faces 12-14: none of them is part of a rind");
    EXPECT_EQ(complaint(scene_of(cube()), "rind.punch", {{"faces", "all"}}), "faces 0-5: none of them is part of a rind");
    EXPECT_EQ(complaint(scene, "rind.punch", {{"faces", "none"}}), "no faces");
}

TEST(Punch, CountsAPairNamedTwiceOnce)
{
    Scene scene = crust_of(cube());
    EXPECT_TRUE(open(scene, "rind.punch", {Face(1), Face(7), Face(8)}).empty());
    EXPECT_EQ(counts(scene.mesh), (Counts{16, 32, 16}));
}

TEST(Punch, GivesTheWallsTheFreedIdsFirst)
{
    Scene scene = crust_of(cube());
    const std::vector<std::uint32_t> outer = ring(scene.mesh, Face(3));
    open(scene, "rind.punch", {Face(9)});
    EXPECT_EQ(ids(scene.selection->faces), (std::vector<std::uint32_t>{3, 9, 12, 13}));
    EXPECT_EQ(ring(scene.mesh, Face(3)), (std::vector<std::uint32_t>{outer[0], outer[1], outer[1] + 8, outer[0] + 8}));
    EXPECT_EQ(ring(scene.mesh, Face(13)), (std::vector<std::uint32_t>{outer[3], outer[0], outer[0] + 8, outer[3] + 8}));
}

TEST(Peel, RenumbersNothingWhereItRemovesNoMoreThanItMakes)
{
    Scene scene = crust_of(torus(8, 8));
    open(scene, "rind.peel", {Face(20)});
    const Mesh before = scene.mesh;
    std::vector<Face> walls;
    Opener(scene.mesh).peel(*scene.rind.find(scene.mesh, Face(21)), walls); // beside it
    EXPECT_FALSE(scene.mesh.has_holes());
    EXPECT_EQ(counts(scene.mesh), counts(before));
    for (const Face f : before.faces())
        if (before.valence(f) == 4 && f.index != 21 && f.index != 85 && scene.rind.find(before, f)) {
            EXPECT_EQ(ring(scene.mesh, f), ring(before, f));
        }
}

TEST(Openings, LeaveTheWallsAloneSelected)
{
    Scene scene = crust_of(cube());
    for (const auto& [name, direction, walls] : {std::tuple("rind.punch", x, 4u), std::tuple("rind.peel", z, 3u)}) { // the second one joins the first
        Selection everything;
        for (const Face f : scene.mesh.faces()) everything.faces.push_back(f);
        for (const Edge e : scene.mesh.edges()) everything.edges.push_back(e);
        for (const Vertex v : scene.mesh.vertices()) everything.vertices.push_back(v);
        scene.selection = everything;
        open(scene, name, looking(cube(), {direction}));
        EXPECT_EQ(scene.selection->faces.size(), walls) << name;
        EXPECT_TRUE(scene.selection->edges.empty()) << name;
        EXPECT_TRUE(scene.selection->vertices.empty()) << name;
    }
}

} // namespace
} // namespace druse
