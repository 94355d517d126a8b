#pragma once

#include "cell/cell_tile.h"

#include <array>
#include <string>
#include <vector>

namespace druse::ui {

/// A point of a pane as an editor shows it, by its number in the pane's mesh.
struct PanePoint {
    enum class Kind { corner, edge, interior, split };

    Kind kind = Kind::interior;
    Point2 at{0.0};
    int orbit = 0;      // its number in the cell
    std::string name;   // as commands take it, `p3:i5`; what lies on other panes too has the same name there
    CellPointName here; // in this pane, without it: `i5`, `v2`
};

/// What an editor shows of a pane of a cell: flat, whatever was moved.
struct ShownPane {
    /// A piece of a constraint.
    struct Line {
        std::array<PaneMesh::Index, 2> ends{};
        int chain = 0;
    };

    int pane = -1;              // none: nothing is shown
    bool is_flat = true;        // in phase I, so that it may be edited
    bool may_edit_sides = true; // points of edges come and go only while all panes are flat
    std::vector<Point2> outline; // the corners
    std::vector<CellSide> sides;
    std::vector<PanePoint> points;
    std::vector<PaneMesh::Corners> triangles;
    std::vector<PaneMesh::Index> rim; // counter-clockwise
    std::vector<int> rim_sides;       // on which side each point of it is the first of a piece
    std::vector<Line> lines;
    std::vector<std::vector<CellPointName>> chains; // constraints as their files have them, where the pane is flat

    Point2 low() const;
    Point2 high() const;
    bool holds(const Point2& p) const;
};

/// Precondition: pane is one of the cell. Cost: linear in its points.
ShownPane shown_pane(const CellTile& cell, int pane);

} // namespace druse::ui
