#include "app/reference.h"

#include "app/command.h"
#include "app/registry.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace druse {
namespace {

using Json = nlohmann::ordered_json;

bool is_numeric(const Parameter& p)
{
    using Type = Parameter::Type;
    return p.type == Type::number || p.type == Type::integer || p.type == Type::numbers || p.type == Type::integers;
}

TEST(Reference, HoldsEveryFamilyInMenuOrder)
{
    std::vector<std::string> families;
    for (const Operator& op : all_operators().operators())
        if (families.empty() || families.back() != op.family()) families.push_back(op.family());
    const std::vector<std::string> expected{"make", "face", "select", "group", "extrude", "remesh", "topology", "rind", "graph", "pane", "tile", "cell", "mesh", "check", "document"};
    EXPECT_EQ(families, expected);
}

TEST(Reference, SaysOfEveryOperatorWhatItIsForWhereItIsFromAndHowToCallIt)
{
    for (const Operator& op : all_operators().operators()) {
        SCOPED_TRACE(op.name);
        EXPECT_FALSE(op.help.empty());
        EXPECT_EQ(op.help.find('\n'), std::string::npos);
        EXPECT_FALSE(op.source.empty());
        ASSERT_FALSE(op.example.empty());
        const Invocation call = bind(all_operators(), parse_command(op.example));
        EXPECT_EQ(call.op, &op);
    }
}

TEST(Reference, SaysOfEveryParameterWhatItTakes)
{
    for (const Operator& op : all_operators().operators())
        for (const Parameter& p : op.parameters) {
            SCOPED_TRACE(op.name + " " + p.name);
            EXPECT_FALSE(p.help.empty());
            EXPECT_EQ(p.help.find('\n'), std::string::npos);
            EXPECT_FALSE(takes_text(p).empty());
            EXPECT_NE(p.name, "preset");
            if (is_numeric(p)) {
                EXPECT_NE(p.domain.unit, Unit::none) << "a number without a unit";
                EXPECT_LE(p.domain.range.min, p.domain.range.max);
            }
            EXPECT_TRUE(p.required || p.optional || !p.default_text.empty() || p.type == Parameter::Type::text);
            if (p.default_text.empty()) continue;
            // The default is one of the values it takes, and is written as it is read.
            const std::shared_ptr<void> values = op.make();
            EXPECT_NO_THROW(p.set(values.get(), p.default_text));
            EXPECT_EQ(p.text(values.get()), p.default_text);
        }
}

TEST(Reference, NamesOnlyParametersThatAreThere)
{
    for (const Operator& op : all_operators().operators()) {
        SCOPED_TRACE(op.name);
        std::set<std::string> names;
        for (const Parameter& p : op.parameters) EXPECT_TRUE(names.insert(p.name).second) << p.name << " is registered twice";
        for (const auto& set : op.exclusive)
            for (const std::string& name : set) EXPECT_TRUE(names.contains(name)) << name;
        for (const Preset& preset : op.presets) EXPECT_NO_THROW(bind(all_operators(), parse_command(op.name + " preset=" + preset.name)));
    }
}

TEST(Reference, FindsOperatorsByShortNamesAndAliases)
{
    for (const Operator& op : all_operators().operators()) {
        EXPECT_EQ(all_operators().find(op.name), &op);
        for (const std::string& alias : op.aliases) EXPECT_EQ(all_operators().find(alias), &op) << alias;
    }
    EXPECT_EQ(all_operators().get("dodecahedral").name, "extrude.dodecahedral");
    EXPECT_EQ(all_operators().get("extrude-dodecahedral").name, "extrude.dodecahedral");
    EXPECT_THROW((void)all_operators().get("solid"), CommandError); // make.solid or extrude.solid
}

TEST(Reference, IsAPageWithASectionForEveryOperator)
{
    const std::string page = reference_markdown(all_operators());
    std::size_t at = 0;
    for (const Operator& op : all_operators().operators()) {
        at = page.find("### `" + op.name + "`", at);
        ASSERT_NE(at, std::string::npos) << op.name;
        const std::string section = reference_markdown(op);
        EXPECT_EQ(page.substr(at, section.size()), section);
        for (const Parameter& p : op.parameters) EXPECT_NE(section.find("| `" + p.name + "="), std::string::npos) << p.name;
        EXPECT_NE(section.find("    " + op.example + "\n"), std::string::npos);
    }
}

TEST(Reference, IsAlsoJson)
{
    const Json all = Json::parse(reference_json(all_operators()));
    ASSERT_EQ(all.size(), all_operators().operators().size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Operator& op = all_operators().operators()[i];
        EXPECT_EQ(all[i]["name"], op.name);
        EXPECT_EQ(all[i]["parameters"].size(), op.parameters.size());
        EXPECT_EQ(Json::parse(reference_json(op)), all[i]);
    }
    const Json one = Json::parse(reference_json(all_operators().get("extrude.dodecahedral")));
    for (const Json& p : one["parameters"])
        if (p["name"] == "angle") {
            EXPECT_EQ(p["unit"], "degrees");
            EXPECT_EQ(p["range"]["min"], 1.0);
            EXPECT_EQ(p["range"]["max"], 179.0);
            EXPECT_NEAR(std::stod(p["default"].get<std::string>()), 116.565051177078, 1e-12);
        }
}

TEST(Reference, ListsEveryOperatorOnALine)
{
    const std::string text = reference_text(all_operators());
    for (const Operator& op : all_operators().operators()) EXPECT_NE(text.find("  " + op.name + " "), std::string::npos) << op.name;
    EXPECT_EQ(reference_text(all_operators().get("document.clear")),
              "document.clear: Empty the document: mesh, source, groups and selection\n\nexample: document.clear\nsource:  Druse\n");
}

} // namespace
} // namespace druse
