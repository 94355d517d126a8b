#include "app/preset_file.h"

#include "app/command.h"
#include "app/script.h"
#include "dlfl/errors.h"
#include "io/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace druse {

std::filesystem::path PresetFile::default_path()
{
    if (const char* config = std::getenv("XDG_CONFIG_HOME"); config && *config) return std::filesystem::path(config) / "druse/presets";
    const char* home = std::getenv("HOME");
    return std::filesystem::path(home && *home ? home : "/tmp") / ".config/druse/presets";
}

PresetFile::PresetFile(std::filesystem::path file) : file_(std::move(file))
{
    std::error_code none;
    if (!std::filesystem::is_regular_file(file_, none)) return;
    try {
        const Script script = Script::read(file_);
        for (std::string_view rest = script.text; !rest.empty();) lines_.push_back(parse(next_line(rest)));
    } catch (const InputError&) {
        lines_.clear();
    }
}

PresetFile::Line PresetFile::parse(std::string_view text)
{
    Line line{std::string(text), {}, {}};
    try {
        const Command command = parse_command(text);
        for (const auto& [key, value] : command.arguments) {
            if (key == "preset") line.preset.name = value;
            else line.preset.arguments.append(line.preset.arguments.empty() ? "" : " ").append(argument_text(key, value));
        }
        if (!line.preset.name.empty()) line.operator_name = command.name;
    } catch (const CommandError&) {
    }
    return line;
}

std::vector<Preset> PresetFile::of(const Operator& op) const
{
    std::vector<Preset> list;
    for (const Line& line : lines_)
        if (line.operator_name == op.name) list.push_back(line.preset);
    return list;
}

std::vector<PresetFile::Line>::iterator PresetFile::find(const Operator& op, std::string_view name)
{
    return std::ranges::find_if(lines_, [&](const Line& line) { return line.operator_name == op.name && line.preset.name == name; });
}

void PresetFile::store(const Operator& op, Preset preset)
{
    if (preset.name.empty()) throw CommandError("a preset needs a name");
    if (std::ranges::find(op.presets, preset.name, &Preset::name) != op.presets.end())
        throw CommandError(fmt::format("preset={} of {} is part of Druse; choose another name", preset.name, op.name));
    std::string text = fmt::format("{} {} {}", op.name, argument_text("preset", preset.name), preset.arguments);
    if (preset.arguments.empty()) text.pop_back();
    Line line{std::move(text), op.name, std::move(preset)};
    if (const auto old = find(op, line.preset.name); old != lines_.end()) *old = std::move(line);
    else lines_.push_back(std::move(line));
    write();
}

void PresetFile::forget(const Operator& op, std::string_view name)
{
    const auto line = find(op, name);
    if (line == lines_.end()) return;
    lines_.erase(line);
    write();
}

void PresetFile::write() const
{
    if (file_.empty()) return;
    std::error_code error;
    std::filesystem::create_directories(file_.parent_path(), error);
    OutputSet output;
    ByteSink& sink = output.open(file_);
    for (const Line& line : lines_) sink.put(line.text + "\n");
    output.commit();
}

std::string PresetFile::expand(const Registry& registry, const std::string& command) const
{
    Command parsed;
    try {
        parsed = parse_command(command);
    } catch (const CommandError&) {
        return command;
    }
    const Operator* op = registry.find(parsed.name);
    const auto named = std::ranges::find(parsed.arguments, "preset", &std::pair<std::string, std::string>::first);
    if (!op || named == parsed.arguments.end()) return command;
    const auto line = std::ranges::find_if(lines_, [&](const Line& l) { return l.operator_name == op->name && l.preset.name == named->second; });
    if (line == lines_.end()) return command;

    parsed.arguments.erase(named);
    for (auto& value : parse_command(line->text).arguments)
        if (value.first != "preset" && std::ranges::find(parsed.arguments, value.first, &std::pair<std::string, std::string>::first) == parsed.arguments.end())
            parsed.arguments.push_back(std::move(value));
    std::string text = parsed.name;
    for (const auto& [key, value] : parsed.arguments) text.append(" ").append(argument_text(key, value));
    return text;
}

} // namespace druse
