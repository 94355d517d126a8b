#include "tile/incidence_symbol.h"

#include "tile/isohedral_table.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace druse {
namespace {

TEST(IncidenceSymbol, ClosesRoundEveryCornerForAll81Types)
{
    EXPECT_EQ(tile_lines().size(), 81u);
    for (const TileLine& line : tile_lines())
        EXPECT_TRUE(closes(IncidenceSymbol::parse(tile_nets()[line.net].valences, line.tile, line.adjacency))) << "IH" << line.number;
}

TEST(IncidenceSymbol, DoesNotCloseWhereCornersOfOtherValenceMeet)
{
    // A kite whose edges at the 60° corner answer those at the 120° corner.
    EXPECT_FALSE(closes(IncidenceSymbol::parse("3 4 6 4", "a+b+c+d+", "b+a+d+c+")));
    // Three quarter turns make no full turn.
    EXPECT_FALSE(closes(IncidenceSymbol::parse("3 3 3 3", "a+b+c+d+", "b+a+d+c+")));
}

TEST(IncidenceSymbol, IsOneOf93UpToNameAndReflection)
{
    // The twelve whose tiles need marks close as well.
    const std::array<std::array<std::string, 3>, 12> marked = {{{"3 3 3 3 3 3", "a+a-a+a-a+a-", "a-"},
                                                               {"3 6 3 6", "a+b+b-a-", "a-b-"},
                                                               {"4 4 4 4", "a+b+c+d+", "a-b-c-d-"},
                                                               {"4 4 4 4", "a+b+a+b+", "a-b-"},
                                                               {"4 4 4 4", "a+a+a+a+", "a-"},
                                                               {"4 4 4 4", "ab+cb-", "ab-c"},
                                                               {"4 4 4 4", "a+a-b+b-", "a-b-"},
                                                               {"4 4 4 4", "a+a-a+a-", "a-"},
                                                               {"4 8 8", "a+b+c+", "a-b-c-"},
                                                               {"6 6 6", "a+b+c+", "a-b-c-"},
                                                               {"6 6 6", "a+a+a+", "a-"},
                                                               {"6 6 6", "ab+b-", "ab-"}}};
    for (const auto& [valences, tile, adjacency] : marked) EXPECT_TRUE(closes(IncidenceSymbol::parse(valences, tile, adjacency))) << tile << adjacency;
}

TEST(IncidenceSymbol, HasTheSymmetriesThatKeepLettersAndArrows)
{
    const auto count = [](const char* valences, const char* tile, const char* adjacency) {
        return own_symmetries(IncidenceSymbol::parse(valences, tile, adjacency)).size();
    };
    EXPECT_EQ(count("3 3 3 3 3 3", "aaaaaa", "a"), 12u);
    EXPECT_EQ(count("3 3 3 3 3 3", "a+a+a+a+a+a+", "a+"), 6u); // arrows that run round admit no reflection
    EXPECT_EQ(count("3 3 3 3 3 3", "ab+c+dc-b-", "dc-b-a"), 2u);
    EXPECT_EQ(count("4 4 4 4", "a+b+c+d+", "c+d+a+b+"), 1u);
}

} // namespace
} // namespace druse
