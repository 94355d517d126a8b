#include "ui/palette.h"

#include <gtest/gtest.h>

namespace druse::ui {
namespace {

TEST(Palette, FindsEntriesThatHoldAllWordsAndThoseThatBeginSoFirst)
{
    const std::vector<PaletteEntry> entries{{"Undo", "Edit", {}}, {"remesh.doo_sabin", "cut corners and edges", {}}, {"extrude.cubical", "Raise a box", {}}, {"Edges", "View", {}}};
    EXPECT_EQ(find_entries(entries, "").size(), 4u);
    const auto found = find_entries(entries, "edges");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0]->label, "Edges");
    EXPECT_EQ(find_entries(entries, "CUT remesh").size(), 1u);
    EXPECT_EQ(find_entries(entries, "doo_sabin").size(), 1u);
    EXPECT_TRUE(find_entries(entries, "nothing").empty());
}

} // namespace
} // namespace druse::ui
