#include "io/scan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

namespace druse {
namespace {

std::string line(const std::string& text)
{
    return text + "\n" + std::string(16, ' ');
}

/// The number that is all of `text`, or NaN.
double number(const std::string& text)
{
    const std::string padded = line(text);
    double value = 0;
    const char* end = scan::number(padded.c_str(), value);
    return end == padded.c_str() + text.size() ? value : std::nan("");
}

TEST(ScanNumber, AgreesWithTheStandardLibraryToTheLastBit)
{
    std::mt19937_64 random(1);
    for (int i = 0; i < 200000; ++i) {
        std::string text = random() % 2 ? "-" : "";
        for (std::size_t k = 1 + random() % 19; k > 0; --k) text += static_cast<char>('0' + random() % 10);
        if (random() % 4) {
            text += '.';
            for (std::size_t k = random() % 19; k > 0; --k) text += static_cast<char>('0' + random() % 10);
        }
        if (random() % 3 == 0) text += (random() % 2 ? "e" : "E-") + std::to_string(random() % 40);
        ASSERT_EQ(number(text), std::strtod(text.c_str(), nullptr)) << text;
    }
}

TEST(ScanNumber, ReadsEveryFormOfANumber)
{
    EXPECT_EQ(number("0"), 0);
    EXPECT_TRUE(std::signbit(number("-0")));
    EXPECT_EQ(number("+1"), 1);
    EXPECT_EQ(number(".5"), 0.5);
    EXPECT_EQ(number("5."), 5);
    EXPECT_EQ(number("1e3"), 1000);
    EXPECT_EQ(number("1E+3"), 1000);
    EXPECT_EQ(number("25e-1"), 2.5);
    EXPECT_EQ(number("00000000000000000000000001"), 1);
    EXPECT_EQ(number("0.1000000000000000055511151231257827021181583404541015625"), 0.1);
    EXPECT_EQ(number("1.7976931348623157e308"), 1.7976931348623157e308);
}

TEST(ScanNumber, TakesWhatIsTooSmallForADoubleAsNothing)
{
    EXPECT_EQ(number("1e-400"), 0);
    EXPECT_EQ(number("-1e-999999999"), 0);
    EXPECT_EQ(number("0." + std::string(400, '0') + "1"), 0);
    EXPECT_EQ(number("5e-324"), 5e-324);
}

TEST(ScanNumber, RefusesWhatIsNoFiniteNumber)
{
    for (const char* text :
         {"", "-", "+", ".", "e5", "1e", "1e+", "nan", "inf", "-inf", "NAN", "abc", "--1", "1e400", "1e999999999", "-2e308"})
        EXPECT_TRUE(std::isnan(number(text))) << text;
    EXPECT_TRUE(std::isnan(number("1" + std::string(400, '0'))));
}

TEST(ScanNumber, StopsWhereTheNumberEnds)
{
    const std::string text = line("1.5/2");
    double value = 0;
    EXPECT_EQ(scan::number(text.c_str(), value), text.c_str() + 3);
    EXPECT_EQ(value, 1.5);
}

TEST(ScanInteger, ReadsSignsAndManyDigits)
{
    const auto integer = [](const std::string& text) {
        std::int64_t value = -7;
        const std::string padded = line(text);
        return scan::integer(padded.c_str(), value) ? value : -7;
    };
    EXPECT_EQ(integer("0"), 0);
    EXPECT_EQ(integer("12345678"), 12345678);
    EXPECT_EQ(integer("1234567890123"), 1234567890123);
    EXPECT_EQ(integer("-12"), -12);
    EXPECT_EQ(integer("+12"), 12);
    EXPECT_EQ(integer("99999999999999999999999999"), 1000000000000000000);
    EXPECT_EQ(integer("-99999999999999999999999999"), -1000000000000000000);
    EXPECT_EQ(integer("-"), -7);
    EXPECT_EQ(integer("x"), -7);
}

TEST(ScanBlanks, FollowsALineThatGoesOnAfterABackslash)
{
    const std::string text = line(" \t\\\n \\\r\n7");
    long lines = 1;
    EXPECT_EQ(*scan::skip_blanks(text.c_str(), lines), '7');
    EXPECT_EQ(lines, 3);
}

TEST(QuotedWord, ShowsNothingThatATerminalWouldObey)
{
    EXPECT_EQ(scan::quoted_word("foo bar\n"), "'foo'");
    EXPECT_EQ(scan::quoted_word("\n"), "the end of the line");
    EXPECT_EQ(scan::quoted_word("a\x1b[2J\n"), "'a?[2J'");
    EXPECT_EQ(scan::quoted_word((std::string(100, 'x') + "\n").c_str()), "'" + std::string(40, 'x') + "…'");
}

} // namespace
} // namespace druse
