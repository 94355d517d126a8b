#pragma once

#include "ui/pointer.h"

namespace druse::ui {

class MainWindow;

/// The menu for what is under the pointer in the view.
void show_context_menu(MainWindow& window, const Pointer& pointer);

} // namespace druse::ui
