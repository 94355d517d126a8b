#pragma once

#include "ui/divider.h"
#include "ui/editor_window.h"
#include "ui/facts_panel.h"
#include "ui/file_commands.h"
#include "ui/groups_panel.h"
#include "ui/history_panel.h"
#include "ui/operator_tree.h"
#include "ui/parameter_panel.h"
#include "ui/preferences.h"
#include "ui/section.h"
#include "ui/session.h"
#include "ui/status_bar.h"
#include "ui/timer.h"
#include "ui/view.h"
#include "ui/view_bar.h"
#include "ui/viewport.h"

#include <FL/Fl_Box.H>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace druse::ui {

class CellWindow;
class SourceWindow;
class TileWindow;

/// Puts the parts of the window side by side and tells each when the session has changed. What they do is in them.
class MainWindow : public EditorWindow {
public:
    struct Options {
        bool test = false; // no animation, nothing remembered
    };
    MainWindow(Session& session, Preferences& preferences, const Options& options, int w, int h);
    ~MainWindow() override;

    void resize(int x, int y, int w, int h) override;
    int handle(int event) override;

    /// One line for everything that happens: what the session says, frames, and what is pressed in the view.
    std::function<void(const std::string&)> on_event;
    /// After every change of the session.
    std::function<void()> on_change;

    Session& session() override { return session_; }
    View& view() { return view_; }
    Viewport& viewport() { return viewport_; }
    FileCommands& files() { return files_; }
    Preferences& preferences() { return preferences_; }
    GroupsPanel& groups() { return groups_; }
    ParameterPanel& parameters() { return parameters_; }

    // What the View and Help menus do with the window itself.
    void fold_sides();
    bool sides_are_folded() const { return !left_open_ && !right_open_; }
    void full_screen();
    void edit_preferences();
    void save_screenshot();
    void show_help();
    void show_log();
    void quit();
    /// The editors of tiles and of cells, opened where they are not open yet.
    TileWindow& tile_editor();
    CellWindow& cell_editor();
    /// The one for a `.tile` file.
    SourceWindow& editor_for(const std::filesystem::path& file);
    /// Those that have been open.
    std::vector<SourceWindow*> editors() const;
    /// One is there for the first time.
    std::function<void(SourceWindow&)> on_editor;
    /// Opens a file: a tile or a cell in its editor.
    void open(const std::filesystem::path& file) override;
    void choose(const Operator& op) override;
    bool is_in_view(int x, int y) const override;

private:
    void arrange();
    void arrange_right(int x, int y, int w, int h);
    void event(const std::string& line);
    void update_hint();
    void refresh(); // after a change of the session
    void later();   // what need not be done at once
    void escape();
    void carry(GroupList::Carry what, int group);
    void smooth_changed();
    bool other_key(int key);
    void show_missing_view();
    void frame_what_is_new();
    template <class Editor>
    Editor& show_editor(std::unique_ptr<Editor>& editor);
    bool open_in_editor(const std::filesystem::path& file, const SourceWindow* asks);

    Session& session_;
    Preferences& preferences_;
    Options options_;
    View view_;
    FileCommands files_;

    Pictures pictures_;
    OperatorTree tree_;
    ParameterPanel parameters_;
    ViewBar view_bar_;
    Fl_Box no_view_; // says why there is no picture
    Viewport viewport_;
    HistoryPanel history_;
    GroupsPanel groups_;
    FactsPanel facts_;
    Section history_section_, groups_section_, facts_section_;
    Divider left_divider_, right_divider_, tree_divider_;
    StatusBar status_;

    std::unique_ptr<TileWindow> tile_editor_;
    std::unique_ptr<CellWindow> cell_editor_;

    Timer show_progress_, count_facts_, forget_failed_, animate_, give_up_view_;

    int left_width_, right_width_, tree_height_;
    bool left_open_ = true, right_open_ = true;
    std::filesystem::path framed_file_;
    bool framed_ = false;
    bool cross_ = false; // the pointer in the view
    bool carrying_ = false; // a group over the view
    bool closing_ = false;
};

} // namespace druse::ui
