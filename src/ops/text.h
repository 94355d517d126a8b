#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace druse {

/// The shortest text that reads back as the same number.
std::string number_text(double x);

/// Reads all of `text` as a finite number, an integer, an id. @throws CommandError `expected …`
double parse_number(std::string_view text);
long long parse_integer(std::string_view text);
std::uint32_t parse_id(std::string_view text);

/// `text` with the letters A to Z made small.
std::string lower_case(std::string text);

/// The pieces between separators; an empty text has none, a leading or trailing separator gives an empty piece.
std::vector<std::string_view> split(std::string_view text, char separator);

/// The candidate most like `word`, or an empty text if none is near (more than a third of its letters differ).
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// `a`, `a or b`, `a, b or c`.
std::string listing(const std::vector<std::string>& words, std::string_view last = "or");

} // namespace druse
