#include "app/command.h"

#include "dlfl/errors.h"

#include <gtest/gtest.h>

namespace druse {
namespace {

enum class Mood { calm, wild };

struct Everything {
    double size = 1.5;
    int count = 2;
    bool on = false;
    Mood mood = Mood::calm;
    std::array<double, 2> pair{1.0, 2.0};
    std::string name;
    FilePath file;
    Colour colour{255, 0, 0};
    FaceSelector faces;
    std::optional<int> shift, vertex;
};

Registry some_operators()
{
    const auto nothing = [](Scene&, const auto&, Context&) {};
    Registry r;
    r.add(define<Everything>("test.everything", "Takes a bit of everything")
              .param(&Everything::size, "size", Unit::length, above(0), "how large")
              .param(&Everything::count, "count", Unit::count, {1, 9}, "how many")
              .param(&Everything::on, "on", "whether")
              .param(&Everything::mood, "mood", words({"calm", "wild"}), "how")
              .param(&Everything::pair, "pair", Unit::ratio, {}, "two")
              .param(&Everything::name, "name", "what it is called")
              .param(&Everything::file, "file", "from where")
              .param(&Everything::colour, "colour", "in which colour")
              .param(&Everything::faces, "faces", "which faces")
              .preset("large", "size=100 mood=wild")
              .alias("test.all")
              .run(nothing));
    r.add(define<Everything>("test.one_of", "Takes one of two")
              .param(&Everything::shift, "shift", Unit::count, {}, "by how much")
              .param(&Everything::vertex, "vertex", Unit::count, {}, "where")
              .exactly_one({"shift", "vertex"})
              .run(nothing));
    r.add(define<Everything>("test.governed", "Takes what its mood takes")
              .param(&Everything::mood, "mood", words({"calm", "wild"}), "how")
              .param(&Everything::count, "count", Unit::count, {1, 9}, "how many")
              .param(&Everything::size, "size", Unit::length, above(0), "how large")
              .only_where("mood", {"wild"})
              .run(nothing));
    r.add(define<Everything>("test.required", "Takes a file").param(&Everything::file, "file", "from where").required().run(nothing));
    r.add(define<NoParameters>("test.nothing", "Takes nothing").run(nothing));
    return r;
}

class Commands : public testing::Test {
protected:
    std::string canonical(std::string_view line) const { return bind(registry_, parse_command(line)).text(); }
    std::string complaint(std::string_view line) const
    {
        try {
            return "no complaint: " + canonical(line);
        } catch (const CommandError& e) {
            return e.what();
        }
    }
    Everything values(std::string_view line) const
    {
        return *static_cast<const Everything*>(bind(registry_, parse_command(line)).parameters.get());
    }

