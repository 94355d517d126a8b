#include "app/command.h"

#include "app/reference.h"
#include "dlfl/errors.h"
#include "ops/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace druse {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// A piece of a command inside a message: not longer than a line bears.
std::string shown(std::string_view text)
{
    constexpr std::size_t most = 60;
    if (text.size() <= most) return std::string(text);
    std::size_t end = most;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) --end; // not inside a character of UTF-8
    return std::string(text.substr(0, end)) + "…";
}

/// Reads the words of a line from left to right.
class CommandReader {
public:
    explicit CommandReader(std::string_view line) : rest_(line) {}

    Command read()
    {
        for (const char c : rest_)
            if ((static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f) throw CommandError("a command is one line without control characters");
        Command command;
        if (!at_word()) return command;
        command.name = std::string(bare());
        if (command.name.find_first_of("=\"") != std::string::npos)
            throw CommandError(fmt::format("expected the name of an operator, found '{}'", shown(command.name)));
        try {
            while (at_word()) command.arguments.push_back(argument());
        } catch (const CommandError& e) {
            throw CommandError(fmt::format("{}: {}", shown(command.name), e.what()));
        }
        return command;
    }

private:
    bool at_word()
    {
        while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
        return !rest_.empty() && rest_.front() != '#';
    }

    std::string_view bare()
    {
        const auto end = static_cast<std::size_t>(std::ranges::find_if(rest_, is_blank) - rest_.begin());
        const std::string_view word = rest_.substr(0, end);
        rest_.remove_prefix(end);
        return word;
    }

    std::pair<std::string, std::string> argument()
    {
        const std::size_t sign = rest_.find_first_of("= \t\"");
        if (sign == std::string_view::npos || sign == 0 || rest_[sign] != '=')
            throw CommandError(fmt::format("expected key=value, found '{}'", shown(bare())));
        std::string key(rest_.substr(0, sign));
        rest_.remove_prefix(sign + 1);
        if (rest_.starts_with('"')) return {std::move(key), quoted(key)};
        const std::string_view value = bare();
        if (value.find('"') != std::string_view::npos)
            throw CommandError(fmt::format("{}={}: expected quotes around the whole value", shown(key), shown(value)));
        return {std::move(key), std::string(value)};
    }

    std::string quoted(const std::string& key)
    {
        std::string value;
        for (std::size_t i = 1; i < rest_.size(); ++i) {
            if (rest_[i] == '"') {
                rest_.remove_prefix(i + 1);
                if (!rest_.empty() && !is_blank(rest_.front())) throw CommandError(fmt::format("{}=: expected a blank after the closing quote", shown(key)));
                return value;
            }
            if (rest_[i] == '\\') {
                ++i;
                if (i == rest_.size() || (rest_[i] != '"' && rest_[i] != '\\'))
                    throw CommandError(fmt::format("{}=: expected \\\" or \\\\ after a backslash in quotes", shown(key)));
            }
            value += rest_[i];
        }
        throw CommandError(fmt::format("{}=: the closing quote is missing", shown(key)));
    }

    std::string_view rest_;
};

/// Fills the parameters of one operator.
class Binder {
public:
    explicit Binder(const Operator& op) : op_(op), call_{&op, op.make(), std::vector<bool>(op.parameters.size(), false)} {}

    Invocation bind(const Command& command)
    {
        const auto arguments = each_once(command);
        for (const auto& [key, value] : arguments)
            if (key == "preset") take_preset(value);
        for (const auto& [key, value] : arguments)
            if (key != "preset") set(key, value);
        check_required();
        check_exclusive();
        check_replaced();
        check_governed();
        return std::move(call_);
    }

private:
    /// The arguments, with the values of a key that may be repeated as one.
    std::vector<std::pair<std::string, std::string>> each_once(const Command& command) const
    {
        std::vector<std::pair<std::string, std::string>> arguments;
        for (const auto& [key, value] : command.arguments) {
            const auto before = std::ranges::find_if(arguments, [&](const auto& a) { return a.first == key; });
            const Parameter* p = op_.find(key);
            if (before == arguments.end()) arguments.emplace_back(key, value);
            else if (p && p->repeated) before->second.append(" ").append(value);
            else throw CommandError(fmt::format("{} is given twice", shown(key)));
        }
        return arguments;
    }

    void set(const std::string& key, const std::string& value)
    {
        const auto p = std::ranges::find(op_.parameters, key, &Parameter::name);
        if (p == op_.parameters.end()) throw CommandError(unknown(key));
        try {
            p->set(call_.parameters.get(), value);
        } catch (const CommandError& e) {
            throw CommandError(fmt::format("{}={}: {}", key, shown(value), e.what()));
        }
        call_.given[static_cast<std::size_t>(p - op_.parameters.begin())] = true;
    }

