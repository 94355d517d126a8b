// The four minimal operators: their table of effects row by row, the rotation rule, and long random walks beside a naive model.
#include "dlfl/errors.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <vector>

namespace druse {
namespace {

using namespace test;

std::int64_t parts(const Mesh& mesh) { return static_cast<std::int64_t>(components(mesh).parts.size()); }

/// What an operator adds to V, E, F, χ, the number of components and the genus.
struct Effect {
    std::int64_t vertices, edges, faces, euler, components, genus;
    friend bool operator==(const Effect&, const Effect&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Effect& e)
    {
        return out << "V " << e.vertices << ", E " << e.edges << ", F " << e.faces << ", chi " << e.euler << ", C " << e.components << ", g " << e.genus;
    }
};

template <class Change>
Effect effect(Mesh& mesh, Change&& change)
{
    const Counts before = mesh.counts();
    const std::int64_t euler = euler_characteristic(mesh), c = parts(mesh), g = genus(mesh);
    change();
    EXPECT_SOUND(mesh);
    const Counts after = mesh.counts();
    return {std::int64_t(after.vertices) - before.vertices, std::int64_t(after.edges) - before.edges, std::int64_t(after.faces) - before.faces,
            euler_characteristic(mesh) - euler, parts(mesh) - c, genus(mesh) - g};
}

TEST(CreateVertex, MakesAComponentOfOneVertexAndOneFace)
{
    Mesh mesh = cube();
    Vertex v;
    EXPECT_EQ(effect(mesh, [&] { v = mesh.create_vertex(Point(1, 2, 3)); }), (Effect{1, 0, 1, 2, 1, 0}));
    EXPECT_TRUE(mesh.is_point_sphere(v));
    EXPECT_EQ(valence(mesh, v), 0);
    EXPECT_EQ(valence(mesh, mesh.face(mesh.corner(v))), 1);
    EXPECT_EQ(mesh.position(v), Point(1, 2, 3));
    int corners = 0;
    for (const Corner c : mesh.around(v)) corners += c == mesh.corner(v) ? 1 : 100;
    EXPECT_EQ(corners, 1);
}

TEST(DeleteVertex, TakesAPointSphereAway)
{
    Mesh mesh = cube();
    const Vertex v = mesh.create_vertex(Point(0));
    EXPECT_EQ(effect(mesh, [&] { mesh.delete_vertex(v); }), (Effect{-1, 0, -1, -2, -1, 0}));
    EXPECT_FALSE(mesh.is_alive(v));
}

TEST(DeleteVertex, RefusesAVertexWithEdges)
{
    Mesh mesh = cube();
    EXPECT_THROW(mesh.delete_vertex(Vertex(0)), InternalError);
    EXPECT_EQ(mesh, cube());
}

TEST(CreateVertex, RefusesAPlaceThatIsNotFinite)
{
    Mesh mesh;
    EXPECT_THROW(mesh.create_vertex(Point(0, std::numeric_limits<double>::quiet_NaN(), 0)), InternalError);
    EXPECT_THROW(mesh.create_vertex(Point(std::numeric_limits<double>::infinity(), 0, 0)), InternalError);
}

TEST(InsertEdge, SplitsAFaceInTwo)
{
    Mesh mesh = cube();
    mesh.set_group(Face(3), 7);
    const Corner c1 = mesh.corner(Face(3), 1), c2 = mesh.corner(Face(3), 3), start = mesh.corner(Face(3));
    Edge e;
    EXPECT_EQ(effect(mesh, [&] { e = mesh.insert_edge(c1, c2); }), (Effect{0, 1, 1, 0, 0, 0}));
    EXPECT_EQ(e, Edge(12));
    EXPECT_EQ(mesh.corner(e, 0), c1);
    EXPECT_EQ(mesh.corner(e, 1), c2);
    EXPECT_EQ(valence(mesh, Face(3)), 3);
    EXPECT_EQ(valence(mesh, Face(6)), 3);
    EXPECT_EQ(mesh.corner(Face(3)), start); // the part with the start corner keeps the id
    EXPECT_EQ(mesh.edge(mesh.corner(Face(6))), e); // the other starts at the new edge
    EXPECT_EQ(mesh.group(Face(6)), 7);
}

TEST(InsertEdge, BetweenFacesOfOneComponentAddsAHandle)
{
    Mesh mesh = cube();
    mesh.set_group(Face(0), 3);
    mesh.set_group(Face(5), 4);
    const Corner start = mesh.corner(Face(0));
    EXPECT_EQ(effect(mesh, [&] { mesh.insert_edge(mesh.corner(Face(5), 2), mesh.corner(Face(0), 1)); }), (Effect{0, 1, -1, -2, 0, 1}));
    EXPECT_TRUE(mesh.is_alive(Face(0))); // the lower id stays, with its group and start
    EXPECT_FALSE(mesh.is_alive(Face(5)));
    EXPECT_EQ(mesh.group(Face(0)), 3);
    EXPECT_EQ(mesh.corner(Face(0)), start);
    EXPECT_EQ(valence(mesh, Face(0)), 10);
}

TEST(InsertEdge, BetweenComponentsJoinsThemAndAddsTheirGenera)
{
    Mesh mesh = torus(4, 4);
    mesh.append(torus(3, 3));
    EXPECT_EQ(genus(mesh), 2);
    EXPECT_EQ(effect(mesh, [&] { mesh.insert_edge(mesh.corner(Face(0)), mesh.corner(Face(16))); }), (Effect{0, 1, -1, -2, -1, 0}));
    EXPECT_EQ(genus(mesh), 2);
}

TEST(InsertEdge, JoinsTwoPointSpheresIntoASegmentAndDeletingItGivesThemBack)
{
    Mesh mesh;
    const Vertex a = mesh.create_vertex(Point(0)), b = mesh.create_vertex(Point(1));
    Edge e;
    EXPECT_EQ(effect(mesh, [&] { e = mesh.insert_edge(mesh.corner(a), mesh.corner(b)); }), (Effect{0, 1, -1, -2, -1, 0}));
    EXPECT_EQ(counts(mesh), (Counts{2, 1, 1}));
    EXPECT_EQ(valence(mesh, Face(0)), 2);
    EXPECT_EQ(effect(mesh, [&] { mesh.delete_edge(e); }), (Effect{0, -1, 1, 2, 1, 0}));
    EXPECT_TRUE(mesh.is_point_sphere(a));
    EXPECT_TRUE(mesh.is_point_sphere(b));
}

TEST(InsertEdge, GoesIntoTheCornerBetweenItsTwoEdges)
{
    Mesh mesh = cube();
    const Corner c1 = mesh.corner(Face(2), 0), c2 = mesh.corner(Face(2), 2);
    const Edge in = mesh.edge(mesh.previous(c1)), out = mesh.edge(c1);
    const Edge e = mesh.insert_edge(c1, c2);
    EXPECT_EQ(mesh.edge(mesh.previous(c1)), in); // c1 keeps the edge coming in
    EXPECT_EQ(mesh.edge(c1), e);                 // and is the tail of the new one
    const Corner taken = mesh.next(mesh.opposite(c1));
    EXPECT_EQ(mesh.vertex(taken), mesh.vertex(c1)); // a new corner has taken the edge going out
    EXPECT_EQ(mesh.edge(taken), out);
    // Counter-clockwise around the vertex: out, the new edge, in.
    EXPECT_EQ(mesh.rotate(taken), c1);
    EXPECT_EQ(mesh.edge(mesh.rotate(c1)), in);
}

TEST(InsertEdge, BetweenNeighbouringCornersMakesATwoSidedFace)
{
    Mesh mesh = cube();
    const Corner c = mesh.corner(Face(0));
    const Edge first = mesh.edge(c), e = mesh.insert_edge(c, mesh.next(c));
    EXPECT_SOUND(mesh);
    EXPECT_EQ(valence(mesh, Face(0)) + valence(mesh, Face(6)), 6);
    EXPECT_EQ(mesh.ends(e), mesh.ends(first));
}

TEST(InsertEdge, BetweenTwoCornersOfOneVertexMakesALoop)
{
    Mesh mesh = cube_with_antenna();
    const Corner tip = mesh.corner(Vertex(8)), before = mesh.previous(tip), after = mesh.next(tip);
    ASSERT_EQ(mesh.vertex(before), mesh.vertex(after));
    Edge e;
    EXPECT_EQ(effect(mesh, [&] { e = mesh.insert_edge(before, after); }), (Effect{0, 1, 1, 0, 0, 0}));
    EXPECT_EQ(mesh.ends(e)[0], mesh.ends(e)[1]);
    // Taking the antenna leaves a face with one side, and taking that leaves the cube.
    EXPECT_EQ(effect(mesh, [&] { mesh.delete_edge(mesh.edge(mesh.corner(Vertex(8))), true); }), (Effect{-1, -1, 0, 0, 0, 0}));
    EXPECT_TRUE(valence(mesh, mesh.faces(e)[0]) == 1 || valence(mesh, mesh.faces(e)[1]) == 1);
    EXPECT_EQ(effect(mesh, [&] { mesh.delete_edge(e); }), (Effect{0, -1, -1, 0, 0, 0}));
    EXPECT_EQ(counts(mesh), (Counts{8, 12, 6}));
}

TEST(InsertEdge, RefusesTheSameCornerTwice)
{
    Mesh mesh = cube();
    EXPECT_THROW(mesh.insert_edge(mesh.corner(Face(0)), mesh.corner(Face(0))), InternalError);
    EXPECT_EQ(mesh, cube());
}

TEST(InsertEdge, LeavesAnOpenBoundaryAlone)
{
    Mesh mesh = open_grid(2, 2);
    const Corner on_boundary = mesh.corner(*mesh.boundary_faces().begin());
    EXPECT_THROW(mesh.insert_edge(on_boundary, mesh.corner(Face(0))), InternalError);
    EXPECT_THROW(mesh.delete_edge(mesh.edge(on_boundary)), InternalError);
    EXPECT_EQ(mesh, open_grid(2, 2));
}

TEST(DeleteEdge, MergesTwoFacesUnderTheLowerId)
{
    Mesh mesh = cube();
    for (const Face f : mesh.faces()) mesh.set_group(f, int(f.index) + 1);
    const Edge e(11);
    const auto [f, g] = mesh.faces(e);
    const Face low = std::min(f, g), high = std::max(f, g);
    EXPECT_EQ(effect(mesh, [&] { mesh.delete_edge(e); }), (Effect{0, -1, -1, 0, 0, 0}));
    EXPECT_TRUE(mesh.is_alive(low));
    EXPECT_FALSE(mesh.is_alive(high));
    EXPECT_EQ(mesh.group(low), int(low.index) + 1);
    EXPECT_EQ(valence(mesh, low), 6);
}

TEST(DeleteEdge, OfAHandleTakesTheHandleAway)
{
    Mesh mesh = cube();
    const Edge e = mesh.insert_edge(mesh.corner(Face(0)), mesh.corner(Face(5)));
    EXPECT_EQ(genus(mesh), 1);
    EXPECT_EQ(effect(mesh, [&] { mesh.delete_edge(e); }), (Effect{0, -1, 1, 2, 0, -1}));
    EXPECT_EQ(counts(mesh), (Counts{8, 12, 6}));
}

TEST(DeleteEdge, OfABridgeLetsTheComponentFallInTwo)
{
    Mesh mesh = tethered_cubes();
    EXPECT_EQ(effect(mesh, [&] { mesh.delete_edge(Edge(24)); }), (Effect{0, -1, 1, 2, 1, 0}));
}

TEST(DeleteEdge, LeavesAPointSphereOrTakesItAwayToo)
{
    Mesh mesh = cube_with_antenna();
    const Edge antenna(12);
    EXPECT_EQ(effect(mesh, [&] { mesh.delete_edge(antenna); }), (Effect{0, -1, 1, 2, 1, 0}));
    EXPECT_TRUE(mesh.is_point_sphere(Vertex(8)));
    EXPECT_EQ(valence(mesh, Face(0)), 4); // the face of the cube keeps its id

    mesh = cube_with_antenna();
    EXPECT_EQ(effect(mesh, [&] { mesh.delete_edge(antenna, true); }), (Effect{-1, -1, 0, 0, 0, 0}));
    mesh.compact();
    EXPECT_EQ(rings(mesh), rings(cube()));
}

TEST(DeleteEdge, OfALoneSegmentWithCleanupLeavesNothing)
{
    Mesh mesh = segment();
    mesh.delete_edge(Edge(0), true);
    EXPECT_SOUND(mesh);
    EXPECT_EQ(counts(mesh), (Counts{0, 0, 0}));
}

TEST(DeleteEdge, OfALoneLoopLeavesAPointSphere)
{
    // Two antennae on one vertex, an edge between two of its corners, and the antennae taken away: a vertex with a loop.
    for (const bool cleanup : {false, true}) {
        Mesh mesh;
        const Vertex v = mesh.create_vertex(Point(0)), w = mesh.create_vertex(Point(1));
        mesh.insert_edge(mesh.corner(v), mesh.corner(w));
        const Corner at_w = mesh.corner(w);
        const Vertex x = mesh.create_vertex(Point(2));
        const Edge to_x = mesh.insert_edge(mesh.corner(x), mesh.corner(v));
        const Edge to_w = mesh.edge(at_w);
        std::vector<Corner> at_v;
        for (const Corner c : mesh.around(v)) at_v.push_back(c);
        ASSERT_EQ(at_v.size(), 2u);
        const Edge loop = mesh.insert_edge(at_v[0], at_v[1]);
        mesh.delete_edge(to_x, true);
        mesh.delete_edge(to_w, true);
        ASSERT_SOUND(mesh);
        ASSERT_EQ(counts(mesh), (Counts{1, 1, 2}));
        mesh.delete_edge(loop, cleanup);
        EXPECT_SOUND(mesh);
        EXPECT_EQ(counts(mesh), cleanup ? (Counts{0, 0, 0}) : (Counts{1, 0, 1}));
    }
}

// --- random walks -------------------------------------------------------------------------------------------------------------

/// The rotation system of a mesh, kept by hand: for each vertex, counter-clockwise, the sides of edges that leave it.
class Model {
public:
    using Side = std::pair<std::uint32_t, int>; // edge, and which of its two corners

