#include "cell/cell_point_name.h"

#include "dlfl/errors.h"
#include "pane/name_scanner.h"

#include <fmt/format.h>

#include <optional>

namespace druse {

namespace {

std::optional<CellPointName> parse_cell_name(std::string_view text)
{
    using Kind = CellPointName::Kind;
    NameScanner scanner(text);
    CellPointName name;
    if (scanner.take('p')) {
        const auto pane = scanner.take_number();
        if (!pane || !scanner.take(':')) return {};
        name.pane = *pane;
    }
    const char kind = scanner.take_any();
    const auto number = scanner.take_number();
    if (!number) return {};
    name.index = *number;
    switch (kind) {
    case 'i': name.kind = Kind::interior; break;
    case 'v': name.kind = Kind::pane_corner; break;
    case 'c': name.kind = Kind::corner; break;
    case 's':
        name.kind = Kind::split;
        if (scanner.take('@')) {
            const auto side = scanner.take_number();
            if (!side) return {};
            name.side = *side;
        }
        break;
    case 'e':
    case 'x': {
        const auto index = scanner.take(':') ? scanner.take_number(1) : std::nullopt;
        if (!index) return {};
        name.kind = kind == 'e' ? Kind::side : Kind::edge;
        name.line = *number;
        name.index = *index - 1;
        break;
    }
    default: return {};
    }
    if (name.pane >= 0 && (kind == 'c' || kind == 'x')) return {};
    return scanner.done() ? std::optional(name) : std::nullopt;
}

} // namespace

CellPointName CellPointName::parse(std::string_view text)
{
    if (const auto name = parse_cell_name(text)) return *name;
    throw CommandError(fmt::format("'{}' is no name of a point: expected c0, x0:1, p0:i0 or s0, or of a pane v0, e0:1, i0, s0 or s0@2 (on its side 2)", text));
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
