// The registry: names as people type them, and what every operator must say about itself.
#include "ops/registry.h"

#include "run.h"

#include <cmath>
#include <fstream>
#include <set>

namespace druse {
namespace {

using namespace test;

std::string unknown(std::string_view name)
{
    try {
        ops_registry().get(name);
    } catch (const CommandError& e) {
        return e.what();
    }
    return "(none)";
}

TEST(Registry, TakesNamesWithAnySeparatorAndWithoutTheirFamily)
{
    for (const char* name : {"extrude.dodecahedral", "extrude-dodecahedral", "extrude_dodecahedral", "dodecahedral"})
        EXPECT_EQ(ops_registry().get(name).name, "extrude.dodecahedral");
    for (const char* name : {"remesh.catmull_clark", "remesh-catmull-clark", "catmull.clark"}) EXPECT_EQ(ops_registry().get(name).name, "remesh.catmull_clark");
    EXPECT_EQ(ops_registry().find("group"), ops_registry().find("select.group")); // the family `group` is no operator
    EXPECT_EQ(ops_registry().find(""), nullptr);
}

TEST(Registry, AsksBackWhereALastPartIsShared)
{
    Registry registry;
    registry.add(define<NoParameters>("make.thing", "Add a thing"));
    registry.add(define<NoParameters>("mesh.thing", "Change a thing"));
    registry.add(define<NoParameters>("mesh.other", "Change another thing").alias("mesh.second"));
    EXPECT_EQ(registry.find("thing"), nullptr);
    EXPECT_THROW(registry.get("thing"), CommandError);
    EXPECT_EQ(registry.get("second").name, "mesh.other");
    EXPECT_THROW(registry.add(define<NoParameters>("mesh-other", "Twice")), InternalError);
    EXPECT_THROW(registry.add(define<NoParameters>("mesh.third", "An alias twice").alias("mesh.second")), InternalError);
}

TEST(Registry, NamesTheNearestOperator)
{
    EXPECT_EQ(unknown("make.cubes"), "unknown operator 'make.cubes'; did you mean 'make.cube'?");
    EXPECT_EQ(unknown("dodecahedrl"), "unknown operator 'dodecahedrl'; did you mean 'extrude.dodecahedral'?");
    EXPECT_EQ(unknown("xyzzy"), "unknown operator 'xyzzy'; `druse ops` lists them");
}

TEST(Registry, MakesATitleOfAName)
{
    EXPECT_EQ(ops_registry().get("remesh.catmull_clark").title(), "Catmull clark");
    EXPECT_EQ(ops_registry().get("make.cube").title(), "Cube");
}

// --- every operator ---------------------------------------------------------------------------------------------------------------

class EveryOperator : public testing::TestWithParam<Operator> {};
INSTANTIATE_TEST_SUITE_P(Ops, EveryOperator, testing::ValuesIn(ops_registry().operators()), [](const auto& p) {
    std::string name = p.param.name;
    std::ranges::replace(name, '.', '_');
    return name;
});

TEST_P(EveryOperator, HasHelpSourceAndExample)
{
    const Operator& op = GetParam();
    EXPECT_FALSE(op.help.empty());
    EXPECT_EQ(op.help.find('\n'), std::string::npos);
    EXPECT_FALSE(op.help.ends_with('.'));
    EXPECT_FALSE(op.source.empty());
    EXPECT_TRUE(op.example.starts_with(op.name)) << op.example;
    for (const char c : op.name) EXPECT_TRUE((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.') << op.name;
}

TEST_P(EveryOperator, SaysOfEveryParameterWhatItIs)
{
    std::set<std::string> names;
    for (const Parameter& p : GetParam().parameters) {
        EXPECT_TRUE(names.insert(p.name).second) << p.name;
        EXPECT_FALSE(p.help.empty()) << p.name;
        EXPECT_FALSE(p.type_text().empty()) << p.name;
        using Type = Parameter::Type;
        const bool numbers = p.type == Type::number || p.type == Type::integer || p.type == Type::numbers || p.type == Type::integers;
        EXPECT_FALSE(numbers && p.domain.range.is_everything()) << p.name << " has no range";
        EXPECT_FALSE(p.type == Type::word && p.domain.words.empty()) << p.name;
        EXPECT_FALSE(p.required && p.optional) << p.name;
        // A parameter without a default is required or may stay unset.
        EXPECT_EQ(p.default_text.empty(), p.required || p.optional) << p.name;
    }
    for (const auto& set : GetParam().exclusive)
        for (const std::string& name : set) {
            ASSERT_NE(GetParam().find(name), nullptr) << name;
            EXPECT_TRUE(GetParam().find(name)->optional) << name;
        }
}

TEST_P(EveryOperator, TakesItsOwnDefaultsAndWritesThemTheSame)
{
    const auto parameters = GetParam().make();
    for (const Parameter& p : GetParam().parameters) {
        if (p.default_text.empty()) continue;
        EXPECT_EQ(p.text(parameters.get()), p.default_text);
        EXPECT_NO_THROW(p.set(parameters.get(), p.default_text)) << p.name;
        EXPECT_EQ(p.text(parameters.get()), p.default_text) << p.name;
    }
}

TEST_P(EveryOperator, TakesItsExample)
{
    const auto parameters = GetParam().make();
    const auto words = split(GetParam().example, ' ');
    std::set<std::string_view> given;
    for (std::size_t i = 1; i < words.size(); ++i) {
        const auto at = words[i].find('=');
        ASSERT_NE(at, std::string_view::npos) << words[i];
        const Parameter* p = GetParam().find(words[i].substr(0, at));
        ASSERT_NE(p, nullptr) << words[i];
        EXPECT_NO_THROW(p->set(parameters.get(), words[i].substr(at + 1))) << words[i];
        const std::string written = p->text(parameters.get()); // perhaps 1e-06 for 1e-6
        EXPECT_NO_THROW(p->set(parameters.get(), written)) << written;
        EXPECT_EQ(p->text(parameters.get()), written);
        EXPECT_TRUE(given.insert(p->name).second);
    }
    for (const Parameter& p : GetParam().parameters)
        EXPECT_TRUE(!p.required || given.contains(p.name)) << p.name;
    for (const auto& set : GetParam().exclusive) EXPECT_EQ(std::ranges::count_if(set, [&](const std::string& n) { return given.contains(n); }), 1);
}

TEST_P(EveryOperator, CitesWorksThatTheBibliographyLists)
{
    std::ifstream file(std::string(DRUSE_DOCS) + "/references.md");
    const std::string references(std::istreambuf_iterator<char>(file), {});
    ASSERT_FALSE(references.empty());
    if (GetParam().source == "Druse") return;
    // `Author[, Author & Author] year[, section]`, several with semicolons: an entry starts with `**Author … year**`.
    for (std::string_view work : split(GetParam().source, ';')) {
        while (work.starts_with(' ')) work.remove_prefix(1);
        std::size_t end = 0;
        for (std::size_t i = 0; i + 4 <= work.size() && end == 0; ++i)
            if (std::all_of(work.begin() + long(i), work.begin() + long(i) + 4, [](char c) { return c >= '0' && c <= '9'; })) end = i + 4;
        ASSERT_GT(end, 0u) << work;
        EXPECT_NE(references.find("**" + std::string(work.substr(0, end)) + "**"), std::string::npos) << work;
    }
}

} // namespace
} // namespace druse
