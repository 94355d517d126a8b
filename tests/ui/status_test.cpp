#include "ui/facts_panel.h"
#include "ui/session.h"
#include "ui/status_bar.h"

#include "app/registry.h"

#include <gtest/gtest.h>

#include <fstream>

namespace druse::ui {
namespace {

std::string line(const Session& session)
{
    std::string text;
    for (const StatusPart& part : status_parts(session.display(), "mm")) text += (text.empty() ? "" : " | ") + std::string(part.warns ? "! " : "") + part.text;
    return text;
}

TEST(Status, ToldOfTwoSolids)
{
    Session session(all_operators());
    session.run("make.cube size=2");
    session.wait();
    EXPECT_EQ(line(session), "V 8  E 12  F 6 | genus 0 | parts 1 | watertight | 2×2×2 mm | sel 6");
    session.run("make.torus nu=3 nv=3");
    session.wait();
    EXPECT_EQ(line(session).substr(0, 49), "V 17  E 30  F 15 | genus 1 (0, 1) | parts 2 | wat");
}

TEST(Status, WarnsOfAnOpenModel)
{
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "druse_open.obj";
    std::ofstream(file) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    Session session(all_operators());
    session.open(file);
    session.wait();
    EXPECT_NE(line(session).find("! 3 open edges"), std::string::npos);
    EXPECT_EQ(print_facts(session.display(), "mm").front().tone, Fact::Tone::warning);
}

TEST(Status, OfAnEmptyDocumentSaysNoMoreThanThat)
{
    Session session(all_operators());
    EXPECT_EQ(line(session), "V 0  E 0  F 0 | sel 0");
    EXPECT_EQ(print_facts(session.display(), "mm").size(), 1u);
}

} // namespace
} // namespace druse::ui