    static Side side(const Mesh& mesh, Corner c)
    {
        const Edge e = mesh.edge(c);
        return {e.index, mesh.corner(e, 0) == c ? 0 : 1};
    }
    /// Where a new edge goes at a corner: right after the side that leaves it.
    struct Place {
        std::uint32_t vertex;
        bool alone;
        Side after;
    };
    static Place place(const Mesh& mesh, Corner c)
    {
        const bool alone = !mesh.edge(c).valid();
        return {mesh.vertex(c).index, alone, alone ? Side() : side(mesh, c)};
    }
    void create(std::uint32_t v) { rotation_[v]; }
    void remove(std::uint32_t v) { rotation_.erase(v); }
    void insert(std::uint32_t edge, const Place& p1, const Place& p2)
    {
        put(p1, {edge, 0});
        put(p2, {edge, 1});
    }
    void erase(std::uint32_t edge, bool cleanup)
    {
        for (auto it = rotation_.begin(); it != rotation_.end();) {
            auto& sides = it->second;
            const std::size_t before = sides.size();
            std::erase_if(sides, [edge](const Side& s) { return s.first == edge; });
            if (cleanup && before > 0 && sides.empty()) it = rotation_.erase(it);
            else ++it;
        }
    }
    void expect_same(const Mesh& mesh) const
    {
        ASSERT_EQ(mesh.vertex_count(), rotation_.size());
        for (const auto& [v, sides] : rotation_) {
            ASSERT_TRUE(mesh.is_alive(Vertex(v)));
            if (sides.empty()) {
                ASSERT_TRUE(mesh.is_point_sphere(Vertex(v)));
                continue;
            }
            std::vector<Side> found;
            for (const Corner c : mesh.around(Vertex(v))) found.push_back(side(mesh, c));
            const auto first = std::find(found.begin(), found.end(), sides.front());
            ASSERT_NE(first, found.end());
            std::rotate(found.begin(), first, found.end());
            ASSERT_EQ(found, sides);
        }
    }

private:
    void put(const Place& p, const Side& s)
    {
        auto& sides = rotation_[p.vertex];
        if (sides.empty()) sides.push_back(s);
        else sides.insert(std::find(sides.begin(), sides.end(), p.after) + 1, s);
    }
    std::map<std::uint32_t, std::vector<Side>> rotation_;
};

/// Which id a new element must take: the lowest one freed, or else the next.
class Ids {
public:
    std::uint32_t expected() const { return freed_.empty() ? next_ : *freed_.begin(); }
    void take()
    {
        if (freed_.empty()) ++next_;
        else freed_.erase(freed_.begin());
    }
    void free(std::uint32_t id) { freed_.insert(id); }

private:
    std::uint32_t next_ = 0;
    std::set<std::uint32_t> freed_;
};

template <class H, class R>
H pick(const R& range, std::uint32_t count, std::mt19937& random)
{
    auto it = range.begin();
    for (auto k = random() % count; k > 0; --k) ++it;
    return *it;
}

Corner pick_corner(const Mesh& mesh, std::mt19937& random)
{
    for (;;)
        if (const Corner c(static_cast<std::uint32_t>(random() % mesh.corner_limit())); mesh.is_alive(c)) return c;
}

class RandomWalk : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Seeds, RandomWalk, testing::Range(0, 30));

TEST_P(RandomWalk, StaysSoundForTwentyThousandSteps)
{
    SCOPED_TRACE(testing::Message() << "seed " << GetParam());
    std::mt19937 random(static_cast<unsigned>(GetParam()));
    Mesh mesh;
    Model model;
    Ids vertices, edges, faces;
    std::map<int, int> done; // how often each row of the table came up
    for (int step = 0; step < 20000; ++step) {
        SCOPED_TRACE(testing::Message() << "step " << step);
        const std::int64_t euler = euler_characteristic(mesh);
        const unsigned dice = random() % 100;
        const bool crowded = mesh.edge_count() > 24;
        std::int64_t expected = 0;
        if (mesh.vertex_count() < 2 || (dice < 12 && mesh.vertex_count() < 12)) {
            const Vertex v = mesh.create_vertex(Point(step, 0, 0));
            ASSERT_EQ(v.index, vertices.expected());
            ASSERT_EQ(mesh.face(mesh.corner(v)).index, faces.expected());
            vertices.take();
            faces.take();
            model.create(v.index);
            expected = 2;
            ++done[0];
        } else if (dice < 20) {
            const auto v = pick<Vertex>(mesh.vertices(), mesh.vertex_count(), random);
            if (!mesh.is_point_sphere(v)) continue;
            vertices.free(v.index);
            faces.free(mesh.face(mesh.corner(v)).index);
            mesh.delete_vertex(v);
            model.remove(v.index);
            expected = -2;
            ++done[1];
        } else if (dice < (crowded ? 30u : 62u)) {
            const Corner c1 = pick_corner(mesh, random), c2 = pick_corner(mesh, random);
            if (c1 == c2) continue;
            const Face f1 = mesh.face(c1), f2 = mesh.face(c2);
            const Corner start = mesh.corner(std::min(f1, f2));
            const auto p1 = Model::place(mesh, c1), p2 = Model::place(mesh, c2);
            const Edge e = mesh.insert_edge(c1, c2);
            ASSERT_EQ(e.index, edges.expected());
            ASSERT_EQ(mesh.corner(e, 0), c1);
            ASSERT_EQ(mesh.corner(e, 1), c2);
            edges.take();
            model.insert(e.index, p1, p2);
            ASSERT_EQ(mesh.corner(std::min(f1, f2)), start);
            if (f1 == f2) {
                const Face made(faces.expected());
                faces.take();
                ASSERT_TRUE(mesh.corner(made) == c1 || mesh.corner(made) == c2);
                ++done[2];
            } else {
                ASSERT_FALSE(mesh.is_alive(std::max(f1, f2)));
                faces.free(std::max(f1, f2).index);
                expected = -2;
                ++done[3];
            }
        } else {
            if (mesh.edge_count() == 0) continue;
            const auto e = pick<Edge>(mesh.edges(), mesh.edge_count(), random);
            const auto [f, g] = mesh.faces(e);
            const auto [a, b] = mesh.ends(e);
            const bool cleanup = random() % 4 == 0;
            const bool loop = a == b, a_ends = valence(mesh, a) == (loop ? 2 : 1), b_ends = !loop && valence(mesh, b) == 1;
            mesh.delete_edge(e, cleanup);
            edges.free(e.index);
            model.erase(e.index, cleanup);
            if (f == g) {
                ASSERT_TRUE(mesh.is_alive(f) || (cleanup && a_ends && b_ends));
                faces.take();
                expected = 2;
                ++done[4];
            } else {
                faces.free(std::max(f, g).index);
                ++done[5];
            }
            // Point spheres that go with it take their faces along.
            for (const auto& [ends, v] : {std::pair(a_ends, a), std::pair(b_ends, b)}) {
                if (!ends || !cleanup) continue;
                ASSERT_FALSE(mesh.is_alive(v));
                vertices.free(v.index);
                expected -= 2;
            }
            if (cleanup && (a_ends || b_ends)) { // which faces is the operator's business: look
                faces = Ids();
                std::vector<std::uint32_t> gaps;
                for (std::uint32_t i = 0; i < mesh.face_limit(); ++i) {
                    faces.take();
                    if (!mesh.is_alive(Face(i))) gaps.push_back(i);
                }
                for (const std::uint32_t i : gaps) faces.free(i);
            }
        }
        ASSERT_SOUND(mesh);
        ASSERT_EQ(euler_characteristic(mesh) - euler, expected);
        ASSERT_NO_FATAL_FAILURE(model.expect_same(mesh));
        if (step % 50 == 0) {
            ASSERT_EQ(euler_characteristic(mesh), 2 * parts(mesh) - 2 * genus(mesh));
            ASSERT_GE(genus(mesh), 0);
        }
    }
    for (int row = 0; row < 6; ++row) EXPECT_GT(done[row], 200) << "row " << row << " hardly came up";
}

TEST_P(RandomWalk, IsTakenBackBitForBit)
{
    SCOPED_TRACE(testing::Message() << "seed " << GetParam());
    std::mt19937 random(static_cast<unsigned>(GetParam()) + 500);
    Mesh mesh = mixed();
    std::vector<Mesh> states{mesh};
    std::vector<MeshChange> changes;
    for (int command = 0; command < 40; ++command) {
        mesh.begin_change();
        for (int k = 0; k < 1 + command % 7; ++k) {
            const unsigned dice = random() % 100;
            if (dice < 15) {
                mesh.create_vertex(Point(command, k, 0));
            } else if (dice < 55) {
                const Corner c1 = pick_corner(mesh, random), c2 = pick_corner(mesh, random);
                if (c1 != c2 && !mesh.face(c1).is_boundary() && !mesh.face(c2).is_boundary()) mesh.insert_edge(c1, c2);
            } else if (mesh.edge_count() > 0) {
                const auto e = pick<Edge>(mesh.edges(), mesh.edge_count(), random);
                if (!mesh.is_on_boundary(e)) mesh.delete_edge(e, dice % 2 == 0);
            }
        }
        if (command % 9 == 8) mesh.replace_with(command % 2 == 0 ? torus(5, 4) : mixed());
        if (command % 4 == 3) {
            mesh.roll_back(); // with holes, without compact()
            ASSERT_EQ(mesh, states.back());
            ASSERT_FALSE(mesh.has_holes());
        } else {
            mesh.compact();
            changes.push_back(mesh.end_change());
            ASSERT_EQ(check_change(mesh, changes.back()), "");
            states.push_back(mesh);
        }
        ASSERT_SOUND(mesh);
    }
    std::size_t at = changes.size();
    for (int move = 0; move < 200; ++move) {
        if (at > 0 && (at == changes.size() || random() % 2 == 0)) mesh.exchange(changes[--at]);
        else mesh.exchange(changes[at++]);
        ASSERT_EQ(mesh, states[at]);
    }
    ASSERT_SOUND(mesh);
}

} // namespace
} // namespace druse
