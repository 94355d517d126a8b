// Measures against closed forms.
#include "dlfl/measures.h"

#include "dlfl/mesh_builder.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace druse {
namespace {

using namespace test;

constexpr double pi = std::numbers::pi;

void transform(Mesh& mesh, double scale, const Vector& by)
{
    for (const Vertex v : mesh.vertices()) mesh.set_position(v, scale * mesh.position(v) + by);
}

struct Solid {
    Mesh (*make)();
    double volume, area;
};

std::vector<Solid> platonic_solids()
{
    const double s3 = std::sqrt(3.0), s5 = std::sqrt(5.0);
    return {{tetrahedron, std::sqrt(2.0) / 12, s3},
            {cube, 1, 6},
            {octahedron, std::sqrt(2.0) / 3, 2 * s3},
            {dodecahedron, (15 + 7 * s5) / 4, 3 * std::sqrt(25 + 10 * s5)},
            {icosahedron, 5 * (3 + s5) / 12, 5 * s3}};
}

TEST(Volume, OfThePlatonicSolidsIsEuclids)
{
    for (const Solid& s : platonic_solids()) {
        const Mesh mesh = s.make();
        EXPECT_NEAR(volume(mesh), s.volume, 1e-14 * 10);
        EXPECT_NEAR(surface_area(mesh), s.area, 1e-13);
        EXPECT_LT(edge_lengths(mesh).relative_spread(), 1e-14);
        EXPECT_LT(flatness(mesh), 1e-14);
    }
}

TEST(Volume, LosesNoDigitsFarFromTheOrigin)
{
    for (const Solid& s : platonic_solids()) {
        Mesh mesh = s.make();
        transform(mesh, 3, {1e6, -2e6, 5e5});
        EXPECT_NEAR(volume(mesh) / (27 * s.volume), 1, 1e-8); // coordinates themselves have lost 1e-10 of an edge
        EXPECT_NEAR(surface_area(mesh) / (9 * s.area), 1, 1e-8);
    }
}

TEST(Volume, OfAnOpenSurfaceIsThatWithTheOpeningsFilled)
{
    EXPECT_NEAR(volume(open_tube(4)), 1, 1e-14);
    EXPECT_NEAR(volume(open_grid(3, 2)), 0, 1e-14);
}

TEST(Volume, OfATorusMeshNearsTwoPiSquaredRrr)
{
    // 2π² R r² with R 1, r 0.4; a mesh of n points falls short by about (2π / n)² / 6 in each circle.
    EXPECT_NEAR(volume(torus(400, 300)) / (2 * pi * pi * 0.16), 1, 2e-4);
}

TEST(Genus, IsThatOfTheLiterature)
{
    EXPECT_EQ(genus(cube()), 0);
    EXPECT_EQ(genus(torus(5, 3)), 1);
    for (const int g : {1, 2, 3, 5, 9}) EXPECT_EQ(genus(block_with_holes(g)), g);
    EXPECT_EQ(genus(open_tube(6)), 0);
    EXPECT_EQ(genus(Mesh()), 0);
    Mesh mesh = torus(5, 3);
    mesh.append(block_with_holes(4));
    mesh.append(open_grid(2, 2));
    EXPECT_EQ(genus(mesh), 5);
    EXPECT_EQ(euler_characteristic(mesh), 0 + (2 - 8) + 1);
}

TEST(Components, AreNumberedByTheirLowestFace)
{
    // Faces of two cubes in turn, the second one first.
    MeshBuilder builder;
    const Mesh part = cube();
    for (int k = 0; k < 2; ++k)
        for (const Vertex v : part.vertices()) builder.add_vertex(part.position(v) + Vector(3 * k, 0, 0));
    for (const Face f : part.faces())
        for (const std::uint32_t k : {8u, 0u}) {
            for (const auto v : ring(part, f)) builder.add_corner(v + k);
            builder.end_face();
        }
    const Components parts = components(builder.build());
    ASSERT_EQ(parts.parts.size(), 2u);
    for (std::uint32_t f = 0; f < 12; ++f) EXPECT_EQ(parts.of_face[f], f % 2);
    for (const auto& p : parts.parts) {
        EXPECT_EQ(p.faces, 6u);
        EXPECT_EQ(p.euler, 2);
        EXPECT_EQ(p.genus(), 0);
    }
}

TEST(Components, CountOpenBoundariesAndHoles)
{
    Mesh mesh = mixed();
    const Components parts = components(mesh);
    ASSERT_EQ(parts.parts.size(), 5u); // prism, torus, open grid, antenna, point sphere
    EXPECT_EQ(parts.parts[1].genus(), 1);
    EXPECT_EQ(parts.parts[2].boundary_loops, 1u);
    EXPECT_EQ(parts.parts[2].genus(), 0);
    EXPECT_EQ(parts.parts[4].faces, 1u);
    EXPECT_EQ(parts.parts[4].euler, 2);
    mesh.delete_edge(Edge(0)); // a hole among the faces
    const Components after = components(mesh);
    std::uint32_t in_holes = 0;
    for (const auto part : after.of_face) in_holes += part == Face::none ? 1 : 0;
    EXPECT_EQ(in_holes, 1u);
    EXPECT_EQ(after.parts[0].faces, 6u);
}

TEST(AreaVector, LooksOutwardAndIsAsLongAsTheArea)
{
    const Mesh mesh = l_prism();
    EXPECT_LT(glm::distance(area_vector(mesh, Face(0)), Vector(0, 0, -3)), 1e-15); // concave
    EXPECT_LT(glm::distance(area_vector(mesh, Face(7)), Vector(0, 0, 3)), 1e-15);
    EXPECT_LT(glm::distance(unit_normal(mesh, Face(1)), Vector(0, -1, 0)), 1e-15);
    EXPECT_DOUBLE_EQ(area(mesh, Face(1)), 2);
}

TEST(AreaVector, OfAWarpedFaceAveragesIt)
{
    // Unit square with one corner lifted by h: the vector is the half cross product of the diagonals.
    MeshBuilder builder;
    const double h = 0.3;
    for (const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, h), Point(0, 1, 0)}) builder.add_vertex(p);
    builder.add_face(std::vector<std::uint32_t>{0, 1, 2, 3});
    builder.add_face(std::vector<std::uint32_t>{3, 2, 1, 0});
    const Mesh mesh = builder.build();
    EXPECT_LT(glm::distance(area_vector(mesh, Face(0)), 0.5 * glm::cross(Vector(1, 1, h), Vector(-1, 1, 0))), 1e-15);
    // Newell's plane through the mean leaves all four corners equally far: h / 4 along a normal of slope (h/2, h/2).
    EXPECT_NEAR(nonplanarity(mesh, Face(0)), h / 4 / std::sqrt(1 + h * h / 2), 1e-15);
}

