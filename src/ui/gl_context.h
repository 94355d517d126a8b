#pragma once

#include "render/gl_proc.h"

class Fl_Gl_Window;

namespace druse::ui {

/// Gives a shown GL window an OpenGL 3.3 core context of our own, on the window's visual.
///
/// FLTK's way to a core profile, FL_OPENGL3, hands its list of attributes to a function that reads it differently: the window
/// becomes single-buffered and takes the highest sample count there is. So the window asks for a plain visual, and the context
/// comes from here.
/// @return false if the driver has none; then the window keeps the context FLTK makes
bool make_core_context(Fl_Gl_Window& window);

/// Finds functions of the context that is current.
GlProcLoader window_gl_loader();

} // namespace druse::ui
