#include "dlfl/triangulate.h"

#include "dlfl/mesh_builder.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

#include <cmath>
#include <random>
#include <set>
#include <utility>

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

/// The sides that run across the faces of a two-sided polygon, face by face, as vertices.
std::array<std::set<std::pair<std::uint32_t, std::uint32_t>>, 2> diagonals(const Mesh& mesh)
{
    Triangulator triangulator;
    std::array<std::set<std::pair<std::uint32_t, std::uint32_t>>, 2> found;
    for (const std::uint32_t f : {0u, 1u})
        for (const auto& t : triangulator.triangles(mesh, Face(f)))
            for (std::size_t i = 0; i < 3; ++i)
                if (const Corner a = t[i], b = t[(i + 1) % 3]; mesh.next(a) != b) found[f].insert(std::minmax(mesh.vertex(a).index, mesh.vertex(b).index));
    return found;
}

TEST(Triangulator, CutsAFaceAlikeFromBothSidesAndFromAnyCorner)
{
    // Warped rings, so that it matters along which diagonals: regular ones with heights in turn, and stars, whose ears come in sets of equals.
    for (const double dent : {1.0, 0.4})
        for (int n = 4; n <= 14; ++n) {
            std::vector<Point> points;
            for (int i = 0; i < n; ++i) {
                const double a = 2 * M_PI * i / n + 0.1, r = i % 2 == 0 ? 1.0 : dent;
                points.emplace_back(r * std::cos(a), r * std::sin(a), 0.1 * (i % 3));
            }
            Mesh mesh = two_sided(points);
            const auto first = diagonals(mesh);
            EXPECT_EQ(first[0].size(), std::size_t(n - 3));
            EXPECT_EQ(first[0], first[1]) << n << " sides, " << dent;
            for (int start = 1; start < n; ++start) {
                mesh.set_start(mesh.corner(Face(1), start));
                EXPECT_EQ(diagonals(mesh), first) << n << " sides from corner " << start;
            }
        }
}

TEST(Triangulator, CutsARegularStarAlikeHoweverItLies)
{
    // All its points are equal but for rounding.
    const auto star = [](double turn) {
        std::vector<Point> points;
        for (int i = 0; i < 10; ++i) {
            const double a = M_PI * i / 5 + turn, r = i % 2 == 0 ? 1.0 : 0.5;
            points.emplace_back(r * std::cos(a), r * std::sin(a), 0.05 * (i % 2));
        }
        return diagonals(two_sided(points))[0];
    };
    const auto first = star(0);
    for (int i = 1; i < 200; ++i) EXPECT_EQ(star(0.0314 * i), first) << i;
}

TEST(Triangulator, CutsARingThatGoesTwiceThroughAVertex)
{
    // The one face around a tree has each inner vertex as often as it has edges.
    Mesh mesh;
    const Vertex hub = mesh.create_vertex({0, 0, 0});
    for (int i = 0; i < 5; ++i) {
        const Vertex leaf = mesh.create_vertex({std::cos(i), std::sin(i), 0.1 * i});
        mesh.insert_edge(mesh.corner(hub), mesh.corner(leaf));
    }
    mesh.compact();
    Triangulator triangulator;
    EXPECT_EQ(triangulator.triangles(mesh, Face(0)).size(), 8u);
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
