#include "ops/parameter.h"

#include <fmt/format.h>

#include <cmath>

namespace druse {

const char* name(Unit unit)
{
    switch (unit) {
    case Unit::degrees: return "degrees";
    case Unit::length: return "model units";
    case Unit::area: return "square model units";
    default: return "";
    }
}

namespace {

/// An end of a range; never `1e+06`, as people write it out.
std::string end_text(double x) { return std::abs(x) < 1e15 && std::floor(x) == x ? fmt::format("{:.0f}", x) : number_text(x); }

/// `1 number`, `3 numbers`.
std::string counted(int count, std::string_view plural)
{
    if (count == 1) plural.remove_suffix(1);
    return fmt::format("{} {}", count, plural);
}

} // namespace

std::string Range::text() const
{
    std::string result;
    const bool from = !std::isinf(min), to = !std::isinf(max);
    const std::string low = end_text(min), high = end_text(max);
    if (from && to && above_min && below_max) result = fmt::format("between {} and {}, both excluded", low, high);
    else if (from && to && above_min) result = fmt::format("above {}, up to {}", low, high);
    else if (from && to && below_max) result = fmt::format("{} or more, below {}", low, high);
    else if (from && to && min == max) result = low;
    else if (from && to) result = fmt::format("{} to {}", low, high);
    else if (from) result = above_min ? fmt::format("above {}", low) : fmt::format("{} or more", low);
    else if (to) result = below_max ? fmt::format("below {}", high) : fmt::format("{} or less", high);
    if (without_zero) result += result.empty() ? "any number but 0" : ", not 0";
    return result;
}

namespace {

std::string expected(const char* noun, const Domain& d)
{
    std::string text = d.range.is_everything() ? std::string(noun) : d.range.text();
    if (const char* unit = name(d.unit); *unit) text += d.range.is_everything() ? fmt::format(" ({})", unit) : fmt::format(" {}", unit);
    return "expected " + text;
}

} // namespace

double ParameterType<double>::parse(std::string_view t, const Domain& d)
{
    try {
        if (const double x = parse_number(t); d.range.contains(x)) return x;
    } catch (const CommandError&) {
    }
    throw CommandError(expected("a number", d));
}

int ParameterType<int>::parse(std::string_view t, const Domain& d)
{
    try {
        const long long x = parse_integer(t);
        if (x >= std::numeric_limits<int>::min() && x <= std::numeric_limits<int>::max() && d.range.contains(double(x))) return int(x);
    } catch (const CommandError&) {
    }
    throw CommandError(d.range.is_everything() ? expected("an integer", d) : expected("an integer", d) + " (an integer)");
}

bool ParameterType<bool>::parse(std::string_view t, const Domain&)
{
    if (t == "true") return true;
    if (t == "false") return false;
    throw CommandError("expected true or false");
}

FilePath ParameterType<FilePath>::parse(std::string_view t, const Domain&)
{
    if (t.empty()) throw CommandError("expected a file name");
    return {std::string(t)};
}

Colour ParameterType<Colour>::parse(std::string_view t, const Domain&)
{
    if (const auto c = colour_from_hex(t)) return *c;
    throw CommandError("expected a colour #rrggbb");
}

Point ParameterType<Point>::parse(std::string_view t, const Domain&)
{
    const auto pieces = split(t, ',');
    if (pieces.size() == 2 || pieces.size() == 3) {
        try {
            return {parse_number(pieces[0]), parse_number(pieces[1]), pieces.size() == 3 ? parse_number(pieces[2]) : 0.0};
        } catch (const CommandError&) {
        }
    }
    throw CommandError("expected a point x,y,z");
}

EdgeId ParameterType<EdgeId>::parse(std::string_view t, const Domain&)
{
    try {
        if (const auto at = t.find('~'); at != std::string_view::npos) return {parse_id(t.substr(0, at)), parse_id(t.substr(at + 1))};
        return {parse_id(t)};
    } catch (const CommandError&) {
        throw CommandError("expected an edge id, or its two end vertices like 4~9");
    }
}

std::string ParameterType<EdgeId>::text(EdgeId x, const Domain&)
{
    return x.other_end == Edge::none ? std::to_string(x.id) : fmt::format("{}~{}", x.id, x.other_end);
}

CornerId ParameterType<CornerId>::parse(std::string_view t, const Domain&)
{
    const auto at = t.find(':');
    try {
        if (at != std::string_view::npos) return {parse_id(t.substr(0, at)), parse_id(t.substr(at + 1))};
    } catch (const CommandError&) {
    }
    throw CommandError("expected a corner FACE:K");
}

void check_length(std::size_t length, const Range& range, const char* what)
{
    if (range.contains(double(length)) && length > 0) return;
    if (range.min == range.max) throw CommandError(fmt::format("expected {}, found {}", counted(static_cast<int>(range.min), what), length));
    throw CommandError(range.is_everything() ? fmt::format("expected {} with commas", what)
                                             : fmt::format("expected {} {}, found {}", range.text(), what, length));
}

Words words(std::initializer_list<const char*> list) { return {{list.begin(), list.end()}}; }

void Parameter::describe(std::string_view its_name, std::string_view its_help, Domain its_domain, const void* defaults)
{
    name = its_name;
    help = its_help;
    domain = std::move(its_domain);
    default_text = text(defaults);
}

std::string Parameter::type_text() const
{
    switch (type) {
    case Type::number: return "number";
    case Type::integer: return "integer";
    case Type::toggle: return "switch";
    case Type::word: return "word";
    case Type::numbers: return fixed_length > 0 ? counted(fixed_length, "numbers") : "list of numbers";
    case Type::integers: return fixed_length > 0 ? counted(fixed_length, "integers") : "list of integers";
    case Type::texts: return "list of words";
    case Type::point: return "point";
    case Type::colour: return "colour";
    case Type::text: return "text";
    case Type::file: return "file";
    case Type::name_or_file: return "name or file";
    case Type::faces: return "faces";
    case Type::edges: return "edges";
    case Type::vertices: return "vertices";
    case Type::id: return "id";
    case Type::corner: return "corner";
    }
    return {};
}

} // namespace druse
