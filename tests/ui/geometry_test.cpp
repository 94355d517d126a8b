#include "ui/geometry.h"

#include "dlfl/errors.h"

#include <gtest/gtest.h>

namespace druse::ui {
namespace {

TEST(Geometry, IsReadAsXProgramsWriteIt)
{
    const Geometry g = Geometry::parse("1280x800+10+20");
    EXPECT_EQ(g.width, 1280);
    EXPECT_EQ(g.height, 800);
    EXPECT_EQ(g.x, 10);
    EXPECT_EQ(g.y, 20);
    EXPECT_FALSE(Geometry::parse("1280x800").x);
    EXPECT_FALSE(Geometry::parse("+1+2").width);
    EXPECT_FALSE(Geometry::parse("").width);
}

TEST(Geometry, RefusesEverythingElse)
{
    for (const char* text : {"1280", "1280x", "x800", "1280x800+1", "-3x5", "1280x800+1+2+3", "99999999999x3", "99999x99999", "wide"})
        EXPECT_THROW(Geometry::parse(text), CommandError) << text;
}

} // namespace
} // namespace druse::ui
