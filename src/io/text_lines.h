#pragma once

#include "dlfl/errors.h"
#include "io/scan.h"
#include "io/text_blocks.h"

#include <cstring>
#include <string>
#include <string_view>

namespace druse {

/// A text line by line, for formats in which each element has a line of its own. Throws InputError with the line.
class TextLines {
public:
    /// @param comments whether `#` begins what is passed over up to the end of the line
    TextLines(ByteSource& source, bool comments) : name_(source.name()), comments_(comments), blocks_(source) {}

    /// Goes on to the next line, at its first word; false after the last.
    bool next_line()
    {
        if (p_ != end_) p_ = static_cast<const char*>(std::memchr(p_, '\n', static_cast<std::size_t>(end_ - p_))) + 1;
        if (p_ == end_ && !blocks_.next(p_, end_)) {
            p_ = end_;
            return false;
        }
        ++line_;
        p_ = skip_blanks(p_);
        return true;
    }
    /// The same, but passes over lines without a word.
    bool next_line_of_words()
    {
        while (next_line())
            if (!at_end()) return true;
        return false;
    }

    /// True if no word is left on the line.
    bool at_end() const { return *p_ == '\n' || (comments_ && *p_ == '#'); }
    /// The next word, empty at the end of the line; more text follows behind it.
    std::string_view word() const { return {p_, static_cast<std::size_t>(at_end() ? 0 : scan::end_of_word(p_) - p_)}; }
    /// Goes on to the next word. Precondition: !at_end().
    void pass_over() { p_ = skip_blanks(scan::end_of_word(p_)); }

    double number()
    {
        double value = 0;
        const char* const after = scan::number(p_, value);
        if (!after || !(scan::ends_word(*after) || (comments_ && *after == '#')))
            fail("expected a number, found " + scan::quoted_word(p_));
        p_ = skip_blanks(after);
        return value;
    }

    [[noreturn]] void fail(const std::string& what) const { throw InputError(name_, line_, what); }

private:
    static const char* skip_blanks(const char* p)
    {
        while (scan::is_blank(*p)) ++p;
        return p;
    }

    const std::string& name_;
    bool comments_;
    TextBlocks blocks_;
    const char *p_ = nullptr, *end_ = nullptr;
    long line_ = 0;
};

} // namespace druse
