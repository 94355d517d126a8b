#pragma once

#include "ui/preferences.h"

namespace druse::ui {

/// Asks for what the person prefers. @return true if something was changed
bool ask_for_preferences(Preferences& preferences);

} // namespace druse::ui
