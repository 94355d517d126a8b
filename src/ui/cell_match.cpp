#include "ui/cell_match.h"

#include <algorithm>
#include <array>
#include <utility>

namespace druse::ui {

namespace {

std::array<double, 2> key_of(const Point2& p) { return {p.x, p.y}; }
double key_of(double t) { return t; }
std::array<double, 4> key_of(const std::array<double, 4>& split) { return split; }

/// Which of `after` each of `before` is, by places; nothing where all are those of the same number.
template <class T>
std::optional<std::vector<int>> matched(const std::vector<T>& before, const std::vector<T>& after)
{
    if (before.size() == after.size()) {
        std::size_t elsewhere = 0;
        for (std::size_t i = 0; i < before.size(); ++i) elsewhere += before[i] != after[i];
        if (elsewhere < 2) return {};
    }
    std::vector<std::pair<decltype(key_of(before[0])), int>> places;
    places.reserve(after.size());
    for (const T& place : after) places.emplace_back(key_of(place), static_cast<int>(places.size()));
    std::ranges::sort(places);
    std::vector<int> numbers;
    numbers.reserve(before.size());
    for (const T& place : before) {
        const auto found = std::ranges::lower_bound(places, key_of(place), {}, [](const auto& entry) { return entry.first; });
        numbers.push_back(found != places.end() && found->first == key_of(place) ? found->second : -1);
    }
    return numbers;
}

/// Pane and place of what splits made.
std::vector<std::array<double, 4>> splits_of(const CellTile& cell)
{
    std::vector<std::array<double, 4>> splits;
    for (int point = cell.point_count() - 1; point >= 0 && cell.name(point).kind == CellPointName::Kind::split; --point) {
        const Point at = cell.base(point);
        splits.push_back({static_cast<double>(cell.pane_of(point)), at.x, at.y, at.z});
    }
    std::ranges::reverse(splits);
    return splits;
}

} // namespace

CellMatch::CellMatch(const CellTile& before, const CellTile& after)
{
    is_another_ = before.cell().kind != after.cell().kind || before.cell().volume() != after.cell().volume();
    keeps_names_ = !is_another_;
    if (is_another_) return;
    for (int pane = 0; pane < before.pane_count(); ++pane) inner_.push_back(matched(before.interior(pane), after.interior(pane)));
    for (int edge = 0; edge < std::ssize(before.cell().edges); ++edge) edges_.push_back(matched(before.edge_points(edge), after.edge_points(edge)));
    splits_ = matched(splits_of(before), splits_of(after));
    const auto stay = [](const Numbers& numbers) { return !numbers; };
    keeps_names_ = !splits_ && std::ranges::all_of(inner_, stay) && std::ranges::all_of(edges_, stay);
}

std::optional<CellPointName> CellMatch::now(const CellPointName& name) const
{
    if (is_another_) return {};
    const Numbers* numbers = nullptr;
    switch (name.kind) {
    case CellPointName::Kind::interior: numbers = &inner_[static_cast<std::size_t>(name.pane)]; break;
    case CellPointName::Kind::edge: numbers = &edges_[static_cast<std::size_t>(name.line)]; break;
    case CellPointName::Kind::split: numbers = &splits_; break;
    default: break;
    }
    CellPointName now = name;
    if (numbers && *numbers) now.index = name.index < std::ssize(**numbers) ? (**numbers)[static_cast<std::size_t>(name.index)] : -1;
    return now.index >= 0 ? std::optional(now) : std::nullopt;
}

std::optional<OrbitMember> member_now(const CellMatch& match, const CellTile& before, const CellTile& after, const OrbitMember& member)
{
    const auto name = match.now(before.name(member.orbit));
    if (!name) return {};
    const int orbit = after.find(*name);
    const auto members = after.members(orbit);
    return std::ranges::find(members, member.shift) != members.end() ? std::optional(OrbitMember{orbit, member.shift}) : std::nullopt;
}

} // namespace druse::ui
