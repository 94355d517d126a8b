#include "geom/colour.h"

#include <algorithm>
#include <cmath>

namespace druse {

std::string to_hex(Colour c)
{
    constexpr char digit[] = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t channel : {c.red, c.green, c.blue}) {
        text += digit[channel >> 4];
        text += digit[channel & 15];
    }
    return text;
}

std::optional<Colour> colour_from_hex(std::string_view text)
{
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    std::uint8_t channel[3] = {};
    for (int i = 0; i < 6; ++i) {
        const char c = text[static_cast<std::size_t>(i) + 1];
        int value = 0;
        if (c >= '0' && c <= '9') value = c - '0';
        else if (c >= 'a' && c <= 'f') value = c - 'a' + 10;
        else if (c >= 'A' && c <= 'F') value = c - 'A' + 10;
        else return std::nullopt;
        channel[i / 2] = static_cast<std::uint8_t>(channel[i / 2] * 16 + value);
    }
    return Colour{channel[0], channel[1], channel[2]};
}

Colour colour_from_unit(double red, double green, double blue)
{
    const auto channel = [](double x) { return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.0, 1.0) * 255.0)); };
    return {channel(red), channel(green), channel(blue)};
}

Colour colour_from_hsv(double hue, double saturation, double value)
{
    const double sector = (hue - std::floor(hue)) * 6.0;
    const double chroma = value * saturation;
    const double second = chroma * (1.0 - std::abs(std::fmod(sector, 2.0) - 1.0));
    const double base = value - chroma;
    double r = 0, g = 0, b = 0;
    switch (static_cast<int>(sector)) {
    case 0: r = chroma, g = second; break;
    case 1: r = second, g = chroma; break;
    case 2: g = chroma, b = second; break;
    case 3: g = second, b = chroma; break;
    case 4: r = second, b = chroma; break;
    default: r = chroma, b = second; break;
    }
    return colour_from_unit(r + base, g + base, b + base);
}

} // namespace druse
