// Whole meshes from polygon lists that need no mending.
#include "dlfl/mesh_builder.h"

#include "dlfl/errors.h"
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
using Rings = std::vector<std::vector<std::uint32_t>>;

MeshBuilder filled(const Mesh& mesh)
{
    MeshBuilder builder;
    for (const Vertex v : mesh.vertices()) builder.add_vertex(mesh.position(v));
    for (const Face f : mesh.faces()) builder.add_face(ring(mesh, f), mesh.group(f));
    return builder;
}

/// True if an index file can hold the mesh: no two edges have the same ends, and none is a loop.
bool has_plain_edges(const Mesh& mesh)
{
    std::set<std::pair<Vertex, Vertex>> met;
    for (const Edge e : mesh.edges()) {
        const auto [a, b] = mesh.ends(e);
        if (a == b || !met.insert(std::minmax(a, b)).second) return false;
    }
    return true;
}

std::vector<NamedShape> plain_shapes()
{
    std::vector<NamedShape> shapes = all_shapes();
    std::erase_if(shapes, [](const NamedShape& s) { return !has_plain_edges(s.make()); });
    return shapes;
}

class EveryPlainShape : public testing::TestWithParam<NamedShape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, EveryPlainShape, testing::ValuesIn(plain_shapes()), shape_name<testing::TestParamInfo<NamedShape>>);

TEST_P(EveryPlainShape, IsBuiltAgainFromItsPolygons)
{
    const Mesh mesh = GetParam().make();
    MeshBuilder builder = filled(mesh);
    Repairs repairs;
    const Mesh built = builder.build(repairs);
    EXPECT_SOUND(built);
    EXPECT_EQ(rings(built), rings(mesh));
    EXPECT_EQ(counts(built), counts(mesh));
    EXPECT_EQ(built.boundary_count(), mesh.boundary_count());
    EXPECT_TRUE(std::ranges::equal(built.positions(), mesh.positions()));
    EXPECT_TRUE(std::ranges::equal(built.groups(), mesh.groups()));
    EXPECT_EQ(repairs.faces_turned + repairs.vertices_split + repairs.edges_split + repairs.loose_vertices, 0u);
    // Edges are numbered as the faces, each from its start corner, first use them, and run as the first of them does.
    std::uint32_t expected = 0;
    for (const Face f : built.faces())
        for (const Corner c : built.corners(f)) {
            const Edge e = built.edge(c);
            if (!e.valid()) continue;
            ASSERT_LE(e.index, expected);
            if (e.index < expected) continue;
            EXPECT_EQ(built.corner(e, 0), c);
            ++expected;
        }
    EXPECT_EQ(expected, built.edge_count());
}

TEST_P(EveryPlainShape, IsTheSameMeshWhenItsFacesWereShuffledButForTheirIds)
{
    const Mesh mesh = GetParam().make();
    std::mt19937 random(7);
    Rings shuffled = rings(mesh);
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    for (auto& r : shuffled) std::rotate(r.begin(), r.begin() + static_cast<std::ptrdiff_t>(random() % r.size()), r.end());
    MeshBuilder builder;
    for (const Vertex v : mesh.vertices()) builder.add_vertex(mesh.position(v));
    for (const auto& r : shuffled) builder.add_face(r);
    Repairs repairs;
    const Mesh built = builder.build(repairs);
    EXPECT_SOUND(built);
    EXPECT_EQ(rings(built), shuffled);
    EXPECT_EQ(counts(built), counts(mesh));
    EXPECT_EQ(genus(built), genus(mesh));
}

TEST(MeshBuilder, IsEmptyAfterwards)
{
    MeshBuilder builder = filled(cube());
    EXPECT_EQ(builder.corner_count(), 24u);
    builder.build();
    EXPECT_EQ(builder.vertex_count() + builder.face_count() + builder.corner_count(), 0u);
    EXPECT_EQ(builder.build().counts(), Counts());
}

