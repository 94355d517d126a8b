#pragma once

namespace druse::ui {

/// Where the pointer is in the view, in pixels from its top left corner, and what else is held down.
struct Pointer {
    double x = 0, y = 0;
    int button = 0; // 1 left, 2 middle, 3 right; 0 none
    bool shift = false, ctrl = false, alt = false;
    bool twice = false; // the second press of a double click
};

/// That of the event of the mouse that is being handled, in a view whose top left corner is there in its window.
Pointer pointer_at(int left, int top);

} // namespace druse::ui
