#include "io/face_colours.h"

#include "io/group_materials.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_set>

namespace druse {

namespace {

void describe(int id, const Material& material, GroupTable& groups)
{
    // Our own writers give every group a colour; the one that it would have anyway is not its own.
    if (material.colour && *material.colour != GroupTable::default_colour(id)) groups.set_colour(id, *material.colour);
    if (!material.group_name.empty()) groups.set_name(id, material.group_name);
}

} // namespace

void ColourNumbers::add_cube(std::uint32_t outer)
{
    cube_of_[outer] = numbers_.size() / cube_size + 1;
    std::fill_n(numbers_.extend(cube_size), cube_size, 0);
}

std::int32_t FacePaints::material(std::string_view name)
{
    if (name.empty()) return 0;
    const auto found = by_name_.find(name);
    if (found != by_name_.end()) return found->second;
    const auto paint = static_cast<std::int32_t>(paints_.size());
    paints_.push_back({false, std::string(name), {}});
    by_name_.emplace(name, paint);
    return paint;
}

std::int32_t FacePaints::colour(Colour c)
{
    const auto [at, added] = by_colour_.try_emplace(c, static_cast<std::int32_t>(paints_.size()));
    if (added) paints_.push_back({true, "", c});
    return at->second;
}

bool FacePaints::named_as_groups(const std::vector<bool>& used) const
{
    for (std::size_t paint = 1; paint < paints_.size(); ++paint)
        if (used[paint] && (paints_[paint].is_colour || !group_of_material(paints_[paint].material))) return false;
    return true;
}

void FacePaints::colour_groups(std::span<const std::int32_t> faces, std::span<const std::int32_t> ids, const Materials& materials,
                               GroupTable& groups) const
{
    std::unordered_set<std::int32_t> met;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (f > 0 && ids[f] == ids[f - 1]) continue;
        if (!met.insert(ids[f]).second) continue;
        if (const Material* material = materials.find(paints_[static_cast<std::size_t>(faces[f])].material))
            describe(ids[f], *material, groups);
    }
}

bool FacePaints::to_groups(std::span<std::int32_t> faces, const Materials& materials, GroupTable& groups) const
{
    if (paints_.size() == 1) return false;
    std::vector<bool> used(paints_.size(), false);
    for (const std::int32_t paint : faces) used[static_cast<std::size_t>(paint)] = true;
    if (std::find(used.begin() + 1, used.end(), true) == used.end()) return false;

    std::vector<std::int32_t> group_of_paint(paints_.size(), -1);
    group_of_paint[0] = 0;
    if (named_as_groups(used)) {
        for (std::size_t paint = 1; paint < paints_.size(); ++paint) {
            if (!used[paint]) continue;
            const int id = *group_of_material(paints_[paint].material);
            group_of_paint[paint] = id;
            const Material* material = materials.find(paints_[paint].material);
            if (material) describe(id, *material, groups);
        }
    } else {
        int last = 0;
        ColourNumbers colours;
        std::vector<std::int32_t> group_of_colour;
        for (const std::int32_t face_paint : faces) {
            const auto paint = static_cast<std::size_t>(face_paint);
            if (group_of_paint[paint] >= 0) continue;
            const Material* material = paints_[paint].is_colour ? nullptr : materials.find(paints_[paint].material);
            if (!paints_[paint].is_colour && !(material && material->colour)) {
                group_of_paint[paint] = ++last; // known by its name only
                continue;
            }
            const Colour colour = paints_[paint].is_colour ? paints_[paint].colour : *material->colour;
            const auto n = static_cast<std::size_t>(colours.number(colour));
            if (n > group_of_colour.size()) {
                group_of_colour.push_back(++last);
                groups.set_colour(last, colour);
            }
            group_of_paint[paint] = group_of_colour[n - 1];
        }
    }
    for (std::int32_t& face : faces) face = group_of_paint[static_cast<std::size_t>(face)];
    return true;
}

void groups_from_vertex_colours(std::span<const Vertex> corners, std::span<const std::uint32_t> ends,
                                std::span<const Vector> colours, std::span<std::int32_t> faces, GroupTable& groups)
{
    const auto channel = [](double x) { return static_cast<std::uint8_t>(std::clamp(x, 0.0, 1.0) * 255.0 + 0.5); };
    ColourNumbers numbers;
    std::uint32_t begin = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        Vector sum(0.0);
        for (std::uint32_t c = begin; c < ends[f]; ++c) sum += colours[corners[c].index];
        const Vector mean = sum / double(ends[f] - begin);
        faces[f] = std::isnan(mean.x) ? 0 : numbers.number({channel(mean.x), channel(mean.y), channel(mean.z)});
        begin = ends[f];
    }
    int id = 0;
    for (const Colour c : numbers.colours()) groups.set_colour(++id, c);
}

void groups_from_materials(std::span<std::int32_t> faces, std::size_t count, const std::function<NamedColour(std::size_t)>& material, GroupTable& groups)
{
    std::vector<std::optional<NamedColour>> used(count);
    std::vector<std::size_t> order; // as first met
    for (const std::int32_t face : faces) {
        const auto m = static_cast<std::size_t>(face);
        if (m == 0 || used[m - 1]) continue;
        used[m - 1] = material(m - 1);
        order.push_back(m - 1);
    }
    std::vector<std::int32_t> group(count + 1, 0);
    if (std::ranges::all_of(order, [&](std::size_t m) { return used[m]->group.has_value(); })) {
        std::ranges::sort(order);
        std::set<int> known;
        for (const std::size_t m : order) {
            const int id = *used[m]->group;
            group[m + 1] = id;
            if (known.insert(id).second) describe(id, {used[m]->colour, group_name_in(used[m]->name)}, groups); // the first of each group counts
        }
    } else {
        ColourNumbers colours;
        for (const std::size_t m : order) group[m + 1] = colours.number(used[m]->colour);
        int id = 0;
        for (const Colour c : colours.colours()) groups.set_colour(++id, c);
    }
    for (std::int32_t& face : faces) face = group[static_cast<std::size_t>(face)];
}

} // namespace druse
