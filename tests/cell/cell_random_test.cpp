// Cells deformed at random, held against samples of space.
#include "cell/cell_shapes.h"
#include "cell/freedom.h"
#include "dlfl/ray_cast.h"
#include "dlfl/self_intersections.h"
#include "support/mesh_checks.h"

#include <gtest/gtest.h>

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace druse {
namespace {

constexpr CellMatrix skewed{1.2, .3, -.2, .1, .9, .25, -.15, .2, 1.4}; // det 1.36775

/// How many copies of a tile hold a place: those whose surface goes round it.
class Covering {
public:
    Covering(const CellTile& tile, const Mesh& mesh) : tile_(tile), rays_(mesh, progress_, 1), box_(bounds(mesh)), near_(cells_near(tile, make_solid(tile), 0))
    {
        near_.push_back({});
    }
    /// Whether each of some places is in one copy, once.
    bool is_single(std::mt19937& random, int samples) const
    {
        for (int s = 0; s < samples; ++s) {
            // A copy that holds a place in the box of the tile has a box that meets that one.
            const Point p(uniform(random, box_.min.x, box_.max.x), uniform(random, box_.min.y, box_.max.y), uniform(random, box_.min.z, box_.max.z));
            int sum = 0, most = 0;
            for (const LatticeStep& step : near_) {
                const Point q = p - tile_.world(tile_.cell().at(step));
                if (glm::any(glm::lessThan(q, box_.min)) || glm::any(glm::greaterThan(q, box_.max))) continue;
                const int times = rays_.winding(q, [](std::uint32_t) { return true; });
                sum += times;
                most = std::max(most, std::abs(times));
            }
            if (sum != 1 || most != 1) return false;
        }
        return true;
    }

private:
    const CellTile& tile_;
    Progress progress_;
    RayCast rays_;
    Box box_;
    std::vector<LatticeStep> near_;
};

/// Triangles whose reversed twin on a neighbour is not there, once: by orbits and steps, without rounding.
std::size_t unpaired(const CellTile& tile)
{
    using Corner = std::pair<int, LatticeStep>;
    const CellSolid solid = make_solid(tile);
    std::vector<Corner> corner_of;
    for (int i = 0; i < tile.point_count(); ++i)
        for (const LatticeStep& step : tile.members(i)) corner_of.emplace_back(i, step);
    const auto turned = [](std::array<Corner, 3> t) {
        std::ranges::rotate(t, std::ranges::min_element(t));
        return t;
    };
    std::map<std::array<Corner, 3>, int> count;
    for (const auto& [a, b, c] : solid.triangles) ++count[turned({corner_of[a], corner_of[b], corner_of[c]})];
    std::size_t alone = 0;
    for (std::size_t i = 0; i < solid.triangles.size(); ++i) {
        const LatticeStep step = tile.cell().panes[std::size_t(solid.sides[i].pane)].translation;
        std::array<Corner, 3> twin;
        for (std::size_t k = 0; k < 3; ++k) {
            twin[k] = corner_of[solid.triangles[i][2 - k]];
            twin[k].second = solid.sides[i].far ? twin[k].second + step : twin[k].second - step;
        }
        const auto found = count.find(turned(twin));
        alone += found == count.end() || found->second != 1;
    }
    return alone;
}

class EveryCellAtRandom : public testing::TestWithParam<CellKind> {};

TEST_P(EveryCellAtRandom, HasTheCountsAndVolumesOfExactArithmetic)
{
    const CellKind kind = GetParam();
    const CellTile tile = subdivided(kind);
    // V, T and orbits of a centre fan over halved edges, each triangle in four; and 1.36775 times the volume of the lattice cell.
    const std::map<CellKind, std::array<int, 3>> counts{
        {CellKind::cube, {98, 192, 37}}, {CellKind::hexprism, {146, 288, 57}}, {CellKind::fcc, {194, 384, 81}}, {CellKind::elongated, {226, 448, 93}}, {CellKind::bcc, {290, 576, 121}}};
    const std::map<CellKind, double> volumes{
        {CellKind::cube, 1.36775}, {CellKind::hexprism, 1.36775 * std::sqrt(3.0) / 2}, {CellKind::fcc, 21.884}, {CellKind::elongated, 43.768}, {CellKind::bcc, 43.768}};
    std::mt19937 random(11);
    CellTile moved = shaken(tile, 0.15 * shortest_edge(kind), random);
    moved.set_matrix(skewed);
    const Mesh mesh = mesh_of(moved);
    EXPECT_EQ((std::array{int(mesh.vertex_count()), int(mesh.face_count()), moved.point_count()}), counts.at(kind));
    EXPECT_NEAR(volume(mesh), volumes.at(kind), 1e-9 * volumes.at(kind));
    EXPECT_NEAR(moved.volume(), volumes.at(kind), 1e-9 * volumes.at(kind));
    EXPECT_EQ(genus(mesh), 0);
}

TEST_P(EveryCellAtRandom, FillsSpaceOnceWhereItsSurfaceDoesNotMeetItself)
{
    const CellKind kind = GetParam();
    const CellTile tile = subdivided(kind);
    std::mt19937 random(static_cast<unsigned>(kind) + 1);
    int embedded = 0, pierced = 0, seen = 0;
    for (int round = 0; round < 200; ++round) {
        SCOPED_TRACE(round);
        const double part = round % 4 == 0 ? 0.05 : round % 4 == 1 ? 0.15 : round % 4 == 2 ? 0.45 : 1.8;
        CellTile moved = shaken(tile, part * shortest_edge(kind), random);
        if (round % 2 == 1) moved.set_matrix(skewed);
        Progress progress;
        const CellCheck found = check(moved, {.directions = false}, progress);
        const Mesh mesh = mesh_of(moved);
        EXPECT_NEAR(volume(mesh), moved.volume(), 1e-9 * moved.volume());
        EXPECT_LE(found.pane_mismatch, 1e-12 * moved.size() * 10);
        EXPECT_EQ(unpaired(moved), 0u);
        EXPECT_EQ(found.genus, 0);
        EXPECT_EQ(found.faults.size(), found.pierced.size());
        const bool single = Covering(moved, mesh).is_single(random, part > 1 ? 60 : 8);
        if (found.self_intersections == 0) {
            ++embedded;
            EXPECT_TRUE(single);
        } else {
            ++pierced;
            seen += !single;
            // A pane that is met is that of a neighbour across it.
            for (const auto& p : found.pierced) EXPECT_EQ(p.neighbour, p.side.far ? -moved.cell().panes[std::size_t(p.side.pane)].translation : moved.cell().panes[std::size_t(p.side.pane)].translation);
        }
    }
    EXPECT_GE(embedded, 50);
    EXPECT_GE(pierced, 50);
    EXPECT_GE(seen, 25); // places in 2, 3 or 5 copies
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryCellAtRandom, testing::ValuesIn(every_cell), [](const auto& made) { return std::string(name(made.param)); });

} // namespace
} // namespace druse
