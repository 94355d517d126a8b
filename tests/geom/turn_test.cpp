#include "geom/turn.h"

#include <gtest/gtest.h>

namespace druse {
namespace {

TEST(Turn, IsTheCosineAndSineOfAFractionOfATurn)
{
    for (const std::int64_t n : {1, 2, 3, 4, 5, 7, 8, 12, 360, 1000003})
        for (std::int64_t i = -3; i < 40; ++i) {
            const double angle = 2 * std::numbers::pi * double(i) / double(n);
            EXPECT_NEAR(turn(i, n).x, std::cos(angle), 1e-13);
            EXPECT_NEAR(turn(i, n).y, std::sin(angle), 1e-13);
        }
}

TEST(Turn, IsExactWhereTheNumbersAre)
{
    EXPECT_EQ(turn(1, 4), Point2(0, 1));
    EXPECT_EQ(turn(2, 4), Point2(-1, 0));
    EXPECT_EQ(turn(-1, 4), Point2(0, -1));
    EXPECT_EQ(turn(1, 12).y, 0.5);
    EXPECT_EQ(turn(1, 6).x, 0.5);
    EXPECT_EQ(turn(1, 8).x, turn(1, 8).y);
    EXPECT_EQ(turn_by_degrees(-450), Point2(0, -1));
    EXPECT_EQ(turn_by_degrees(210), Point2(-std::sqrt(0.75), -0.5));
}

TEST(Turn, MirrorsToTheLastDigit)
{
    for (std::int64_t i = 0; i < 100; ++i) {
        EXPECT_EQ(turn(i, 100).x, turn(100 - i, 100).x);
        EXPECT_EQ(turn(i, 100).y, -turn(100 - i, 100).y);
        EXPECT_EQ(turn(i, 100), -turn(i + 50, 100));
        EXPECT_EQ(turn(i, 100).x, turn(i + 25, 100).y);
    }
}

TEST(TurnByDegrees, TakesAnyAngle)
{
    EXPECT_NEAR(turn_by_degrees(12.5).y, std::sin(12.5 * std::numbers::pi / 180), 1e-16);
    EXPECT_NEAR(glm::length(turn_by_degrees(1e300)), 1, 1e-15);
}

} // namespace
} // namespace druse
