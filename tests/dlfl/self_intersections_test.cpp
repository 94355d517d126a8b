#include "dlfl/self_intersections.h"

#include "dlfl/mesh_builder.h"
#include "dlfl/triangulate.h"
#include "geom/triangle_contact.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <cmath>
#include <random>
#include <set>

namespace druse::test {
namespace {

SelfIntersections found(const Mesh& mesh)
{
    Progress progress;
    return self_intersections(mesh, progress);
}

/// Each triangle with each: what the tree must not lose.
std::uint64_t pairs_by_brute_force(const Mesh& mesh, std::set<Face>* faces = nullptr)
{
    std::vector<std::pair<Triangle, Face>> triangles;
    Triangulator triangulator;
    for (const Face f : mesh.faces())
        for (const auto& t : triangulator.triangles(mesh, f)) {
            const Triangle corners{mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])};
            if (shadow_of(corners).turn != 0) triangles.emplace_back(corners, f);
        }
    std::uint64_t pairs = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t j = i + 1; j < triangles.size(); ++j)
            if (meet_beyond_common(triangles[i].first, shadow_of(triangles[i].first), triangles[j].first)) {
                ++pairs;
                if (faces) faces->insert({triangles[i].second, triangles[j].second});
            }
    return pairs;
}

Mesh moved(Mesh mesh, const Vector& by)
{
    for (const Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v) + by);
    return mesh;
}

/// Two cubes of side 1, the second moved.
Mesh cubes(const Vector& by)
{
    Mesh mesh = cube();
    mesh.append(moved(cube(), by));
    return mesh;
}

Mesh from_triangles(const std::vector<Point>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
    MeshBuilder builder;
    for (const Point& p : points) builder.add_vertex(p);
    for (const auto& t : triangles) builder.add_face(t);
    Repairs repairs;
    return builder.build(repairs);
}

TEST(SelfIntersections, AreNoneInSolids)
{
    for (const Mesh& mesh : {tetrahedron(), cube(), octahedron(), dodecahedron(), icosahedron(), prism(7), pyramid(9), torus(24, 12), l_prism(), warped_cube(),
                             block_with_holes(3), two_cubes(), open_grid(4, 3), open_tube(5), point_sphere(), Mesh()}) {
        const SelfIntersections s = found(mesh);
        EXPECT_EQ(s.pairs, 0u);
        EXPECT_TRUE(s.faces.empty());
    }
}

TEST(SelfIntersections, AreThoseOfEachWithEachInEveryShape)
{
    for (const NamedShape& shape : all_shapes()) {
        const Mesh mesh = shape.make();
        std::set<Face> faces;
        const std::uint64_t pairs = pairs_by_brute_force(mesh, &faces);
        const SelfIntersections s = found(mesh);
        EXPECT_EQ(s.pairs, pairs) << shape.name;
        EXPECT_EQ(s.faces, std::vector<Face>(faces.begin(), faces.end())) << shape.name;
    }
}

TEST(SelfIntersections, AreWhereTwoCubesOverlap)
{
    // Moved by less than a side in each direction, three faces of each cube pierce three of the other: six squares meet six.
    const SelfIntersections s = found(cubes(Vector(0.5, 0.375, 0.25)));
    EXPECT_GT(s.pairs, 0u);
    EXPECT_EQ(s.faces.size(), 6u);
    EXPECT_EQ(s.pairs, pairs_by_brute_force(cubes(Vector(0.5, 0.375, 0.25))));
    EXPECT_EQ(found(cubes(Vector(2, 0, 0))).pairs, 0u);
}

TEST(SelfIntersections, AreWhereTheFacesOfTwoCubesTouch)
{
    // Whole faces on each other, cut along the same diagonal or along both: each triangle overlaps one or two others. What else
    // meets there does so in common corners and sides.
    EXPECT_EQ(found(cubes(Vector(1, 0, 0))).faces.size(), 2u);
    // Half of a face on half of another; the corners that touch a face belong to three others each.
    EXPECT_GT(found(cubes(Vector(1, 0.5, 0))).pairs, 0u);
    EXPECT_EQ(found(cubes(Vector(1 + 0x1p-50, 0, 0))).pairs, 0u);
    // All of one cube upon all of the other.
    EXPECT_EQ(found(cubes(Vector(0))).faces.size(), 12u);
}

TEST(SelfIntersections, AreNotWhereCubesShareACornerOrAnEdge)
{
    EXPECT_EQ(found(cubes(Vector(1, 1, 1))).pairs, 0u); // a corner
    EXPECT_EQ(found(cubes(Vector(1, 1, 0))).pairs, 0u); // an edge
    // Half an edge is not a common one: of each cube, the two squares beside it meet others, and the one with a corner on the other edge.
    EXPECT_EQ(found(cubes(Vector(1, 1, 0.5))).faces.size(), 6u);
}