TEST(MeshBuilder, KeepsGroups)
{
    MeshBuilder builder = filled(cube());
    builder.groups()[3] = 9;
    EXPECT_EQ(builder.build().group(Face(3)), 9);
}

TEST(MeshBuilder, RefusesWithoutRepairsWhatIsNoClosedManifold)
{
    Rings cube_less_one = rings(cube());
    cube_less_one.pop_back();
    for (const Rings& polygons : {cube_less_one, Rings{{0, 1, 2}, {0, 1, 2}}, Rings{{0, 1, 1}, {0, 1}}, Rings{{0, 1, 2}, {0, 2, 1}, {3, 4, 2}, {3, 2, 4}}}) {
        MeshBuilder builder;
        for (int v = 0; v < 8; ++v) builder.add_vertex(Point(v));
        for (const auto& p : polygons) builder.add_face(p);
        EXPECT_THROW(builder.build(), InternalError);
    }
    MeshBuilder builder;
    builder.add_vertex(Point(0));
    builder.add_face(std::vector<std::uint32_t>{0, 1, 2});
    EXPECT_THROW(builder.build(), InternalError);
    MeshBuilder empty_face;
    empty_face.end_face();
    EXPECT_THROW(empty_face.build(), InternalError);
}

TEST(MeshBuilder, BuildsAPyramidWithAMillionSidesInLinearTime)
{
    constexpr std::uint32_t n = 1'000'000;
    for (const bool apex_first : {true, false}) { // a bucket per vertex must not be searched, nor may one be sorted
        MeshBuilder builder;
        builder.reserve(n + 1, n + 1, 4 * n);
        const std::uint32_t base = apex_first ? 1 : 0, apex = apex_first ? 0 : n;
        for (std::uint32_t v = 0; v <= n; ++v) builder.add_vertex(Point(v, 0, 0));
        for (std::uint32_t i = n; i-- > 0;) builder.add_corner(base + i);
        builder.end_face();
        for (std::uint32_t i = 0; i < n; ++i) builder.add_face(std::vector<std::uint32_t>{base + i, base + (i + 1) % n, apex});
        const Mesh mesh = builder.build();
        EXPECT_EQ(counts(mesh), (Counts{n + 1, 2 * n, n + 1}));
        EXPECT_EQ(valence(mesh, Vertex(apex)), int(n));
        EXPECT_SOUND(mesh);
    }
}

TEST(MeshBuilder, BuildsManyTinyComponents)
{
    MeshBuilder builder;
    const Mesh part = tetrahedron();
    constexpr std::uint32_t n = 1000;
    for (std::uint32_t i = 0; i < n; ++i) {
        builder.add_point_sphere(builder.add_vertex(Point(2.0 * i, 9, 9)));
        for (const Vertex v : part.vertices()) builder.add_vertex(part.position(v) + Vector(2.0 * i, 0, 0));
        for (const Face f : part.faces()) {
            for (const auto v : ring(part, f)) builder.add_corner(5 * i + 1 + v);
            builder.end_face();
        }
    }
    const Mesh mesh = builder.build();
    EXPECT_SOUND(mesh);
    EXPECT_EQ(components(mesh).parts.size(), 2 * n);
    EXPECT_EQ(genus(mesh), 0);
    EXPECT_TRUE(mesh.is_point_sphere(Vertex(5)));
}

TEST(MeshBuilder, BuildsMeshesWithMoreVerticesThanEdges)
{
    MeshBuilder builder;
    for (int i = 0; i < 100; ++i) builder.add_point_sphere(builder.add_vertex(Point(i)));
    const std::uint32_t a = builder.add_vertex(Point(0)), b = builder.add_vertex(Point(1));
    builder.add_face(std::vector<std::uint32_t>{a, b}); // one face on both sides of an edge
    const Mesh mesh = builder.build();
    EXPECT_SOUND(mesh);
    EXPECT_EQ(counts(mesh), (Counts{102, 1, 101}));
}

} // namespace
} // namespace druse
