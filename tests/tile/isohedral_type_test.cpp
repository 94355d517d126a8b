#include "tile/isohedral_type.h"

#include "dlfl/errors.h"
#include "tile/tile_facts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace druse {
namespace {

using Paths = std::vector<std::vector<Point2>>; // inner points by letter

std::vector<Point2> outline(const IsohedralType& type, const CornerVector& corners, const Paths& paths)
{
    std::vector<Point2> points;
    for (int k = 0; k < type.corners; ++k) {
        const Point2 from = corner(corners, k), to = corner(corners, type.symbol.corner(k + 1));
        points.push_back(from);
        for (const Point2& p : prepared(paths[type.edges[k].path], type.edges[k].preparation)) points.push_back(on_edge(p, from, to));
    }
    return points;
}

double area(const std::vector<Point2>& polygon)
{
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        twice += p.x * q.y - p.y * q.x;
    }
    return 0.5 * twice;
}

/// ∫ |x − centroid|² over the polygon.
double polar_moment(const std::vector<Point2>& polygon)
{
    Point2 first(0.0);
    double second = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        const double cross = p.x * q.y - p.y * q.x;
        first += cross / 6.0 * (p + q);
        second += cross / 12.0 * (glm::dot(p, p) + glm::dot(p, q) + glm::dot(q, q));
    }
    return second - glm::dot(first, first) / area(polygon);
}

/// Whether no two sides meet that should not.
bool is_simple(const std::vector<Point2>& polygon)
{
    const auto side = [](const Point2& a, const Point2& b, const Point2& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); };
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j) {
            if (i == 0 && j == n - 1) continue;
            const Point2 a = polygon[i], b = polygon[i + 1], c = polygon[j], d = polygon[(j + 1) % n];
            if (side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0) return false;
        }
    return area(polygon) > 0;
}

bool contains(const std::vector<Point2>& polygon, const Point2& p)
{
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Point2 a = polygon[i], b = polygon[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    }
    return inside;
}

/// A random path of that shape, not far from straight.
std::vector<Point2> random_path(PathShape shape, std::mt19937& random)
{
    std::uniform_real_distribution<double> off(-0.1, 0.1), along(0.2, 0.4);
    const Point2 p(along(random), off(random)), q(1 - along(random), off(random));
    switch (shape) {
    case PathShape::free: return {p, q};
    case PathShape::half_turn: return {p, {1 - p.x, -p.y}};
    case PathShape::flip: return {p, {1 - p.x, p.y}};
    default: return {};
    }
}

TEST(IsohedralType, IsAsPublishedIn81Cases)
{
    EXPECT_EQ(isohedral_types().size(), std::size(test::tile_facts));
    for (const auto& facts : test::tile_facts) {
        const IsohedralType& type = isohedral_type(facts.number);
        EXPECT_EQ(type.own_name(), facts.own) << type.name();
        EXPECT_EQ(type.aspects(), facts.aspects) << type.name();
        EXPECT_EQ(type.edge_text(), facts.edges) << type.name();
        EXPECT_EQ(type.shape_text(), facts.shapes) << type.name();
        std::string parameters, freedom;
        for (int p = 0; p < static_cast<int>(type.parameters.size()); ++p) parameters += (p > 0 ? " " : "") + type.parameter_name(p);
        for (int k = 0; k < type.corners; ++k) freedom += static_cast<char>('0' + type.inside.freedom(k));
        EXPECT_EQ(parameters, facts.parameters) << type.name();
        EXPECT_EQ(freedom, facts.freedom) << type.name();
        EXPECT_EQ(type.held_translation.has_value(), facts.held.has_value()) << type.name();
        const Point2 kept = type.held_translation ? type.held_translation->at(type.start) : Point2(0.0);
        EXPECT_LT(glm::length(kept - facts.held.value_or(Point2(0.0))), 1e-12) << type.name();
    }
}

