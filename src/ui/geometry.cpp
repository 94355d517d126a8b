#include "ui/geometry.h"

#include "dlfl/errors.h"

#include <regex>

namespace druse::ui {

Geometry Geometry::parse(const std::string& text)
{
    static const std::regex form("(?:([0-9]{2,5})x([0-9]{2,5}))?(?:\\+([0-9]{1,5})\\+([0-9]{1,5}))?");
    std::smatch match;
    if (!std::regex_match(text, match, form))
        throw CommandError("--geometry=" + text + ": expected WIDTHxHEIGHT, WIDTHxHEIGHT+X+Y or +X+Y");
    const auto number = [&](std::size_t i) { return match[i].matched ? std::optional<int>(std::stoi(match[i])) : std::nullopt; };
    return {number(1), number(2), number(3), number(4)};
}

} // namespace druse::ui