TEST(SelfIntersections, AreWhereAFaceIsFoldedOntoItsNeighbour)
{
    // Two triangles of an open surface, hinged at a side: flat, bent, nearly closed, closed.
    const auto hinged = [](const Point& tip) { return from_triangles({{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, tip}, {{{0, 1, 2}, {1, 0, 3}}}); };
    EXPECT_EQ(found(hinged({1, -3, 0})).pairs, 0u);
    EXPECT_EQ(found(hinged({1, 0, 3})).pairs, 0u);
    EXPECT_EQ(found(hinged({1, 2, 1e-300})).pairs, 0u);
    EXPECT_EQ(found(hinged({1, 2, 0})).pairs, 1u);
}

TEST(SelfIntersections, AreTheTwoSidesOfAFlatPolygon)
{
    EXPECT_EQ(found(dihedron(3)).pairs, 1u);
    EXPECT_EQ(found(dihedron(5)).faces.size(), 2u);
}

TEST(SelfIntersections, AreNoneWhereATorusIsPinchedToACorner)
{
    // One ring of the tube drawn together to a point: corners in one place, and faces beside them without an area or with three corners.
    Mesh mesh = torus(12, 6);
    Vector mean(0.0);
    for (std::uint32_t v = 0; v < 6; ++v) mean += mesh.position(Vertex(v)) / 6.0;
    for (std::uint32_t v = 0; v < 6; ++v) mesh.set_position(Vertex(v), mean);
    EXPECT_EQ(found(mesh).pairs, 0u);
    EXPECT_EQ(pairs_by_brute_force(mesh), 0u);
    // Pulled through the opposite side of the tube's ring it pierces it.
    for (std::uint32_t v = 0; v < 6; ++v) mesh.set_position(Vertex(v), -1.5 * mean);
    EXPECT_GT(found(mesh).pairs, 0u);
    EXPECT_EQ(found(mesh).pairs, pairs_by_brute_force(mesh));
}

TEST(SelfIntersections, AreTheSameWhereverTheSurfaceLies)
{
    // Steps of a power of two move all coordinates exactly.
    const Mesh mesh = cubes(Vector(0.5, 0.375, 0.25));
    const std::uint64_t pairs = found(mesh).pairs;
    EXPECT_EQ(found(moved(mesh, Vector(1024, -4096, 512))).pairs, pairs);
}

TEST(SelfIntersections, AreThoseOfEachWithEachInSoups)
{
    for (unsigned seed = 0; seed < 30; ++seed) {
        std::mt19937 random(seed);
        // On a coarse grid much touches and overlaps, in a fine one much pierces.
        const int size = seed % 3 == 0 ? 4 : seed % 3 == 1 ? 20 : 100000;
        const auto number = [&] { return double(std::uniform_int_distribution<int>(0, size)(random)) / size; };
        std::vector<Point> points;
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (std::uint32_t i = 0; i < 150; ++i) {
            const Point at(number(), number(), number());
            for (int k = 0; k < 3; ++k) points.push_back(at + 0.5 * Vector(number(), number(), number()));
            triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
        const Mesh mesh = from_triangles(points, triangles);
        std::set<Face> faces;
        const std::uint64_t pairs = pairs_by_brute_force(mesh, &faces);
        const SelfIntersections s = found(mesh);
        EXPECT_GT(pairs, 50u);
        EXPECT_EQ(s.pairs, pairs) << "seed " << seed;
        EXPECT_EQ(s.faces, std::vector<Face>(faces.begin(), faces.end())) << "seed " << seed;
    }
}

TEST(SelfIntersections, StopAtTheNumberAskedFor)
{
    const Mesh mesh = cubes(Vector(0));
    Progress progress;
    EXPECT_EQ(self_intersections(mesh, progress, 1).pairs, 1u);
    EXPECT_EQ(self_intersections(mesh, progress, 5).pairs, 5u);
    EXPECT_EQ(self_intersections(cube(), progress, 1).pairs, 0u);
}

TEST(SelfIntersections, ReportProgressAndStopWhenCancelled)
{
    const Mesh mesh = torus(100, 50);
    Progress progress;
    self_intersections(mesh, progress);
    EXPECT_GT(progress.fraction(), 0.5);
    EXPECT_LE(progress.fraction(), 1.0);
    progress.cancel();
    EXPECT_THROW(self_intersections(mesh, progress), Cancelled);
}

} // namespace
} // namespace druse::test
