#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace druse {

/// One pixel of 8-bit sRGB with straight (not premultiplied) alpha.
struct Pixel {
    std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
    friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// A picture in memory, row by row from the top left.
struct Image {
    int width = 0, height = 0;
    std::vector<Pixel> pixels;

    Image() = default;
    Image(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h)) {}

    Pixel& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    const Pixel& at(int x, int y) const { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }

    friend bool operator==(const Image&, const Image&) = default;
};

} // namespace druse
