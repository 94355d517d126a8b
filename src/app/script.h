#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace druse {

/// Commands as text, one a line, with `#` comments.
struct Script {
    std::string name;             // what errors call it
    std::filesystem::path path;   // without links; empty if it is no file
    std::filesystem::path folder; // what its file parameters are relative to
    std::string text;

    static constexpr std::size_t most_bytes = std::size_t(64) << 20;
    static constexpr std::size_t most_nested = 16; // scripts that open scripts

    /// @throws InputError if it cannot be read or is larger than `most_bytes`
    static Script read(const std::filesystem::path& file);
    /// From standard input; relative to the working folder.
    static Script read_standard_input();
};

/// True for `druse`, the format of scripts, in either case.
bool is_script_format(std::string_view format);
/// True for a file that is a script by its extension.
bool is_script(const std::filesystem::path& file);

/// Takes the next line off the text, without its line break (`\n` or `\r\n`).
std::string_view next_line(std::string_view& text);

} // namespace druse
