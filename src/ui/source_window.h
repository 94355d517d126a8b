#pragma once

#include "ui/editor_window.h"
#include "ui/file_commands.h"
#include "ui/history_panel.h"
#include "ui/parameter_panel.h"
#include "ui/pictures.h"
#include "ui/preferences.h"
#include "ui/section.h"
#include "ui/session.h"
#include "ui/solid_file.h"
#include "ui/status_bar.h"
#include "ui/timer.h"

#include <FL/Fl_Choice.H>

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace druse::ui {

/// An editor of something that a mesh is made of, a tile or a cell: a document of its own, whose mesh goes to the main window when it is done. What such editors
/// have in common; where their parts are, and what is drawn in them, is theirs.
class SourceWindow : public EditorWindow {
public:
    ~SourceWindow() override;
    int handle(int event) override;

    /// One line for everything that happens, as that of the main window.
    std::function<void(const std::string&)> on_event;
    /// After every change of the session.
    std::function<void()> on_change;
    /// A tile is done: its history, which ends with its mesh.
    std::function<void(Script)> on_export;

    /// `tile` or `cell`: the family of its operators. Lines of the event log and of recordings that are this editor's begin with it and a colon.
    const std::string& word() const { return word_; }
    std::string mark() const { return word_ + ": "; }
    Session& session() override { return session_; }
    FileCommands& files() { return files_; }
    void open(const std::filesystem::path& file) override { files_.open(file); }
    void choose(const Operator& op) override;
    /// The mesh that was made is for the main window, with the history that it comes of.
    void hand_over();
    /// Asks about unsaved work. @return true if it may go
    bool may_close() { return files_.may_leave(); }

protected:
    /// `paint` draws solids for the pictures of operators.
    SourceWindow(const Registry& registry, Preferences& preferences, bool test, const char* word, const char* title, Pictures::Painter paint, int w, int h);

    // --- what each does its own way ---------------------------------------------------------------------------------------------------------
    virtual void follow_source() = 0;         // the session changed: what is dragged goes on
    virtual bool is_dragging() const = 0;     // then only that is drawn
    virtual void refresh_parts() = 0;         // the rest, when it has ended
    virtual std::vector<StatusPart> facts() const = 0;
    virtual std::string hint() const = 0;
    virtual bool cancel_gesture() = 0;        // @return false if there was none
    virtual void refresh_bar() = 0;
    virtual Fl_Widget& main_part() = 0;       // has the focus when nothing else has
    virtual void place_parts() = 0;
    virtual bool other_key(int) { return false; }

    // --- for those that are made of it ------------------------------------------------------------------------------------------------------
    void add_parts(std::initializer_list<Fl_Widget*> parts); // before the menu, and what is in every editor
    void start();                                             // at the end of a constructor
    void dismantle();                                         // at the beginning of a destructor
    void refresh();
    void update_hint();
    void settle(); // a drag has ended
    void update_status() { status_.update(preferences_.unit); }
    void event(const std::string& line) const;
    bool is_closing() const { return closing_; }
    /// The mesh, while it is what the last step made.
    bool shows_mesh() const;
    void resize(int x, int y, int w, int h) override;
    void place_operators(int x, int y, int w, int bottom); // their choice, and the parameters below it
    Actions file_actions(std::function<void()> make_new, std::function<void()> export_it, Actions exports = {});
    void add_operator_actions(Actions& list, const char* menu); // one for each
    void choose_by_name(const char* name);
    /// Runs the command, if it is not what was done last. @return false if it is refused: the status line says why
    bool make_solid(const std::string& command);
    /// A file for what is exported; nothing if the person changed their mind.
    std::optional<std::filesystem::path> ask_for_solid_file() const;
    void export_solids(const std::vector<SolidFile>& solids);
    void close();

    Preferences& preferences_;
    bool test_;
    Session session_;
    FileCommands files_;
    Pictures pictures_;
    HistoryPanel history_;
    Section history_section_;
    StatusBar status_;

private:
    void refresh_panels();
    void escape();

    std::string word_, title_;
    std::vector<const Operator*> operators_;
    Registry no_operators_; // the menu has its operators as entries of its own
    Fl_Choice operator_choice_;
    ParameterPanel parameters_;
    Timer show_progress_, settle_;
    bool panels_are_old_ = false, closing_ = false;
};

} // namespace druse::ui
