#pragma once

#include "ui/status_bar.h"
#include "ui/tile_dialogs.h"

#include "cell/cell_tile.h"

#include <optional>
#include <string>
#include <vector>

namespace druse::ui {

/// `Rhombic dodecahedron` and the like.
const char* cell_title(CellKind kind);

/// Asks for one of the five cells, by its picture. @return nothing if the person changed their mind
std::optional<CellKind> choose_cell_kind(std::optional<CellKind> current);

/// Asks what solid to make of a cell. @return nothing if the person changed their mind
std::optional<TileExport> ask_how_to_export_cell(const std::vector<StatusPart>& facts);

/// What a pane has that it had not when it was flat.
struct PaneShape {
    int moved = 0;  // points inside it that are elsewhere
    int splits = 0; // points that were put into its triangles and edges
    int flips = 0;  // edges that were turned
    bool empty() const { return moved == 0 && splits == 0 && flips == 0; }
};
PaneShape shape_of(const CellTile& cell, int pane);

/// What becomes of points that were moved, when their pane goes back to phase I.
enum class RollBack { keep, anew, cancel };
/// What is asked then.
std::string roll_back_question(int pane, const PaneShape& shape);
RollBack ask_how_to_roll_back(int pane, const PaneShape& shape);

} // namespace druse::ui
