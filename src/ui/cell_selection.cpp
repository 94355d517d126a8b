#include "ui/cell_selection.h"

#include "ui/cell_match.h"

#include <algorithm>
#include <set>
#include <utility>

namespace druse::ui {

namespace {

CellSelection::Pick pick_of(const CellTile& cell, const OrbitMember& member) { return {cell.name(member.orbit), member}; }

std::vector<CellSelection::Pick> picks_without(std::vector<CellSelection::Pick> picks, const std::vector<OrbitMember>& members)
{
    const auto key = [](const OrbitMember& member) { return std::pair(member.orbit, member.shift); };
    std::set<std::pair<int, LatticeStep>> out;
    for (const OrbitMember& member : members) out.insert(key(member));
    std::erase_if(picks, [&](const CellSelection::Pick& pick) { return out.contains(key(pick.at)); });
    return picks;
}

} // namespace

bool CellSelection::has(const OrbitMember& member) const { return std::ranges::find(picks_, member, &Pick::at) != picks_.end(); }

bool CellSelection::has_orbit(int orbit) const
{
    return std::ranges::find(picks_, orbit, [](const Pick& pick) { return pick.at.orbit; }) != picks_.end();
}

std::string CellSelection::text() const
{
    std::set<int> orbits;
    std::vector<const Pick*> last; // of each orbit, from the last one back
    for (auto pick = picks_.rbegin(); pick != picks_.rend(); ++pick)
        if (orbits.insert(pick->at.orbit).second) last.push_back(&*pick);
    std::string text;
    for (auto pick = last.rbegin(); pick != last.rend(); ++pick) text.append(text.empty() ? "" : ",").append((*pick)->name.text());
    return text;
}

void CellSelection::set(const CellTile& cell, std::vector<Pick> picks)
{
    cell_ = picks.empty() ? std::nullopt : std::optional(cell);
    if (picks == picks_) return;
    picks_ = std::move(picks);
    if (on_change) on_change();
}

void CellSelection::click(const CellTile& cell, const OrbitMember& member, bool add, bool drop)
{
    if (drop || (add && !picks_.empty() && picks_.back().at == member)) return this->drop({member});
    if (add) this->add(cell, {member});
    else pick(cell, {member});
}

void CellSelection::pick(const CellTile& cell, const std::vector<OrbitMember>& members)
{
    std::vector<Pick> picks;
    for (const OrbitMember& member : members) picks.push_back(pick_of(cell, member));
    set(cell, std::move(picks));
}

void CellSelection::add(const CellTile& cell, const std::vector<OrbitMember>& members)
{
    std::vector<Pick> picks = picks_without(picks_, members); // one of them is the last one again
    for (const OrbitMember& member : members) picks.push_back(pick_of(cell, member));
    set(cell, std::move(picks));
}

void CellSelection::drop(const std::vector<OrbitMember>& members)
{
    if (cell_) set(*cell_, picks_without(picks_, members));
}

void CellSelection::clear()
{
    if (cell_) set(*cell_, {});
}

void CellSelection::follow(const CellTile* cell)
{
    if (!cell_) return;
    if (!cell || cell->phase() != 2) return clear();
    const CellMatch match(*cell_, *cell);
    std::vector<Pick> picks;
    for (const Pick& pick : picks_)
        if (const auto member = member_now(match, *cell_, *cell, pick.at)) picks.push_back(pick_of(*cell, *member));
    set(*cell, std::move(picks));
}

} // namespace druse::ui
