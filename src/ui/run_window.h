#pragma once

#include <string>

namespace druse {

/// What the command line says about the window. Empty texts: not given.
struct WindowOptions {
    std::string file;      // opened at the start
    bool test = false;     // no animation, no autosave, no tooltips, no cursor blinking, preferences of its own that are not kept
    std::string geometry;  // WxH, WxH+X+Y or +X+Y
    std::string event_log; // a line is added to this file for everything that happens
    std::string record;    // what the person does is written to this file, one event a line
    std::string replay;    // and played from such a file
    double ui_scale = 0;   // 1, 1.25, 1.5 or 2; 0: as in the preferences
};

/// Opens the window and returns the exit status when it is closed.
/// @throws SystemError without a display; CommandError if `geometry` or `ui_scale` is not of its form; InputError if a log,
/// recording or replay file cannot be opened
int run_window(const WindowOptions& options);

} // namespace druse
