#pragma once

#include <FL/Fl_Window.H>

#include <fstream>
#include <string>

namespace druse::ui {

class EditorWindow;
class MainWindow;

/// Writes down what a person does in the main window and in the editors of tiles and cells, one event a line, as Replay reads it.
///
/// Menus and dialogs are left out; what comes of them is written instead: the entry that was picked, the file that was opened.
class Recorder {
public:
    /// @throws InputError if the file cannot be written
    Recorder(MainWindow& window, const std::string& file);
    ~Recorder();
    Recorder(const Recorder&) = delete;
    Recorder& operator=(const Recorder&) = delete;

    /// Another window of the program, from now on.
    void watch(EditorWindow& window);
    /// An event of the log: what a person has chosen where this does not look.
    void follow(const std::string& line);

private:
    static int dispatch(int event, Fl_Window* to);
    void record(int event, EditorWindow& window);
    void write(EditorWindow& window, const std::string& line);

    static Recorder* only_;
    MainWindow& window_;
    std::ofstream out_;
    bool pressed_ = false;
};

} // namespace druse::ui
