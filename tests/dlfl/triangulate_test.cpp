#include "dlfl/triangulate.h"

#include "dlfl/mesh_builder.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <cmath>
#include <random>

namespace druse::test {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// A two-sided polygon; face 0 runs like the points.
Mesh two_sided(const std::vector<Point>& points)
{
    MeshBuilder builder;
    std::vector<std::uint32_t> ring;
    for (const Point& p : points) ring.push_back(builder.add_vertex(p));
    builder.add_face(ring);
    std::reverse(ring.begin(), ring.end());
    builder.add_face(ring);
    return builder.build();
}

/// The triangles of face 0 as vertices.
Triangles cut(const Mesh& mesh)
{
    Triangulator triangulator;
    Triangles all;
    for (const auto& t : triangulator.triangles(mesh, Face(0)))
        all.push_back({mesh.vertex(t[0]).index, mesh.vertex(t[1]).index, mesh.vertex(t[2]).index});
    return all;
}

Vector area_of(const Mesh& mesh, const std::array<Corner, 3>& t)
{
    const Point &a = mesh.position(t[0]), &b = mesh.position(t[1]), &c = mesh.position(t[2]);
    return 0.5 * glm::cross(b - a, c - a);
}

TEST(Triangulator, CutsAQuadAlongTheShorterDiagonal)
{
    EXPECT_EQ(cut(two_sided({{0, 0, 0}, {4, 0, 0}, {5, 1, 0}, {1, 1, 0}})), (Triangles{{0, 1, 3}, {1, 2, 3}}));
    EXPECT_EQ(cut(two_sided({{1, 1, 0}, {0, 0, 0}, {4, 0, 0}, {5, 1, 0}})), (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Triangulator, CutsAQuadToItsStraightCornerWhicheverSideRoundingPutItOn)
{
    for (const double off : {-0x1p-52, 0.0, 0x1p-52})
        EXPECT_EQ(cut(two_sided({{0, 0, 0}, {0.5, off, 0}, {1, 0, 0}, {0.5, 3, 0}})), (Triangles{{0, 1, 3}, {1, 2, 3}})) << off;
}

TEST(Triangulator, CutsASquareAlikeWhereverItLies)
{
    std::mt19937 random(1);
    const auto number = [&] { return double(random()) / 2147483648.0 - 1.0; };
    for (int i = 0; i < 1000; ++i) {
        const Point at(1000 * number(), number(), 1e6 * number());
        const Vector u = glm::normalize(Vector(number(), number(), number()));
        const Vector v = glm::normalize(glm::cross(u, Vector(number(), number(), number())));
        EXPECT_EQ(cut(two_sided({at, at + u, at + u + v, at + v})), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    }
}

TEST(Triangulator, CutsAConcaveQuadAlongTheOnlyDiagonalInside)
{
    // The dart's reflex corner is in each place once.
    const std::vector<Point> dart{{0, 0, 0}, {2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}}; // reflex at 2
    const Mesh mesh = two_sided({dart[0], dart[1], dart[2], dart[3]});
    EXPECT_EQ(cut(mesh), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(cut(two_sided({dart[1], dart[2], dart[3], dart[0]})), (Triangles{{0, 1, 3}, {1, 2, 3}}));
}

class EveryShapeCut : public testing::TestWithParam<NamedShape> {};
INSTANTIATE_TEST_SUITE_P(Triangulator, EveryShapeCut, testing::ValuesIn(all_shapes()),
                         shape_name<testing::TestParamInfo<NamedShape>>);

TEST_P(EveryShapeCut, GivesTwoTrianglesLessThanCornersThatAddUpToTheFace)
{
    const Mesh mesh = GetParam().make();
    Triangulator triangulator;
    for (const Face f : mesh.faces()) {
        const auto& triangles = triangulator.triangles(mesh, f);
        EXPECT_EQ(static_cast<int>(triangles.size()), std::max(0, valence(mesh, f) - 2));
        if (triangles.empty()) continue;
        Vector sum(0.0);
        for (const auto& t : triangles) {
            sum += area_of(mesh, t);
            for (const Corner c : t) EXPECT_EQ(mesh.face(c), f);
        }
        EXPECT_LT(glm::length(sum - area_vector(mesh, f)), 1e-12 * (1 + area(mesh, f)));
    }
}

TEST(Triangulator, StaysInsideAConcaveFaceInAnyPlane)
{
    std::mt19937 random(2);
    const auto number = [&] { return double(random()) / 2147483648.0 - 1.0; };
    for (int i = 0; i < 200; ++i) {
        const Vector u = glm::normalize(Vector(number(), number(), number()));
        const Vector v = glm::normalize(glm::cross(u, Vector(number(), number(), number()))), up = glm::cross(u, v);
        std::vector<Point> star;
        for (int k = 0; k < 40; ++k) {
            const double r = 1.1 + number(), a = k * M_PI / 20;
            star.push_back(100.0 * up + r * std::cos(a) * u + r * std::sin(a) * v);
        }
        const Mesh mesh = two_sided(star);
        Triangulator triangulator;
        double total = 0;
        for (const auto& t : triangulator.triangles(mesh, Face(0))) {
            EXPECT_GT(glm::dot(area_of(mesh, t), up), 0);
            total += glm::length(area_of(mesh, t));
        }
        EXPECT_NEAR(total, area(mesh, Face(0)), 1e-9);
    }
}

TEST(Triangulator, CutsTheBorderOfAGridWithoutFlatTriangles)
{
    const Mesh mesh = grid(60, 40); // the last face has 200 corners, all but four of them straight
    const Face below(mesh.face_count() - 1);
    ASSERT_EQ(valence(mesh, below), 200);
    Triangulator triangulator;
    for (const auto& t : triangulator.triangles(mesh, below)) EXPECT_LT(area_of(mesh, t).z, -1e-3);
}

} // namespace
} // namespace druse::test