TEST(IsohedralType, AddsUpToThePublishedCounts)
{
    std::array<int, 7> by_parameters{}, by_paths{};
    std::array<int, 13> by_aspects{};
    std::array<int, 4> edges{}, colourings{}; // of colourings: 3 colours period 1 and 3, 2 colours period 1 and 2
    int draggable = 0, held = 0, mirrored = 0, heesch = 0;
    for (const IsohedralType& type : isohedral_types()) {
        ++by_parameters[type.parameters.size()];
        ++by_paths[type.shapes.size()];
        ++by_aspects[type.aspects()];
        for (const TileEdge& e : type.edges) ++edges[static_cast<int>(type.shapes[e.path])];
        if (!type.parameters.empty())
            for (int k = 0; k < type.corners; ++k) ++(type.inside.freedom(k) > 0 ? draggable : held);
        mirrored += type.has_mirrored_aspects();
        heesch += type.own.size() == 1 && std::ranges::find(type.shapes, PathShape::straight) == type.shapes.end();
        const auto& [count, period, colour] = type.colours;
        ++colourings[count == 3 ? (period == 1 ? 0 : 1) : (period == 1 ? 2 : 3)];
        EXPECT_EQ(period, count == 3 && period > 1 ? 3 : count == 2 && period > 1 ? 2 : 1) << type.name();
    }
    EXPECT_EQ(by_parameters, (std::array<int, 7>{26, 15, 21, 9, 7, 2, 1}));
    EXPECT_EQ(by_paths, (std::array<int, 7>{0, 17, 30, 26, 7, 1, 0}));
    EXPECT_EQ(by_aspects, (std::array<int, 13>{0, 17, 25, 6, 22, 0, 8, 0, 2, 0, 0, 0, 1}));
    EXPECT_EQ(edges, (std::array<int, 4>{166, 96, 18, 75})); // J S U I
    EXPECT_EQ(draggable, 155);
    EXPECT_EQ(held, 98);
    EXPECT_EQ(mirrored, 30);
    EXPECT_EQ(heesch, 28);
    EXPECT_EQ(colourings, (std::array<int, 4>{12, 26, 25, 18}));
}

TEST(IsohedralType, HasTheMeasuresOfTheReferenceTiles)
{
    for (const auto& wanted : test::tile_measures) {
        const IsohedralType& type = isohedral_type(wanted.number);
        auto values = type.default_parameters();
        for (std::size_t p = 0; p < values.size(); ++p) values[p] += p % 2 == 0 ? 0.04 : -0.04;
        Paths paths;
        for (const PathShape shape : type.shapes) {
            if (shape == PathShape::free) paths.push_back({{0.25, 0.09}, {0.6, -0.05}});
            else if (shape == PathShape::half_turn) paths.push_back({{0.3, 0.07}, {0.7, -0.07}});
            else if (shape == PathShape::flip) paths.push_back({{0.3, 0.06}, {0.7, 0.06}});
            else paths.push_back({});
        }
        const CornerVector corners = type.corners_of(values);
        const auto polygon = outline(type, corners, paths);
        EXPECT_NEAR(area(polygon), wanted.area, 1e-8) << type.name();
        EXPECT_NEAR(polar_moment(polygon), wanted.moment, 1e-8) << type.name();

        double first = 1e9, second = 1e9;
        Point2 shortest(0.0);
        const auto all = translations(type.placed, 4);
        for (const CornerShift& t : all)
            if (const double length = glm::length(t.at(corners)); length < first) {
                first = length;
                shortest = t.at(corners);
            }
        for (const CornerShift& t : all) {
            const Point2 v = t.at(corners);
            if (std::abs(v.x * shortest.y - v.y * shortest.x) > 1e-6) second = std::min(second, glm::length(v));
        }
        EXPECT_NEAR(first, wanted.first, 1e-8) << type.name();
        EXPECT_NEAR(second, wanted.second, 1e-8) << type.name();
    }
}

