#include "dlfl/group_table.h"

#include <algorithm>
#include <utility>

namespace druse {

Colour GroupTable::default_colour(int id)
{
    if (id <= 0) return {204, 204, 204};
    return colour_from_hsv((id - 1) * 0.618033988749895, 0.62, 0.93);
}

std::vector<GroupTable::Own>::const_iterator GroupTable::find(int id) const
{
    return std::lower_bound(colours_.begin(), colours_.end(), id, [](const Own& own, int i) { return own.id < i; });
}

Colour GroupTable::colour(int id) const
{
    const auto at = find(id);
    return at != colours_.end() && at->id == id ? at->colour : default_colour(id);
}

const std::string& GroupTable::name(int id) const
{
    static const std::string nameless;
    const auto at = names_.find(id);
    return at != names_.end() ? at->second : nameless;
}

bool GroupTable::has_own_colour(int id) const
{
    const auto at = find(id);
    return at != colours_.end() && at->id == id;
}

void GroupTable::set_colour(int id, Colour c)
{
    if (colours_.empty() || colours_.back().id < id) {
        colours_.push_back({id, c});
        return;
    }
    const auto at = colours_.begin() + (find(id) - colours_.cbegin());
    if (at->id == id)
        at->colour = c;
    else
        colours_.insert(at, {id, c});
}

void GroupTable::set_default_colour(int id)
{
    if (has_own_colour(id)) colours_.erase(find(id));
}

void GroupTable::set_name(int id, std::string name)
{
    if (name.empty())
        names_.erase(id);
    else
        names_[id] = std::move(name);
}

void GroupTable::forget(int id)
{
    set_default_colour(id);
    names_.erase(id);
}

} // namespace druse
