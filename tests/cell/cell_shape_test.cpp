// Phase II of cells: moves by orbit, splits, flips, rolling back, clearance.
#include "cell/cell_shapes.h"
#include "cell/freedom.h"
#include "cell/harmonic.h"
#include "support/mesh_checks.h"

#include <gtest/gtest.h>

#include <array>

namespace druse {
namespace {

/// Flips the first edge of a pane that can be.
bool flip_any(CellTile& tile, int pane)
{
    for (const auto& t : tile.mesh(pane).triangles) {
        try {
            tile.flip(pane, tile.pane_name(pane, t[0]), tile.pane_name(pane, t[1]));
            return true;
        } catch (const CellRefusal&) {
        }
    }
    return false;
}

class EveryShapedCell : public testing::TestWithParam<CellKind> {};

TEST_P(EveryShapedCell, MovesOneOrbitAndNothingElse)
{
    const CellTile tile = subdivided(GetParam());
    const CellSolid before = make_solid(tile);
    std::size_t first = 0;
    for (int i = 0; i < tile.point_count(); ++i) {
        CellTile moved = tile;
        const Vector by(0.1, -0.2, 0.3);
        moved.move(std::array{i, i}, by); // once, however often it is named
        const CellSolid after = make_solid(moved);
        for (std::size_t k = 0; k < before.points.size(); ++k) {
            const bool member = k >= first && k < first + tile.members(i).size();
            EXPECT_LT(glm::length(after.points[k] - before.points[k] - (member ? by : Vector(0.0))), 1e-12);
        }
        EXPECT_EQ(after.triangles, before.triangles);
        first += tile.members(i).size();
    }
    EXPECT_EQ(first, before.points.size());
}

TEST_P(EveryShapedCell, KeepsItsVolumeThroughSplitsAndFlipsAndComesBackFromItsDesign)
{
    std::mt19937 random(3);
    CellTile tile = shaken(subdivided(GetParam()), 0.1 * shortest_edge(GetParam()), random);
    int made = 0;
    for (int round = 0; round < 120; ++round) {
        const int p = int(random() % unsigned(tile.pane_count()));
        const PaneMesh& mesh = tile.mesh(p);
        const int t = int(random() % mesh.triangles.size());
        const CellPointName a = tile.pane_name(p, mesh.triangles[std::size_t(t)][0]), b = tile.pane_name(p, mesh.triangles[std::size_t(t)][1]);
        const int before = tile.point_count();
        const double volume_before = volume(make_solid(tile));
        try {
            if (round % 3 == 0) tile.split_triangle(p, t, {0.2, 0.3, 0.5});
            else if (round % 3 == 1) tile.split_edge(p, a, b, 0.4);
            else tile.flip(p, a, b);
            ++made;
        } catch (const CellRefusal& refusal) {
            EXPECT_TRUE(refusal.reason() == CellRefusal::Reason::fixed || refusal.reason() == CellRefusal::Reason::duplicate) << refusal.what();
            continue;
        }
        EXPECT_EQ(tile.point_count(), before + (round % 3 == 2 ? 0 : 1));
        EXPECT_NEAR(volume(make_solid(tile)), volume_before, 1e-9 * volume_before);
    }
    EXPECT_GT(made, 80);
    for (int i = 0; i < tile.point_count(); ++i) tile.move(std::array{i}, Vector(uniform(random, -0.01, 0.01), 0, 0));
    const Mesh mesh = mesh_of(tile);
    EXPECT_SOUND(mesh);
    EXPECT_EQ(genus(mesh), 0);
    EXPECT_NEAR(volume(mesh), tile.volume(), 1e-9 * tile.volume());
    const CellTile again(tile.design());
    EXPECT_EQ(again.design(), tile.design());
    EXPECT_EQ(make_solid(again).points, make_solid(tile).points);
    EXPECT_EQ(make_solid(again).triangles, make_solid(tile).triangles);
}

TEST_P(EveryShapedCell, SplitsASideOnAllPanesOfItsOrbit)
{
    CellTile tile = CellTile::of_kind(GetParam(), 4);
    tile.shape();
    const auto before = mesh_of(tile).vertex_count();
    const auto edge = std::size_t(tile.cell().panes[0].sides[1].edge.orbit);
    EXPECT_EQ(tile.split_edge(0, CellPointName::parse("v2"), CellPointName::parse("v1"), 0.25).text(), "s0");
    const auto members = tile.cell().edges[edge].members.size();
    EXPECT_EQ(mesh_of(tile).vertex_count(), before + members);
    EXPECT_EQ(tile.members(tile.find(CellPointName::split(0))).size(), members);
    // And once more, between the new point and an end.
    tile.split_edge(0, CellPointName::parse("s0"), CellPointName::parse("v1"), 0.5);
    tile.move(std::array{tile.find(CellPointName::split(1))}, Vector(0.1, 0.2, 0.05));
    const Mesh mesh = mesh_of(tile);
    EXPECT_SOUND(mesh);
    EXPECT_EQ(mesh.vertex_count(), before + 2 * members);
    EXPECT_NEAR(volume(mesh), tile.volume(), 1e-9 * tile.volume());
    EXPECT_EQ(CellTile(tile.design()).design(), tile.design());
}

TEST_P(EveryShapedCell, RollsBackOnePairAndLeavesTheRest)
{
    std::mt19937 random(5);
    CellTile tile = shaken(subdivided(GetParam()), 0.1 * shortest_edge(GetParam()), random);
    const int p = tile.pane_count() - 1, other = 0;
    tile.split_edge(p, CellPointName::parse("v0"), CellPointName::parse("e0:1"), 0.5);  // s0, which other panes have
    tile.split_triangle(p, 3, {0.2, 0.3, 0.5});                                        // s1, which goes
    tile.split_triangle(other, 2, {0.2, 0.3, 0.5});                                    // s2, which becomes s1
    EXPECT_TRUE(flip_any(tile, p));
    const CellTile before = tile;
    tile.roll_back(p);
    EXPECT_TRUE(tile.is_flat(p));
    EXPECT_EQ(CellTile(tile.design()).design(), tile.design());
    tile.remove_points(std::array{CellPointName::interior(p, 2)});
    const CellPointName fresh = tile.add_point(p, tile.flat_place(p, tile.find_in_pane(p, CellPointName::interior(-1, 0))) * 0.9 + 0.03 * tile.cell().panes[std::size_t(p)].outline[0]);
    EXPECT_EQ(fresh.kind, CellPointName::Kind::interior);
    EXPECT_EQ(CellTile(tile.design()).design(), tile.design());
    tile.shape();
    EXPECT_FALSE(tile.is_flat(p));
    EXPECT_EQ(tile.point_count(), before.point_count() - 1); // one went, one came, and a split went
    for (int i = 0; i < before.point_count(); ++i) {
        CellPointName name = before.name(i);
        if (before.pane_of(i) == p) {
            if (name.kind == CellPointName::Kind::split || name.index == 2) continue;
            if (name.index > 2) --name.index;
        } else if (name == CellPointName::split(2)) {
            name = CellPointName::split(1);
        }
        EXPECT_EQ(tile.position(tile.find(name)), before.position(i)) << name.text();
    }
    for (int q = 0; q < tile.pane_count(); ++q)
        if (q != p) {
            EXPECT_EQ(tile.mesh(q).triangles, before.mesh(q).triangles) << q;
        }
    const Vector moved = tile.moved(tile.find(fresh));
    EXPECT_NE(moved, Vector(0.0)); // as its neighbours are
    EXPECT_LT(glm::length(moved), 0.2 * shortest_edge(GetParam()));
    EXPECT_SOUND(mesh_of(tile));
    EXPECT_NEAR(volume(make_solid(tile)), tile.volume(), 1e-9 * tile.volume());
    EXPECT_EQ(CellTile(tile.design()).design(), tile.design());

    // Any of them, and into space again: every point is where it was, and of the triangles only those of the pair may differ.
    for (int q = 0; q < before.pane_count(); ++q) {
        CellTile there = shaken(subdivided(GetParam()), 0.1 * shortest_edge(GetParam()), random), back = there;
        flip_any(back, q);
        back.roll_back(q);
        back.shape();
        for (int i = 0; i < there.point_count(); ++i) EXPECT_EQ(back.position(i), there.position(i)) << back.name(i).text();
        for (int r = 0; r < there.pane_count(); ++r) EXPECT_EQ(back.mesh(r).triangles, there.mesh(r).triangles);
    }

    CellTile afresh = before;
    afresh.roll_back(p, false);
    afresh.shape();
    for (int i = 0; i < afresh.point_count(); ++i)
        if (afresh.pane_of(i) == p) {
            EXPECT_EQ(afresh.moved(i), Vector(0.0));
        }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryShapedCell, testing::ValuesIn(every_cell), [](const auto& made) { return std::string(name(made.param)); });

TEST(Harmonic, ReproducesLinearFunctionsOfThePlace)
{
    CellTile tile = CellTile::of_kind(CellKind::bcc, 40);
    divide_sides(tile, 2, 8);
    tile.refine(2, {.min_angle = 20, .max_area = 2.0});
    std::vector<Point2> places;
    std::vector<std::uint32_t> unknown;
    std::vector<Vector> values, expected;
    for (PaneMesh::Index i = 0; i < tile.mesh(2).point_count(); ++i) {
        const Point2 p = places.emplace_back(tile.flat_place(2, i));
        expected.emplace_back(1 + 2 * p.x - p.y, 3 * p.y, -p.x);
        const bool inside = i >= tile.mesh(2).rim.size();
        if (inside) unknown.push_back(i);
        values.push_back(inside ? Vector(0.0) : expected.back());
    }
    ASSERT_GT(unknown.size(), 50u);
    fill_harmonic(places, tile.mesh(2).triangles, unknown, values);
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_LT(glm::length(values[i] - expected[i]), 1e-9);
}

TEST(CellSplit, LiesOnTheMovedSurfaceAndStaysWhenThatMoves)
{
    CellTile tile = CellTile::of_kind(CellKind::cube, 10);
    const CellPointName i0 = tile.add_point(0, {0, 0});
    tile.shape();
    tile.move(std::array{tile.find(i0)}, Vector(3, 0, 0));
    const auto [a, b, c] = tile.mesh(0).triangles[0];
    const auto at = [&](PaneMesh::Index i) { return tile.position(tile.pane_point(0, i).orbit) + tile.cell().at(tile.pane_point(0, i).shift); };
    const Point expected = 0.2 * at(a) + 0.3 * at(b) + 0.5 * at(c);
    const int s = tile.find(tile.split_triangle(0, 0, {0.2, 0.3, 0.5}));
    EXPECT_LT(glm::length(tile.position(s) - expected), 1e-12);
    tile.move(std::array{tile.find(i0)}, Vector(0, 1, 0));
    EXPECT_LT(glm::length(tile.position(s) - expected), 1e-12);
}

TEST(CellFlip, IsRefusedWhereItWouldDoubleAnEdge)
{
    CellTile tile = CellTile::of_kind(CellKind::cube, 10);
    tile.add_point(0, {0, 0});
    tile.shape();
    const auto reason = [&](const char* a, const char* b) {
        try {
            tile.flip(0, CellPointName::parse(a), CellPointName::parse(b));
        } catch (const CellRefusal& refusal) {
            return std::string(name(refusal.reason()));
        }
        return std::string();
    };
    EXPECT_EQ(reason("v0", "v1"), "fixed");
    EXPECT_EQ(reason("v0", "v2"), "no-such-edge");
    EXPECT_EQ(reason("i0", "v0"), "");
    EXPECT_EQ(reason("i0", "v0"), "no-such-edge"); // it has become that from v1 to v3
    EXPECT_EQ(reason("i0", "v2"), "duplicate");    // which this would become too
}

TEST(CellClearance, LeavesJointsOfItsWidth)
{
    Progress progress;
    for (const CellKind kind : every_cell)
        for (const CellJoint joint : {CellJoint::inset, CellJoint::shrink}) {
            CellTile tile = CellTile::of_kind(kind, 40);
            tile.set_matrix({1.2, .3, -.2, .1, .9, .25, -.15, .2, 1.4});
            const CellCheck found = check(tile, {.clearance = 0.4, .joint = joint}, progress);
            EXPECT_EQ(found.faults, std::vector<std::string>{}) << name(kind);
            EXPECT_LT(found.volume_left, found.volume);
            EXPECT_GE(found.clearance, 0.4 - 4e-5);
            if (joint == CellJoint::inset) {
                EXPECT_NEAR(found.clearance, 0.4, 1e-9) << name(kind);
            }
        }
    // A cube inset by c/2 on each side.
    EXPECT_NEAR(volume(make_solid(CellTile::of_kind(CellKind::cube, 10), 0.4)), 9.6 * 9.6 * 9.6, 1e-9);
    EXPECT_THROW(make_solid(CellTile::of_kind(CellKind::cube, 10), 11, CellJoint::shrink), CellRefusal);
}

TEST(CellClearance, IsRefusedWhereTheSolidWouldComeOutTurned)
{
    const CellMatrix plate{1, 0, 0, 0, 1, 0, 0, 0, 0.01}, rod{1, 0, 0, 0, 0.01, 0, 0, 0, 0.01};
    struct Case {
        CellKind kind;
        double size;
        std::optional<double> height;
        CellMatrix matrix;
        double clearance;
    };
    const CellMatrix none = CellDesign().matrix;
    for (const Case& c : {Case{CellKind::hexprism, 4, 0.3, none, 0.4}, Case{CellKind::cube, 20, {}, plate, 0.4}, Case{CellKind::cube, 20, {}, rod, 0.4}, Case{CellKind::cube, 4, {}, none, 5},
                          Case{CellKind::cube, 4, {}, none, 4}, Case{CellKind::fcc, 1, {}, none, 3}, Case{CellKind::fcc, 1, {}, none, 100}, Case{CellKind::fcc, 4, {}, none, 1e300}}) {
        CellTile tile = CellTile::of_kind(c.kind, c.size, c.height);
        tile.set_matrix(c.matrix);
        EXPECT_THROW(make_solid(tile, c.clearance), CellRefusal) << name(c.kind) << " " << c.clearance;
        Progress progress;
        const CellCheck found = check(tile, {.clearance = c.clearance}, progress);
        EXPECT_TRUE(found.vanishes);
        ASSERT_EQ(found.faults.size(), 1u);
        EXPECT_TRUE(found.faults[0].starts_with("vanishes: clearance ")) << found.faults[0];
    }
    EXPECT_NEAR(volume(make_solid(CellTile::of_kind(CellKind::cube, 4), 3.9)), 1e-3, 1e-9);
}

TEST(CellClearance, TellsOfJointsThatAreNarrower)
{
    CellTile tile = CellTile::of_kind(CellKind::cube, 10);
    Progress progress;
    EXPECT_EQ(narrow_joints(tile, make_solid(tile, 0.4), 0.4, progress), std::nullopt);
    EXPECT_EQ(narrow_joints(tile, make_solid(tile, 0.3), 0.4, progress), "joints are 0.3 wide at the narrowest, not 0.4");
    // A wall between two neighbours that is steep: the shrunk cell moves along it.
    tile.add_edge_point(0, 0.5);
    tile.shape();
    tile.move(std::array{tile.find(CellPointName::edge(0, 0))}, Vector(3, 2, 4));
    EXPECT_NE(narrow_joints(tile, make_solid(tile, 0.4, CellJoint::shrink), 0.4, progress), std::nullopt);
}

TEST(CellSplit, OnTwoSidesIsTheOneThatHasTheEdge)
{
    CellTile tile = CellTile::of_kind(CellKind::cube, 4); // opposite sides of a pane are of one orbit
    tile.shape();
    const CellPointName v0 = CellPointName::parse("v0"), v1 = CellPointName::parse("v1"), v2 = CellPointName::parse("v2"), v3 = CellPointName::parse("v3"), s0 = CellPointName::parse("s0");
    tile.split_edge(0, v0, v1, 0.5);
    int split = 0;
    for (const CellPointName& corner : {v0, v1, v2, v3}) { // each is at the end of one half of one of the two sides
        CellTile trial = tile;
        const auto [a, b] = trial.edge_between(0, {CellPointName::split(0, corner == v0 || corner == v1 ? 0 : 2), corner});
        EXPECT_TRUE(trial.mesh(0).find(a, b) || trial.mesh(0).find(b, a));
        try {
            trial.split_edge(0, s0, corner, 0.5);
            ++split;
        } catch (const CellRefusal& refusal) { // a diagonal goes there as well
            EXPECT_NE(std::string(refusal.what()).find("say on which side, as s0@"), std::string::npos) << refusal.what();
        }
    }
    EXPECT_EQ(split, 2);
    tile.roll_back(0);
    try {
        tile.constrain(0, std::array{v2, s0});
        ADD_FAILURE() << "runs to a split";
    } catch (const CellRefusal& refusal) {
        EXPECT_STREQ(refusal.what(), "fixed: s0 was made by a split in space: no line of the flat pane runs there");
    }
}

TEST(CellCheck, StopsWhenItIsCancelled)
{
    const CellTile cube = CellTile::of_kind(CellKind::cube, 10);
    Progress progress;
    progress.cancel();
    EXPECT_THROW(check(cube, {}, progress), Cancelled);
    EXPECT_THROW(free_directions(cube, make_solid(cube), progress), Cancelled);
    EXPECT_THROW(least_distance(cube, make_solid(cube), 1, progress), Cancelled);
}

TEST(CellFreedom, IsThatOfABlockWhosePanesAreFlat)
{
    Progress progress;
    CellTile cube = CellTile::of_kind(CellKind::cube, 10);
    EXPECT_EQ(free_directions(cube, make_solid(cube), progress).size(), 26u); // from face, edge or corner of a block
    // A bent pane: what is pulled out on the right keeps the cell from going up or down or to the sides, and a mushroom keeps it from going anywhere.
    const CellPointName middle = cube.add_point(0, {0, 0});
    cube.shape();
    cube.move(std::array{cube.find(middle)}, Vector(3, 0, 0));
    const std::vector<Vector> free = free_directions(cube, make_solid(cube), progress);
    EXPECT_NE(std::ranges::find(free, Vector(1, 0, 0)), free.end());
    EXPECT_NE(std::ranges::find(free, Vector(-1, 0, 0)), free.end());
    EXPECT_EQ(std::ranges::find(free, Vector(0, 0, 1)), free.end());
    EXPECT_EQ(std::ranges::find(free, Vector(0, 1, 0)), free.end());
}

} // namespace
} // namespace druse
