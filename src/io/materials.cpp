#include "io/materials.h"

#include "dlfl/errors.h"
#include "io/scan.h"
#include "io/text_blocks.h"

#include <fmt/format.h>

#include <charconv>

namespace druse {

namespace {

/// The rest of a line without the blanks around it.
std::string_view rest_of_line(const char* p, const char* end_of_line)
{
    while (p != end_of_line && scan::is_blank(*p)) ++p;
    while (end_of_line != p && scan::is_blank(end_of_line[-1])) --end_of_line;
    return {p, static_cast<std::size_t>(end_of_line - p)};
}

bool take_word(std::string_view& line, std::string_view word)
{
    if (!line.starts_with(word) || (line.size() > word.size() && !scan::is_blank(line[word.size()]))) return false;
    line.remove_prefix(word.size());
    while (!line.empty() && scan::is_blank(line.front())) line.remove_prefix(1);
    return true;
}

/// The colour `r g b`, or `r` for a grey; nothing, and `wrong` the place, where something is no number.
std::optional<Colour> colour_at(const char* at, const char*& wrong)
{
    double channel[3] = {0, 0, 0};
    for (int i = 0; i < 3; ++i) {
        while (scan::is_blank(*at)) ++at;
        if (i > 0 && *at == '\n') {
            channel[i] = channel[0];
            continue;
        }
        const char* const after = scan::number(at, channel[i]);
        if (!after || !scan::ends_word(*after)) {
            wrong = at;
            return std::nullopt;
        }
        at = after;
    }
    return colour_from_unit(channel[0], channel[1], channel[2]);
}

} // namespace

void Materials::read_library(const ByteSource& model, std::string_view names)
{
    const auto read_if_there = [&](std::string_view name) {
        const auto path = model.find_side_file(std::string(name));
        if (!path) return false;
        std::optional<ByteSource> file;
        try {
            file.emplace(ByteSource::file(*path));
        } catch (const InputError&) {
            return false; // there, but not for us to read
        }
        read(*file);
        return true;
    };
    if (read_if_there(names)) return;
    const std::string_view all = names;
    while (!names.empty()) {
        std::size_t length = 0;
        while (length < names.size() && !scan::is_blank(names[length])) ++length;
        const std::string_view name = names.substr(0, length);
        if (name.size() == all.size() || !read_if_there(name)) missing_.emplace_back(name);
        while (length < names.size() && scan::is_blank(names[length])) ++length;
        names.remove_prefix(length);
    }
}

void Materials::read(ByteSource& file)
{
    Material* current = nullptr;
    long line_number = 0;
    TextBlocks blocks(file);
    const char *p = nullptr, *end = nullptr;
    while (blocks.next(p, end))
        while (p < end) {
            ++line_number;
            const char* line_end = p;
            while (*line_end != '\n') ++line_end;
            std::string_view line = rest_of_line(p, line_end);
            p = line_end + 1;
            if (take_word(line, "newmtl")) {
                current = &by_name_[std::string(line)];
                *current = {};
            } else if (current && take_word(line, "Kd")) {
                // `Kd spectral …` and `Kd xyz …` say nothing in red, green and blue.
                if (take_word(line, "spectral") || take_word(line, "xyz")) continue;
                const char* wrong = nullptr;
                current->colour = colour_at(line.data(), wrong);
                if (wrong && malformed_++ == 0)
                    first_malformed_ = fmt::format("{}:{}: Kd: expected a number, found {}", file.name(), line_number, scan::quoted_word(wrong));
            } else if (current && take_word(line, "#") && take_word(line, "name")) {
                current->group_name = std::string(line.substr(0, line.find_first_of(" \t")));
            }
        }
}

std::vector<std::string> Materials::notes() const
{
    std::vector<std::string> notes;
    const auto more = [](std::size_t count) { return count == 1 ? "" : "s"; };
    if (missing_.size() == 1) notes.push_back(fmt::format("{} cannot be read: its colours are unknown", missing_[0]));
    if (missing_.size() > 1)
        notes.push_back(fmt::format("{} and {} more .mtl file{} cannot be read: their colours are unknown", missing_[0], missing_.size() - 1,
                                    more(missing_.size() - 1)));
    if (malformed_ == 1) notes.push_back(fmt::format("{}: the colour is unknown", first_malformed_));
    if (malformed_ > 1) notes.push_back(fmt::format("{}: this and {} more colour{} are unknown", first_malformed_, malformed_ - 1, more(malformed_ - 1)));
    return notes;
}

const Material* Materials::find(std::string_view name) const
{
    const auto found = by_name_.find(name);
    return found == by_name_.end() ? nullptr : &found->second;
}

std::string material_of_group(int id)
{
    return fmt::format("group_{}", id);
}

std::optional<int> group_of_material(std::string_view name)
{
    constexpr std::string_view prefix = "group_";
    if (!name.starts_with(prefix)) return std::nullopt;
    name.remove_prefix(prefix.size());
    if (name.empty() || !scan::is_digit(name[0]) || (name[0] == '0' && name.size() > 1)) return std::nullopt;
    int id = 0;
    const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), id);
    if (error != std::errc() || stop != name.data() + name.size()) return std::nullopt;
    return id;
}

} // namespace druse
