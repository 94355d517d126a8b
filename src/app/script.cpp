#include "app/script.h"

#include "dlfl/errors.h"
#include "io/byte_source.h"

#include <fmt/format.h>

#include <algorithm>

namespace druse {

namespace {

std::string read_all(ByteSource source)
{
    std::string text;
    constexpr std::size_t block = std::size_t(64) << 10;
    for (;;) {
        const std::size_t before = text.size();
        text.resize(before + block);
        const std::size_t count = source.read(text.data() + before, block);
        text.resize(before + count);
        if (text.size() > Script::most_bytes)
            throw InputError(source.name(), fmt::format("expected a script of at most {} MiB", Script::most_bytes >> 20));
        if (count < block) break;
    }
    if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3); // the mark some editors begin UTF-8 with
    return text;
}

} // namespace

Script Script::read(const std::filesystem::path& file)
{
    Script script{file.string(), {}, file.parent_path(), read_all(ByteSource::file(file))};
    std::error_code error;
    script.path = std::filesystem::canonical(file, error);
    return script;
}

Script Script::read_standard_input() { return {"standard input", {}, {}, read_all(ByteSource::standard_input())}; }

bool is_script_format(std::string_view format)
{
    return std::ranges::equal(format, std::string_view("druse"), {}, [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
}

bool is_script(const std::filesystem::path& file)
{
    const std::string extension = file.extension().string();
    return !extension.empty() && is_script_format(std::string_view(extension).substr(1));
}

std::string_view next_line(std::string_view& text)
{
    const auto end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

} // namespace druse
