#pragma once

#include "render/image.h"

class Fl_Window;

namespace druse::ui {

/// What the display shows of a window, widgets and all.
Image picture_of(Fl_Window& window);

} // namespace druse::ui
