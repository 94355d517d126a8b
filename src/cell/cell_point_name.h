#pragma once

#include <compare>
#include <string>
#include <string_view>

namespace druse {

/// How a point of a cell is called. With all that the lattice makes of it: `c4` a corner, `x2:1` the first point of edge orbit 2, `p3:i5` a point inside pane
/// 3 counted from 0, `s0` one made by a split. Inside one pane: `i5`, `v2` its corner, `e1:2` the second point of its side 1, `s0`; these may have the
/// pane before them. A split of an edge may lie on two sides of a pane: the first of them is meant, and `s0@2` is the one on side 2.
struct CellPointName {
    enum class Kind { corner, edge, interior, split, pane_corner, side };

    Kind kind = Kind::corner;
    int pane = -1;  // of what lies in a pane; -1: none is said
    int line = 0;   // of points of an edge orbit or side, which
    int index = 0;  // from 0
    int side = -1;  // of splits on a side, which; -1: none is said

    static CellPointName corner(int c) { return {Kind::corner, -1, 0, c, -1}; }
    static CellPointName edge(int orbit, int i) { return {Kind::edge, -1, orbit, i, -1}; }
    static CellPointName interior(int pane, int i) { return {Kind::interior, pane, 0, i, -1}; }
    static CellPointName split(int s, int side = -1) { return {Kind::split, -1, 0, s, side}; }

    /// @throws CommandError where it is no name of a point
    static CellPointName parse(std::string_view text);
    std::string text() const;
    /// Whether it says where it is without a pane.
    bool is_of_cell() const { return pane >= 0 || kind == Kind::corner || kind == Kind::edge || kind == Kind::split; }

    friend auto operator<=>(const CellPointName&, const CellPointName&) = default;
};

} // namespace druse
