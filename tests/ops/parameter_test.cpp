// Parameters: what text each type takes, and what it says when it does not.
#include "ops/parameter.h"

#include <gtest/gtest.h>

namespace druse {
namespace {

struct All {
    double number = 1.5;
    int integer = 3;
    bool toggle = false;
    enum class Word { one, two } word = Word::two;
    std::array<double, 3> three{1, 2, 3};
    std::array<double, 1> single{1};
    std::vector<int> list{4};
    std::optional<double> unset;
    OrWord<double> number_or_word = "auto";
    Point point{1, 2, 3};
    Colour colour{1, 2, 3};
    std::string text = "a b";
    EdgeId edge;
    CornerId corner;
};

template <class T>
std::string set(T All::*member, const char* text, Domain domain = {})
{
    const Parameter p = make_parameter<All>(member, "p", "help", std::move(domain));
    All all;
    try {
        p.set(&all, text);
    } catch (const CommandError& e) {
        return e.what();
    }
    return "= " + p.text(&all);
}

TEST(Parameter, TakesNumbersInTheirRange)
{
    EXPECT_EQ(set(&All::number, "0.25"), "= 0.25");
    EXPECT_EQ(set(&All::number, "x"), "expected a number");
    EXPECT_EQ(set(&All::number, "180", {Unit::degrees, {1, 179}, {}, {}}), "expected 1 to 179 degrees");
    EXPECT_EQ(set(&All::number, "179", {Unit::degrees, {1, 179}, {}, {}}), "= 179");
    EXPECT_EQ(set(&All::number, "0", {Unit::ratio, nonzero(-100, 100), {}, {}}), "expected -100 to 100, not 0");
    EXPECT_EQ(set(&All::number, "0", {Unit::ratio, nonzero(), {}, {}}), "expected any number but 0");
    EXPECT_EQ(set(&All::number, "0.5", {Unit::ratio, between(0, 0.5), {}, {}}), "expected between 0 and 0.5, both excluded");
    EXPECT_EQ(set(&All::number, "0", {Unit::length, above(0), {}, {}}), "expected above 0 model units");
    EXPECT_EQ(set(&All::number, "nan"), "expected a number");
    EXPECT_EQ(set(&All::integer, "2.5"), "expected an integer");
    EXPECT_EQ(set(&All::integer, "99999999999"), "expected an integer");
    EXPECT_EQ(set(&All::integer, "0", {Unit::count, {1, 20}, {}, {}}), "expected 1 to 20 (an integer)");
}

TEST(Parameter, TakesWordsAndSwitches)
{
    const Domain domain{Unit::none, {}, {}, {"one", "two"}};
    EXPECT_EQ(set(&All::word, "one", domain), "= one");
    EXPECT_EQ(set(&All::word, "three", domain), "expected one or two");
    EXPECT_EQ(set(&All::toggle, "true"), "= true");
    EXPECT_EQ(set(&All::toggle, "1"), "expected true or false");
    EXPECT_EQ(set(&All::number_or_word, "auto", {Unit::none, {}, {}, {"auto"}}), "= auto");
    EXPECT_EQ(set(&All::number_or_word, "2", {Unit::none, {}, {}, {"auto"}}), "= 2");
    EXPECT_EQ(set(&All::number_or_word, "x", {Unit::none, {}, {}, {"auto"}}), "expected a number, or auto");
}

TEST(Parameter, TakesListsOfTheirLength)
{
    EXPECT_EQ(set(&All::three, "1,0.5,0.25"), "= 1,0.5,0.25");
    EXPECT_EQ(set(&All::three, "1,2"), "expected 3 numbers, found 2");
    EXPECT_EQ(set(&All::three, ""), "expected 3 numbers, found 0");
    EXPECT_EQ(set(&All::three, "1,2,x"), "expected a number");
    EXPECT_EQ(set(&All::single, "1,2"), "expected 1 number, found 2");
    EXPECT_EQ(make_parameter<All>(&All::single, "p", "help", Domain{}).type_text(), "1 number");
    EXPECT_EQ(set(&All::list, "7,8,9"), "= 7,8,9");
    EXPECT_EQ(set(&All::list, ""), "expected integers with commas");
    EXPECT_EQ(set(&All::list, "1,2,3", {Unit::none, {}, {1, 2}, {}}), "expected 1 to 2 integers, found 3");
}

TEST(Parameter, TakesPointsColoursAndIds)
{
    EXPECT_EQ(set(&All::point, "1,2"), "= 1,2,0");
    EXPECT_EQ(set(&All::point, "1,2,-3.5"), "= 1,2,-3.5");
    EXPECT_EQ(set(&All::point, "1"), "expected a point x,y,z");
    EXPECT_EQ(set(&All::point, "1,2,3,4"), "expected a point x,y,z");
    EXPECT_EQ(set(&All::colour, "#FF8000"), "= #ff8000");
    EXPECT_EQ(set(&All::colour, "red"), "expected a colour #rrggbb");
    EXPECT_EQ(set(&All::edge, "4~9"), "= 4~9");
    EXPECT_EQ(set(&All::edge, "12"), "= 12");
    EXPECT_EQ(set(&All::edge, "4~"), "expected an edge id, or its two end vertices like 4~9");
    EXPECT_EQ(set(&All::corner, "3:0"), "= 3:0");
    EXPECT_EQ(set(&All::corner, "3"), "expected a corner FACE:K");
}

TEST(Parameter, MayStayUnset)
{
    const Parameter p = make_parameter<All>(&All::unset, "p", "help", Domain{});
    All all;
    EXPECT_TRUE(p.optional);
    EXPECT_EQ(p.default_text, "");
    EXPECT_EQ(p.text(&all), "");
    p.set(&all, "2");
    EXPECT_EQ(p.text(&all), "2");
}

TEST(Range, ReadsLikeASentence)
{
    EXPECT_EQ((Range{1, 179}).text(), "1 to 179");
    EXPECT_EQ((Range{-1e6, 2.5}).text(), "-1000000 to 2.5");
    EXPECT_EQ(above(0).text(), "above 0");
    EXPECT_EQ(at_least(2).text(), "2 or more");
    EXPECT_EQ((Range{0, 1, true, false}).text(), "above 0, up to 1");
    EXPECT_EQ((Range{0, 1, false, true}).text(), "0 or more, below 1");
    EXPECT_EQ((Range{3, 3}).text(), "3");
    EXPECT_EQ(Range().text(), "");
    EXPECT_FALSE((Range{0, 1}).contains(std::nan("")));
}

} // namespace
} // namespace druse
