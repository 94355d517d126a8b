// Remeshing of some faces or vertices only, and triangulation.
#include "remesh_models.h"

#include "dlfl/mesh_builder.h"

#include <cmath>
#include <numbers>

namespace druse {
namespace {

using namespace test;

TEST(RemeshStellate, OfAllFacesIsThatOfFacesWithTheirNumberOfSides)
{
    EXPECT_TRUE(made_of(dodecahedron(), "remesh.stellate", {{"only", "5"}, {"height", "0.3"}}) == made_of(dodecahedron(), "remesh.stellate", {{"height", "0.3"}}));
    EXPECT_TRUE(made_of(torus(7, 5), "remesh.truncate", {{"only", "4"}, {"t", "0.3"}}) == made_of(torus(7, 5), "remesh.truncate", {{"t", "0.3"}}));
}

TEST(RemeshStellate, LeavesOtherFacesWhereTheyWere)
{
    for (const Input& input : remeshed_models)
        for (const int sides : {3, 4, 5}) {
            SCOPED_TRACE(std::string(input.name) + ", " + std::to_string(sides));
            const Mesh old = input.make(), mesh = made_of(old, "remesh.stellate", {{"only", std::to_string(sides)}});
            Rings expected;
            std::vector<int> expected_groups;
            std::uint32_t found = 0;
            for (const Face f : old.faces()) {
                const Ring r = ring(old, f);
                if (int(r.size()) != sides) {
                    expected.push_back(r);
                    expected_groups.push_back(2);
                    continue;
                }
                for (std::size_t i = 0; i < r.size(); ++i) expected.push_back({r[i], r[(i + 1) % r.size()], old.vertex_count() + found});
                expected_groups.insert(expected_groups.end(), r.size(), 1);
                ++found;
            }
            EXPECT_EQ(counts(mesh), (Counts{old.vertex_count() + found, old.edge_count() + unsigned(sides) * found, old.face_count() + unsigned(sides - 1) * found}));
            EXPECT_EQ(rings(mesh), expected);
            EXPECT_EQ(groups(mesh), expected_groups);
            expect_genus_and_volume_kept(old, mesh);
        }
}

TEST(RemeshTruncate, CutsOnlyVerticesOfAValence)
{
    for (const Input& input : remeshed_models)
        for (const int valence : {3, 4, 5}) {
            SCOPED_TRACE(std::string(input.name) + ", " + std::to_string(valence));
            const Mesh old = input.make(), mesh = made_of(old, "remesh.truncate", {{"only", std::to_string(valence)}});
            std::uint32_t found = 0;
            for (const Vertex v : old.vertices()) found += old.valence(v) == valence ? 1 : 0;
            EXPECT_EQ(counts(mesh), (Counts{old.vertex_count() + unsigned(valence - 1) * found, old.edge_count() + unsigned(valence) * found, old.face_count() + found}));
            expect_genus_and_volume_kept(old, mesh);
            std::vector<int> expected_groups(old.face_count(), 1);
            expected_groups.insert(expected_groups.end(), found, 2);
            EXPECT_EQ(groups(mesh), expected_groups);
            for (const Face f : old.faces()) {
                int sides = 0;
                for (const Corner c : old.corners(f)) sides += old.valence(old.vertex(c)) == valence ? 2 : 1;
                EXPECT_EQ(mesh.valence(f), sides);
            }
        }
}

TEST(RemeshTruncate, CutsTheTipOffAPyramid)
{
    const Mesh mesh = made_of(pyramid(7), "remesh.truncate", {{"only", "7"}});
    const Mesh old = pyramid(7);
    EXPECT_EQ(counts(mesh), (Counts{14, 21, 9}));
    for (const Vertex v : mesh.vertices()) EXPECT_EQ(mesh.valence(v), 3);
    for (std::uint32_t v = 0; v < 7; ++v) {
        EXPECT_EQ(mesh.position(Vertex(v)), old.position(Vertex(v)));
        EXPECT_NEAR(mesh.position(Vertex(7 + v)).z, 0.75, 1e-15); // at a quarter of the edges from the tip, at height 1
    }
}

TEST(RemeshPartial, StopsWhereNothingIsLeftAndRefusesTooMuch)
{
    EXPECT_EQ(counts(made_of(cube(), "remesh.stellate", {{"only", "4"}, {"iterations", "20"}})), (Counts{14, 36, 24}));
    EXPECT_EQ(complaint(scene_of(cube()), "remesh.truncate", {{"only", "3"}, {"iterations", "20"}}), "would make 41841412812 edges, more than 20 million"); // 12·3²⁰
    EXPECT_EQ(complaint(scene_of(tetrahedron()), "remesh.stellate", {{"only", "3"}, {"iterations", "15"}}), "would make 86093442 edges, more than 20 million"); // 6·3¹⁵
    EXPECT_EQ(complaint(scene_of(open_grid(3, 2)), "remesh.stellate", {{"only", "4"}}), "the model is open: 10 boundary edges");
}

// --- triangulation -----------------------------------------------------------------------------------------------------------------

using Words = std::vector<std::pair<std::string, std::string>>;

TEST(RemeshTriangulate, MakesTrianglesOfEveryModelInEveryWay)
{
    for (const Input& input : remeshed_models) {
        SCOPED_TRACE(input.name);
        Mesh old = input.make();
        for (const Face f : old.faces()) old.set_group(f, 1 + int(f.index));
        const std::uint32_t V = old.vertex_count(), E = old.edge_count(), F = old.face_count();
        for (const char* method : {"ear", "fan"}) {
            const Mesh mesh = made_of(old, "remesh.triangulate", {{"method", method}});
            EXPECT_EQ(counts(mesh), (Counts{V, 3 * E - 3 * F, 2 * E - 2 * F}));
            expect_genus_and_volume_kept(old, mesh);
            std::vector<int> expected;
            for (const Face f : old.faces()) expected.insert(expected.end(), std::size_t(old.valence(f) - 2), old.group(f));
            EXPECT_EQ(groups(mesh), expected);
            for (const Face f : mesh.faces()) ASSERT_EQ(mesh.valence(f), 3);
        }
        const Mesh mesh = made_of(old, "remesh.triangulate", {{"method", "center"}});
        std::uint32_t large = 0, sides = 0;
        for (const Face f : old.faces())
            if (old.valence(f) > 3) {
                ++large;
                sides += unsigned(old.valence(f));
            }
        EXPECT_EQ(counts(mesh), (Counts{V + large, E + sides, F - large + sides}));
        expect_genus_and_volume_kept(old, mesh);
    }
}

/// A flat face over points in the plane, and its back.
Mesh two_sided(const std::vector<Point2>& polygon)
{
    MeshBuilder builder;
    Ring ring;
    for (const Point2& p : polygon) ring.push_back(builder.add_vertex(Point(p, 0.0)));
    builder.add_face(ring);
    builder.add_face(Ring(ring.rbegin(), ring.rend()));
    return builder.build();
}

TEST(RemeshTriangulate, ClipsTheFirstEarFromTheStartCornerOn)
{
    const auto triangles = [](const std::vector<Point2>& polygon) {
        Rings all = rings(made_of(two_sided(polygon), "remesh.triangulate", {{"faces", "0"}}));
        EXPECT_EQ(all.back().size(), polygon.size()); // the back was not asked for
        all.pop_back();
        return all;
    };
    EXPECT_EQ(triangles({{0, 0}, {2, 0}, {2, 1}, {0, 1}}), (Rings{{0, 1, 3}, {1, 2, 3}}));
    // An arrow head: its tip, corner 0, sees the dent, corner 2, inside its triangle.
    EXPECT_EQ(triangles({{0, 4}, {-2, 0}, {0, 1}, {2, 0}}), (Rings{{1, 2, 0}, {0, 2, 3}}));
    // A straight corner is no ear, and blocks the triangle it lies on.
    EXPECT_EQ(triangles({{0, 2}, {0, 0}, {1, 0}, {2, 0}}), (Rings{{1, 2, 0}, {0, 2, 3}}));
}

TEST(RemeshTriangulate, CoversConcaveFacesOnce)
{
    std::vector<Point2> star, comb;
    for (int i = 0; i < 40; ++i) {
        const double angle = std::numbers::pi * i / 20, r = i % 2 == 0 ? 1.0 : 0.2;
        star.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    for (int i = 0; i < 10; ++i) comb.insert(comb.end(), {{3.0 * i, 0.0}, {3.0 * i + 1, 0.0}, {3.0 * i + 1, 5.0}, {3.0 * i + 2, 5.0}});
    comb.insert(comb.end(), {{30.0, 0.0}, {30.0, -1.0}, {0.0, -1.0}});
    std::reverse(comb.begin(), comb.end());
    for (const std::vector<Point2>& polygon : {star, comb}) {
        const Mesh old = two_sided(polygon), mesh = made_of(old, "remesh.triangulate");
        double up = 0;
        for (const Face f : mesh.faces()) {
            EXPECT_GT(area(mesh, f), 1e-9);
            up += std::abs(area_vector(mesh, f).z);
        }
        EXPECT_NEAR(up, surface_area(old), 1e-9); // if any overlapped, or turned over, it would be more
    }
}

TEST(RemeshTriangulate, CutsWhatCrossesItselfAllTheSame)
{
    std::vector<Point2> pentagram;
    for (int i = 0; i < 5; ++i) pentagram.emplace_back(std::cos(0.8 * std::numbers::pi * i), std::sin(0.8 * std::numbers::pi * i));
    for (const std::vector<Point2>& polygon : {pentagram, std::vector<Point2>(6, Point2(1, 1)), {{0, 0}, {1, 0}, {2, 0}, {3, 0}}, {{0, 0}, {1, 1}, {1, 0}, {0, 1}}}) {
        const Mesh old = two_sided(polygon), mesh = made_of(old, "remesh.triangulate");
        EXPECT_SOUND(mesh);
        EXPECT_EQ(mesh.face_count(), 2 * polygon.size() - 4);
    }
}

TEST(RemeshTriangulate, HasGroupsOfItsOwnIfAsked)
{
    Mesh old = prism(5); // two pentagons and five squares
    old.set_group(Face(0), 7);
    EXPECT_EQ(groups(made_of(old, "remesh.triangulate", {{"groups", "absolute"}, {"faces", "sides:5"}})), (std::vector<int>{1, 1, 1, 2, 2, 2, 2, 2, 1, 1, 1}));
    EXPECT_EQ(groups(made_of(old, "remesh.triangulate", {{"groups", "none"}, {"faces", "0"}})), std::vector<int>(9, 0));
    EXPECT_EQ(groups(made_of(old, "remesh.triangulate", {{"faces", "0"}})), (std::vector<int>{7, 7, 7, 0, 0, 0, 0, 0, 0}));
}

} // namespace
} // namespace druse