TEST(IsohedralType, FillsThePlaneWithRandomTiles)
{
    std::mt19937 random(61);
    for (const IsohedralType& type : isohedral_types())
        for (int round = 0, tries = 0; round < 5 && tries < 1000; ++tries) {
            auto values = type.default_parameters();
            const double reach = 0.15 * std::sqrt(std::abs(area(outline(type, type.start, Paths(type.shapes.size())))));
            for (double& v : values) v += std::uniform_real_distribution<double>(-reach, reach)(random);
            const CornerVector corners = type.corners_of(values);
            Paths paths;
            for (const PathShape shape : type.shapes) paths.push_back(random_path(shape, random));
            const auto polygon = outline(type, corners, paths);
            if (!is_simple(polygon)) continue;
            ++round;

            const Point2 a = type.placed.lattice[0].at(corners), b = type.placed.lattice[1].at(corners);
            const double det = a.x * b.y - a.y * b.x;
            EXPECT_NEAR(type.aspects() * area(polygon), det, 1e-9) << type.name();

            // A random point of the plane lies in exactly one copy.
            std::uniform_real_distribution<double> in_cell(0, 1);
            for (int sample = 0; sample < 6; ++sample) {
                const Point2 p = in_cell(random) * a + in_cell(random) * b;
                int copies = 0;
                for (const CornerMotion& m : type.placed.representatives) {
                    const CornerMotion back = inverse(m);
                    for (int i = -5; i <= 5; ++i)
                        for (int j = -5; j <= 5; ++j) copies += contains(polygon, back.apply(p - double(i) * a - double(j) * b, corners));
                }
                EXPECT_EQ(copies, 1) << type.name();
            }
            // What lies beyond an edge is the neighbour of the table: its edge runs along this one.
            for (int aspect = 0; aspect < type.aspects(); ++aspect)
                for (int k = 0; k < type.corners; ++k) {
                    const TileNeighbour& n = type.neighbours[aspect][k];
                    const auto here = [&](int c) { return type.placed.representatives[aspect].apply(corner(corners, type.symbol.corner(c)), corners); };
                    const auto there = [&](int c) {
                        return type.placed.representatives[n.aspect].apply(corner(corners, type.symbol.corner(c)), corners) + double(n.shift.i) * a +
                               double(n.shift.j) * b;
                    };
                    const double direct = glm::length(here(k) - there(n.partner + 1)) + glm::length(here(k + 1) - there(n.partner));
                    const double turned = glm::length(here(k) - there(n.partner)) + glm::length(here(k + 1) - there(n.partner + 1));
                    EXPECT_LT(std::min(direct, turned), 1e-9) << type.name() << " edge " << k;
                    EXPECT_NE(type.colours.of(aspect, 0, 0), type.colours.of(n.aspect, n.shift.i, n.shift.j)) << type.name();
                }
        }
}

TEST(IsohedralType, LetsItsOutlineFitUnderEveryMotionOfTheTiling)
{
    std::mt19937 random(62);
    for (const IsohedralType& type : isohedral_types()) {
        Paths paths;
        for (const PathShape shape : type.shapes) paths.push_back(random_path(shape, random));
        const auto edge = [&](int k) {
            const Point2 from = corner(type.start, k), to = corner(type.start, type.symbol.corner(k + 1));
            std::vector<Point2> points{from};
            for (const Point2& p : prepared(paths[type.edges[k].path], type.edges[k].preparation)) points.push_back(on_edge(p, from, to));
            points.push_back(to);
            return points;
        };
        for (const TileCrossing& c : crossings(type.symbol)) {
            // The motion is found by its ends alone; the points between must follow.
            const auto here = edge(c.edge);
            auto there = edge(c.partner);
            if (c.direct) std::ranges::reverse(there);
            const double angle = std::atan2(here.back().y - here.front().y, here.back().x - here.front().x);
            const double other = std::atan2(there.back().y - there.front().y, there.back().x - there.front().x);
            for (std::size_t i = 0; i < here.size(); ++i) {
                const auto along = [](const Point2& p, const Point2& origin, double a) {
                    const Point2 d = p - origin;
                    return Point2(std::cos(a) * d.x + std::sin(a) * d.y, std::cos(a) * d.y - std::sin(a) * d.x);
                };
                Point2 moved = along(there[i], there.front(), other);
                if (!c.direct) moved.y = -moved.y;
                EXPECT_LT(glm::length(along(here[i], here.front(), angle) - moved), 1e-9) << type.name() << " edge " << c.edge;
            }
        }
    }
}

TEST(IsohedralType, HasTheCornersOrbitsAndAspectsOfTheFirstFour)
{
    EXPECT_EQ(isohedral_type(1).corner_orbit, (std::vector<int>{0, 1, 0, 1, 0, 1}));
    EXPECT_EQ(isohedral_type(41).corner_orbit, (std::vector<int>{0, 0, 0, 0}));
    EXPECT_EQ(isohedral_type(79).corner_orbit, (std::vector<int>{0, 1, 1}));
    EXPECT_EQ(isohedral_type(31).corner_orbit, (std::vector<int>{0, 1, 2, 1}));
    // Quarter turns about corner 0, sixth turns about corner 2.
    for (const auto& [number, fixed] : {std::pair{79, 0}, std::pair{31, 2}}) {
        const IsohedralType& type = isohedral_type(number);
        for (const CornerMotion& m : type.placed.representatives)
            EXPECT_LT(glm::length(m.apply(corner(type.start, fixed), type.start) - corner(type.start, fixed)), 1e-12) << type.name();
    }
}

