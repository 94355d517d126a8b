#pragma once

#include "ui/status_bar.h"
#include "ui/tile_view.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace druse::ui {

/// Asks for the picture behind a tile and how it lies: opacity, width and turn. `on_change` is called while they are changed.
/// @return false if the person changed their mind; then it is as it was
bool ask_for_traced_image(std::optional<TracedImage>& traced, const ShownTile& shape, const std::function<void()>& on_change);

/// Asks what solid to make of a tile. @return the command that makes it; nothing if the person changed their mind
std::optional<std::string> ask_how_to_export(const std::vector<StatusPart>& facts);

} // namespace druse::ui
