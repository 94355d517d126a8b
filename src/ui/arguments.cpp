#include "ui/arguments.h"

#include "app/command.h"

#include <algorithm>

namespace druse::ui {

std::string Arguments::text(std::string_view parameter) const
{
    if (const auto it = given_.find(parameter); it != given_.end()) return it->second;
    const Parameter* p = operator_->find(parameter);
    return p ? p->default_text : std::string();
}

void Arguments::set(std::string_view parameter, std::string_view text)
{
    const Parameter* p = operator_->find(parameter);
    ASSERT(p, "a parameter of the operator");
    const bool off = p->optional && p->type == Parameter::Type::toggle && text == "false"; // a switch that may stay unset is so when off
    if (text.empty() || text == p->default_text || off) {
        if (const auto it = given_.find(parameter); it != given_.end()) given_.erase(it);
        return;
    }
    const std::shared_ptr<void> trial = operator_->make();
    p->set(trial.get(), text);
    given_[p->name] = std::string(text);
}

bool Arguments::counts(std::string_view parameter) const
{
    const Parameter* p = operator_->find(parameter);
    if (!p || !(p->governor.empty() || Operator::counts(*p, text(p->governor)))) return false;
    return std::none_of(operator_->parameters.begin(), operator_->parameters.end(),
                        [&](const Parameter& other) { return other.instead_of == p->name && given_.contains(other.name); });
}

std::string Arguments::command(const std::vector<std::pair<std::string, std::string>>& overrides) const
{
    std::string line = operator_->name;
    for (const Parameter& p : operator_->parameters) {
        const auto over = std::find_if(overrides.begin(), overrides.end(), [&](const auto& o) { return o.first == p.name; });
        if (over != overrides.end()) line.append(" ").append(argument_text(p.name, over->second));
        else if (const auto it = given_.find(p.name); it != given_.end() && counts(p.name)) line.append(" ").append(argument_text(p.name, it->second));
    }
    return line;
}

} // namespace druse::ui