TEST(DragCorner, MovesTheOthersLeast)
{
    const IsohedralType& quad = isohedral_type(41);
    const auto moved = drag_corner(quad, quad.default_parameters(), 2, {1.2, 1.1});
    ASSERT_EQ(moved.parameters.size(), 2u);
    EXPECT_NEAR(moved.parameters[0], 1.2, 1e-12);
    EXPECT_NEAR(moved.parameters[1], 0.1, 1e-12);
    EXPECT_LT(glm::length(corner(quad.corners_of(moved.parameters), 3) - Point2(0, 1)), 1e-12);

    const IsohedralType& hexagon = isohedral_type(1);
    const double d = 1 - test::root3 / 2;
    const auto wide = hexagon.corners_of(drag_corner(hexagon, hexagon.default_parameters(), 2, {1, 0.5}).parameters);
    EXPECT_LT(glm::length(corner(wide, 1) - Point2(1 / test::root3 + d / 3, 0)), 1e-12);
    EXPECT_LT(glm::length(corner(wide, 5) - Point2(-1 / (2 * test::root3) - 2 * d / 3, 0.5)), 1e-12);
    EXPECT_LT(glm::length(corner(wide, 3) - corner(wide, 1) - Point2(0, 1)), 1e-12);
}

TEST(DragCorner, EndsInAnAdmissibleTileAsNearAsItCanCome)
{
    std::mt19937 random(63);
    std::uniform_real_distribution<double> off(-0.2, 0.2);
    for (const IsohedralType& type : isohedral_types()) {
        for (int k = 0; k < type.corners && !type.parameters.empty(); ++k) {
            const Point2 target = corner(type.start, k) + Point2(off(random), off(random));
            const MovedTile moved = drag_corner(type, type.default_parameters(), k, target);
            const CornerVector corners = type.corners_of(moved.parameters);
            const Point2 reached = moved.frame.world(corner(corners, k));
            // In the frame where it may, and with the frame where that holds it.
            const double gap = type.inside.freedom(k) == 1 ? 0.0 : glm::length(reached - target);
            EXPECT_LT(gap, 1e-9) << type.name() << " corner " << k;
            const CornerVector rest = plus(plus(corners, type.start, -1.0), type.inside.project(plus(corners, type.start, -1.0)), -1.0);
            for (const double x : rest) EXPECT_NEAR(x, 0.0, 1e-12) << type.name();
            if (type.inside.freedom(k) == 0) continue;
            for (const CornerVector& d : type.inside.directions)
                for (const double step : {-1e-4, 1e-4})
                    EXPECT_GE(glm::length(corner(plus(corners, d, step), k) - target), glm::length(reached - target) - 1e-9) << type.name();
        }
    }
    EXPECT_THROW(drag_corner(isohedral_type(79), {}, 0, {1, 1}), CommandError);
}

TEST(IsohedralType, TakesItsCornersFromAnotherTypeOfTheNet)
{
    // A parallelogram of IH41, seen as the rectangle-like tile of IH72 nearest to it: right angles.
    const IsohedralType& from = isohedral_type(41);
    const CornerVector corners = from.corners_of(std::vector<double>{1.5, 0.3});
    const IsohedralType& to = isohedral_type(72);
    const MovedTile near = nearest_tile(to, corners);
    const CornerVector tile = to.corners_of(near.parameters);
    const Point2 side = corner(tile, 1) - corner(tile, 0), other = corner(tile, 3) - corner(tile, 0);
    EXPECT_NEAR(glm::dot(side, other), 0.0, 1e-12);
    // A type's own tile is its own nearest one.
    const MovedTile same = nearest_tile(from, corners);
    EXPECT_NEAR(same.parameters[0], 1.5, 1e-12);
    EXPECT_NEAR(same.parameters[1], 0.3, 1e-12);
    EXPECT_NEAR(same.frame.size, 1.0, 1e-12);
}

TEST(IsohedralType, NamesItsParametersWhereTheCountIsWrong)
{
    const auto message = [](int number, std::vector<double> values) {
        try {
            (void)isohedral_type(number).corners_of(values);
        } catch (const CommandError& e) {
            return std::string(e.what());
        }
        return std::string("no error");
    };
    EXPECT_EQ(message(41, {1}), "IH41 has 2 parameters: x1 y1");
    EXPECT_EQ(message(44, {}), "IH44 has 2 parameters: x1 x3");
    EXPECT_EQ(message(79, {1}), "IH79 has no parameters");
    EXPECT_THROW(isohedral_type(19), CommandError); // its tiles need marks
    EXPECT_THROW(isohedral_type(94), CommandError);
}

} // namespace
} // namespace druse
