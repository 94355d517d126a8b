#include "graph/expression.h"

#include "dlfl/errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace druse {
namespace {

double value(std::string_view text) { return Expression(text)({.x = 3, .y = -4, .r = 5, .t = -0.5}); }

std::string complaint(std::string_view text)
{
    try {
        value(text);
    } catch (const CommandError& e) {
        return e.what();
    }
    return "(none)";
}

TEST(Expression, BindsAsMathematicsDoes)
{
    EXPECT_EQ(value("1+2*3"), 7);
    EXPECT_EQ(value("(1 + 2) * 3"), 9);
    EXPECT_EQ(value("2-3-4"), -5);
    EXPECT_EQ(value("16/4/2"), 2);
    EXPECT_EQ(value("2^3^2"), 512);
    EXPECT_EQ(value("-2^2"), -4);
    EXPECT_EQ(value("2^-1"), 0.5);
    EXPECT_EQ(value("-x*-y--r"), -7);
    EXPECT_EQ(value("x^2+y^2-r^2"), 0);
    EXPECT_EQ(value("+.5e1"), 5);
}

TEST(Expression, KnowsItsFunctionsAndNames)
{
    EXPECT_DOUBLE_EQ(value("sin(pi/6)"), 0.5);
    EXPECT_DOUBLE_EQ(value("cos(pi)"), -1);
    EXPECT_DOUBLE_EQ(value("tan(pi/4)"), 1);
    EXPECT_DOUBLE_EQ(value("log(exp(2))"), 2);
    EXPECT_EQ(value("sqrt(abs(y))"), 2);
    EXPECT_EQ(value("min(x, max(y, t))"), -0.5);
}

TEST(Expression, SaysWhereItCannotBeRead)
{
    EXPECT_EQ(complaint(" "), "expected a formula");
    EXPECT_EQ(complaint("1+"), "expected a value at the end");
    EXPECT_EQ(complaint("(1"), "expected ) at the end");
    EXPECT_EQ(complaint("1)"), "expected an operator at character 2, found ')'");
    EXPECT_EQ(complaint("2 q"), "expected an operator at character 3, found 'q'");
    EXPECT_EQ(complaint("2*foo"), "expected x, y, r, t, pi or one of sin cos tan sqrt exp log abs min max at character 3, found 'foo'");
    EXPECT_EQ(complaint("sin 3"), "expected ( after sin at character 5, found '3'");
    EXPECT_EQ(complaint("min(1)"), "expected a comma and a second value of min at character 6, found ')'");
    EXPECT_EQ(complaint("2*1e999"), "the number at character 3 is too large or too small");
    EXPECT_EQ(complaint("é"), "expected a value at character 1, found 'é'");
}

TEST(Expression, SaysWhatHasNoValue)
{
    EXPECT_EQ(complaint("1/(x+y+1)"), "1/0 is not a finite number");
    EXPECT_EQ(complaint("sqrt(y)"), "sqrt(-4) is not a finite number");
    EXPECT_EQ(complaint("log(0)"), "log(0) is not a finite number");
    EXPECT_EQ(complaint("y^0.5"), "(-4)^0.5 is not a finite number");
}

TEST(Expression, IsBoundedInDepthAndNotInLength)
{
    std::string sum = "0", deep, tall;
    for (int i = 0; i < 100000; ++i) sum += "+1";
    EXPECT_EQ(value(sum), 100000);
    for (int i = 0; i < 100; ++i) deep += "(";
    EXPECT_EQ(value(deep + "1" + std::string(100, ')')), 1);
    EXPECT_EQ(complaint(deep + "(1" + std::string(101, ')')), "nested more than 100 deep");
    EXPECT_EQ(complaint(std::string(1000000, '-') + "1"), "nested more than 100 deep");
    EXPECT_EQ(complaint(std::string(1000000, '(')), "nested more than 100 deep");
    // As many values waiting as there can be: a sum, a product and a first argument in each nesting.
    for (int i = 0; i < 99; ++i) tall += "min(1,1+1*";
    EXPECT_EQ(value("1+1*" + tall + "1" + std::string(99, ')')), 2);
}

} // namespace
} // namespace druse
