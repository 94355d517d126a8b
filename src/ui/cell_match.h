#pragma once

#include "cell/cell_tile.h"

#include <optional>
#include <vector>

namespace druse::ui {

/// Which points of a cell are which after an edit, or steps of undo: names do not tell, because those behind one that goes or comes take other numbers.
///
/// Corners are told by their numbers. Others are the same where they lie, flat, in the same place of the same pane, edge orbit or split; and where all but one of
/// as many do, that one was moved. Of a cell of another kind, size or height nothing is the same.
/// Cost: linear in the points where none came or went, else n log n.
class CellMatch {
public:
    CellMatch(const CellTile& before, const CellTile& after);

    /// All points are called as they were.
    bool keeps_names() const { return keeps_names_; }
    /// What a point is called now; nothing if it is gone, or was none of the cell before.
    std::optional<CellPointName> now(const CellPointName& name) const;

private:
    using Numbers = std::optional<std::vector<int>>; // what each became, −1 for none; nothing where all stay

    bool is_another_ = false, keeps_names_ = true;
    std::vector<Numbers> inner_, edges_; // by pane and edge orbit
    Numbers splits_;
};

/// A place of an orbit, in the cell that is there now; nothing if it is gone.
std::optional<OrbitMember> member_now(const CellMatch& match, const CellTile& before, const CellTile& after, const OrbitMember& member);

} // namespace druse::ui
