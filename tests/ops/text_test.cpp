#include "ops/text.h"

#include "dlfl/errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace druse {
namespace {

TEST(NumberText, IsTheShortestThatReadsBackTheSame)
{
    EXPECT_EQ(number_text(0.1), "0.1");
    EXPECT_EQ(number_text(1), "1");
    EXPECT_EQ(number_text(-0.0), "0");
    EXPECT_EQ(number_text(1e300), "1e+300");
    EXPECT_EQ(number_text(116.565051177078), "116.565051177078");
    std::mt19937_64 random(1);
    for (int i = 0; i < 10000; ++i) {
        const double x = std::ldexp(double(random()), int(random() % 600) - 300);
        EXPECT_EQ(parse_number(number_text(x)), x);
        EXPECT_EQ(parse_number(number_text(-x)), -x);
    }
}

TEST(ParseNumber, TakesFiniteNumbersAndNothingBesides)
{
    EXPECT_EQ(parse_number("1e-3"), 0.001);
    EXPECT_EQ(parse_number("+2"), 2);
    EXPECT_EQ(parse_number("-.5"), -0.5);
    EXPECT_EQ(parse_integer("-4"), -4);
    EXPECT_EQ(parse_id("4294967295"), 4294967295u);
    for (const char* text : {"", " ", "1 ", " 1", "1,5", "nan", "inf", "1e999", "0x10", "1.2.3", "--1", "+-1", "one"})
        EXPECT_THROW(parse_number(text), CommandError) << text;
    for (const char* text : {"", "1.5", "1e3", "+-1", "99999999999999999999"}) EXPECT_THROW(parse_integer(text), CommandError) << text;
    for (const char* text : {"", "-1", "+1", "1.0", "4294967296"}) EXPECT_THROW(parse_id(text), CommandError) << text;
}

TEST(Split, GivesWhatLiesBetweenSeparators)
{
    using Pieces = std::vector<std::string_view>;
    EXPECT_EQ(split("", ','), Pieces());
    EXPECT_EQ(split("a", ','), (Pieces{"a"}));
    EXPECT_EQ(split("a,b", ','), (Pieces{"a", "b"}));
    EXPECT_EQ(split(",a,,b,", ','), (Pieces{"", "a", "", "b", ""}));
}

TEST(Nearest, FindsAWordWithALetterWrongMissingOrSwapped)
{
    const std::vector<std::string> words{"heights", "angle", "iterations", "grouped", "groups"};
    EXPECT_EQ(nearest("height", words), "heights");
    EXPECT_EQ(nearest("agnle", words), "angle");
    EXPECT_EQ(nearest("iteration", words), "iterations");
    EXPECT_EQ(nearest("iter", words), "iterations");
    EXPECT_EQ(nearest("zebra", words), "");
    EXPECT_EQ(nearest("", words), "");
    EXPECT_EQ(nearest(std::string(100000, 'x'), words), "");
}

TEST(Listing, ReadsLikeASentence)
{
    EXPECT_EQ(listing({}), "");
    EXPECT_EQ(listing({"a"}), "a");
    EXPECT_EQ(listing({"a", "b"}), "a or b");
    EXPECT_EQ(listing({"a", "b", "c"}, "and"), "a, b and c");
}

} // namespace
} // namespace druse
