#include "render/png.h"

#include "dlfl/errors.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <png.h>
#include <sys/stat.h>
#include <unistd.h>

namespace druse {

static_assert(sizeof(Pixel) == 4, "libpng reads and writes rows of pixels as they lie in memory");

namespace {

/// A file beside the target that is removed again unless it is renamed into place.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::string& target) : target_(target), name_(target + ".XXXXXX")
    {
        descriptor_ = mkstemp(name_.data());
        if (descriptor_ < 0) fail();
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile()
    {
        if (descriptor_ >= 0) close(descriptor_);
        if (!renamed_) unlink(name_.c_str());
    }

    void write(const std::vector<std::uint8_t>& bytes)
    {
        for (std::size_t done = 0; done < bytes.size();) {
            const ssize_t n = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
            if (n < 0 && errno == EINTR) continue;
            if (n < 0) fail();
            done += static_cast<std::size_t>(n);
        }
    }

    void rename_into_place()
    {
        // mkstemp makes files for the owner only; a picture is a file like any other.
        const mode_t mask = umask(0);
        umask(mask);
        const bool closed = fchmod(descriptor_, 0666 & ~mask) == 0 && close(descriptor_) == 0;
        descriptor_ = -1;
        if (!closed || std::rename(name_.c_str(), target_.c_str()) != 0) fail();
        renamed_ = true;
    }

private:
    [[noreturn]] void fail() const { throw InputError(target_, std::string("cannot write: ") + std::strerror(errno)); }

    std::string target_, name_;
    int descriptor_ = -1;
    bool renamed_ = false;
};

} // namespace

std::vector<std::uint8_t> encode_png(const Image& image)
{
    ASSERT(image.width > 0 && image.height > 0, "a picture has at least one pixel");
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width);
    header.height = static_cast<png_uint_32>(image.height);

    const bool opaque = std::all_of(image.pixels.begin(), image.pixels.end(), [](const Pixel& p) { return p.alpha == 255; });
    std::vector<std::uint8_t> rgb;
    const void* rows = image.pixels.data();
    if (opaque) {
        rgb.reserve(image.pixels.size() * 3);
        for (const Pixel& p : image.pixels) rgb.insert(rgb.end(), {p.red, p.green, p.blue});
        rows = rgb.data();
    }
    header.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;

    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
    std::vector<std::uint8_t> file(size);
    const bool written = png_image_write_to_memory(&header, file.data(), &size, 0, rows, 0, nullptr) != 0;
    ASSERT(written, "an image in memory can be encoded as PNG");
    file.resize(size);
    return file;
}

void write_png(const std::string& file, const Image& image)
{
    const std::vector<std::uint8_t> bytes = encode_png(image);
    TemporaryFile temporary(file);
    temporary.write(bytes);
    temporary.rename_into_place();
}

Image read_png(const std::string& file)
{
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&header, file.c_str())) throw InputError(file, header.message);
    header.format = PNG_FORMAT_RGBA;
    Image image(static_cast<int>(header.width), static_cast<int>(header.height));
    if (!png_image_finish_read(&header, nullptr, image.pixels.data(), 0, nullptr)) throw InputError(file, header.message);
    return image;
}

} // namespace druse
