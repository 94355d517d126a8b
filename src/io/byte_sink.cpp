#include "io/byte_sink.h"

#include "dlfl/errors.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include <unistd.h>

namespace druse {

ByteSink::ByteSink(int descriptor, std::string name)
    : descriptor_(descriptor), name_(std::move(name)), buffer_(std::make_unique_for_overwrite<char[]>(capacity))
{
}

void ByteSink::put(std::string_view text)
{
    while (!text.empty()) {
        const std::size_t count = std::min<std::size_t>(text.size(), 1 << 16);
        std::memcpy(room(count), text.data(), count);
        use(count);
        text.remove_prefix(count);
    }
}

void ByteSink::flush()
{
    write_all(buffer_.get(), used_);
    used_ = 0;
}

void ByteSink::overwrite(std::uint64_t offset, std::string_view bytes)
{
    flush();
    while (!bytes.empty()) {
        const ssize_t count = pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) throw InputError(name_, std::string("cannot be written: ") + std::strerror(errno));
        bytes.remove_prefix(static_cast<std::size_t>(count));
        offset += static_cast<std::uint64_t>(count);
    }
}

void ByteSink::write_all(const char* bytes, std::size_t count)
{
    while (count > 0) {
        const ssize_t written = write(descriptor_, bytes, count);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) throw InputError(name_, std::string("cannot be written: ") + std::strerror(errno));
        bytes += written;
        count -= static_cast<std::size_t>(written);
    }
}

} // namespace druse
