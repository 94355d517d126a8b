#include "io/grey_image.h"

#include "dlfl/errors.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace druse {

namespace {

constexpr std::uint64_t largest_picture_file = std::uint64_t(256) << 20;
constexpr std::uint64_t most_pixels = std::uint64_t(64) << 20;

/// What is left of libpng's state where an exception passes.
struct OpenPng {
    png_image image{};
    OpenPng() { image.version = PNG_IMAGE_VERSION; }
    OpenPng(const OpenPng&) = delete;
    OpenPng& operator=(const OpenPng&) = delete;
    ~OpenPng() { png_image_free(&image); }
};

template <class Sample>
std::vector<float> read_shades(png_image& image, const std::string& name)
{
    std::vector<Sample> samples(std::size_t(image.width) * image.height);
    const png_color black{0, 0, 0};
    if (!png_image_finish_read(&image, &black, samples.data(), 0, nullptr)) throw InputError(name, image.message);
    std::vector<float> shades;
    shades.reserve(samples.size());
    for (const Sample s : samples) shades.push_back(static_cast<float>(s) / static_cast<float>(static_cast<Sample>(~Sample{})));
    return shades;
}

} // namespace

double GreyImage::at(const Point2& place) const
{
    const auto last_x = static_cast<double>(width - 1), last_y = static_cast<double>(height - 1);
    const double x = std::clamp(place.x * static_cast<double>(width) - 0.5, 0.0, last_x), y = std::clamp((1.0 - place.y) * static_cast<double>(height) - 0.5, 0.0, last_y);
    const auto left = static_cast<std::size_t>(x), top = static_cast<std::size_t>(y);
    const std::size_t right = std::min(left + 1, width - 1), bottom = std::min(top + 1, height - 1);
    const double u = x - static_cast<double>(left), v = y - static_cast<double>(top);
    const auto shade = [&](std::size_t row, std::size_t column) { return double(shades[row * width + column]); };
    return (1 - v) * ((1 - u) * shade(top, left) + u * shade(top, right)) + v * ((1 - u) * shade(bottom, left) + u * shade(bottom, right));
}

GreyImage read_grey_png(ByteSource& source)
{
    const std::vector<char> bytes = source.read_all(largest_picture_file);
    OpenPng png;
    if (!png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size())) throw InputError(source.name(), png.image.message);
    if (std::uint64_t(png.image.width) * png.image.height > most_pixels) throw InputError(source.name(), "a picture of more than 64 million pixels");
    GreyImage result{png.image.width, png.image.height, {}};
    // libpng takes 16 bits as brightness and 8 bits as sRGB; asked for as they are, neither is converted.
    const bool is_deep = (png.image.format & PNG_FORMAT_FLAG_LINEAR) != 0;
    png.image.format = is_deep ? PNG_FORMAT_LINEAR_Y : PNG_FORMAT_GRAY;
    result.shades = is_deep ? read_shades<std::uint16_t>(png.image, source.name()) : read_shades<std::uint8_t>(png.image, source.name());
    return result;
}

} // namespace druse
