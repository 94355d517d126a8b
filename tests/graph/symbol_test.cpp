#include "graph/symbol.h"

#include "graph/hyperbolic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <ostream>
#include <string>

namespace druse {
namespace {

using Config = std::vector<int>;

std::string text_of(const AdjacencySymbol& symbol)
{
    std::string text;
    for (const auto& [slot, mirrored] : symbol.partners) text.append(text.empty() ? "" : " ").append(std::to_string(slot)).append(mirrored ? "-" : "");
    return text;
}

/// From the literature: adjacency symbols of Grünbaum & Shephard 1987 in words of slots, and edges from sum of angles = 2 pi.
struct Known {
    Config config;
    double length;
    const char* symbol;
    std::size_t symmetries; // of a vertex
    friend std::ostream& operator<<(std::ostream& out, const Known& k) { return out << k.symbol; }
};

const std::vector<Known> known_configs{
    {{7, 7, 7}, 0.566256306735316, "0 0 0", 6},
    {{7, 6, 6}, 0.334395172866447, "1 0 2", 2},
    {{3, 3, 3, 3, 3, 3, 3}, 1.090549663507087, "0 0 0 0 0 0 0", 14},
    {{5, 4, 5, 4}, 0.767197218251319, "1 0 1 0", 4},
    {{5, 3, 4, 3, 3}, 0.567555402087097, "1 0 3 2 4", 1},
    {{3, 7, 3, 7}, 0.491993281103791, "1 0 1 0", 4},
    {{3, 4, 7, 4}, 0.364428760057047, "1 0 3 2", 2},
    {{4, 6, 14}, 0.208860914238967, "0- 1- 2-", 1},
    {{3, 3, 3, 3, 7}, 0.375456990727297, "4 1 3 2 0", 1},
    {{3, 14, 14}, 0.262934492152840, "1 0 2", 2},
};

class KnownConfig : public testing::TestWithParam<Known> {};
INSTANTIATE_TEST_SUITE_P(Symbol, KnownConfig, testing::ValuesIn(known_configs));

TEST_P(KnownConfig, HasItsSymbolAndTheLengthOfItsEdges)
{
    const Known& known = GetParam();
    EXPECT_EQ(geometry_of(known.config), Geometry::hyperbolic);
    EXPECT_NEAR(edge_length(known.config), known.length, 1e-12);
    const auto symbol = find_symbol(known.config);
    ASSERT_TRUE(symbol);
    EXPECT_EQ(text_of(*symbol), known.symbol);
    EXPECT_EQ(symbol->stabiliser.size(), known.symmetries);
    for (int corner = 0; corner < int(known.config.size()); ++corner) EXPECT_EQ(known.config[std::size_t(corner)] % symbol->period(corner), 0);
}

TEST(Symbol, IsMirroredUnlessTheTessellationIsChiral)
{
    const auto mirrored = [](const Config& config, int corner) { return find_symbol(config)->is_mirrored_at(corner); };
    EXPECT_TRUE(mirrored({7, 7, 7}, 0));
    EXPECT_TRUE(mirrored({7, 6, 6}, 0));
    EXPECT_FALSE(mirrored({7, 6, 6}, 1)); // to one side of it lies a heptagon, to the other a hexagon
    EXPECT_TRUE(mirrored({5, 4, 5, 4}, 0));
    for (int corner = 0; corner < 5; ++corner) EXPECT_FALSE(mirrored({5, 3, 4, 3, 3}, corner));
}

TEST(Symbol, RepeatsAroundAHexagonBetweenHeptagonsAndHexagonsEveryOtherCorner)
{
    EXPECT_EQ(find_symbol(Config{7, 7, 7})->period(0), 1);
    EXPECT_EQ(find_symbol(Config{7, 6, 6})->period(0), 1);
    EXPECT_EQ(find_symbol(Config{7, 6, 6})->period(1), 2);
    EXPECT_EQ(find_symbol(Config{4, 6, 14})->period(2), 2);
}

TEST(Symbol, IsNotFoundWhereNoTessellationIsVertexUniform)
{
    for (const Config& config : {Config{5, 5, 5, 4}, {6, 7, 7}, {8, 7, 7}, {3, 3, 3, 5, 5}, {3, 3, 4, 4, 5}, {4, 4, 3, 4, 5}, {3, 3, 4, 5, 4}}) {
        EXPECT_EQ(geometry_of(config), Geometry::hyperbolic);
        EXPECT_FALSE(find_symbol(config));
    }
}

TEST(Symbol, IsLookedForQuicklyAlsoAmongTwelvePolygons)
{
    // The searches that go furthest: nearly all polygons are the same, and what is left fits nowhere.
    EXPECT_FALSE(find_symbol(Config{7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 5, 9}));
    EXPECT_TRUE(find_symbol(Config(12, 40)));
}

TEST(Hyperbolic, IsDecidedExactly)
{
    EXPECT_EQ(geometry_of(Config{3, 3, 3}), Geometry::spherical);
    EXPECT_EQ(geometry_of(Config{3, 3, 4, 3, 4}), Geometry::euclidean);
    EXPECT_EQ(geometry_of(Config{3, 7, 40}), Geometry::spherical);
    EXPECT_EQ(geometry_of(Config{4, 5, 20}), Geometry::euclidean);
    EXPECT_EQ(geometry_of(Config{4, 5, 21}), Geometry::hyperbolic);
    EXPECT_EQ(geometry_of(Config{3, 3, 3, 3, 3, 3}), Geometry::euclidean);
}

TEST(Hyperbolic, PolygonsHaveAnglesThatMakeAFullTurn)
{
    for (const Config& config : {Config{4, 5, 21}, {3, 3, 3, 3, 7}, Config(12, 40)}) {
        double sum = 0;
        for (const int p : config) sum += interior_angle(p, edge_length(config));
        EXPECT_NEAR(sum, 2 * std::numbers::pi, 4e-15 * double(config.size()));
    }
}

} // namespace
} // namespace druse
