#include "cell/cell_point_name.h"

#include "dlfl/errors.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

namespace druse {

namespace {

/// Takes a letter and the number behind it off the front; -1: that is not what is there.
int take_numbered(std::string_view& text, char letter)
{
    int value = 0;
    if (text.size() < 2 || text[0] != letter || text[1] == '-') return -1;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value);
    if (error != std::errc()) return -1;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

std::optional<CellPointName> parse_cell_name(std::string_view text)
{
    using Kind = CellPointName::Kind;
    CellPointName name;
    if (!text.empty() && text[0] == 'p') {
        name.pane = take_numbered(text, 'p');
        if (name.pane < 0 || text.empty() || text[0] != ':') return {};
        text.remove_prefix(1);
    }
    const char kind = text.empty() ? ' ' : text[0];
    const int number = take_numbered(text, kind);
    if (number < 0) return {};
    name.index = number;
    switch (kind) {
    case 'i': name.kind = Kind::interior; break;
    case 'v': name.kind = Kind::pane_corner; break;
    case 'c': name.kind = Kind::corner; break;
    case 's':
        name.kind = Kind::split;
        if (!text.empty() && (name.side = take_numbered(text, '@')) < 0) return {};
        break;
    case 'e':
    case 'x': {
        name.kind = kind == 'e' ? Kind::side : Kind::edge;
        name.line = number;
        const int index = take_numbered(text, ':');
        if (index < 1) return {};
        name.index = index - 1;
        break;
    }
    default: return {};
    }
    if (name.pane >= 0 && (kind == 'c' || kind == 'x')) return {};
    return text.empty() ? std::optional(name) : std::nullopt;
}

} // namespace

CellPointName CellPointName::parse(std::string_view text)
{
    if (const auto name = parse_cell_name(text)) return *name;
    throw CommandError(fmt::format("'{}' is no name of a point: expected c0, x0:1, p0:i0 or s0, or of a pane v0, e0:1, i0 or s0", text));
}

std::string CellPointName::text() const
{
    const std::string in = pane >= 0 ? fmt::format("p{}:", pane) : "";
    switch (kind) {
    case Kind::corner: return fmt::format("c{}", index);
    case Kind::edge: return fmt::format("x{}:{}", line, index + 1);
    case Kind::interior: return fmt::format("{}i{}", in, index);
    case Kind::split: return side >= 0 ? fmt::format("{}s{}@{}", in, index, side) : fmt::format("{}s{}", in, index);
    case Kind::pane_corner: return fmt::format("{}v{}", in, index);
    case Kind::side: break;
    }
    return fmt::format("{}e{}:{}", in, line, index + 1);
}

} // namespace druse
