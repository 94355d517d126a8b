#pragma once

// Words and numbers off lines of text. All functions take a place in a text whose every line ends in '\n' and stop there at the
// latest; none allocates. They sit in the innermost loop of every reader of text, and look at eight bytes at once: as many must
// be readable from any place in the text on.

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

namespace druse::scan {

inline bool is_one_of(std::uint64_t set, char c)
{
    return static_cast<unsigned char>(c) < 64 && (set >> c & 1) != 0;
}
inline bool is_blank(char c)
{
    return is_one_of(1ull << ' ' | 1ull << '\t' | 1ull << '\r' | 1ull << '\v' | 1ull << '\f', c);
}
inline bool ends_word(char c)
{
    return c == '\n' || is_blank(c);
}
inline bool is_digit(char c)
{
    return static_cast<unsigned char>(c - '0') < 10;
}

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

/// Reads all the digits from here on: number · 10^(how many) + their value, modulo 2^64.
inline const char* digits(const char* p, std::uint64_t& number)
{
    static constexpr std::uint64_t power[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
    static_assert(std::endian::native == std::endian::little, "the first digit is the lowest byte");
    while (true) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, p, 8);
        eight ^= 0x3030303030303030u; // digits are 0 to 9 now, and everything else is more
        const std::uint64_t others = ((eight + 0x7676767676767676u) | eight) & 0x8080808080808080u;
        const int count = others ? std::countr_zero(others) / 8 : 8;
        if (count == 0) return p;
        eight <<= 64 - 8 * count; // zeros in front
        eight = (eight * 10 + (eight >> 8)) & 0x00ff00ff00ff00ffu;
        eight = (eight * 100 + (eight >> 16)) & 0x0000ffff0000ffffu;
        eight = (eight * 10000 + (eight >> 32)) & 0xffffffffu;
        number = number * power[count] + eight;
        p += count;
        if (count < 8) return p;
    }
}

bool number_in_full(const char* begin, const char* end, double& value);

/// Reads a decimal number, rounded correctly; null if there is none, if it is not finite, or too large for a double.
///
/// Up to 2^53 in the digits and 10^22 beside them, both are exact in a double, and so is one division or multiplication but for
/// its own rounding (Clinger, *How to read floating point numbers accurately*, 1990). Others take the long way.
inline const char* number(const char* p, double& value)
{
    static constexpr double power[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                       1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const bool negative = *p == '-';
    p += negative || *p == '+';
    const char* const begin = p;
    std::uint64_t mantissa = 0;
    p = digits(p, mantissa);
    std::int64_t count = p - begin;
    std::int64_t exponent = 0;
    if (*p == '.') {
        const char* const fraction = p + 1;
        p = digits(fraction, mantissa);
        exponent = fraction - p;
        count -= exponent;
    }
    if (count == 0) return nullptr;
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
    if (count <= 19 && mantissa <= (std::uint64_t(1) << 53) && exponent >= -22 && exponent <= 22) {
        const double m = static_cast<double>(mantissa);
        value = exponent < 0 ? m / power[-exponent] : m * power[exponent];
    } else if (!number_in_full(begin, p, value)) {
        return nullptr;
    }
    constexpr double sign[] = {1.0, -1.0}; // no branch: signs are hard to foretell
    value *= sign[negative];
    return p;
}

/// Reads a whole number with an optional sign; null if there is none. Numbers of more than 18 digits come out as ±10^18.
inline const char* integer(const char* p, std::int64_t& value)
{
    const bool negative = *p == '-';
    p += negative || *p == '+';
    std::uint64_t n = 0;
    const char* const end = digits(p, n);
    if (end == p) return nullptr;
    if (end - p > 18) n = 1000000000000000000u;
    value = negative ? -static_cast<std::int64_t>(n) : static_cast<std::int64_t>(n);
    return end;
}

/// The word that starts here, for an error: in quotes, cut off where it gets long, without bytes that a terminal would obey; or
/// `the end of the line`.
std::string quoted_word(const char* p);

} // namespace druse::scan
