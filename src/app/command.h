#pragma once

#include "ops/registry.h"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace druse {

/// A command as written: `NAME key=value key=value …`, quotes taken off, nothing looked up yet.
struct Command {
    std::string name;
    std::vector<std::pair<std::string, std::string>> arguments;
};

/// Takes a line apart. Values are bare, or in double quotes with `\"` and `\\`; a `#` where a word would begin starts a comment, so
/// that colours need no quotes (`color=#2b73ff`). An empty or comment line gives an empty name. @throws CommandError
Command parse_command(std::string_view line);

/// `key=value` with the value quoted where it holds a blank, a quote or `#`, or nothing.
std::string argument_text(std::string_view key, std::string_view value);

/// A command whose operator and values are known: what Document runs and History remembers.
struct Invocation {
    const Operator* op = nullptr;
    std::shared_ptr<void> parameters;  // of the operator's own type
    std::vector<bool> given;           // by parameter: was it set by the command (or its preset)

    /// The command in canonical form: the operator's first name, then the given parameters in registered order with their
    /// values as Druse writes them.
    std::string text() const;
};

/// Looks up the operator and reads every value; `preset=NAME` first, so that the other values override it.
/// @throws CommandError `OPERATOR: key=value: expected …`, `OPERATOR: unknown parameter 'x'; did you mean 'y'?`, also for a key
/// given twice or a required one missing, and for sets of which exactly one is given
Invocation bind(const Registry& registry, const Command& command);

} // namespace druse
