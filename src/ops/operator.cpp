#include "ops/operator.h"

#include <algorithm>

namespace druse {

std::string Operator::title() const
{
    std::string text = name.substr(name.find('.') + 1);
    for (char& c : text)
        if (c == '_') c = ' ';
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

const Parameter* Operator::find(std::string_view parameter) const
{
    for (const Parameter& p : parameters)
        if (p.name == parameter) return &p;
    return nullptr;
}

bool Operator::counts(const Parameter& p, std::string_view value)
{
    return p.governor.empty() || std::ranges::find(p.governing, value) != p.governing.end();
}

Registration::Registration(std::string_view name, std::string_view help, std::function<std::shared_ptr<void>()> make)
{
    operator_.name = name;
    operator_.help = help;
    operator_.make = std::move(make);
}

void Registration::add(Parameter&& parameter) { operator_.parameters.push_back(std::move(parameter)); }

void Registration::add_exclusive(std::initializer_list<const char*> names) { operator_.exclusive.emplace_back(names.begin(), names.end()); }

void Registration::add_preset(std::string_view name, std::string_view arguments)
{
    operator_.presets.push_back({std::string(name), std::string(arguments)});
}

} // namespace druse
