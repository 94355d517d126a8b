#include "app/reference.h"

#include "app/command.h"
#include "app/padded.h"
#include "ops/text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace druse {

namespace {

using Json = nlohmann::ordered_json;

bool is_numeric(const Parameter& p)
{
    using Type = Parameter::Type;
    return p.type == Type::number || p.type == Type::integer || p.type == Type::numbers || p.type == Type::integers;
}

/// What the command says of a parameter that is not given: `angle=90`, `vertex=` where it stays unset, `file=` where it is required.
std::string with_default(const Parameter& p) { return p.default_text.empty() ? p.name + "=" : argument_text(p.name, p.default_text); }

const char* unit_word(Unit unit)
{
    switch (unit) {
    case Unit::degrees: return "degrees";
    case Unit::length: return "length";
    case Unit::area: return "area";
    case Unit::ratio: return "ratio";
    case Unit::count: return "count";
    case Unit::id: return "id";
    case Unit::none: break;
    }
    return "";
}

Json or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json range_json(const Range& range)
{
    if (range.is_everything()) return nullptr;
    Json j;
    j["min"] = std::isinf(range.min) ? Json(nullptr) : Json(range.min);
    j["max"] = std::isinf(range.max) ? Json(nullptr) : Json(range.max);
    j["without_min"] = range.above_min;
    j["without_max"] = range.below_max;
    j["without_zero"] = range.without_zero;
    return j;
}

Json parameter_json(const Operator& op, const Parameter& p)
{
    Json j;
    j["name"] = p.name;
    j["type"] = p.type_text();
    j["unit"] = or_null(unit_word(p.domain.unit));
    j["default"] = or_null(p.default_text);
    j["required"] = p.required;
    j["range"] = range_json(p.domain.range);
    j["length"] = p.fixed_length > 0 ? Json(p.fixed_length) : range_json(p.domain.length);
    j["words"] = p.domain.words;
    if (p.repeated) j["repeated"] = true;
    Json excludes = Json::array();
    for (const auto& set : op.exclusive)
        if (std::ranges::find(set, p.name) != set.end())
            for (const std::string& other : set)
                if (other != p.name) excludes.push_back(other);
    for (const Parameter& other : op.parameters) {
        if (other.instead_of == p.name) excludes.push_back(other.name);
        if (p.instead_of == other.name) excludes.push_back(other.name);
    }
    j["excludes"] = std::move(excludes);
    if (!p.governor.empty()) j["only_where"] = {{"parameter", p.governor}, {"values", p.governing}};
    j["help"] = p.help;
    return j;
}

Json operator_json(const Operator& op)
{
    Json j;
    j["name"] = op.name;
    j["family"] = op.family();
    j["title"] = op.title();
    j["help"] = op.help;
    j["kind"] = op.kind == Operator::Kind::edit ? "edit" : op.kind == Operator::Kind::query ? "query" : "travel";
    j["aliases"] = op.aliases;
    j["parameters"] = Json::array();
    for (const Parameter& p : op.parameters) j["parameters"].push_back(parameter_json(op, p));
    j["presets"] = Json::object();
    for (const Preset& preset : op.presets) j["presets"][preset.name] = preset.arguments;
    j["example"] = op.example;
    j["source"] = op.source;
    return j;
}

std::string dump(const Json& j) { return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

/// What a parameter is, with what it depends on: `height at the rim (to=polyp)`.
std::string help_text(const Parameter& p)
{
    if (p.required) return p.help + " (required)";
    if (p.repeated) return p.help + " (may be repeated)";
    return p.governor.empty() ? p.help : fmt::format("{} ({}={})", p.help, p.governor, listing(p.governing));
}

/// `a`, `b` and `c`, each as code.
std::string code(std::vector<std::string> names)
{
    for (std::string& name : names) name = fmt::format("`{}`", name);
    return listing(names, "and");
}

/// Text for a cell of a Markdown table.
std::string cell(std::string_view text)
{
    std::string result;
    for (const char c : text) {
        if (c == '|') result += '\\';
        result += c;
    }
    return result;
}

/// Calls `first` whenever another family begins, and `each` for every operator.
template <class First, class Each>
void by_family(const Registry& registry, First&& first, Each&& each)
{
    std::string family;
    for (const Operator& op : registry.operators()) {
        if (op.family() != family) first(family = op.family());
        each(op);
    }
}

} // namespace

std::string takes_text(const Parameter& p)
{
    const std::vector<std::string>& words = p.domain.words;
    if (p.type == Parameter::Type::word) return listing(words);
    std::string text = p.type_text();
    if (is_numeric(p)) {
        const std::string unit = name(p.domain.unit);
        if (!p.domain.range.is_everything()) text += ", " + p.domain.range.text() + (unit.empty() ? "" : " " + unit);
        else if (!unit.empty()) text += " (" + unit + ")";
        if (p.domain.unit == Unit::ratio) text += " (ratio)";
    }
    if (!p.domain.length.is_everything()) text += fmt::format(", {} of them", p.domain.length.text());
    if (!words.empty()) text += ", or " + listing(words);
    return text;
}

std::string reference_text(const Registry& registry)
{
    std::size_t width = 0;
    for (const Operator& op : registry.operators()) width = std::max(width, op.name.size());
    std::string text;
    by_family(
        registry, [&](const std::string& family) { text += (text.empty() ? "" : "\n") + family + "\n"; },
        [&](const Operator& op) { text += fmt::format("  {}  {}\n", padded(op.name, width), op.help); });
    return text;
}

std::string reference_text(const Operator& op)
{
    std::string text = fmt::format("{}: {}\n", op.name, op.help);
    if (!op.aliases.empty()) text += fmt::format("also called {}\n", listing(op.aliases, "and"));
    std::size_t width = 0, takes = 0;
    for (const Parameter& p : op.parameters) {
        width = std::max(width, with_default(p).size());
        takes = std::max(takes, takes_text(p).size());
    }
    width = std::min<std::size_t>(width, 32);
    takes = std::min<std::size_t>(takes, 40);
    if (!op.parameters.empty()) text += "\n";
    for (const Parameter& p : op.parameters)
        text += fmt::format("  {}  {}  {}\n", padded(with_default(p), width), padded(takes_text(p), takes), help_text(p));
    for (const auto& set : op.exclusive) text += fmt::format("  exactly one of {}\n", listing(set, "and"));
    for (const Preset& preset : op.presets) text += fmt::format("  preset={}: {}\n", preset.name, preset.arguments);
    return text + fmt::format("\nexample: {}\nsource:  {}\n", op.example, op.source);
}

std::string reference_json(const Registry& registry)
{
    Json all = Json::array();
    for (const Operator& op : registry.operators()) all.push_back(operator_json(op));
    return dump(all);
}

std::string reference_json(const Operator& op) { return dump(operator_json(op)); }

std::string reference_markdown(const Operator& op)
{
    std::string text = fmt::format("### `{}`\n\n{}.", op.name, op.help);
    if (!op.aliases.empty()) text += fmt::format(" Also called {}.", code(op.aliases));
    if (op.kind == Operator::Kind::query) text += " Changes nothing and prints one JSON object.";
    text += "\n\n";
    if (!op.parameters.empty()) {
        text += "| parameter | takes | meaning |\n|---|---|---|\n";
        for (const Parameter& p : op.parameters)
            text += fmt::format("| `{}` | {} | {} |\n", cell(with_default(p)), cell(takes_text(p)), cell(help_text(p)));
        text += "\n";
    }
    for (const auto& set : op.exclusive) text += fmt::format("Exactly one of {} is given.\n\n", code(set));
    for (const Preset& preset : op.presets) text += fmt::format("Preset `{}`: `{}`\n\n", preset.name, preset.arguments);
    return text + fmt::format("    {}\n\nSource: {}\n", op.example, op.source);
}

std::string reference_markdown(const Registry& registry)
{
    std::string text = "# Operators\n\n"
                       "Made by `druse ops --markdown` from the registry. A command is `NAME key=value key=value …`; every operator also takes\n"
                       "`preset=NAME`, a stored set of its parameters which the other keys override.\n";
    by_family(
        registry, [&](const std::string& family) { text += fmt::format("\n## {}\n", family); },
        [&](const Operator& op) { text.append("\n").append(reference_markdown(op)); });
    return text;
}

} // namespace druse
