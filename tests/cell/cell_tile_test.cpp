// Phase I of cells: points and lines of panes, points of edges.
#include "cell/cell_shapes.h"

#include <gtest/gtest.h>

#include <array>

namespace druse {
namespace {

/// The word with which an edit is refused, and that it changed nothing.
template <class F>
std::string refusal(CellTile& tile, F&& f)
{
    const CellDesign before = tile.design();
    std::string word;
    try {
        f();
    } catch (const CommandError& error) {
        word = error.what();
        word.resize(std::min(word.size(), word.find(':')));
    }
    EXPECT_EQ(tile.design(), before);
    return word;
}

/// A design makes the tile that it was taken from, and every name finds its point.
void expect_consistent(const CellTile& tile)
{
    const CellTile again(tile.design());
    EXPECT_EQ(again.design(), tile.design());
    for (int i = 0; i < tile.point_count(); ++i) EXPECT_EQ(tile.find(CellPointName::parse(tile.name(i).text())), i);
    for (int p = 0; p < tile.pane_count(); ++p) {
        EXPECT_EQ(again.mesh(p), tile.mesh(p));
        for (PaneMesh::Index i = 0; i < tile.mesh(p).point_count(); ++i) {
            EXPECT_EQ(tile.find_in_pane(p, CellPointName::parse(tile.pane_name(p, i).text())), i);
            // Flat places and places in space are the same.
            const CellPane& pane = tile.cell().panes[std::size_t(p)];
            const OrbitMember member = tile.pane_point(p, i);
            const Point2 flat = tile.flat_place(p, i);
            EXPECT_LT(glm::length(pane.centre + flat.x * pane.right + flat.y * pane.up - tile.base(member.orbit) - tile.cell().at(member.shift)), 1e-12 * tile.size());
            const auto members = tile.members(member.orbit);
            EXPECT_NE(std::ranges::find(members, member.shift), members.end());
            EXPECT_NE(std::ranges::find(members, member.shift - pane.translation), members.end());
        }
    }
}

TEST(CellPointName, IsReadAsItIsWritten)
{
    for (const char* text : {"c4", "x2:1", "p3:i5", "s0", "i5", "v2", "e1:2", "s7@3", "p0:v1", "p0:e2:3", "p1:s2"}) EXPECT_EQ(CellPointName::parse(text).text(), text);
    for (const char* text : {"", "c", "x2", "x2:0", "p3", "p3:", "p3:c0", "p:i0", "i-1", "v1 ", "s0@", "e1:", "q0", "p1:p2:i0", "i99999999999"})
        EXPECT_THROW(CellPointName::parse(text), CommandError) << text;
}

TEST(CellPanes, TakePointsOfAnEdgeOnAllSidesOfItsOrbit)
{
    for (const CellKind kind : every_cell) {
        SCOPED_TRACE(name(kind));
        CellTile tile = CellTile::of_kind(kind, 4);
        const Mesh before = mesh_of(tile);
        const auto members = int(tile.cell().edges[0].members.size());
        EXPECT_EQ(tile.add_edge_point(0, 0.25).text(), "x0:1");
        EXPECT_EQ(tile.add_edge_point(0, 0.75).text(), "x0:2");
        EXPECT_EQ(tile.add_edge_point(0, 0.5).text(), "x0:2");
        EXPECT_EQ(tile.edge_points(0), (std::vector<double>{0.25, 0.5, 0.75}));
        EXPECT_EQ(tile.add_edge_point(0, 0.25).text(), "x0:1"); // is there
        EXPECT_EQ(tile.notes().size(), 1u);
        EXPECT_EQ(int(mesh_of(tile).vertex_count()) - int(before.vertex_count()), 3 * members);
        EXPECT_EQ(int(tile.members(tile.find(CellPointName::edge(0, 1))).size()), members);
        expect_consistent(tile);
        tile.remove_edge_points(std::array{CellPointName::edge(0, 1)});
        EXPECT_EQ(tile.edge_points(0), (std::vector<double>{0.25, 0.75}));
        expect_consistent(tile);
    }
}

TEST(CellPanes, TakePointsAndLinesInside)
{
    CellTile tile = CellTile::of_kind(CellKind::fcc, 40);
    EXPECT_EQ(tile.add_point(1, {1, 2}).text(), "p1:i0");
    EXPECT_EQ(tile.add_point(1, {-3, 1}).text(), "p1:i1");
    EXPECT_EQ(tile.add_point(1, {1, 2.01}).text(), "p1:i0"); // is there, within a five-hundredth of the size
    EXPECT_EQ(int(tile.mesh(1).triangles.size()), 6);        // 2 I + B − 2
    const std::array path{CellPointName::parse("v0"), CellPointName::parse("i1")};
    tile.constrain(1, path);
    EXPECT_EQ(tile.constrained_edges(1).size(), 1u);
    expect_consistent(tile);
    tile.move_point(CellPointName::parse("p1:i0"), {2, 2});
    EXPECT_EQ(tile.interior(1)[0], Point2(2, 2));
    tile.unconstrain(1, path);
    EXPECT_TRUE(tile.constrained_edges(1).empty());
    tile.remove_points(std::array{CellPointName::parse("p1:i0")});
    EXPECT_EQ(tile.interior(1), (std::vector<Point2>{{-3, 1}}));
    // Lines that cross make a point.
    tile.constrain(2, std::array{CellPointName::parse("v0"), CellPointName::parse("v2")});
    tile.constrain(2, std::array{CellPointName::parse("v1"), CellPointName::parse("v3")});
    EXPECT_EQ(tile.interior(2).size(), 1u);
    EXPECT_LT(glm::length(tile.interior(2)[0]), 1e-12);
    divide_sides(tile, 2, 4);
    tile.refine(2, {.min_angle = 20, .max_area = 10.0});
    EXPECT_GT(tile.interior(2).size(), 5u);
    expect_consistent(tile);
}

TEST(CellPanes, LoseManyPointsInOneStep)
{
    CellTile tile = CellTile::of_kind(CellKind::cube, 10);
    const auto name = [](const char* text) { return CellPointName::parse(text); };
    for (const Point2& at : {Point2(-3, 0), Point2(3, 0), Point2(0, -3), Point2(0, 3)}) tile.add_point(0, at);
    tile.constrain(0, std::array{name("i0"), name("i1")});
    tile.constrain(0, std::array{name("i2"), name("i3")});
    ASSERT_EQ(tile.interior(0).size(), 5u) << "lines cross";
    tile.add_point(1, {2, 2});
    tile.add_edge_point(0, 0.25);
    tile.add_edge_point(0, 0.75);

    CellTile less = tile;
    less.remove_points(std::array{name("p0:i4")});
    EXPECT_EQ(less.notes(), (std::vector<std::string>{"i4 stays: lines cross there"}));
    EXPECT_EQ(less.interior(0).size(), 5u);
    less.remove_points(std::array{name("p0:i4"), name("p1:i0"), name("x0:1")});
    EXPECT_EQ(less.notes(), (std::vector<std::string>{"i4 stays: lines cross there"}));
    EXPECT_TRUE(less.interior(1).empty());
    EXPECT_EQ(less.edge_points(0), (std::vector<double>{0.75}));
    expect_consistent(less);

    // Its lines go with it, whatever is named first, and one that is named twice goes once.
    less = tile;
    less.remove_points(std::array{name("x0:2"), name("p0:i4"), name("p0:i0"), name("p0:i3"), name("p0:i1"), name("p0:i2"), name("p0:i0"), name("x0:1")});
    EXPECT_EQ(less.notes(), std::vector<std::string>());
    EXPECT_TRUE(less.interior(0).empty());
    EXPECT_TRUE(less.constrained_edges(0).empty());
    EXPECT_TRUE(less.edge_points(0).empty());
    EXPECT_EQ(less.interior(1).size(), 1u);
    expect_consistent(less);

    // All or nothing.
    EXPECT_EQ(refusal(tile, [&] { tile.remove_points(std::array{name("p0:i0"), name("p1:i3")}); }), "no-such-point");
    EXPECT_EQ(refusal(tile, [&] { tile.remove_points(std::array{name("p0:i0"), name("c0")}); }), "fixed");
    EXPECT_EQ(refusal(tile, [&] { tile.remove_edge_points(std::array{name("x0:1"), name("p0:i0")}); }), "no-such-point");
}

TEST(CellPanes, MakeAPointNearASideOneOfItsEdgeOrbit)
{
    for (const CellKind kind : every_cell)
        for (int p = 0; p < CellTile::of_kind(kind).pane_count(); ++p) {
            CellTile tile = CellTile::of_kind(kind, 4);
            const CellPane& pane = tile.cell().panes[std::size_t(p)];
            for (std::size_t k = 0; k < pane.sides.size(); ++k) {
                const Point2 at = 0.7 * pane.outline[k] + 0.3 * pane.outline[(k + 1) % pane.outline.size()];
                const CellPointName made = tile.add_point(p, at);
                EXPECT_EQ(made.kind, CellPointName::Kind::edge);
                const Point2 flat = tile.flat_place(p, tile.find_in_pane(p, {CellPointName::Kind::side, -1, int(k), 0, -1}));
                EXPECT_LT(std::min(glm::length(flat - at), glm::length(flat - 0.3 * pane.outline[k] - 0.7 * pane.outline[(k + 1) % pane.outline.size()])), 1e-12);
            }
            expect_consistent(tile);
        }
}

TEST(CellPanes, KeepLinesAlongTheirSidesWhenPointsComeAndGo)
{
    CellTile tile = CellTile::of_kind(CellKind::cube, 10);
    tile.constrain(0, std::array{CellPointName::parse("v0"), CellPointName::parse("v1"), CellPointName::parse("v3")});
    const int orbit = tile.cell().panes[0].sides[0].edge.orbit;
    tile.add_edge_point(orbit, 0.25);
    tile.add_edge_point(orbit, 0.5);
    EXPECT_EQ(tile.constrained_edges(0).size(), 4u);
    expect_consistent(tile);
    tile.remove_edge_points(std::array{CellPointName::edge(orbit, 0)});
    EXPECT_EQ(tile.constrained_edges(0).size(), 3u);
    expect_consistent(tile);
}

TEST(CellPanes, RefuseWhatTheyCannotDo)
{
    CellTile tile = CellTile::of_kind(CellKind::bcc, 40);
    tile.add_edge_point(0, 0.5);
    tile.add_point(0, {1, 1});
    EXPECT_EQ(refusal(tile, [&] { tile.move_point(CellPointName::parse("x0:1"), {1, 1}); }), "fixed"); // points on the edges of panes stay
    EXPECT_EQ(refusal(tile, [&] { tile.move_point(CellPointName::parse("p0:v0"), {1, 1}); }), "fixed");
    EXPECT_EQ(refusal(tile, [&] { tile.remove_points(std::array{CellPointName::parse("c0")}); }), "fixed");
    EXPECT_EQ(refusal(tile, [&] { tile.add_point(0, {100, 0}); }), "outside");
    EXPECT_EQ(refusal(tile, [&] { tile.add_point(7, {0, 0}); }), "no-such-pane");
    EXPECT_EQ(refusal(tile, [&] { tile.add_edge_point(12, 0.5); }), "no-such-edge");
    EXPECT_EQ(refusal(tile, [&] { tile.remove_points(std::array{CellPointName::parse("p0:i7")}); }), "no-such-point");
    EXPECT_EQ(refusal(tile, [&] { tile.remove_points(std::array{CellPointName::parse("i0")}); }), "no-such-point");
    EXPECT_EQ(refusal(tile, [&] { tile.unconstrain(0, std::array{CellPointName::parse("v0"), CellPointName::parse("i0")}); }), "no-such-segment");
    EXPECT_EQ(refusal(tile, [&] { tile.move(std::array{0}, Vector(1)); }), "phase");
    EXPECT_EQ(refusal(tile, [&] { tile.split_triangle(0, 0, {0.2, 0.3, 0.5}); }), "phase");
    EXPECT_EQ(refusal(tile, [&] { tile.roll_back(0); }), "phase");
    EXPECT_EQ(refusal(tile, [&] { tile.set_matrix({1, 0, 0, 0, 1, 0, 0, 0, 0}); }), "flat-cell");
    EXPECT_EQ(refusal(tile, [&] { tile.set_matrix({-1, 0, 0, 0, 1, 0, 0, 0, 1}); }), "flat-cell");
    tile.shape();
    EXPECT_EQ(refusal(tile, [&] { tile.add_point(0, {2, 2}); }), "phase");
    EXPECT_EQ(refusal(tile, [&] { tile.add_edge_point(0, 0.25); }), "phase");
    EXPECT_EQ(refusal(tile, [&] { tile.move_point(CellPointName::parse("p0:i0"), {2, 2}); }), "phase");
    tile.roll_back(0);
    EXPECT_EQ(refusal(tile, [&] { tile.add_point(1, {2, 2}); }), "phase");
    EXPECT_EQ(refusal(tile, [&] { tile.move(std::array{tile.find(CellPointName::parse("p0:i0"))}, Vector(1)); }), "phase");
    EXPECT_EQ(refusal(tile, [&] { tile.split_triangle(0, 0, {0.2, 0.3, 0.5}); }), "phase");
    tile.move_point(CellPointName::parse("p0:i0"), {2, 2});
}

TEST(CellDesign, IsRefusedWhereItIsNoneOfACell)
{
    const CellDesign good = CellTile::of_kind(CellKind::cube, 10).design();
    const auto is_bad = [](CellDesign design, auto&& f) {
        f(design);
        try {
            CellTile tile(std::move(design));
        } catch (const CommandError&) {
            return true;
        }
        return false;
    };
    EXPECT_FALSE(is_bad(good, [](CellDesign&) {}));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.size = -1; }));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.size = std::nan(""); }));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.panes.pop_back(); }));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.edges.emplace_back(); }));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.edges[0] = {0.5, 0.5}; }));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.edges[0] = {1.0}; }));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.panes[0].points = {{7, 7}}; }));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.panes[0].points = {{1, 1}, {1, 1}}; }));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.panes[0].segments = {{CellPointName::parse("i0"), CellPointName::parse("v0")}}; }));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.matrix[0] = 0; }));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.moved[CellPointName::corner(0)] = Vector(1); })); // in phase 1
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.phase = 2, d.moved[CellPointName::corner(1)] = Vector(1); }));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.phase = 2, d.moved[CellPointName::parse("p0:v0")] = Vector(1); })); // has another name
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.phase = 2, d.moved[CellPointName::split(0)] = Vector(1); }));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.phase = 2, d.details.emplace_back(); })); // weights of 0
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.phase = 2, d.flat[5]; }));
    EXPECT_TRUE(is_bad(good, [](CellDesign& d) { d.phase = 2, d.flat[0].fresh = {0}; }));
}

} // namespace
} // namespace druse
