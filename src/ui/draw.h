#pragma once

#include "geom/colour.h"

#include <FL/Enumerations.H>

#include <string>

namespace druse::ui {

// Small things that several widgets draw.

/// One line of text, its middle at that of the rectangle; what is too long ends in "…".
void draw_text(const std::string& text, int x, int y, int w, int h, Fl_Color colour, Fl_Align align = FL_ALIGN_LEFT);
/// The mark before something that folds: it points down when it is open, else to the right.
void draw_chevron(int x, int y, int size, bool open, Fl_Color colour);
void draw_swatch(int x, int y, int size, Colour colour);
Fl_Color fl_colour(Colour c);

} // namespace druse::ui
