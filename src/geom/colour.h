#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace druse {

/// An 8-bit sRGB colour.
struct Colour {
    std::uint8_t red = 0, green = 0, blue = 0;

    friend bool operator==(const Colour&, const Colour&) = default;
    friend auto operator<=>(const Colour&, const Colour&) = default;
};

/// `#rrggbb`, lower case.
std::string to_hex(Colour c);

/// Reads `#rrggbb`; nothing if `text` is not of that form.
std::optional<Colour> colour_from_hex(std::string_view text);

/// Rounds three channels of 0…1 to 8 bits each; values outside are cut off.
Colour colour_from_unit(double red, double green, double blue);

/// Hue, saturation and value, each 0…1.
Colour colour_from_hsv(double hue, double saturation, double value);

} // namespace druse
