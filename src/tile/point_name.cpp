#include "tile/point_name.h"

#include "dlfl/errors.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

namespace druse {

namespace {

/// Takes a number off the front.
std::optional<int> take_number(std::string_view& text)
{
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end == text.data() || text[0] == '-') return {};
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

bool take(std::string_view& text, char c)
{
    if (text.empty() || text[0] != c) return false;
    text.remove_prefix(1);
    return true;
}

std::optional<PointName> parse_name(std::string_view text)
{
    using Kind = PointName::Kind;
    if (text.empty()) return {};
    const char kind = text[0];
    text.remove_prefix(1);
    const auto number = take_number(text);
    if (!number) return {};
    PointName name;
    switch (kind) {
    case 'v': name = PointName::corner(*number); break;
    case 'i': name = PointName::interior(*number); break;
    case 'm': name = {Kind::middle, *number, 0, -1}; break;
    case 'e': {
        if (!take(text, ':')) return {};
        const auto index = take_number(text);
        if (!index || *index < 1) return {};
        name = {take(text, 'm') ? Kind::mirrored : Kind::path, *number, *index - 1, -1};
        break;
    }
    default: return {};
    }
    if (name.is_of_path() && take(text, '@')) {
        const auto edge = take_number(text);
        if (!edge) return {};
        name.edge = *edge;
    }
    return text.empty() ? std::optional(name) : std::nullopt;
}

} // namespace

PointName PointName::parse(std::string_view text)
{
    if (const auto name = parse_name(text)) return *name;
    throw CommandError(fmt::format("'{}' is no name of a point: expected v0, e0:1, e0:1m, m0 or i0", text));
}

std::string PointName::text() const
{
    const std::string on = edge >= 0 ? fmt::format("@{}", edge) : "";
    switch (kind) {
    case Kind::corner: return fmt::format("v{}", index);
    case Kind::path: return fmt::format("e{}:{}{}", path, index + 1, on);
    case Kind::mirrored: return fmt::format("e{}:{}m{}", path, index + 1, on);
    case Kind::middle: return fmt::format("m{}{}", path, on);
    case Kind::interior: break;
    }
    return fmt::format("i{}", index);
}

} // namespace druse
