#include "ui/arguments.h"

#include "app/registry.h"

#include <gtest/gtest.h>

namespace druse::ui {
namespace {

TEST(Arguments, NameOnlyWhatDiffersFromTheDefaults)
{
    Arguments a(all_operators().get("extrude.cubical"));
    EXPECT_EQ(a.command(), "extrude.cubical");
    a.set("angle", "80");
    EXPECT_EQ(a.command(), "extrude.cubical angle=80");
    EXPECT_EQ(a.command({{"faces", "3"}}), "extrude.cubical faces=3 angle=80");
    a.set("angle", "90");
    EXPECT_EQ(a.command(), "extrude.cubical");
}

TEST(Arguments, RefuseWhatTheOperatorWouldRefuse)
{
    Arguments a(all_operators().get("extrude.cubical"));
    EXPECT_THROW(a.set("angle", "270"), CommandError);
    EXPECT_THROW(a.set("angle", "steep"), CommandError);
    EXPECT_THROW(a.set("grouped", "maybe"), CommandError);
    EXPECT_EQ(a.command(), "extrude.cubical");
}

TEST(Arguments, LeaveOutASwitchThatIsOffAndMayStayUnset)
{
    Arguments a(all_operators().get("group.by"));
    a.set("absolute", "true");
    EXPECT_EQ(a.command(), "group.by absolute=true");
    a.set("absolute", "false"); // which is refused beside another rule than sides
    EXPECT_EQ(a.command(), "group.by");
}

TEST(Arguments, LeaveOutWhatDoesNotCountAndKeepIt)
{
    Arguments a(all_operators().get("graph.map"));
    EXPECT_TRUE(a.counts("size"));
    EXPECT_FALSE(a.counts("turns"));
    a.set("to", "helix");
    a.set("turns", "3");
    EXPECT_TRUE(a.counts("turns"));
    EXPECT_EQ(a.command(), "graph.map to=helix turns=3");
    a.set("to", "torus");
    EXPECT_EQ(a.command(), "graph.map to=torus");
    a.set("to", "helix");
    EXPECT_EQ(a.command(), "graph.map to=helix turns=3");
}

TEST(Arguments, QuoteWhatACommandMustQuote)
{
    Arguments a(all_operators().get("document.open"));
    a.set("file", "my models/cube.obj");
    EXPECT_EQ(a.command(), "document.open file=\"my models/cube.obj\"");
}

} // namespace
} // namespace druse::ui
