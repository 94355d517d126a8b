#pragma once

#include "cell/cell_tile.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace druse::ui {

/// Points of a cell in space that are picked, in the order in which they were: the last one carries the vector along which they move. Two views share one.
class CellSelection {
public:
    /// One place of an orbit: with it the whole orbit moves.
    struct Pick {
        CellPointName name; // of the orbit
        OrbitMember at;     // its number now, and which of its members
        friend bool operator==(const Pick&, const Pick&) = default;
    };

    std::function<void()> on_change;

    const std::vector<Pick>& picks() const { return picks_; }
    bool empty() const { return picks_.empty(); }
    const Pick* last() const { return picks_.empty() ? nullptr : &picks_.back(); }
    bool has(const OrbitMember& member) const;
    bool has_orbit(int orbit) const;
    /// The names as commands take them, each once, the last one's last: `c0,p3:i5`; empty without one.
    std::string text() const;

    /// What a click does: picks one alone, or with `add` that too (and drops it, if it was the last one), or with `drop` takes it out.
    void click(const CellTile& cell, const OrbitMember& member, bool add, bool drop);
    void pick(const CellTile& cell, const std::vector<OrbitMember>& members);
    /// More, in their order, or fewer.
    void add(const CellTile& cell, const std::vector<OrbitMember>& members);
    void drop(const std::vector<OrbitMember>& members);
    void clear();

    /// The cell has changed: the same points stay picked, whatever they are called now, and what is no longer there is forgotten. Null, or a cell in phase I: all of it.
    void follow(const CellTile* cell);

private:
    void set(const CellTile& cell, std::vector<Pick> picks);

    std::vector<Pick> picks_;
    std::optional<CellTile> cell_; // that they are of, where there are any
};

} // namespace druse::ui
