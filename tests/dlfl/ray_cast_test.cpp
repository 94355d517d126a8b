#include "dlfl/ray_cast.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace druse::test {
namespace {

Mesh moved_and_scaled(Mesh mesh, double scale, const Vector& by)
{
    for (const Vertex v : mesh.vertices()) mesh.set_position(v, scale * mesh.position(v) + by);
    return mesh;
}

struct Cast {
    explicit Cast(Mesh m) : mesh(std::move(m)), rays(mesh, progress, 1) {}
    int winding(const Point& p) const
    {
        return rays.winding(p, [](std::uint32_t) { return true; });
    }
    Progress progress;
    Mesh mesh;
    RayCast rays;
};

TEST(RayCast, MeetsTheFirstFaceFromEitherSide)
{
    const Cast cast(moved_and_scaled(cube(), 1, Vector(10, 20, 30)));
    Box box;
    for (const Vertex v : cast.mesh.vertices()) box.add(cast.mesh.position(v));
    for (const Vector& d : {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1), Vector(-1, 0, 0), Vector(0, -1, 0), Vector(0, 0, -1)}) {
        const auto out = cast.rays.first(box.center(), d, 1e9);
        ASSERT_TRUE(out);
        EXPECT_NEAR(out->distance, 0.5, 1e-12);
        EXPECT_NEAR(out->facing, 1, 1e-12);
        const auto in = cast.rays.first(box.center() - 3.0 * d, d, 1e9);
        ASSERT_TRUE(in);
        EXPECT_NEAR(in->distance, 2.5, 1e-12);
        EXPECT_NEAR(in->facing, -1, 1e-12);
        EXPECT_FALSE(cast.rays.first(box.center() - 3.0 * d, d, 2.4));
        EXPECT_FALSE(cast.rays.first(box.center() + 3.0 * d, d, 1e9));
        const auto through = cast.rays.first(box.center(), d, 1e9, out->triangle);
        EXPECT_TRUE(!through || through->triangle != out->triangle);
    }
    const double r = std::sqrt(1.0 / 3);
    const auto slanting = cast.rays.first(box.center() + Point(0.1, 0.02, 0), Vector(r, r, r), 1e9);
    ASSERT_TRUE(slanting);
    EXPECT_NEAR(slanting->distance, 0.4 / r, 1e-12); // the wall in x, 0.5 - 0.1 away
    EXPECT_NEAR(slanting->facing, r, 1e-12);
}

TEST(RayCast, LetsNoRaySlipBetweenNeighbours)
{
    // From the middle of a fine sphere to every vertex and every middle of an edge.
    const Cast cast(moved_and_scaled(torus(40, 20), 3, Vector(0)));
    const Point inside(3, 0, 0); // on the circle that the tube goes round
    for (const Edge e : cast.mesh.edges()) {
        const auto [v, w] = cast.mesh.ends(e);
        for (const Point& to : {cast.mesh.position(v), 0.5 * (cast.mesh.position(v) + cast.mesh.position(w))}) {
            const auto hit = cast.rays.first(inside, glm::normalize(to - inside), 1e9);
            ASSERT_TRUE(hit);
            EXPECT_LE(hit->distance, glm::distance(inside, to) + 1e-9);
        }
    }
}

TEST(RayCast, CountsHowOftenASurfaceGoesRoundAPoint)
{
    const Cast ring(torus(24, 12)); // radii 1 and 0.4
    EXPECT_EQ(ring.winding(Point(0, 0, 0)), 0);
    EXPECT_EQ(ring.winding(Point(1, 0, 0)), 1);
    EXPECT_EQ(ring.winding(Point(0, -1, 0.1)), 1);
    EXPECT_EQ(ring.winding(Point(0, 0, 5)), 0);

    Mesh mesh = moved_and_scaled(cube(), 10, Vector(0));
    Mesh inner = moved_and_scaled(cube(), 2, Vector(0));
    Box box;
    for (const Vertex v : mesh.vertices()) box.add(mesh.position(v));
    for (const Vertex v : inner.vertices()) inner.set_position(v, inner.position(v) + box.center() / 1.25);
    mesh.append(inner);
    Box hole;
    for (const Vertex v : inner.vertices()) hole.add(inner.position(v));
    const Cast nested(std::move(mesh));
    EXPECT_EQ(nested.winding(hole.center()), 2);
    EXPECT_EQ(nested.winding(box.max + Vector(1)), 0);
    EXPECT_EQ(nested.winding(box.max - Vector(0.1)), 1);
}

TEST(RayCast, FindsNothingInNothing)
{
    const Cast cast{Mesh()};
    EXPECT_FALSE(cast.rays.first(Point(0), Vector(0, 0, 1), 1e9));
    EXPECT_EQ(cast.winding(Point(0)), 0);
}

} // namespace
} // namespace druse::test
