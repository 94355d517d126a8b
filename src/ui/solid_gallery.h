#pragma once

#include "ui/pictures.h"

#include <optional>
#include <string>
#include <vector>

namespace druse::ui {

/// The names of the built-in solids; of a family, such as `prism:N`, those with 3 to 6 sides.
std::vector<std::string> gallery_solids();

/// Shows all of them with their pictures, `current` marked, and a way to a file. @return what was chosen; nothing if it was closed
std::optional<std::string> choose_solid(Pictures& pictures, const std::string& current);

} // namespace druse::ui
