// Faces replaced by discs of polygons, against the same mesh built from its polygon list.
#include "dlfl/patch.h"

#include "dlfl/errors.h"
#include "dlfl/mesh_builder.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace druse {
namespace {

using namespace test;
using Polygon = std::vector<int>;

struct Disc {
    int ring, inner;
    std::vector<Polygon> polygons;
};

Patch connected(const Disc& disc)
{
    Patch patch(disc.ring, disc.inner);
    for (const Polygon& p : disc.polygons) patch.add(p);
    patch.connect();
    return patch;
}

/// A top with n corners, which keeps the id, and n walls.
Disc box(int n)
{
    Disc disc{n, n, {{}}};
    for (int i = 0; i < n; ++i) disc.polygons[0].push_back(n + i);
    for (int i = 0; i < n; ++i) disc.polygons.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
    return disc;
}

/// n triangles about one new vertex.
Disc fan(int n)
{
    Disc disc{n, 1, {}};
    for (int i = 0; i < n; ++i) disc.polygons.push_back({i, (i + 1) % n, n});
    return disc;
}

/// A polygon split at random, again and again: by a diagonal, by a path over a new vertex, or by a fan.
Disc random_disc(int n, std::mt19937& random)
{
    Disc disc{n, 0, {{}}};
    std::set<std::pair<int, int>> used; // edges, by their ends
    const auto use = [&used](int a, int b) { return used.insert(std::minmax(a, b)).second; };
    for (int i = 0; i < n; ++i) {
        disc.polygons[0].push_back(i);
        use(i, (i + 1) % n);
    }
    for (int step = static_cast<int>(random() % 8); step > 0; --step) {
        const Polygon p = disc.polygons[random() % disc.polygons.size()];
        auto& place = *std::find(disc.polygons.begin(), disc.polygons.end(), p);
        const std::size_t m = p.size(), i = random() % m, j = (i + 1 + random() % (m - 1)) % m;
        Polygon first, second;
        const auto split = [&](int middle) { // the part from i to j, and the part from j to i
            for (std::size_t k = i; k != j; k = (k + 1) % m) first.push_back(p[k]);
            first.push_back(p[j]);
            for (std::size_t k = j; k != i; k = (k + 1) % m) second.push_back(p[k]);
            second.push_back(p[i]);
            if (middle >= 0) {
                first.push_back(middle);
                second.push_back(middle);
            }
        };
        switch (random() % 3) {
        case 0:
            if ((i + 1) % m == j || (j + 1) % m == i || !use(p[i], p[j])) continue;
            split(-1);
            break;
        case 1: {
            const int middle = n + disc.inner++;
            use(p[i], middle);
            use(middle, p[j]);
            split(middle);
            break;
        }
        case 2: {
            const int apex = n + disc.inner++;
            for (std::size_t k = 1; k < m; ++k) disc.polygons.push_back({p[k], p[(k + 1) % m], apex});
            *std::find(disc.polygons.begin(), disc.polygons.end(), p) = {p[0], p[1], apex};
            for (const int v : p) use(v, apex);
            continue;
        }
        }
        place = first;
        disc.polygons.push_back(second);
    }
    std::shuffle(disc.polygons.begin(), disc.polygons.end(), random);
    for (Polygon& p : disc.polygons) std::rotate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(random() % p.size()), p.end());
    return disc;
}

/// The polygons of a mesh after its faces were replaced, by plain book-keeping; and the ends of the new edges in the order in
/// which the new faces first use them.
struct Replaced {
    std::vector<std::vector<std::uint32_t>> rings;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> new_edges;
    std::uint32_t vertices;
};
Replaced replaced(const Mesh& mesh, const std::vector<Face>& faces, const std::vector<const Disc*>& discs)
{
    Replaced r{rings(mesh), {}, mesh.vertex_count()};
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Disc& disc = *discs[i];
        const auto old = ring(mesh, faces[i]);
        std::set<std::pair<int, int>> met;
        for (std::size_t k = 0; k < disc.polygons.size(); ++k) {
            const Polygon& p = disc.polygons[k];
            std::vector<std::uint32_t> ids;
            const auto id = [&](int local) {
                return local < disc.ring ? old[static_cast<std::size_t>(local)] : r.vertices + static_cast<std::uint32_t>(local - disc.ring);
            };
            for (std::size_t s = 0; s < p.size(); ++s) {
                const int a = p[s], b = p[(s + 1) % p.size()];
                ids.push_back(id(a));
                if (a < disc.ring && b == (a + 1) % disc.ring) continue;
                if (met.insert(std::minmax(a, b)).second) r.new_edges.emplace_back(id(a), id(b));
            }
            if (k == 0) r.rings[faces[i].index] = ids;
            else r.rings.push_back(ids);
        }
        r.vertices += static_cast<std::uint32_t>(disc.inner);
    }
    return r;
}

