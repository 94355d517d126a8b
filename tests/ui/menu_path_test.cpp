#include "ui/menu.h"

#include "app/registry.h"

#include <gtest/gtest.h>

#include <set>

namespace druse::ui {
namespace {

TEST(MenuPaths, PutFamiliesWhereOneLooksForThem)
{
    EXPECT_EQ(menu_path(all_operators().get("extrude.dodecahedral")), "Extrude/Dodecahedral");
    EXPECT_EQ(menu_path(all_operators().get("mesh.transform")), "Edit/Mesh/Transform");
    EXPECT_EQ(menu_path(all_operators().get("face.start")), "Edit/Face/Start");
    EXPECT_EQ(menu_path(all_operators().get("check.manifold")), "Edit/Check/Manifold");
}

TEST(MenuPaths, AreDifferentForAllOperators)
{
    std::set<std::string> paths;
    for (const Operator& op : all_operators().operators()) EXPECT_TRUE(paths.insert(menu_path(op)).second) << op.name;
}

} // namespace
} // namespace druse::ui
