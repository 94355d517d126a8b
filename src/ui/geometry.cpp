#include "ui/geometry.h"

#include "dlfl/errors.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace druse::ui {

namespace {

constexpr int largest_side = 16384; // what graphics cards draw into

bool take(std::string_view& rest, char c)
{
    if (!rest.starts_with(c)) return false;
    rest.remove_prefix(1);
    return true;
}

/// A number of `fewest` to five digits off the front; nothing if there is none.
std::optional<int> take_number(std::string_view& rest, std::size_t fewest)
{
    const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
    if (digits < fewest || digits > 5) return std::nullopt;
    int number = 0;
    std::from_chars(rest.data(), rest.data() + digits, number);
    rest.remove_prefix(digits);
    return number;
}

} // namespace

Geometry Geometry::parse(const std::string& text)
{
    std::string_view rest = text;
    Geometry geometry;
    bool fits = true;
    if (!rest.empty() && rest.front() != '+')
        fits = (geometry.width = take_number(rest, 2)) && take(rest, 'x') && (geometry.height = take_number(rest, 2));
    if (fits && take(rest, '+')) fits = (geometry.x = take_number(rest, 1)) && take(rest, '+') && (geometry.y = take_number(rest, 1));
    if (!fits || !rest.empty()) throw CommandError("--geometry=" + text + ": expected WIDTHxHEIGHT, WIDTHxHEIGHT+X+Y or +X+Y");
    if (geometry.width.value_or(0) > largest_side || geometry.height.value_or(0) > largest_side)
        throw CommandError("--geometry=" + text + ": expected at most " + std::to_string(largest_side) + " pixels a side");
    return geometry;
}

} // namespace druse::ui
