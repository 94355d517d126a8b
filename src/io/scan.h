#pragma once

// Words and numbers off lines of text. All functions take a place in a text whose every line ends in '\n' and stop there at the
// latest; none allocates. They sit in the innermost loop of every reader of text.

#include <cstdint>
#include <string>

namespace druse::scan {

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
inline bool is_digit(char c) { return static_cast<unsigned char>(c - '0') < 10; }
inline bool ends_word(char c) { return c == '\n' || is_blank(c); }

/// The next place that is no blank. A backslash before a line break is one; `line` counts the break.
inline const char* skip_blanks(const char* p, long& line)
{
    while (true) {
        if (is_blank(*p)) {
            ++p;
        } else if (*p == '\\' && (p[1] == '\n' || (p[1] == '\r' && p[2] == '\n'))) {
            p += p[1] == '\n' ? 2 : 3;
            ++line;
        } else {
            return p;
        }
    }
}

/// The end of the word that starts here.
inline const char* end_of_word(const char* p)
{
    while (!ends_word(*p)) ++p;
    return p;
}

const char* number_in_full(const char* begin, const char* end, double& value);

/// Reads a decimal number, rounded correctly; null if there is none, if it is not finite, or too large for a double.
///
/// Up to 2^53 in the digits and 10^22 beside them, both are exact in a double, and so is one division or multiplication but for its
/// own rounding (Clinger, *How to read floating point numbers accurately*, 1990). Others take the long way.
inline const char* number(const char* p, double& value)
{
    static constexpr double power[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                       1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const bool negative = *p == '-';
    if (negative || *p == '+') ++p;
    const char* const begin = p;
    std::uint64_t mantissa = 0;
    for (; is_digit(*p); ++p) mantissa = 10 * mantissa + static_cast<std::uint64_t>(*p - '0');
    std::int64_t digits = p - begin;
    std::int64_t exponent = 0;
    if (*p == '.') {
        const char* const fraction = ++p;
        for (; is_digit(*p); ++p) mantissa = 10 * mantissa + static_cast<std::uint64_t>(*p - '0');
        exponent = fraction - p;
        digits -= exponent;
    }
    if (digits == 0) return nullptr;
    if ((*p | 0x20) == 'e') {
        const char* q = p + 1;
        const bool down = *q == '-';
        if (down || *q == '+') ++q;
        if (!is_digit(*q)) return nullptr;
        std::int64_t written = 0;
        for (; is_digit(*q); ++q)
            if (written < 1000000) written = 10 * written + (*q - '0');
        exponent += down ? -written : written;
        p = q;
    }
    if (digits <= 19 && mantissa <= (std::uint64_t(1) << 53) && exponent >= -22 && exponent <= 22) {
        const double m = static_cast<double>(mantissa);
        value = exponent < 0 ? m / power[-exponent] : m * power[exponent];
    } else if (!number_in_full(begin, p, value)) {
        return nullptr;
    }
    if (negative) value = -value;
    return p;
}

/// Reads a whole number with an optional sign; null if there is none. Numbers beyond ±10^18 come out as about that.
inline const char* integer(const char* p, std::int64_t& value)
{
    const bool negative = *p == '-';
    if (negative || *p == '+') ++p;
    if (!is_digit(*p)) return nullptr;
    std::int64_t n = 0;
    for (; is_digit(*p); ++p)
        if (n < 100000000000000000) n = 10 * n + (*p - '0');
    value = negative ? -n : n;
    return p;
}

/// The word that starts here, for an error: in quotes, cut off where it gets long, without bytes that a terminal would obey; or
/// `the end of the line`.
std::string quoted_word(const char* p);

} // namespace druse::scan
