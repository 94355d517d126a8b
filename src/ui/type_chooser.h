#pragma once

#include <optional>
#include <string>
#include <vector>

namespace druse::ui {

/// What a person may ask of a type.
struct TypeFilter {
    int rotations = 0;     // about a point: 1, 2, 3, 4 or 6; 0: any
    bool no_mirrored = false; // no tile is the mirror image of another
};

/// The numbers of the isohedral types that pass.
std::vector<int> types_that_pass(const TypeFilter& filter);

/// Lets a person choose a type by its picture. @param current its name, `IH79`; may be empty
/// @return its name; nothing if they changed their mind
std::optional<std::string> choose_tile_type(const std::string& current);

} // namespace druse::ui
