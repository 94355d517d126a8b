#pragma once

#include "ui/shown_tile.h"
#include "ui/solid_file.h"

#include "ops/scene.h"
#include "tile/layered_tile.h"

#include <filesystem>
#include <string>
#include <vector>

namespace druse::ui {

/// The layered tile that a scene holds; null if there is none.
const LayeredTile* layered_tile(const Scene& scene);

/// What the editor shows of a tile; without a type if there is none. Cost: linear in its points.
ShownTile shown_tile(const LayeredTile* tile);

/// Each different solid of its stack, mirror images counted apart, in a file of its own: the proto-tile in `file`, then those with -2, -3, … behind its name.
/// @param command what makes the first one
std::vector<SolidFile> solid_files(const LayeredTile& tile, const std::string& command, const std::filesystem::path& file);

} // namespace druse::ui
