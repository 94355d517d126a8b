#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace druse {

/// How far a text is read, where a parser that takes iterators can be asked.
struct TextPlace {
    const char* begin = nullptr;
    const char* at = nullptr;
    const char* end = nullptr;

    /// The line of the character read last but one: the parser looks one ahead behind a number.
    long line() const { return 1 + static_cast<long>(std::count(begin, at > begin ? at - 1 : begin, '\n')); }
};

/// Walks through a text and leaves behind where it is.
class TextWalk {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    TextWalk(TextPlace& place, const char* at) : place_(&place), at_(at) {}
    reference operator*() const { return *at_; }
    TextWalk& operator++()
    {
        place_->at = ++at_;
        return *this;
    }
    TextWalk operator++(int)
    {
        const TextWalk before = *this;
        ++*this;
        return before;
    }
    friend bool operator==(const TextWalk& a, const TextWalk& b) { return a.at_ == b.at_; }

private:
    TextPlace* place_;
    const char* at_;
};

} // namespace druse