TEST(AreaVector, OfWhatHasNoAreaIsZero)
{
    for (const Mesh& mesh : {segment(), three_lunes(), point_sphere()})
        for (const Face f : mesh.faces()) {
            EXPECT_EQ(area(mesh, f), 0);
            EXPECT_EQ(unit_normal(mesh, f), Vector(0));
            EXPECT_EQ(nonplanarity(mesh, f), 0);
        }
}

TEST(VertexMean, IsTheMeanOfTheCorners)
{
    const Mesh mesh = pyramid(4);
    EXPECT_LT(glm::distance(vertex_mean(mesh, Face(0)), Point(0)), 1e-15);
    const Mesh antenna = cube_with_antenna(); // a corner visited twice counts twice
    EXPECT_LT(glm::distance(vertex_mean(antenna, Face(0)), Point(-0.5 / 3, -0.5 / 3, -2.0 / 3)), 1e-15);
}

TEST(Bounds, HoldAllVertices)
{
    const Box box = bounds(l_prism());
    EXPECT_EQ(box.min, Point(0, 0, 0));
    EXPECT_EQ(box.max, Point(2, 2, 1));
    EXPECT_TRUE(bounds(Mesh()).empty());
}

TEST(Facts, OfACube)
{
    Mesh mesh = cube();
    mesh.set_group(Face(0), 2);
    const MeshFacts r = facts(mesh);
    EXPECT_EQ(r.counts, (Counts{8, 12, 6}));
    EXPECT_EQ(r.corners, 24u);
    EXPECT_EQ(r.components, 1u);
    EXPECT_EQ(r.euler, 2);
    EXPECT_EQ(r.genus, 0);
    EXPECT_EQ(r.component_genus, std::vector<std::int64_t>{0});
    EXPECT_NEAR(r.volume, 1, 1e-15);
    EXPECT_NEAR(r.area, 6, 1e-15);
    EXPECT_EQ(r.max_nonplanarity, 0);
    EXPECT_DOUBLE_EQ(r.shortest_edge, 1);
    EXPECT_DOUBLE_EQ(r.mean_edge, 1);
    EXPECT_DOUBLE_EQ(r.longest_edge, 1);
    EXPECT_EQ(r.sides, (std::map<int, std::uint32_t>{{4, 6}}));
    EXPECT_EQ(r.valences, (std::map<int, std::uint32_t>{{3, 8}}));
    EXPECT_EQ(r.groups, (std::map<int, std::uint32_t>{{0, 5}, {2, 1}}));
    EXPECT_EQ(r.boundary_edges + r.point_spheres + r.parallel_edges + r.zero_thickness_walls, 0u);
}

