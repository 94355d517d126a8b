#pragma once

#include <FL/Enumerations.H>

namespace druse::ui {

/// The colours of the window.
struct Theme {
    Fl_Color window;    // panels
    Fl_Color sunken;    // lists and fields
    Fl_Color raised;    // buttons
    Fl_Color border;
    Fl_Color header;    // bars of sections
    Fl_Color text, faint_text;
    Fl_Color accent, on_accent;
    Fl_Color hover;
    Fl_Color error, amber, good;
};

const Theme& theme();

/// Makes FLTK look like this: colours, flat boxes with a thin rounded border, fonts. Call it before the first widget is made.
void use_theme(bool dark);
bool theme_is_dark();

// Boxes of our own.
Fl_Boxtype field_box();  // sunken, rounded
Fl_Boxtype button_box(); // raised, rounded

} // namespace druse::ui