void expect_replaced(Mesh& mesh, const std::vector<Face>& faces, const std::vector<const Disc*>& discs)
{
    const Replaced expected = replaced(mesh, faces, discs);
    const Mesh before = mesh;
    std::vector<Patch> patches;
    for (const Disc* d : discs) patches.push_back(connected(*d));
    std::vector<const Patch*> patch_of;
    for (const Patch& p : patches) patch_of.push_back(&p);

    const std::uint32_t first = mesh.replace_faces(faces, patch_of);
    EXPECT_EQ(first, before.vertex_count());
    for (std::uint32_t v = first; v < mesh.vertex_count(); ++v) mesh.set_position(Vertex(v), Point(v, 0, 0));
    ASSERT_SOUND(mesh);
    EXPECT_EQ(mesh.vertex_count(), expected.vertices);
    EXPECT_EQ(rings(mesh), expected.rings);
    EXPECT_EQ(euler_characteristic(mesh), euler_characteristic(before));
    ASSERT_EQ(mesh.edge_count(), before.edge_count() + expected.new_edges.size());
    for (std::uint32_t e = 0; e < before.edge_count(); ++e) EXPECT_EQ(mesh.ends(Edge(e)), before.ends(Edge(e)));
    for (std::uint32_t k = 0; k < expected.new_edges.size(); ++k) {
        const auto [a, b] = mesh.ends(Edge(before.edge_count() + k));
        EXPECT_EQ(std::pair(a.index, b.index), expected.new_edges[k]) << "new edge " << k;
    }
}

TEST(ReplaceFace, RaisesABoxOnAFaceOfTheCube)
{
    Mesh mesh = cube();
    mesh.set_group(Face(2), 5);
    const Disc disc = box(4);
    expect_replaced(mesh, {Face(2)}, {&disc});
    EXPECT_EQ(counts(mesh), (Counts{12, 20, 10}));
    EXPECT_EQ(ring(mesh, Face(2)), (std::vector<std::uint32_t>{8, 9, 10, 11})); // the top keeps the id
    for (const std::uint32_t f : {2u, 6u, 7u, 8u, 9u}) EXPECT_EQ(mesh.group(Face(f)), 5);
    EXPECT_EQ(mesh.group(Face(3)), 0);
}

TEST(ReplaceFace, BeginsAtTheStartCorner)
{
    Mesh mesh = cube();
    mesh.set_start(mesh.corner(Face(2), 3));
    const auto old = ring(mesh, Face(2));
    const Disc disc = box(4);
    expect_replaced(mesh, {Face(2)}, {&disc});
    EXPECT_EQ(ring(mesh, Face(6))[0], old[0]);
}

TEST(ReplaceFaces, ReplacesNeighboursInOneGo)
{
    Mesh mesh = cube();
    const Disc disc = box(4);
    std::vector<Face> all;
    for (const Face f : mesh.faces()) all.push_back(f);
    expect_replaced(mesh, all, std::vector<const Disc*>(6, &disc));
    EXPECT_EQ(counts(mesh), (Counts{32, 60, 30}));
}

TEST(ReplaceFaces, FollowsTheOrderGivenNotTheOrderOfIds)
{
    Mesh mesh = cube();
    const Disc a = box(4), b = fan(4);
    expect_replaced(mesh, {Face(5), Face(0), Face(3)}, {&a, &b, &a});
}

TEST(ReplaceFace, TakesAFaceThatVisitsAVertexTwice)
{
    for (Mesh (*make)() : {cube_with_antenna, tethered_cubes, cube_with_edge_handle})
        for (Disc (*disc_of)(int) : {box, fan}) {
            Mesh mesh = make();
            const Disc disc = disc_of(valence(mesh, Face(0)));
            expect_replaced(mesh, {Face(0)}, {&disc});
        }
}

TEST(ReplaceFaces, GivesNewVerticesThePositionsWrittenForThemBefore)
{
    Mesh mesh = cube();
    const Patch patch = connected(fan(4));
    const std::span<Point> room = mesh.vertex_room(2);
    EXPECT_EQ(mesh, cube()); // nothing has changed yet
    room[0] = Point(1, 2, 3);
    room[1] = Point(4, 5, 6);
    const std::vector<Face> faces{Face(4), Face(1)};
    mesh.replace_faces(faces, std::vector<const Patch*>(2, &patch));
    EXPECT_EQ(mesh.position(Vertex(8)), Point(1, 2, 3));
    EXPECT_EQ(mesh.position(Vertex(9)), Point(4, 5, 6));
    EXPECT_SOUND(mesh);
}

