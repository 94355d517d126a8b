// Ids, holes and their closing, copies, and the joining of meshes.
#include "dlfl/mesh.h"

#include "dlfl/errors.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace druse {
namespace {

using namespace test;

template <class R>
std::vector<std::uint32_t> ids(const R& range)
{
    std::vector<std::uint32_t> all;
    for (const auto h : range) all.push_back(h.index);
    return all;
}

TEST(MeshIds, NewElementsTakeTheLowestIdsFreedInTheCommand)
{
    Mesh mesh = cube();
    for (int i = 0; i < 4; ++i) mesh.create_vertex(Point(i)); // vertices 8 … 11, faces 6 … 9
    mesh.delete_vertex(Vertex(10));
    mesh.delete_vertex(Vertex(8));
    mesh.delete_vertex(Vertex(11));
    EXPECT_EQ(mesh.create_vertex(Point(0)), Vertex(8));
    EXPECT_EQ(mesh.face(mesh.corner(Vertex(8))), Face(6));
    EXPECT_EQ(mesh.create_vertex(Point(0)), Vertex(10));
    EXPECT_EQ(mesh.create_vertex(Point(0)), Vertex(11));
    EXPECT_EQ(mesh.create_vertex(Point(0)), Vertex(12));
}

TEST(MeshIds, RangesPassOverHoles)
{
    Mesh mesh = cube();
    mesh.delete_edge(Edge(0));
    EXPECT_EQ(ids(mesh.edges()), (std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
    EXPECT_EQ(mesh.counts(), (Counts{8, 11, 5}));
    EXPECT_EQ(mesh.edge_limit(), 12u);
    EXPECT_TRUE(mesh.has_holes());
}

TEST(Compact, ClosesHolesAndKeepsTheOrderOfWhatStays)
{
    Mesh mesh = dodecahedron();
    for (const Face f : mesh.faces()) mesh.set_group(f, int(f.index) + 1);
    // Three edges that touch neither each other nor each other's faces twice.
    const auto merged = [&mesh](Edge e) {
        const auto [f, g] = mesh.faces(e);
        mesh.delete_edge(e);
        return std::max(f, g).index;
    };
    std::vector<std::uint32_t> gone{merged(Edge(3)), merged(Edge(29))};
    std::vector<Point> kept_position;
    std::vector<std::array<Vertex, 2>> kept_ends;
    std::vector<int> kept_groups;
    for (const Vertex v : mesh.vertices()) kept_position.push_back(mesh.position(v));
    for (const Edge e : mesh.edges()) kept_ends.push_back(mesh.ends(e));
    for (const Face f : mesh.faces()) kept_groups.push_back(mesh.group(f));
    const auto kept_rings = rings(mesh);

    const Renumbering map = mesh.compact();
    EXPECT_SOUND(mesh);
    EXPECT_FALSE(mesh.has_holes());
    EXPECT_EQ(counts(mesh), (Counts{20, 28, 10}));
    EXPECT_EQ(rings(mesh), kept_rings); // no vertex went
    EXPECT_TRUE(map.vertices.empty());
    ASSERT_EQ(map.edges.size(), 30u);
    EXPECT_EQ(map.edges[2], 2u);
    EXPECT_EQ(map.edges[3], Edge::none);
    EXPECT_EQ(map.edges[4], 3u);
    EXPECT_EQ(map.edges[28], 27u);
    EXPECT_EQ(map.edges[29], Edge::none);
    for (const std::uint32_t f : gone) EXPECT_EQ(map.faces[f], Face::none);
    std::uint32_t k = 0;
    for (const Edge e : mesh.edges()) EXPECT_EQ(mesh.ends(e), kept_ends[k++]);
    k = 0;
    for (const Face f : mesh.faces()) EXPECT_EQ(mesh.group(f), kept_groups[k++]);
}

TEST(Compact, RenumbersVertices)
{
    Mesh mesh;
    std::vector<Vertex> v;
    for (int i = 0; i < 6; ++i) v.push_back(mesh.create_vertex(Point(i, 0, 0)));
    mesh.insert_edge(mesh.corner(v[1]), mesh.corner(v[4]));
    mesh.delete_vertex(v[0]);
    mesh.delete_vertex(v[3]);
    const Renumbering map = mesh.compact();
    EXPECT_SOUND(mesh);
    EXPECT_EQ(map.vertices, (std::vector<std::uint32_t>{Vertex::none, 0, 1, Vertex::none, 2, 3}));
    for (std::uint32_t old : {1u, 2u, 4u, 5u}) EXPECT_EQ(mesh.position(Vertex(map.vertices[old])).x, old);
    EXPECT_EQ(mesh.ends(Edge(0)), (std::array{Vertex(0), Vertex(2)}));
}

TEST(Compact, OfAMeshWithoutHolesMovesNothing)
{
    Mesh mesh = mixed();
    EXPECT_TRUE(mesh.compact().empty());
    EXPECT_EQ(mesh, mixed());
}

TEST(Compact, KeepsTheBoundary)
{
    Mesh mesh = open_grid(3, 3);
    const Vertex v = mesh.create_vertex(Point(9));
    mesh.delete_edge(mesh.insert_edge(mesh.corner(Face(4), 0), mesh.corner(Face(4), 2)));
    mesh.delete_vertex(v);
    mesh.delete_edge(mesh.edge(mesh.corner(Face(4), 1)));
    mesh.compact();
    EXPECT_SOUND(mesh);
    EXPECT_EQ(boundary_edge_count(mesh), 12u);
    EXPECT_EQ(counts(mesh), (Counts{16, 23, 8}));
}

TEST(Append, AddsTheOtherMeshAsFurtherComponents)
{
    for (const NamedShape& a : all_shapes())
        for (const NamedShape& b : all_shapes()) {
            SCOPED_TRACE(a.name + " and " + b.name);
            Mesh mesh = a.make();
            const Mesh other = b.make();
            const Counts before = mesh.counts();
            const std::uint32_t loops = mesh.boundary_count();
            const std::int64_t g = genus(mesh) + genus(other);
            mesh.append(other);
            ASSERT_SOUND(mesh);
            ASSERT_EQ(counts(mesh), (Counts{before.vertices + other.vertex_count(), before.edges + other.edge_count(), before.faces + other.face_count()}));
            ASSERT_EQ(mesh.boundary_count(), loops + other.boundary_count());
            ASSERT_EQ(genus(mesh), g);
            for (const Face f : other.faces()) {
                auto expected = ring(other, f);
                for (auto& v : expected) v += before.vertices;
                ASSERT_EQ(ring(mesh, Face(f.index + before.faces)), expected);
                ASSERT_EQ(mesh.group(Face(f.index + before.faces)), other.group(f));
            }
        }
}

TEST(Append, TakesTheMeshItself)
{
    Mesh mesh = mixed(), twice = mixed();
    mesh.append(mesh);
    twice.append(mixed());
    EXPECT_EQ(mesh, twice);
}

TEST(MeshChange, HoldsAssignments)
{
    Mesh mesh = cube();
    mesh.begin_change();
    mesh = torus(5, 4);
    mesh.set_group(Face(0), 3);
    mesh = Mesh(mesh);
    MeshChange change = mesh.end_change();
    mesh.exchange(change);
    EXPECT_EQ(mesh, cube());
    mesh.exchange(change);
    EXPECT_EQ(mesh.face_count(), 20u);
    EXPECT_EQ(mesh.group(Face(0)), 3);
}

TEST(MeshChange, OfACopyIsItsOwn)
{
    Mesh mesh = cube();
    mesh.begin_change();
    mesh.set_group(Face(0), 1);
    Mesh copy = mesh;
    EXPECT_FALSE(copy.is_recording());
    copy.begin_change();
    copy.set_group(Face(1), 2);
    copy.roll_back();
    EXPECT_EQ(copy, mesh);
    mesh.roll_back();
    EXPECT_EQ(mesh, cube());
}

TEST(LargestGroup, IsThatOfTheFacesAfterEveryEditAndOnTheWayBack)
{
    std::mt19937 random(5);
    const auto below = [&](std::uint32_t n) { return std::uint32_t(random() % n); };
    Mesh mesh = torus(12, 9);
    std::vector<MeshChange> changes;
    const auto look = [&] {
        int largest = 0;
        for (const Face f : mesh.faces()) largest = std::max(largest, mesh.group(f));
        ASSERT_EQ(mesh.largest_group(), largest);
        ASSERT_EQ(check(mesh), "");
    };
    for (int step = 0; step < 300; ++step) {
        mesh.begin_change();
        for (int i = 0; i < 3; ++i) {
            const Face f(below(mesh.face_limit()));
            switch (below(6)) {
            case 0: mesh.set_group(f, mesh.largest_group() + int(below(2))); break;
            case 1: mesh.set_group(f, int(below(4))); break;
            case 2: mesh.insert_edge(mesh.corner(f, 0), mesh.corner(f, mesh.valence(f) / 2)); break;
            case 3:
                if (mesh.face_count() > 20) mesh.delete_edge(Edge(below(mesh.edge_limit())));
                mesh.compact();
                break;
            case 4: mesh.write_groups()[f.index] = int(below(9)); break;
            default:
                if (below(20) == 0) mesh = torus(12, 9);
            }
        }
        look();
        if (below(5) == 0) mesh.roll_back();
        else changes.push_back(mesh.end_change());
        look();
    }
    for (auto change = changes.rbegin(); change != changes.rend(); ++change) {
        mesh.exchange(*change);
        look();
    }
    EXPECT_EQ(mesh.largest_group(), 0);
}

TEST(MeshChange, RefusesHolesAndNesting)
{
    Mesh mesh = cube();
    mesh.begin_change();
    EXPECT_THROW(mesh.begin_change(), InternalError);
    mesh.delete_edge(Edge(0));
    EXPECT_THROW(mesh.end_change(), InternalError);
    mesh.roll_back();
    EXPECT_EQ(mesh, cube());
    EXPECT_THROW(mesh.roll_back(), InternalError);
    EXPECT_THROW(mesh.end_change(), InternalError);
    mesh.delete_edge(Edge(0));
    EXPECT_THROW(mesh.begin_change(), InternalError);
}

TEST(MeshChange, CostsWhatWasTouchedNotWhatTheMeshHolds)
{
    Mesh mesh = torus(300, 300);
    mesh.begin_change();
    mesh.insert_edge(mesh.corner(Face(500), 0), mesh.corner(Face(500), 2));
    const MeshChange change = mesh.end_change();
    EXPECT_EQ(check_change(mesh, change), "");
    EXPECT_LT(change.bytes(), mesh.bytes() / 50);
}

TEST(Mesh, AnswersForTheWholeShapeFamily)
{
    for (const NamedShape& shape : all_shapes()) {
        SCOPED_TRACE(shape.name);
        const Mesh mesh = shape.make();
        std::uint64_t by_faces = 0, by_vertices = 0;
        for (const Face f : mesh.faces()) {
            int k = 0;
            for (const Corner c : mesh.corners(f)) {
                ASSERT_EQ(mesh.face(c), f);
                ASSERT_EQ(mesh.corner(f, k++), c);
            }
            ASSERT_EQ(k, valence(mesh, f));
            by_faces += static_cast<std::uint64_t>(k);
        }
        for (const Face f : mesh.boundary_faces())
            for (const Corner c : mesh.corners(f)) {
                ASSERT_EQ(mesh.face(c), f);
                ++by_faces;
            }
        for (const Vertex v : mesh.vertices()) {
            int edges = 0;
            for (const Corner c : mesh.around(v)) {
                ASSERT_EQ(mesh.vertex(c), v);
                ++by_vertices;
                if (!mesh.is_point_sphere(v)) ++edges;
            }
            ASSERT_EQ(edges, valence(mesh, v));
        }
        EXPECT_EQ(by_faces, mesh.corner_limit());
        EXPECT_EQ(by_vertices, mesh.corner_limit());
        EXPECT_EQ(std::uint64_t(2) * mesh.edge_count() + facts(mesh).point_spheres, mesh.corner_limit());
    }
}

TEST(Mesh, WalksAroundAVertexCounterClockwise)
{
    const Mesh mesh = pyramid(7);
    std::vector<std::uint32_t> ends;
    for (const Corner c : mesh.around(Vertex(7))) ends.push_back(mesh.vertex(mesh.next(c)).index);
    ASSERT_EQ(ends.size(), 7u);
    for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(ends[(i + 1) % 7], (ends[i] + 1) % 7); // the base runs so seen from above
}

} // namespace
} // namespace druse
