#include "cell/cell_assembly.h"
#include "cell/cell_shapes.h"
#include "support/mesh_checks.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace druse {
namespace {

struct CellFacts {
    CellKind kind;
    int vertices, edges, faces, pairs;
    std::map<int, int> pane_sides;                 // how many panes have so many
    std::map<int, int> corner_orbits, edge_orbits; // how many have so many members
    double volume;
};

std::vector<CellFacts> cell_table()
{
    const double root = std::sqrt(3.0);
    return {{CellKind::cube, 8, 12, 6, 3, {{4, 6}}, {{8, 1}}, {{4, 3}}, 1},
            {CellKind::hexprism, 12, 18, 8, 4, {{4, 6}, {6, 2}}, {{6, 2}}, {{4, 3}, {3, 2}}, root / 2},
            {CellKind::fcc, 14, 24, 12, 6, {{4, 12}}, {{4, 2}, {6, 1}}, {{3, 8}}, 16},
            {CellKind::elongated, 18, 28, 12, 6, {{4, 8}, {6, 4}}, {{4, 2}, {5, 2}}, {{3, 8}, {4, 1}}, 32},
            {CellKind::bcc, 24, 36, 14, 7, {{4, 6}, {6, 8}}, {{4, 6}}, {{3, 12}}, 32}};
}

class EveryCell : public testing::TestWithParam<CellFacts> {};

TEST_P(EveryCell, HasTheCountsOfTheTable)
{
    const CellFacts& facts = GetParam();
    const Parallelohedron cell = make_parallelohedron(facts.kind, table_size(facts.kind), table_size(facts.kind));
    EXPECT_EQ(int(cell.panes.size()), facts.pairs);
    std::map<int, int> pane_sides, corner_orbits, edge_orbits;
    int vertices = 0, edges = 0;
    for (const CellPane& pane : cell.panes) pane_sides[int(pane.sides.size())] += 2;
    for (const auto& corner : cell.corners) ++corner_orbits[int(corner.members.size())], vertices += int(corner.members.size());
    for (const auto& edge : cell.edges) ++edge_orbits[int(edge.members.size())], edges += int(edge.members.size());
    EXPECT_EQ(pane_sides, facts.pane_sides);
    EXPECT_EQ(corner_orbits, facts.corner_orbits);
    EXPECT_EQ(edge_orbits, facts.edge_orbits);
    EXPECT_EQ(vertices, facts.vertices);
    EXPECT_EQ(edges, facts.edges);
    EXPECT_EQ(vertices - edges + 2 * facts.pairs, 2);
    EXPECT_EQ(2 * facts.pairs, facts.faces);
    // Of what is left when translates are one: V − E + F − 1 = 0.
    EXPECT_EQ(int(cell.corners.size()) - int(cell.edges.size()) + facts.pairs - 1, 0);
    EXPECT_NEAR(cell.volume(), facts.volume, 1e-12 * facts.volume);
}

TEST_P(EveryCell, NumbersPanesByTranslationAndTurnsThemAlike)
{
    const CellFacts& facts = GetParam();
    const Parallelohedron cell = make_parallelohedron(facts.kind, 3, 5);
    for (std::size_t p = 0; p < cell.panes.size(); ++p) {
        const CellPane& pane = cell.panes[p];
        const Vector t = cell.at(pane.translation);
        const double first = std::abs(t.x) > 1e-9 ? t.x : std::abs(t.y) > 1e-9 ? t.y : t.z;
        EXPECT_GT(first, 0);
        if (p > 0) {
            const Vector before = cell.at(cell.panes[p - 1].translation);
            EXPECT_TRUE(std::tuple(before.x, before.y, before.z) > std::tuple(t.x, t.y, t.z));
        }
        EXPECT_LT(glm::length(pane.centre - 0.5 * t), 1e-12);
        EXPECT_GT(glm::dot(pane.normal, t), 0);
        EXPECT_LT(glm::length(glm::cross(pane.right, pane.up) - pane.normal), 1e-12);
        EXPECT_GE(pane.up.z, 0);
        const auto angle = [](const Point2& q) { return std::atan2(q.y, q.x) < -1e-9 ? std::atan2(q.y, q.x) + 2 * std::acos(-1.0) : std::atan2(q.y, q.x); };
        for (std::size_t k = 0; k < pane.corners.size(); ++k) {
            const std::size_t next = (k + 1) % pane.corners.size();
            if (next > 0) {
                EXPECT_LT(angle(pane.outline[k]), angle(pane.outline[next]));
            }
            const Point at = pane.centre + pane.outline[k].x * pane.right + pane.outline[k].y * pane.up;
            EXPECT_LT(glm::length(at - cell.corner(pane.corners[k])), 1e-12);
            // A side is the edge of its orbit.
            const auto& edge = cell.edges[std::size_t(pane.sides[k].edge.orbit)];
            const Vector shift = cell.at(pane.sides[k].edge.shift);
            const Point from = cell.corner(edge.from) + shift, to = cell.corner(edge.to) + shift;
            EXPECT_LT(glm::length((pane.sides[k].reversed ? to : from) - at), 1e-12);
            EXPECT_LT(glm::length((pane.sides[k].reversed ? from : to) - cell.corner(pane.corners[next])), 1e-12);
        }
    }
    // Orbits are numbered as panes first meet them, and an edge orbit runs as it is met.
    int corners = 0, edges = 0;
    for (const CellPane& pane : cell.panes) {
        for (const OrbitMember& c : pane.corners) {
            if (c.orbit == corners) {
                ++corners;
                EXPECT_EQ(c.shift, LatticeStep{});
            }
            EXPECT_LT(c.orbit, corners);
        }
        for (const CellSide& s : pane.sides) {
            if (s.edge.orbit == edges) {
                ++edges;
                EXPECT_FALSE(s.reversed);
            }
            EXPECT_LT(s.edge.orbit, edges);
        }
    }
}

TEST_P(EveryCell, IsItsTableSolidAndClosed)
{
    const CellFacts& facts = GetParam();
    const CellTile tile = CellTile::of_kind(facts.kind, table_size(facts.kind));
    const Mesh mesh = mesh_of(tile);
    EXPECT_SOUND(mesh);
    EXPECT_EQ(genus(mesh), 0);
    EXPECT_EQ(int(mesh.vertex_count()), facts.vertices);
    EXPECT_NEAR(volume(mesh), facts.volume, 1e-12 * facts.volume);
    Progress progress;
    const CellCheck found = check(tile, {}, progress);
    EXPECT_EQ(found.faults, std::vector<std::string>{});
    EXPECT_FALSE(found.free.empty());
}

TEST_P(EveryCell, HasNeighboursAcrossItsPanesInOtherColours)
{
    const CellFacts& facts = GetParam();
    const Parallelohedron cell = make_parallelohedron(facts.kind, 1, 1);
    EXPECT_EQ(int(cells_around(cell, 0).size()), 1);
    const auto around = cells_around(cell, 1);
    EXPECT_EQ(int(around.size()), 1 + facts.faces);
    const LatticeColours colours = colour_cells(cell);
    for (std::size_t i = 1; i < around.size(); ++i) EXPECT_NE(colours.of(around[i]), colours.of({}));
    // A cube's second shell are the cells two steps away: 5³ in the large, the octahedron of 25 in the small.
    if (facts.kind == CellKind::cube) {
        EXPECT_EQ(colours.count, 2);
        EXPECT_EQ(int(cells_around(cell, 2).size()), 25);
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryCell, testing::ValuesIn(cell_table()), [](const auto& made) { return std::string(name(made.param.kind)); });

TEST(HexagonalPrism, IsAsHighAsOneLikes)
{
    const CellTile tile = CellTile::of_kind(CellKind::hexprism, 20, 7);
    EXPECT_NEAR(tile.volume(), std::sqrt(3.0) / 2 * 400 * 7, 1e-9);
    EXPECT_NEAR(volume(make_solid(tile)), tile.volume(), 1e-9);
    EXPECT_THROW(CellTile::of_kind(CellKind::cube, 20, 7), CommandError);
}

TEST(TruncatedOctahedron, HasTheTranslationsOfTheTable)
{
    const Parallelohedron cell = make_parallelohedron(CellKind::bcc, 4, 4);
    std::vector<Vector> found;
    for (const CellPane& pane : cell.panes) found.push_back(cell.at(pane.translation));
    EXPECT_EQ(found, (std::vector<Vector>{{4, 0, 0}, {2, 2, 2}, {2, 2, -2}, {2, -2, 2}, {2, -2, -2}, {0, 4, 0}, {0, 0, 4}}));
}

} // namespace
} // namespace druse
