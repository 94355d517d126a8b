#pragma once

#include <functional>
#include <string>
#include <vector>

namespace druse::ui {

/// Something the window can do besides running operators: an entry of a menu and of the command palette.
struct Action {
    std::string path; // `File/Open…`
    int shortcut = 0; // as FLTK writes them
    std::function<void()> run = {};
    std::function<bool()> is_on = {}; // of a toggle
    bool divider = false;             // a line below it in the menu
};

using Actions = std::vector<Action>;

/// The part after the last `/`.
std::string label_of(const Action& action);

} // namespace druse::ui
