#pragma once

#include "ui/action.h"
#include "ui/list_view.h"

#include "ops/registry.h"

#include <FL/Fl_Double_Window.H>
#include <FL/Fl_Input.H>

#include <functional>
#include <string>
#include <vector>

namespace druse::ui {

class MainWindow;

/// One thing that the command palette can do.
struct PaletteEntry {
    std::string label, detail;
    std::function<void()> run;
};

/// The entries that hold all words of `wanted`, those whose label begins with it first; all of them if it is empty.
std::vector<const PaletteEntry*> find_entries(const std::vector<PaletteEntry>& entries, const std::string& wanted);

/// Every menu entry and every operator by name; and what looks like a command with arguments is run as it is.
void show_palette(MainWindow& window);
/// The files opened last.
void show_recent_files(MainWindow& window);

} // namespace druse::ui
