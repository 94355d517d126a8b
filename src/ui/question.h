#pragma once

#include "ui/layout.h"

#include <FL/Fl_Box.H>
#include <FL/Fl_Button.H>
#include <FL/Fl_Double_Window.H>

namespace druse::ui {

/// A small window with some rows that waits until it is answered.
class Question : public Fl_Double_Window {
public:
    Question(int w, int rows, const char* title);
    static int row() { return layout().button_height() + layout().gap(); }
    static int top(int line) { return layout().margin() + line * row(); }
    /// A label at the left end of a row. The window deletes it.
    static Fl_Box* add_label(int line, int width, const char* text);

    /// Waits. @return whether it was answered with the first button
    bool ask(Fl_Button& yes, Fl_Button& no);

private:
    bool answer_ = false;
};

} // namespace druse::ui
