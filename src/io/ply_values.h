#pragma once

#include "dlfl/errors.h"
#include "io/ply_header.h"
#include "io/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>

namespace druse {

// The two ways in which the values of a PLY file come, one element after the other, with the same calls: next() begins an
// element, number() and pass_over() take its values, end() ends it. All throw InputError with the place in the file.

/// Values in text, each element on its own line.
class PlyText {
public:
    PlyText(ByteSource& source, const PlyHeader& header) : name_(source.name()), lines_(source, false)
    {
        for (long i = 0; i < header.lines; ++i) lines_.next_line();
    }

    void next(const std::string& element, std::uint64_t number, std::uint64_t count)
    {
        if (!lines_.next_line_of_words()) throw InputError(name_, fmt::format("ends in {} {} of {}", element, number, count));
    }
    double number(PlyType) { return lines_.number(); }
    void pass_over(PlyType, std::uint64_t count)
    {
        for (; count > 0; --count) {
            if (lines_.at_end()) fail("expected a value, found the end of the line");
            lines_.pass_over();
        }
    }
    void end()
    {
        if (!lines_.at_end()) fail("expected the end of the line, found " + scan::quoted_word(lines_.word().data()));
    }
    bool has_more() { return lines_.next_line_of_words(); }
    [[noreturn]] void fail(const std::string& what) const { lines_.fail(what); }

private:
    const std::string& name_;
    TextLines lines_;
};

/// Values as they lie in memory, in either byte order.
class PlyBytes {
public:
    PlyBytes(ByteSource& source, const PlyHeader& header)
        : source_(source),
          turned_((header.encoding == PlyEncoding::little_endian) != (std::endian::native == std::endian::little)),
          buffer_(std::make_unique_for_overwrite<char[]>(capacity))
    {
        pass_over(PlyType::uint8, header.size);
    }

    void next(const std::string& element, std::uint64_t number, std::uint64_t count)
    {
        element_ = &element;
        number_ = number;
        count_ = count;
    }

    double number(PlyType type)
    {
        switch (type) {
        case PlyType::int8:
            return take<std::int8_t>();
        case PlyType::uint8:
            return take<std::uint8_t>();
        case PlyType::int16:
            return take<std::int16_t>();
        case PlyType::uint16:
            return take<std::uint16_t>();
        case PlyType::int32:
            return take<std::int32_t>();
        case PlyType::uint32:
            return take<std::uint32_t>();
        case PlyType::float32:
            return take<float>();
        case PlyType::float64:
            break;
        }
        return take<double>();
    }

    void pass_over(PlyType type, std::uint64_t count)
    {
        for (std::uint64_t left = count * size_of(type); left > 0;) {
            if (p_ == end_) need(1);
            const auto now = std::min<std::uint64_t>(left, static_cast<std::uint64_t>(end_ - p_));
            p_ += now;
            left -= now;
        }
    }

    void end() {}

    bool has_more()
    {
        char more = 0;
        return p_ != end_ || source_.read(&more, 1) > 0;
    }

    [[noreturn]] void fail(const std::string& what) const
    {
        throw InputError(source_.name(),
                         fmt::format("before byte {}: {}", before_ + static_cast<std::uint64_t>(p_ - buffer_.get()), what));
    }

private:
    static constexpr std::size_t capacity = std::size_t(1) << 20;

    template <class T> T take()
    {
        if (static_cast<std::size_t>(end_ - p_) < sizeof(T)) [[unlikely]]
            need(sizeof(T));
        char bytes[sizeof(T)];
        std::memcpy(bytes, p_, sizeof(T));
        p_ += sizeof(T);
        if (turned_) std::reverse(bytes, bytes + sizeof(T));
        return std::bit_cast<T>(bytes);
    }

    /// Reads on until that many bytes are there.
    void need(std::size_t count)
    {
        const auto left = static_cast<std::size_t>(end_ - p_);
        before_ += static_cast<std::uint64_t>(p_ - buffer_.get());
        std::memmove(buffer_.get(), p_, left);
        p_ = buffer_.get();
        end_ = p_ + left + source_.read(buffer_.get() + left, capacity - left);
        if (static_cast<std::size_t>(end_ - p_) < count)
            throw InputError(source_.name(), fmt::format("ends in {} {} of {}", *element_, number_, count_));
    }

    ByteSource& source_;
    bool turned_;
    std::unique_ptr<char[]> buffer_;
    char *p_ = buffer_.get(), *end_ = p_;
    std::uint64_t before_ = 0; // bytes of the file before the buffer
    const std::string* element_ = nullptr;
    std::uint64_t number_ = 0, count_ = 0;
};

} // namespace druse
