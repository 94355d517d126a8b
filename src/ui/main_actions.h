#pragma once

#include "ui/action.h"

namespace druse::ui {

class MainWindow;

/// Everything in the menus that is no operator.
Actions main_actions(MainWindow& window);

} // namespace druse::ui
