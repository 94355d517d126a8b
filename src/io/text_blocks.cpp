#include "io/text_blocks.h"

#include <cstring>

namespace druse {

namespace {

/// One past the last line break that ends a line for good, or 0.
std::size_t end_of_lines(const char* text, std::size_t size)
{
    while (size > 0) {
        const void* found = memrchr(text, '\n', size);
        if (!found) return 0;
        size = static_cast<std::size_t>(static_cast<const char*>(found) - text);
        std::size_t before = size;
        if (before > 0 && text[before - 1] == '\r') --before;
        if (before == 0 || text[before - 1] != '\\') return size + 1;
    }
    return 0;
}

constexpr std::size_t slack = 16; // two line breaks of our own, and what scan:: may look at behind the last line

} // namespace

TextBlocks::TextBlocks(ByteSource& source)
    : source_(source), buffer_(std::make_unique_for_overwrite<char[]>(std::size_t(1) << 20)), capacity_(std::size_t(1) << 20)
{
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (source_.head(byte_order_mark.size()) == byte_order_mark) {
        char skipped[3];
        source_.read(skipped, sizeof skipped);
    }
}

bool TextBlocks::next(const char*& begin, const char*& end)
{
    std::memmove(buffer_.get(), buffer_.get() + used_, filled_ - used_);
    filled_ -= used_;
    used_ = 0;
    while (true) {
        const std::size_t room = capacity_ - slack - filled_;
        if (!at_end_) {
            const std::size_t count = source_.read(buffer_.get() + filled_, room);
            filled_ += count;
            at_end_ = count < room;
        }
        if (at_end_) {
            if (filled_ == 0) return false;
            if (buffer_[filled_ - 1] != '\n') buffer_[filled_++] = '\n';
            buffer_[filled_] = '\n'; // a backslash in the last line leads here
            used_ = filled_;
        } else {
            used_ = end_of_lines(buffer_.get(), filled_);
        }
        if (used_ > 0) {
            begin = buffer_.get();
            end = begin + used_;
            return true;
        }
        auto larger = std::make_unique_for_overwrite<char[]>(2 * capacity_); // a line longer than the buffer
        std::memcpy(larger.get(), buffer_.get(), filled_);
        buffer_ = std::move(larger);
        capacity_ *= 2;
    }
}

} // namespace druse
