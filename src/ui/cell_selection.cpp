#include "ui/cell_selection.h"

#include <algorithm>
#include <set>
#include <utility>

namespace druse::ui {

namespace {

CellSelection::Pick pick_of(const CellTile& cell, const OrbitMember& member) { return {cell.name(member.orbit), member}; }

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

void CellSelection::set(std::vector<Pick> picks)
{
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
    set(std::move(picks));
}

void CellSelection::add(const CellTile& cell, const std::vector<OrbitMember>& members)
{
    std::vector<Pick> picks = picks_;
    std::erase_if(picks, [&](const Pick& pick) { return std::ranges::find(members, pick.at) != members.end(); }); // it is the last one again
    for (const OrbitMember& member : members) picks.push_back(pick_of(cell, member));
    set(std::move(picks));
}

void CellSelection::drop(const std::vector<OrbitMember>& members)
{
    std::vector<Pick> picks = picks_;
    std::erase_if(picks, [&](const Pick& pick) { return std::ranges::find(members, pick.at) != members.end(); });
    set(std::move(picks));
}

void CellSelection::clear() { set({}); }

void CellSelection::follow(const CellTile* cell)
{
    std::vector<Pick> picks;
    if (cell && cell->phase() == 2)
        for (Pick pick : picks_) {
            try {
                pick.at.orbit = cell->find(pick.name);
            } catch (const CellRefusal&) {
                continue;
            }
            const auto members = cell->members(pick.at.orbit);
            if (std::ranges::find(members, pick.at.shift) != members.end()) picks.push_back(std::move(pick));
        }
    set(std::move(picks));
}

} // namespace druse::ui