TEST(ReplaceFace, TakesATwoSidedFace)
{
    Mesh mesh = three_lunes();
    const Disc disc = fan(2);
    expect_replaced(mesh, {Face(1)}, {&disc});
    EXPECT_EQ(counts(mesh), (Counts{3, 5, 4}));
}

class RandomDiscs : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Seeds, RandomDiscs, testing::Range(0, 40));

TEST_P(RandomDiscs, TakeThePlacesOfAnyFaces)
{
    SCOPED_TRACE(testing::Message() << "seed " << GetParam());
    std::mt19937 random(static_cast<unsigned>(GetParam()));
    for (const NamedShape& shape : all_shapes()) {
        SCOPED_TRACE(shape.name);
        Mesh mesh = shape.make();
        const Mesh before = mesh;
        std::vector<Face> faces;
        std::vector<Disc> discs;
        for (const Face f : mesh.faces())
            if (valence(mesh, f) > 2 && random() % 2 == 0) faces.push_back(f);
        std::shuffle(faces.begin(), faces.end(), random);
        for (const Face f : faces) discs.push_back(random_disc(valence(mesh, f), random));
        std::vector<const Disc*> pointers;
        for (const Disc& d : discs) pointers.push_back(&d);

        mesh.begin_change();
        ASSERT_NO_FATAL_FAILURE(expect_replaced(mesh, faces, pointers));
        const Mesh after = mesh;
        MeshChange change = mesh.end_change();
        ASSERT_EQ(check_change(mesh, change), "");
        mesh.exchange(change);
        ASSERT_EQ(mesh, before);
        mesh.exchange(change);
        ASSERT_EQ(mesh, after);
    }
}

TEST(Patch, RefusesWhatIsNoDisc)
{
    const auto refuses = [](const Disc& disc) { EXPECT_THROW(connected(disc), InternalError); };
    refuses({3, 0, {}});                                            // nothing
    refuses({4, 0, {{0, 1, 2}}});                                   // a side of the ring unused
    refuses({4, 0, {{0, 1, 2, 3}, {0, 1, 2, 3}}});                  // used twice
    refuses({3, 1, {{0, 1, 3}, {1, 2, 3}, {2, 0, 3, 3}}});          // a side from a vertex to itself
    refuses({3, 1, {{0, 1, 2}}});                                   // a new vertex nobody uses
    refuses({3, 0, {{0, 1, 5}}});                                   // a number that names nothing
    refuses({3, 1, {{0, 1, 3}, {1, 2, 3}, {3, 2, 0}, {3, 2, 0}}});  // a side used twice in one direction
    refuses({3, 4, {{0, 1, 2}, {3, 4, 5}, {3, 5, 4}}});             // something else beside the disc
    refuses({4, 0, {{0, 1, 2}, {0, 2, 3}, {0, 2}}});                // two edges along one diagonal
    refuses(box(2));                                                // and two along one side of the top
    // A disc beside a torus of nine quads: χ is right.
    Disc torus{3, 9, {{0, 1, 2}}};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const auto at = [](int x, int y) { return 3 + (x % 3) * 3 + y % 3; };
            torus.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    refuses(torus);
    // Two triangles that touch in a new vertex besides: a fan too many.
    refuses({4, 1, {{0, 1, 4}, {1, 2, 3, 0, 4}, {4, 0, 1}, {4, 1, 0}}});
}

TEST(ReplaceFace, RefusesAFaceWithAnotherNumberOfSides)
{
    for (const int n : {3, 5, 8}) {
        Mesh mesh = cube();
        const Patch patch = connected(box(n));
        mesh.begin_change();
        EXPECT_THROW(mesh.replace_face(Face(0), patch), InternalError) << n;
        mesh.roll_back();
        EXPECT_EQ(mesh, cube());
    }
}

TEST(ReplaceFace, RefusesABoundaryFaceAndOneThatIsGone)
{
    Mesh mesh = open_grid(1, 1);
    const Patch patch = connected(box(4));
    mesh.begin_change();
    EXPECT_THROW(mesh.replace_face(Face::boundary(0), patch), InternalError);
    mesh.roll_back();
    mesh.begin_change();
    EXPECT_THROW(mesh.replace_face(Face(7), patch), InternalError);
    mesh.roll_back();
    EXPECT_EQ(mesh, open_grid(1, 1));
}

} // namespace
} // namespace druse