    void take_preset(const std::string& name)
    {
        std::vector<std::string> names;
        for (const Preset& preset : op_.presets) {
            if (preset.name == name) {
                for (const auto& [key, value] : each_once(parse_command(op_.name + " " + preset.arguments))) set(key, value);
                return;
            }
            names.push_back(preset.name);
        }
        throw CommandError(names.empty() ? fmt::format("no preset '{}': it has none", shown(name))
                                         : fmt::format("no preset '{}'; expected {}", shown(name), listing(names)));
    }

    std::string unknown(const std::string& key) const
    {
        std::vector<std::string> names;
        for (const Parameter& p : op_.parameters) names.push_back(p.name);
        if (const std::string best = nearest(key, names); !best.empty())
            return fmt::format("unknown parameter '{}'; did you mean '{}'?", shown(key), best);
        return names.empty() ? fmt::format("unknown parameter '{}'; it takes none", shown(key))
                             : fmt::format("unknown parameter '{}'; expected {}", shown(key), listing(names));
    }

    void check_required() const
    {
        for (std::size_t i = 0; i < op_.parameters.size(); ++i) {
            const Parameter& p = op_.parameters[i];
            if (p.required && !call_.given[i]) throw CommandError(fmt::format("{}= is missing; expected {}: {}", p.name, takes_text(p), p.help));
        }
    }

    void check_exclusive() const
    {
        for (const auto& set : op_.exclusive) {
            std::vector<std::string> found;
            for (std::size_t i = 0; i < op_.parameters.size(); ++i)
                if (call_.given[i] && std::ranges::find(set, op_.parameters[i].name) != set.end()) found.push_back(op_.parameters[i].name);
            if (found.size() != 1)
                throw CommandError(fmt::format("expected exactly one of {}, found {}", listing(set, "and"),
                                               found.empty() ? "none" : listing(found, "and")));
        }
    }

    void check_replaced() const
    {
        for (std::size_t i = 0; i < op_.parameters.size(); ++i) {
            const std::string& other = op_.parameters[i].instead_of;
            if (!call_.given[i] || other.empty()) continue;
            const auto replaced = std::ranges::find(op_.parameters, other, &Parameter::name) - op_.parameters.begin();
            if (call_.given[static_cast<std::size_t>(replaced)])
                throw CommandError(fmt::format("{} is in place of {}: give one of them", op_.parameters[i].name, other));
        }
    }

    /// `turns: to=torus does not use it; it uses size, cycles, major and rho`.
    void check_governed() const
    {
        for (std::size_t i = 0; i < op_.parameters.size(); ++i) {
            const Parameter& p = op_.parameters[i];
            if (!call_.given[i] || p.governor.empty()) continue;
            const std::string value = op_.find(p.governor)->text(call_.parameters.get());
            if (Operator::counts(p, value)) continue;
            std::vector<std::string> used;
            for (const Parameter& other : op_.parameters)
                if (other.name != p.governor && (other.governor.empty() || (other.governor == p.governor && Operator::counts(other, value)))) used.push_back(other.name);
            throw CommandError(fmt::format("{}: {}={} does not use it{}", p.name, p.governor, value, used.empty() ? "" : "; it uses " + listing(used, "and")));
        }
    }

    const Operator& op_;
    Invocation call_;
};

} // namespace

Command parse_command(std::string_view line) { return CommandReader(line).read(); }

std::string argument_text(std::string_view key, std::string_view value)
{
    std::string text(key);
    text += '=';
    if (!value.empty() && value.find_first_of(" \t\"#") == std::string_view::npos) return text.append(value);
    text += '"';
    for (const char c : value) {
        if (c == '"' || c == '\\') text += '\\';
        text += c;
    }
    return text += '"';
}

std::string Invocation::text() const
{
    std::string text = op->name;
    for (std::size_t i = 0; i < op->parameters.size(); ++i) {
        if (!given[i]) continue;
        const Parameter& p = op->parameters[i];
        const std::string value = p.text(parameters.get());
        if (p.repeated) {
            for (const std::string_view piece : split(value, ' ')) text.append(" ").append(argument_text(p.name, piece));
            continue;
        }
        text += ' ';
        // A colour is written bare although it begins with `#`.
        text += p.type == Parameter::Type::colour ? p.name + "=" + value : argument_text(p.name, value);
    }
    return text;
}

Invocation bind(const Registry& registry, const Command& command)
{
    if (command.name.size() > 64) throw CommandError(fmt::format("unknown operator '{}'", shown(command.name)));
    const Operator& op = registry.get(command.name);
    try {
        return Binder(op).bind(command);
    } catch (const CommandError& e) {
        throw CommandError(fmt::format("{}: {}", op.name, e.what()));
    }
}

} // namespace druse
