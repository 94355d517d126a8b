#include "ops/registry.h"

#include "dlfl/errors.h"

#include <fmt/format.h>

namespace druse {

namespace {

std::string normalised(std::string_view name)
{
    std::string text(name);
    for (char& c : text)
        if (c == '.' || c == '-') c = '_';
    return text;
}

std::string_view last_part(std::string_view name) { return name.substr(name.find('.') + 1); }

} // namespace

void Registry::add(Operator op)
{
    const std::size_t at = operators_.size();
    ASSERT(by_name_.emplace(normalised(op.name), at).second, "operator names that differ");
    by_last_part_.emplace(normalised(last_part(op.name)), at);
    for (const std::string& alias : op.aliases) {
        ASSERT(by_name_.emplace(normalised(alias), at).second, "aliases that differ from all names");
        by_last_part_.emplace(normalised(last_part(alias)), at);
    }
    operators_.push_back(std::move(op));
}

const Operator* Registry::find(std::string_view name) const
{
    const std::string key = normalised(name);
    if (const auto it = by_name_.find(key); it != by_name_.end()) return &operators_[it->second];
    if (by_last_part_.count(key) == 1) return &operators_[by_last_part_.find(key)->second];
    return nullptr;
}

const Operator& Registry::get(std::string_view name) const
{
    if (const Operator* op = find(name)) return *op;
    std::vector<std::string> several;
    const auto [begin, end] = by_last_part_.equal_range(normalised(name));
    for (auto it = begin; it != end; ++it) several.push_back(operators_[it->second].name);
    if (several.size() > 1) throw CommandError(fmt::format("'{}' may mean {}", name, listing(several)));

    std::vector<std::string> names;
    for (const Operator& op : operators_) {
        names.push_back(op.name);
        names.insert(names.end(), op.aliases.begin(), op.aliases.end());
    }
    std::string best = nearest(name, names);
    if (best.empty()) {
        // Without its family: compare with last parts, and answer with the full name.
        std::vector<std::string> parts;
        for (const std::string& full : names) parts.emplace_back(last_part(full));
        if (const std::string part = nearest(name, parts); !part.empty())
            for (const std::string& full : names)
                if (last_part(full) == part) {
                    best = full;
                    break;
                }
    }
    throw CommandError(best.empty() ? fmt::format("unknown operator '{}'; `druse ops` lists them", name)
                                    : fmt::format("unknown operator '{}'; did you mean '{}'?", name, best));
}

} // namespace druse
