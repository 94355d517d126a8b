#include "ui/geometry.h"

#include "dlfl/errors.h"

#include <regex>

namespace druse::ui {

constexpr int largest_side = 16384; // what graphics cards draw into

Geometry Geometry::parse(const std::string& text)
{
    static const std::regex form("(?:([0-9]{2,5})x([0-9]{2,5}))?(?:\\+([0-9]{1,5})\\+([0-9]{1,5}))?");
    std::smatch match;
    if (!std::regex_match(text, match, form))
        throw CommandError("--geometry=" + text + ": expected WIDTHxHEIGHT, WIDTHxHEIGHT+X+Y or +X+Y");
    const auto number = [&](std::size_t i) { return match[i].matched ? std::optional<int>(std::stoi(match[i])) : std::nullopt; };
    const Geometry geometry{number(1), number(2), number(3), number(4)};
    if (geometry.width.value_or(0) > largest_side || geometry.height.value_or(0) > largest_side)
        throw CommandError("--geometry=" + text + ": expected at most " + std::to_string(largest_side) + " pixels a side");
    return geometry;
}

} // namespace druse::ui
