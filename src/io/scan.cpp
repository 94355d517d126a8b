#include "io/scan.h"

#include <charconv>

namespace druse::scan {

bool number_in_full(const char* begin, const char* end, double& value)
{
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (stop != end) return false;
    if (error != std::errc::result_out_of_range) return true;
    // Too large, or so small that it is nothing. The first digit that counts tells, together with the exponent.
    const char* p = begin;
    std::int64_t magnitude = 0; // of the first digit, against the point
    bool point = false, found = false;
    for (; p != end && (is_digit(*p) || *p == '.'); ++p) {
        if (*p == '.') {
            point = true;
            continue;
        }
        found = found || *p != '0';
        if (found && !point) ++magnitude;
        if (!found && point) --magnitude;
    }
    std::int64_t exponent = 0;
    if (p != end) integer(p + 1, exponent);
    if (magnitude + exponent > 0) return false;
    value = 0.0;
    return true;
}

std::string quoted_word(const char* p)
{
    constexpr std::size_t longest = 40;
    if (*p == '\n') return "the end of the line";
    std::string text = "'";
    for (; !ends_word(*p) && text.size() <= longest; ++p) text += static_cast<unsigned char>(*p) < 0x20 || *p == 0x7f ? '?' : *p;
    if (ends_word(*p)) return text + "'";
    while ((text.back() & 0xC0) == 0x80) text.pop_back(); // no half of a character
    if ((text.back() & 0xC0) == 0xC0) text.pop_back();
    return text + "…'";
}

} // namespace druse::scan