    const Registry registry_ = some_operators();
};

TEST_F(Commands, AreANameAndArguments)
{
    const Command c = parse_command("  make.cube\tsize=2  name=a=b ");
    EXPECT_EQ(c.name, "make.cube");
    using Argument = std::pair<std::string, std::string>;
    EXPECT_EQ(c.arguments, (std::vector<Argument>{{"size", "2"}, {"name", "a=b"}}));
}

TEST_F(Commands, MayBeEmptyOrCommentsOnly)
{
    for (const char* line : {"", "   ", "\t", "# make.cube", "  #make.cube"}) EXPECT_EQ(parse_command(line).name, "") << line;
}

TEST_F(Commands, EndAtACommentThatBeginsAWord)
{
    const Command c = parse_command("make.cube size=2 # not name=x");
    ASSERT_EQ(c.arguments.size(), 1u);
    EXPECT_EQ(c.arguments[0].second, "2");
}

TEST_F(Commands, TakeColoursWithoutQuotes)
{
    EXPECT_EQ(values("test.everything colour=#2b73ff").colour, (Colour{0x2b, 0x73, 0xff}));
    EXPECT_EQ(canonical("test.everything colour=\"#2B73FF\""), "test.everything colour=#2b73ff");
}

TEST_F(Commands, TakeQuotedValuesWithBlanksQuotesAndBackslashes)
{
    EXPECT_EQ(values(R"(test.everything name="a \"b\" \\ #c")").name, R"(a "b" \ #c)");
    EXPECT_EQ(values(R"(test.everything name="")").name, "");
    EXPECT_EQ(values(R"(test.everything name=C:\x)").name, R"(C:\x)");
}

TEST_F(Commands, AreWrittenWithTheFirstNameAndInRegisteredOrder)
{
    EXPECT_EQ(canonical("test-all on=true count=+3 size=1e0"), "test.everything size=1 count=3 on=true");
    EXPECT_EQ(canonical("everything"), "test.everything");
    EXPECT_EQ(canonical("test_nothing"), "test.nothing");
}

TEST_F(Commands, ReadBackAsTheyAreWritten)
{
    for (const char* line : {R"(test.everything name="two words")", R"(test.everything name="a\\b\" c")", R"(test.everything file="a#b.obj")",
                             "test.everything pair=0.1,1e+300 faces=0,4,7-9+group:3", R"(test.everything name="")", "test.everything mood=wild"}) {
        const std::string once = canonical(line);
        EXPECT_EQ(canonical(once), once);
        EXPECT_EQ(once, line);
    }
}

TEST_F(Commands, TakeAPresetWhoseValuesOtherKeysOverride)
{
    EXPECT_EQ(canonical("test.everything preset=large"), "test.everything size=100 mood=wild");
    EXPECT_EQ(canonical("test.everything size=2 preset=large"), "test.everything size=2 mood=wild");
    EXPECT_EQ(complaint("test.everything preset=huge"), "test.everything: no preset 'huge'; expected large");
    EXPECT_EQ(complaint("test.nothing preset=huge"), "test.nothing: no preset 'huge': it has none");
}

TEST_F(Commands, SayWhatIsWrongWithTheirForm)
{
    EXPECT_EQ(complaint("test.everything size"), "test.everything: expected key=value, found 'size'");
    EXPECT_EQ(complaint("test.everything =3"), "test.everything: expected key=value, found '=3'");
    EXPECT_EQ(complaint("test.everything \"size=3\""), "test.everything: expected key=value, found '\"size=3\"'");
    EXPECT_EQ(complaint("test.everything name=\"a"), "test.everything: name=: the closing quote is missing");
    EXPECT_EQ(complaint("test.everything name=\"a\"b"), "test.everything: name=: expected a blank after the closing quote");
    EXPECT_EQ(complaint("test.everything name=a\"b"), "test.everything: name=a\"b: expected quotes around the whole value");
    EXPECT_EQ(complaint(R"(test.everything name="\n")"), R"(test.everything: name=: expected \" or \\ after a backslash in quotes)");
    EXPECT_EQ(complaint("size=3"), "expected the name of an operator, found 'size=3'");
    EXPECT_EQ(complaint("test.nothing\ntest.nothing"), "a command is one line without control characters");
}

TEST_F(Commands, SayWhatWouldDoInPlaceOfAValue)
{
    EXPECT_EQ(complaint("everything size=0"), "test.everything: size=0: expected above 0 model units");
    EXPECT_EQ(complaint("everything size=nan"), "test.everything: size=nan: expected above 0 model units");
    EXPECT_EQ(complaint("everything count=10"), "test.everything: count=10: expected 1 to 9 (an integer)");
    EXPECT_EQ(complaint("everything count=1.5"), "test.everything: count=1.5: expected 1 to 9 (an integer)");
    EXPECT_EQ(complaint("everything on=yes"), "test.everything: on=yes: expected true or false");
    EXPECT_EQ(complaint("everything mood=sad"), "test.everything: mood=sad: expected calm or wild");
    EXPECT_EQ(complaint("everything pair=1"), "test.everything: pair=1: expected 2 numbers, found 1");
    EXPECT_EQ(complaint("everything colour=red"), "test.everything: colour=red: expected a colour #rrggbb");
    EXPECT_EQ(complaint("everything size="), "test.everything: size=: expected above 0 model units");
}

TEST_F(Commands, NameTheNearestParameterOrOperator)
{
    EXPECT_EQ(complaint("everything sise=1"), "test.everything: unknown parameter 'sise'; did you mean 'size'?");
    EXPECT_EQ(complaint("everything zzzzzz=1"),
              "test.everything: unknown parameter 'zzzzzz'; expected size, count, on, mood, pair, name, file, colour or faces");
    EXPECT_EQ(complaint("nothing x=1"), "test.nothing: unknown parameter 'x'; it takes none");
    EXPECT_EQ(complaint("test.everythin"), "unknown operator 'test.everythin'; did you mean 'test.everything'?");
}

TEST_F(Commands, HoldToWhatIsRequiredOnceOrExclusive)
{
    EXPECT_EQ(complaint("required"), "test.required: file= is missing; expected file: from where");
    EXPECT_EQ(complaint("everything size=1 size=1"), "test.everything: size is given twice");
    EXPECT_EQ(complaint("one_of"), "test.one_of: expected exactly one of shift and vertex, found none");
    EXPECT_EQ(complaint("one_of shift=1 vertex=2"), "test.one_of: expected exactly one of shift and vertex, found shift and vertex");
    EXPECT_EQ(complaint("governed count=2"), "no complaint: test.governed count=2");
    EXPECT_EQ(complaint("governed size=1.5 mood=wild"), "no complaint: test.governed mood=wild size=1.5");
    EXPECT_EQ(complaint("governed size=1.5"), "test.governed: size: mood=calm does not use it; it uses count");
    EXPECT_EQ(canonical("one_of shift=1"), "test.one_of shift=1");
}

TEST_F(Commands, QuoteOnlySoMuchOfALongValue)
{
    const std::string told = complaint("everything mood=" + std::string(100000, 'x'));
    EXPECT_EQ(told, "test.everything: mood=" + std::string(60, 'x') + "…: expected calm or wild");
    const std::string umlauts = [] {
        std::string text = "a";
        for (int i = 0; i < 100; ++i) text += "ä";
        return text;
    }();
    EXPECT_NE(complaint("everything mood=" + umlauts).find("ä…:"), std::string::npos); // cut between characters
    EXPECT_LT(complaint(std::string(100000, 'x')).size(), 200u);
}

TEST(ArgumentText, QuotesWhereAReaderWouldStop)
{
    EXPECT_EQ(argument_text("k", "plain"), "k=plain");
    EXPECT_EQ(argument_text("k", "two words"), "k=\"two words\"");
    EXPECT_EQ(argument_text("k", ""), "k=\"\"");
    EXPECT_EQ(argument_text("k", "a#b"), "k=\"a#b\"");
    EXPECT_EQ(argument_text("k", "a\"b\\ "), "k=\"a\\\"b\\\\ \"");
    EXPECT_EQ(argument_text("k", "a\\b"), "k=a\\b");
}

} // namespace
} // namespace druse
