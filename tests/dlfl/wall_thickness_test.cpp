#include "dlfl/wall_thickness.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace druse::test {
namespace {

WallThickness measured(const Mesh& mesh, double reach)
{
    Progress progress;
    const RayCast rays(mesh, progress, 0.5);
    return wall_thickness(mesh, rays, reach, progress, 0.5);
}

std::size_t thin_faces(const WallThickness& t, double below)
{
    return std::size_t(std::count_if(t.under.begin(), t.under.end(), [&](double d) { return d < below; }));
}

Mesh scaled(Mesh mesh, const Vector& by)
{
    for (const Vertex v : mesh.vertices()) mesh.set_position(v, mesh.position(v) * by);
    return mesh;
}

TEST(WallThickness, IsTheShortestWayThroughABox)
{
    const WallThickness t = measured(scaled(cube(), Vector(5, 4, 0.5)), 0.8);
    EXPECT_NEAR(t.thinnest, 0.5, 1e-12);
    EXPECT_EQ(thin_faces(t, 0.8), 2u); // above and below
    EXPECT_EQ(thin_faces(t, 0.4), 0u);
    EXPECT_NEAR(t.under[t.where.index], 0.5, 1e-12);
}

TEST(WallThickness, IsKnownBeyondTheReachWhereItIsLeast)
{
    const WallThickness t = measured(scaled(cube(), Vector(5, 4, 3)), 0.8);
    EXPECT_NEAR(t.thinnest, 3, 1e-12);
    EXPECT_EQ(thin_faces(t, 1e300), 0u);
}

TEST(WallThickness, IsThatOfTheWallOfAHollowBox)
{
    // A box of side 10 with a cavity of side 9.4: walls of 0.3, seen from both sides.
    Mesh mesh = scaled(cube(), Vector(10));
    Box box;
    for (const Vertex v : mesh.vertices()) box.add(mesh.position(v));
    Mesh cavity = mesh;
    const Face any(0);
    cavity.reverse_components({&any, 1});
    for (const Vertex v : cavity.vertices()) cavity.set_position(v, box.center() + 0.94 * (cavity.position(v) - box.center()));
    mesh.append(cavity);
    const WallThickness t = measured(mesh, 0.8);
    EXPECT_NEAR(t.thinnest, 0.3, 1e-9);
    EXPECT_EQ(thin_faces(t, 0.8), 12u);
}

TEST(WallThickness, IsNothingOfAFlatPolygon)
{
    const WallThickness t = measured(dihedron(6), 0.1);
    EXPECT_EQ(t.thinnest, 0);
    EXPECT_EQ(thin_faces(t, 0.1), 2u);
}

TEST(WallThickness, KnowsAnEdgeFromAWall)
{
    // Faces of a tetrahedron meet at 70.5 degrees: near its edges it is thin, but no wall. A wedge of 20 degrees is one.
    EXPECT_EQ(measured(tetrahedron(), 0.2).thinnest, std::numeric_limits<double>::infinity());
    EXPECT_FALSE(measured(tetrahedron(), 0.2).where.valid());
    const Mesh wedge = scaled(prism(3), Vector(1, 0.2, 1)); // an isosceles triangle, or one with a short side
    EXPECT_LT(measured(wedge, 0.2).thinnest, 0.2);
}

TEST(WallThickness, IsTwiceTheRadiusOfARod)
{
    // A prism of 12 sides, whose opposite sides are 2 + √3 edge lengths apart, 20 long.
    Mesh rod = scaled(prism(12), Vector(1, 1, 20));
    const WallThickness t = measured(rod, 5);
    EXPECT_NEAR(t.thinnest, 2 + std::sqrt(3.0), 1e-9);
    EXPECT_EQ(thin_faces(t, 5), 12u);
}

TEST(WallThickness, CanBeCancelled)
{
    const Mesh mesh = torus(100, 50);
    Progress progress;
    const RayCast rays(mesh, progress, 0.5);
    progress.cancel();
    EXPECT_THROW(wall_thickness(mesh, rays, 1, progress, 0.5), Cancelled);
    EXPECT_THROW(RayCast(mesh, progress, 0.5), Cancelled);
}

} // namespace
} // namespace druse::test
