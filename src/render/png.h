#pragma once

#include "render/image.h"

#include <cstdint>
#include <string>
#include <vector>

namespace druse {

/// The image as a PNG file in memory: RGB if every pixel is opaque, else RGBA. The same image gives the same bytes.
std::vector<std::uint8_t> encode_png(const Image& image);

/// Writes the image as a PNG file, beside the target first and renamed into place, so that a failure leaves what was there.
/// @throws InputError naming the file and the system's reason
void write_png(const std::string& file, const Image& image);

/// Reads any PNG as 8-bit RGBA. @throws InputError
Image read_png(const std::string& file);

} // namespace druse
