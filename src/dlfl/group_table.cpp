#include "dlfl/group_table.h"

namespace druse {

Colour GroupTable::default_colour(int id)
{
    if (id <= 0) return {204, 204, 204};
    return colour_from_hsv((id - 1) * 0.618033988749895, 0.62, 0.93);
}

Colour GroupTable::colour(int id) const
{
    const auto it = entries_.find(id);
    return it != entries_.end() && it->second.colour ? *it->second.colour : default_colour(id);
}

const std::string& GroupTable::name(int id) const
{
    static const std::string nameless;
    const auto it = entries_.find(id);
    return it != entries_.end() ? it->second.name : nameless;
}

bool GroupTable::has_own_colour(int id) const
{
    const auto it = entries_.find(id);
    return it != entries_.end() && it->second.colour.has_value();
}

void GroupTable::set_colour(int id, Colour c) { entries_[id].colour = c; }

void GroupTable::set_default_colour(int id)
{
    const auto it = entries_.find(id);
    if (it == entries_.end()) return;
    it->second.colour.reset();
    if (it->second.name.empty()) entries_.erase(it);
}

void GroupTable::set_name(int id, std::string name) { entries_[id].name = std::move(name); }

void GroupTable::forget(int id) { entries_.erase(id); }

} // namespace druse
