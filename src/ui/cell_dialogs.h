#pragma once

#include "ui/status_bar.h"
#include "ui/tile_dialogs.h"

#include "cell/parallelohedron.h"

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

/// What becomes of points that were moved, when their pane goes back to phase I.
enum class RollBack { keep, anew, cancel };
/// `moved`: how many points inside it are no longer where they were flat; `splits`: how many points were put into its triangles and edges.
RollBack ask_how_to_roll_back(int pane, int moved, int splits);

} // namespace druse::ui