TEST(Facts, OfNothingAreZero)
{
    const MeshFacts r = facts(Mesh());
    EXPECT_EQ(r.counts, Counts());
    EXPECT_EQ(r.shortest_edge + r.mean_edge + r.longest_edge + r.area + r.volume, 0);
    EXPECT_TRUE(r.bounds.empty());
    EXPECT_EQ(r.components, 0u);
}

TEST(Facts, CanBeCancelled)
{
    const Mesh mesh = cube();
    Progress progress;
    EXPECT_EQ(facts(mesh, progress).genus, 0);
    progress.cancel();
    EXPECT_THROW(facts(mesh, progress), Cancelled);
}

TEST(Facts, CountPointSpheresAndOpenEdges)
{
    const MeshFacts r = facts(mixed());
    EXPECT_EQ(r.point_spheres, 1u);
    EXPECT_EQ(r.boundary_edges, 10u);
    EXPECT_EQ(r.component_genus, (std::vector<std::int64_t>{0, 1, 0, 0, 0}));
    EXPECT_EQ(r.valences.at(0), 1u);
    EXPECT_EQ(r.sides.at(1), 1u);
}

TEST(ParallelEdges, AreThoseBesideOneWithTheSameEnds)
{
    EXPECT_EQ(facts(cube_with_parallel_edges()).parallel_edges, 1u);
    EXPECT_EQ(facts(three_lunes()).parallel_edges, 2u);
    EXPECT_EQ(facts(cube_with_loop()).parallel_edges, 0u); // a loop is none
    EXPECT_EQ(facts(torus(3, 3)).parallel_edges, 0u);
    // A fan of n edges between two vertices, and that between two vertices of high valence.
    Mesh mesh = pyramid(30);
    for (int i = 0; i < 5; ++i) {
        const Corner c = mesh.corner(Face(1));
        mesh.insert_edge(c, mesh.next(c));
    }
    EXPECT_SOUND(mesh);
    EXPECT_EQ(facts(mesh).parallel_edges, 5u);
}

TEST(ZeroThicknessWalls, AreFacesUponEachOther)
{
    EXPECT_EQ(facts(dihedron(6)).zero_thickness_walls, 1u);
    EXPECT_EQ(facts(cube()).zero_thickness_walls, 0u);
    EXPECT_EQ(facts(torus(3, 3)).zero_thickness_walls, 0u);
    EXPECT_EQ(facts(three_lunes()).zero_thickness_walls, 0u); // two-sided faces have no area: parallel edges, not walls
    Mesh mesh = mixed();
    EXPECT_EQ(facts(mesh).zero_thickness_walls, 0u);
    mesh.append(dihedron(3));
    mesh.append(dihedron(3));
    EXPECT_EQ(facts(mesh).zero_thickness_walls, 2u);
}

TEST(ZeroThicknessWalls, NeedNotShareAnEdge)
{
    // Edges put beside all three sides of a two-sided triangle: lunes lie between its faces now.
    Mesh mesh = dihedron(3);
    for (const std::uint32_t e : {0u, 1u, 2u}) {
        const Corner c = mesh.corner(Edge(e), 0);
        mesh.insert_edge(c, mesh.next(c));
    }
    EXPECT_SOUND(mesh);
    EXPECT_EQ(counts(mesh), (Counts{3, 6, 5}));
    EXPECT_EQ(facts(mesh).zero_thickness_walls, 1u);
    EXPECT_EQ(facts(mesh).parallel_edges, 3u);
}

} // namespace
} // namespace druse
