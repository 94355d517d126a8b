#include "tile/point_name.h"

#include "dlfl/errors.h"
#include "pane/name_scanner.h"

#include <fmt/format.h>

#include <optional>

namespace druse {

namespace {

std::optional<PointName> parse_name(std::string_view text)
{
    using Kind = PointName::Kind;
    NameScanner scanner(text);
    const char kind = scanner.take_any();
    const auto number = scanner.take_number();
    if (!number) return {};
    PointName name;
    switch (kind) {
    case 'v': name = PointName::corner(*number); break;
    case 'i': name = PointName::interior(*number); break;
    case 'm': name = {Kind::middle, *number, 0, -1}; break;
    case 'e': {
        const auto index = scanner.take(':') ? scanner.take_number(1) : std::nullopt;
        if (!index) return {};
        name = {scanner.take('m') ? Kind::mirrored : Kind::path, *number, *index - 1, -1};
        break;
    }
    default: return {};
    }
    if (name.is_of_path() && scanner.take('@')) {
        const auto edge = scanner.take_number();
        if (!edge) return {};
        name.edge = *edge;
    }
    return scanner.done() ? std::optional(name) : std::nullopt;
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
