#pragma once

#include <string>
#include <string_view>

namespace druse {

/// `text` with blanks behind it, up to `width` characters: a column of a table in a terminal.
inline std::string padded(std::string_view text, std::size_t width)
{
    std::string result(text);
    if (result.size() < width) result.append(width - result.size(), ' ');
    return result;
}

} // namespace druse
