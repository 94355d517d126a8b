#pragma once

#include "ui/status_bar.h"
#include "ui/tile_view.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace druse::ui {

/// Asks for the picture behind a tile and how it lies: opacity, width and turn. Meanwhile the view shows it so.
/// @param folder of the document @return the command that lays it there; nothing if the person changed their mind
std::optional<std::string> ask_for_trace(TileView& view, const std::filesystem::path& folder);

/// What becomes of a tile that is done.
struct TileExport {
    std::string command;   // that makes its solid
    bool to_files = false; // else the main window gets it
};
/// Asks what solid to make of a tile. @param solids how many different ones there are @return nothing if the person changed their mind
std::optional<TileExport> ask_how_to_export(const std::vector<StatusPart>& facts, std::size_t solids);

} // namespace druse::ui
