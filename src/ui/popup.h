#pragma once

#include <functional>
#include <string>
#include <vector>

namespace druse::ui {

struct PopupEntry {
    std::string label;
    std::function<void()> run; // none: it only says something
    bool divider = false;      // a line below it
};

/// Shows a menu at a place in the window and does what is chosen.
void show_popup(const std::vector<PopupEntry>& entries, int x, int y);

} // namespace druse::ui
