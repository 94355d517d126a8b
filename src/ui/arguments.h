#pragma once

#include "ops/operator.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace druse::ui {

/// What a person has set of an operator's parameters, as texts. Parameters that were not touched are not there: a command names
/// only what differs from the defaults.
class Arguments {
public:
    explicit Arguments(const Operator& op) : operator_(&op) {}

    const Operator& op() const { return *operator_; }

    /// The text of a parameter: what was set, else its default; empty if it has none.
    std::string text(std::string_view parameter) const;
    /// Sets it; the default, or an empty text, takes it out again. @throws CommandError `expected …`; then the old value stays
    void set(std::string_view parameter, std::string_view text);
    void reset() { given_.clear(); }
    bool is_default(std::string_view parameter) const { return !given_.contains(parameter); }

    /// Whether a parameter counts with what the others are now. One that does not stays set, and is left out of commands.
    bool counts(std::string_view parameter) const;

    bool is_on(std::string_view toggle) const { return text(toggle) == "true"; }

    /// The command, with `overrides` in place of what was set or beside it.
    std::string command(const std::vector<std::pair<std::string, std::string>>& overrides = {}) const;

private:
    const Operator* operator_;
    std::map<std::string, std::string, std::less<>> given_;
};

} // namespace druse::ui
