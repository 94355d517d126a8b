#pragma once

#include "ui/timer.h"

#include <functional>
#include <string>
#include <vector>

namespace druse::ui {

class EditorWindow;
class MainWindow;

/// Plays a recording on the main loop: mouse, keys and menu entries go in where FLTK would put them.
///
/// ```
/// push X Y BUTTON [shift] [ctrl] [alt] [twice]      drag X Y      move X Y      release X Y      wheel X Y NOTCHES
/// key Ctrl+Z      menu Edit/Undo      choose OPERATOR      set PARAMETER VALUE      run COMMAND
/// open FILE       save FILE           export FILE          shot FILE.png            wait EVENT     quit
/// preset NAME     hand over
/// ```
/// A line that begins with `tile: ` or `cell: ` is for the editor of tiles or cells, which it opens; `hand over` ends its work, and the main window has the mesh.
/// `wait` goes on when a line of the event log since the last wait begins so; after 10 seconds it fails.
class Replay {
public:
    /// @throws InputError if the file cannot be read
    Replay(MainWindow& window, const std::string& file);

    void start() { timer_.start(tick); }
    /// A line of the event log.
    void follow(const std::string& line) { events_.push_back(line); }
    /// What went wrong, with the line; empty if nothing did.
    const std::string& failure() const { return failure_; }
    std::function<void()> on_end; // after the last line, or the first that failed

private:
    static constexpr double tick = 0.01; // seconds
    void next();
    void play(std::string line);
    bool is_busy() const;
    bool awaited(const std::string& event);

    MainWindow& window_;
    std::string file_;
    std::vector<std::string> lines_;
    std::size_t at_ = 0;
    std::vector<std::string> events_; // since the last wait
    int ticks_waited_ = 0;
    std::string failure_;
    Timer timer_;
};

} // namespace druse::ui
